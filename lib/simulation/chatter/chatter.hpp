// The limit of a complete chatter. Near it the impacts form an analytic sequence with the ratio r,
// so that the time and the state at the limit follow from those of a few impacts by Richardson's
// extrapolation: (6) and (7) of lib/README.md.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "simulation/chain/motion.hpp"
#include "simulation/chain/tolerances.hpp"
#include "vibro_impact/event.hpp"

namespace vibro_impact::detail {

// The sums of one impact at a stop of the chain.
ImpactSum taken_by_impact(const Chain &chain, std::size_t stop, double closing, double leaving);

// An impact as a node of the extrapolation: what it predicts of the limit, to leading order.
struct ChatterNode {
  Real time = 0.0;  // of the limit, since the first impact
  std::vector<Real> x, v;
  RealPair sum;       // the impulse and the energy of all impacts since the first
  double jump = 0.0;  // of the velocity of the mass, at all impacts to come
};

// The chatter of one mass at one stop.
class Chatter {
 public:
  // An impact at this closing speed, with the motion after it: the flight that follows takes the
  // time `flight_time` to leading order (x in (6)). A new chatter begins unless this one continues.
  void add(const Chain &chain, const Motion &motion, const Contact &contact, double closing,
           double flight_time);
  void end();

  // True if the latest impact is a node: a limit may be taken.
  bool is_at_node() const {
    return size_ > 0 && (impacts_ - 1) % stride_ == 0;
  }
  // The time from the latest node to the limit, extrapolated. It is known when it has settled
  // within this tolerance of 1 / rate and of the time from its first node to the limit.
  std::optional<double> time_left(double tolerance, double rate) const;
  // Sets x and v to those at the limit, extrapolated. Returns false until the velocities have
  // settled within this tolerance of the jump.
  bool extrapolate(double tolerance, Motion &motion) const;

  // The sums of all impacts after the latest node, extrapolated.
  ImpactSum sum_left() const;

  const Contact &contact() const {
    return contact_;
  }
  // The change of the velocity of the mass at all impacts after the latest node.
  double latest_jump() const {
    return node(0).jump;
  }

 private:
  using Weights = std::array<double, most_chatter_nodes>;  // of the latest node first

  Contact contact_;
  // The impulse and the energy of the impacts so far, in twice the precision: what is left of a
  // chatter is the small difference of two sums over the whole.
  RealPair sum_;
  std::array<ChatterNode, most_chatter_nodes> ring_;
  std::size_t size_ = 0, newest_ = 0, impacts_ = 0, stride_ = 1;
  TwofoldInstant first_;  // the instant of the first impact
  double left_ = 0.0;     // the time from the latest node to the limit, to leading order
  double flight_time_ = 0.0, duration_ = 0.0, ratio_ = 0.0;
  double weights_ratio_ = -1.0;  // the ratio of the weights, which the least accepted nodes set
  std::array<Weights, most_chatter_nodes + 1> weights_{};  // for each number of nodes

  const ChatterNode &node(std::size_t before_latest) const;
  void set_weights(double ratio);
};

}  // namespace vibro_impact::detail
