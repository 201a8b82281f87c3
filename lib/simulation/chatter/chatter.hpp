// A chatter: impact after impact at the same stops, in one contact mode, each flight shorter than
// the one before. The one place where that is recognised, and the time of its limit extrapolated:
// what an impact predicts, t + x / (1 - r), is a smooth function of the flight x that follows to
// leading order, and tends to that time as x -> 0 with an error of order x^2 (Neville's table).
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "simulation/stops/impact.hpp"

namespace vibro_impact {

struct ChatterTable {
  struct Node {
    double x, predicted;  // the limit predicted, since the first impact
    std::size_t impact;
  };
  // An entry of Neville's tables of predicted / x and of 1 / x, at x = 0.
  using Entry = Eigen::Array2d;
  std::vector<Node> nodes;  // oldest first
  // The last row: extrapolated from the last 1, 2, ... nodes.
  std::array<Entry, max_chatter_nodes> row{};
  // How many are best to take, less one, and the estimated error of the limit then.
  std::size_t best = 0;
  double error = std::numeric_limits<double>::infinity();
};

inline double limit_of(const ChatterTable::Entry &entry) {
  return entry[0] / entry[1];
}

// Enters a node and the next row of the table: O(nodes). The predicted limit is T + c x^2 + d x^3 +
// ... without a linear term: divided by x, all but T / x is a polynomial that is zero at x = 0. So
// the value there of the polynomial through predicted / x is T times that of the one through 1 / x.
inline void extend(ChatterTable &table, const ChatterTable::Node &node) {
  table.error = std::numeric_limits<double>::infinity();
  table.best = 0;
  if (table.nodes.size() == max_chatter_nodes) table.nodes.erase(table.nodes.begin());
  table.nodes.push_back(node);
  const std::size_t last = table.nodes.size() - 1;
  ChatterTable::Entry here(node.predicted / node.x, 1.0 / node.x);
  double error_before = 0.0;
  for (std::size_t column = 1; column <= last; ++column) {
    const ChatterTable::Entry without_newest = table.row[column - 1], without_oldest = here;
    table.row[column - 1] = here;
    const double share = node.x / (table.nodes[last - column].x - node.x);
    here += (here - without_newest) * share;
    // Not much below that of one node less: they may agree by chance.
    const double error = std::abs(limit_of(here) - limit_of(without_oldest));
    const double believed = std::max(error, luck * error_before);
    if (believed <= table.error) {
      table.error = believed;
      table.best = column;
    }
    error_before = error;
  }
  table.row[last] = here;
}

// The weights of the nodes from `first` on, by which their predictions are extrapolated so: those
// of Lagrange at x = 0, divided by x and by their sum.
inline std::array<double, max_chatter_nodes> node_weights(const ChatterTable &table,
                                                          std::size_t first) {
  std::array<double, max_chatter_nodes> weights{};
  double sum = 0.0;
  for (std::size_t i = first; i < table.nodes.size(); ++i) {
    weights[i] = 1.0 / table.nodes[i].x;
    for (std::size_t j = first; j < table.nodes.size(); ++j)
      if (j != i) weights[i] *= table.nodes[j].x / (table.nodes[j].x - table.nodes[i].x);
    sum += weights[i];
  }
  for (double &weight : weights) weight /= sum;
  return weights;
}

// The impacts of a chatter so far, none where there is none under way.
struct ChatterImpacts {
  std::vector<std::size_t> contacts = {};      // of the mode, hit at every impact
  std::vector<double> times = {}, jumps = {};  // since the first impact; contacts.size() jumps each
  double flight = 0.0;                         // x of the latest impact
  double since = 0.0;                          // flown since then
};

template <int D>
struct Chatter {
  const ContactMode<D> *mode = nullptr;  // of all impacts
  ChatterImpacts impacts;
  std::size_t stride = 1;  // every k-th impact is a node: closer ones amplify rounding
  ChatterTable table;
  typename State<D>::Lanes pushes, speeds;  // of `others_stay_clear`
  State<D> responses;                       // of `move_to_limit`, to the impacts to come

  bool under_way() const {
    return !impacts.times.empty();
  }
  // True when the latest impact is a node and nothing has been flown since.
  bool at_node() const {
    return under_way() && impacts.since == 0.0 &&
           table.nodes.back().impact + 1 == impacts.times.size();
  }
  // Hit j of every impact: its contact, and its jump of the gap speed.
  const Contact<D> &hit(std::size_t j) const {
    return mode->contacts[impacts.contacts[j]];
  }
  double jump(std::size_t impact, std::size_t j) const {
    return impacts.jumps[impact * impacts.contacts.size() + j];
  }
  bool hits_contact(std::size_t k) const {
    return std::find(impacts.contacts.begin(), impacts.contacts.end(), k) != impacts.contacts.end();
  }
  void end() {
    impacts.contacts.clear();
    impacts.times.clear();
    impacts.jumps.clear();
    impacts.flight = impacts.since = 0.0;
    table.nodes.clear();
  }
};

// Begins a chatter of impacts at these contacts of the mode.
template <int D>
void begin(Chatter<D> &chatter, const ContactMode<D> &mode,
           const std::vector<std::size_t> &contacts) {
  chatter.mode = &mode;
  chatter.impacts.contacts = contacts;
  const double ratio = std::log(node_ratio) / std::log(chatter.hit(0).restitution);
  chatter.stride = static_cast<std::size_t>(std::ceil(std::max(1.0, ratio)));
}

// Notes the impacts at `contacts`, which have just happened, with the flight expected next. They go
// on with the chatter, begin one, or end it.
template <int D>
void note_impacts(Chatter<D> &chatter, const State<D> &state,
                  const std::vector<std::size_t> &contacts, double flight, Counters &counters) {
  const ContactMode<D> &mode = *state.mode;
  ChatterImpacts &impacts = chatter.impacts;
  const bool goes_on =
      chatter.under_way() && flight < impacts.flight && contacts == impacts.contacts;
  if (!goes_on) {
    chatter.end();
    const double r = mode.contacts[contacts[0]].restitution;
    // No chatter where r = 0 (one impact stops the mass) and where r = 1 (it never ends).
    if (!(r > 0.0 && r < 1.0 && flight * mode.fastest < 1.0)) return;
    begin(chatter, mode, contacts);
  }
  const double time = goes_on ? impacts.times.back() + impacts.since : 0.0;
  const std::size_t impact = impacts.times.size();
  impacts.times.push_back(time);
  for (const std::size_t k : contacts) {
    const AtStop &stop = state.stops[mode.contacts[k].stop];
    impacts.jumps.push_back(stop.last_speed + stop.speed);
  }
  impacts.flight = flight;
  impacts.since = 0.0;
  if (impact % chatter.stride != 0) return;
  extend(chatter.table, {flight, time + flight / (1.0 - chatter.hit(0).restitution), impact});
  ++counters.chatter_nodes;
}

}  // namespace vibro_impact
