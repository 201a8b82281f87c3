// The impacts of a chatter and their limit T, without the motion. Let x be the flight time after an
// impact at t, to leading order. The impact predicts the limit t + x / (1 - r), which is a smooth
// function of x and differs from T by O(x^2) as x -> 0: (11) to (13) of lib/README.md.
#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

#include "simulation/chain/tolerances.hpp"
#include "simulation/flight/polynomial.hpp"

namespace vibro_impact::detail {

// Neville's tables at x = 0 of predicted / x and of 1 / x, over nodes: a node is an impact that is
// entered into the table. The predicted limit is T + c x^2 + d x^3 + ... without a linear term.
// Divided by x it is T / x plus a polynomial that is zero at x = 0, hence the ratio of the two
// extrapolated values tends to T.
struct ChatterTable {
  struct Node {
    double x, predicted;  // flight time, and predicted limit counted from the first impact
    std::size_t impact;   // index, from 0, of the impact in the chatter
  };
  struct Entry {
    double predicted = 0.0, one = 0.0;
    double limit() const {
      return predicted / one;
    }
  };
  std::vector<Node> nodes;  // oldest first
  // Entry k is extrapolated from the last k + 1 nodes.
  std::array<Entry, max_chatter_nodes> row{};
  // The entry with the smallest estimated error of its limit, and that error.
  std::size_t best = 0;
  double error = std::numeric_limits<double>::infinity();
};

// Adds a node and computes the row of the table that ends with it.
void extend(ChatterTable &table, const ChatterTable::Node &node);

// A chatter is a sequence of impacts at the same contacts in one contact mode, each flight shorter
// than the one before. Without impacts no chatter is under way. At most `max_chatter_nodes` nodes
// and the impacts since the oldest of them are kept.
struct Chatter {
  std::vector<std::size_t> contacts = {};  // indices, in the mode, of the contacts hit
  double restitution = 0.0;                // of the first contact, at speed zero
  // Every stride-th impact is a node. Nodes that are closer to each other amplify rounding.
  std::size_t stride = 1;
  // For each impact the time since the first impact, and the jumps J of the gap speeds, one for
  // each contact. `dropped` counts the impacts before the oldest node, which are dropped.
  std::vector<double> times = {}, jumps = {};
  std::size_t dropped = 0;
  double flight_time = 0.0;  // x of the latest impact
  double since = 0.0;        // time since the latest impact
  ChatterTable table = {};

  bool under_way() const {
    return !times.empty();
  }
  bool hits(std::size_t contact) const;
  // True when the latest impact is a node and the run stands at this impact.
  bool stands_at_node() const {
    return under_way() && since == 0.0 && table.nodes.back().impact + 1 == dropped + times.size();
  }
  // The jump J at contacts[hit] of the kept impact k.
  double jump(std::size_t k, std::size_t hit) const {
    return jumps[k * contacts.size() + hit];
  }
};

// Ends the chatter under way, and begins another one at these contacts without impacts.
void begin(Chatter &chatter, const std::vector<std::size_t> &contacts, double restitution);

void end(Chatter &chatter);

// Adds an impact with these jumps, one for each contact, and the expected time of the flight after
// it. Returns true when the impact is a node of the table.
bool add_impact(Chatter &chatter, double flight_time, const std::vector<double> &jumps);

struct ChatterLimit {
  double time_left = 0.0;  // from the latest impact to the limit
  double error = 0.0;      // estimated error of this time
  std::size_t oldest = 0;  // index of the oldest node of the extrapolation
};

// The limit, if its estimated error is at most `tolerance` and the extrapolated time left differs
// little from the time left that the latest impact predicts. The second condition excludes an error
// that is small by chance near a border orbit, where the hold force is zero at the limit.
std::optional<ChatterLimit> extrapolate_limit(const Chatter &chatter, double tolerance);

// The extrapolated moments M_n = sum_k J_k ((T - t_k) / time_left)^n, n = 0, ..., order, of the
// impacts to come at contact `hit`, and their differences from the moments without the oldest node.
struct ChatterMoments {
  Terms moment{}, difference{};
};
ChatterMoments extrapolate_moments(const Chatter &chatter, const ChatterLimit &limit,
                                   std::size_t hit, double restitution, int order);

}  // namespace vibro_impact::detail
