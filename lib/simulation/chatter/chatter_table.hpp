// The impacts of a chatter and the limit they tend to, in numbers alone. An impact at t, after
// which a flight x follows to leading order, predicts the time t + x / (1 - r) of the limit. This
// is a smooth function of x, and tends to that time as x -> 0 with an error of order x^2. The
// equations are (11) to (13) of lib/README.md.
#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

#include "simulation/chain/tolerances.hpp"
#include "simulation/flight/polynomial.hpp"

namespace vibro_impact::detail {

// Neville's tables, at x = 0, of predicted / x and of 1 / x. The predicted limit is T + c x^2 +
// d x^3 + ... without a linear term: divided by x, all but T / x is a polynomial that is zero at
// x = 0. So the limit is the ratio of the two.
struct ChatterTable {
  struct Node {
    double x, predicted;  // the limit predicted, since the first impact
    std::size_t impact;   // counted from the first
  };
  struct Entry {
    double predicted = 0.0, one = 0.0;
    double limit() const {
      return predicted / one;
    }
  };
  std::vector<Node> nodes;  // oldest first
  // The last row: extrapolated from the last 1, 2, ... nodes.
  std::array<Entry, max_chatter_nodes> row{};
  // How many nodes beside the latest are best to take, and the estimated error of the limit then.
  std::size_t best = 0;
  double error = std::numeric_limits<double>::infinity();
};

// Enters a node and the next row of the table.
void extend(ChatterTable &table, const ChatterTable::Node &node);

// The impacts of a chatter: at the same contacts in one contact mode, each flight shorter than the
// one before. No impacts: no chatter is under way.
struct Chatter {
  std::vector<std::size_t> contacts = {};  // of the mode, hit at every impact
  double restitution = 0.0;                // of the first of them, at rest
  std::size_t stride = 1;  // every k-th impact is a node: closer ones amplify rounding
  // Time since the first impact, and one jump of the gap speed for each contact. Impacts before the
  // oldest node are dropped; `dropped` counts them.
  std::vector<double> times = {}, jumps = {};
  std::size_t dropped = 0;
  double flight = 0.0;  // x of the latest impact
  double since = 0.0;   // time flown since then
  ChatterTable table = {};

  bool under_way() const {
    return !times.empty();
  }
  bool hits(std::size_t contact) const;
  // True when the latest impact is a node and no time has passed since.
  bool stands_at_node() const {
    return under_way() && since == 0.0 && table.nodes.back().impact + 1 == dropped + times.size();
  }
  double latest_jump(std::size_t hit) const {
    return jumps[(times.size() - 1) * contacts.size() + hit];
  }
};

// Ends the chatter under way, and begins one at these contacts.
void begin(Chatter &chatter, const std::vector<std::size_t> &contacts, double restitution);

void end(Chatter &chatter);

// Adds an impact with these jumps, one for each contact, and the flight expected next. Returns true
// when it is a node of the table.
bool add_impact(Chatter &chatter, double flight, const std::vector<double> &jumps);

struct ChatterLimit {
  double time_left = 0.0;  // from the latest impact
  double error = 0.0;      // estimated
  std::size_t oldest = 0;  // of the nodes that it is extrapolated from
};

// The limit, when its estimated error is at most `tolerance` and it does not agree by chance: near
// a border orbit, where the press falls to zero as the chatter ends, the extrapolated time left and
// the one that the latest impact predicts are far apart until late.
std::optional<ChatterLimit> extrapolate_limit(const Chatter &chatter, double tolerance);

// The moments M_n = sum_k J_k ((T - t_k) / time_left)^n of the impacts to come at contact `hit`,
// extrapolated, for n = 0, ..., order, and what the oldest node changes in them.
struct ChatterMoments {
  Terms moment{}, change{};
};
ChatterMoments extrapolate_moments(const Chatter &chatter, const ChatterLimit &limit,
                                   std::size_t hit, double restitution, int order);

}  // namespace vibro_impact::detail
