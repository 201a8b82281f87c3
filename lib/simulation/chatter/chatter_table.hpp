// The impacts of a chatter and their limit T. Let x be the flight time after an impact at t, to
// leading order. The impact predicts the time t + x / (1 - r) of the limit and the state there.
// Both are smooth functions of x and differ from the limit by O(x^2) as x -> 0: (11) and (12) of
// lib/README.md.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "simulation/chain/motion.hpp"
#include "simulation/chain/tolerances.hpp"

namespace vibro_impact::detail {

// The coordinates that a node predicts at the limit, in twice the precision.
struct PredictedState {
  PerCoordinate y, dy, y_low, dy_low;
};

// A node is an impact from which the limit is extrapolated.
struct ChatterNode {
  double x = 0.0;          // flight time after the impact
  double predicted = 0.0;  // time of the limit, counted from the first impact
  double jump = 0.0;       // the largest jump of a gap speed
  PredictedState state = {};
};

using PerNode = std::array<double, max_chatter_nodes>;

// The prediction P(x) = T + c x^2 + ... has no linear term, which a plain extrapolation would not
// use. P / x - T / x is zero at x = 0, so T = lim (P / x) / lim (1 / x), where both limits are
// extrapolated with the same weights, by Neville's scheme.
struct ExtrapolatedLimit {
  double predicted = 0.0, reciprocal = 0.0;
  double time() const {
    return predicted / reciprocal;
  }
};

// A chatter is a sequence of impacts at the same contacts in one contact mode, each flight shorter
// than the one before. Without impacts no chatter is under way.
struct Chatter {
  std::vector<std::size_t> contacts = {};  // indices, in the mode, of the contacts hit
  double restitution = 0.0;                // of the first contact, at speed zero
  // Every stride-th impact is a node. Nodes that are closer to each other amplify rounding.
  std::size_t stride = 1, impacts = 0;
  double time = 0.0;               // of the latest impact, since the first
  double since = 0.0;              // time since the latest impact
  double flight_time = 0.0;        // x of the latest impact
  std::vector<double> jumps = {};  // of the gap speeds at the latest impact, one for each contact
  std::array<ChatterNode, max_chatter_nodes> ring = {};  // the latest nodes: see node
  std::size_t size = 0, oldest = 0;                      // their number, and where they begin
  // Entry k is extrapolated from the latest k + 1 nodes.
  std::array<ExtrapolatedLimit, max_chatter_nodes> row = {};
  // The entry with the smallest estimated error of its limit, and that error.
  std::size_t best = 0;
  double error = 0.0;

  // Node k, from 0 for the oldest to size - 1.
  const ChatterNode &node(std::size_t k) const {
    k += oldest;
    return ring[k < max_chatter_nodes ? k : k - max_chatter_nodes];
  }
  bool under_way() const {
    return impacts > 0;
  }
  bool hits(std::size_t contact) const;
  // True when the latest impact is a node and the run stands at this impact.
  bool stands_at_node() const {
    return under_way() && since == 0.0 && (impacts - 1) % stride == 0;
  }
};

// Ends the chatter under way, and begins another one at these contacts without impacts.
void begin_chatter(Chatter &chatter, const std::vector<std::size_t> &contacts, double restitution);

void end_chatter(Chatter &chatter);

// Adds an impact with these jumps, one for each contact, and the expected time of the flight after
// it. The motion stands just after the impact. Returns true when the impact is a node.
bool add_impact(Chatter &chatter, double flight_time, const std::vector<double> &jumps,
                const Motion &motion);

struct ChatterLimit {
  double time_left = 0.0;  // from the latest impact to the limit
  double error = 0.0;      // estimated error of this time
  std::size_t oldest = 0;  // index of the oldest node of the extrapolation
};

// The weights w_i of the nodes from `oldest` on, by which times and states are extrapolated, and
// those without the oldest node: Lagrange's weights at x = 0, divided by x_i. Both add up to 1.
struct NodeWeights {
  PerNode all = {}, without_oldest = {};
};

NodeWeights weights_of(const Chatter &chatter, std::size_t oldest);

// The limit, if its estimated error is at most `tolerance` and the extrapolated time left differs
// little from the time left that the latest impact predicts. The second condition excludes an error
// that is small by chance near a border orbit, where the hold force is zero at the limit.
std::optional<ChatterLimit> extrapolate_limit(const Chatter &chatter, double tolerance);

}  // namespace vibro_impact::detail
