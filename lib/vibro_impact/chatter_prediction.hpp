// What one impact of a complete chatter predicts of its limit.
//
// Near the accumulation of a chatter sequence the impact map is smooth in the impact speed v, and
// v = 0 is a curve of fixed points with multiplier r: whatever depends smoothly on the state at an
// impact lies, over consecutive impacts, on a smooth curve of any x that is itself proportional to
// v to leading order. Taken here are
//   x = 2 v / a, the flight that follows to leading order (a: the pressing acceleration then), and
//   what each impact predicts of the limit on its own. With w = x / (1 - r), a' the rate of a with
//   the mass at rest, and kappa the damping of the mass itself, c / m of its links, its chatter
//   ends after
//     w - (a' / a + kappa / 2) w^2 / 3 + O(x^3)
//   and meanwhile the others move as if it stuck: the impulse of the damper over a bounce is zero,
//   that of the spring of order x^3.
#pragma once

#include <algorithm>
#include <vector>

#include "motion.hpp"

namespace vibro_impact {

// An impact of a chatter and what it predicts of the limit.
template <int D>
struct ChatterNode {
  double flight = 0.0;                    // x, the time to the next impact to leading order
  double tail = 0.0;                      // time to the accumulation point
  double correction = 0.0;                // second-order term, taken off `tail` for one mass
  double limit = 0.0;                     // time of the accumulation point, since the first node
  typename State<D>::Lanes value, slope;  // there, and the gaps and gap speeds of the other stops
  std::vector<StopState> stops;
};

// Sets `node` to what the impact just applied to `state` at `stops` predicts of the limit of its
// chatter.
template <int D>
void predict_limit(const State<D> &state, const std::vector<std::size_t> &stops, const Scene &scene,
                   ChatterNode<D> &node) {
  using Lanes = typename State<D>::Lanes;
  const ContactMode<D> &mode = *state.mode;
  const auto change = [&](Lanes &lanes, const Eigen::MatrixXd &to_lanes, const OpenStop<D> &open,
                          double gap_rate) {
    const auto i = static_cast<Eigen::Index>(open.mass);
    lanes -= to_lanes.col(i).array() * (sign(scene.stops[open.stop].side) * gap_rate);
  };
  const auto chatters = [&](const OpenStop<D> &open) {
    return std::find(stops.begin(), stops.end(), open.stop) != stops.end();
  };
  // The lanes with the chattering masses brought to rest, and their derivatives with them held:
  // what holds them raises their gap accelerations by a, and the rates of these by a'.
  node.value = state.value;
  node.slope = state.slope;
  for (const OpenStop<D> &open : mode.open) {
    if (!chatters(open)) continue;
    const double speed = state.stops[open.stop].speed;
    change(node.slope, mode.to_modal, open, -speed);
    if (!mode.any_decay) continue;
    change(node.value, mode.velocity_to_modal, open, -speed);
    node.slope = mode.decay.select(-mode.kappa * node.value, node.slope);
  }
  const Lanes curvature = curvature_of(mode, node.value, node.slope);
  Lanes value1 = node.slope, slope1 = curvature, slope2 = -mode.lambda * node.slope;
  if (mode.any_resonant) slope2 += mode.resonant * node.slope(mode.lanes() - 2);
  Lanes pushed = Lanes::Zero(mode.lanes());
  for (const OpenStop<D> &open : mode.open) {
    if (!chatters(open)) continue;
    const double m = scene.mass[open.mass], a = open.press(node.value, node.slope) / m;
    const double rate = rate_of(open.press, node.slope, curvature) / m;
    change(slope1, mode.to_modal, open, a);
    change(slope2, mode.to_modal, open, rate);
    if (mode.any_decay) {
      change(value1, mode.velocity_to_modal, open, a);
      change(pushed, mode.velocity_to_modal, open, rate);
    }
    if (open.stop != stops.front()) continue;
    const double links =
        scene.stiffness[open.mass] +
        (open.mass + 1 < scene.stiffness.size() ? scene.stiffness[open.mass + 1] : 0.0);
    node.flight = 2.0 * state.stops[open.stop].speed / a;
    node.tail = node.flight / (1.0 - scene.restitution);
    node.correction = (rate / a + scene.beta * links / (2.0 * m)) * node.tail * node.tail / 3.0;
  }
  slope2 -= mode.kappa * slope1;
  Lanes value2 = slope1;
  if (mode.any_decay) {
    value2 = mode.decay.select(pushed - mode.kappa * value1, slope1);
    slope1 = mode.decay.select(-mode.kappa * value1, slope1);
    slope2 = mode.decay.select(-mode.kappa * value2, slope2);
  }
  // No more than half, far from the limit: the time left is not negative.
  if (stops.size() == 1)
    node.tail -= std::clamp(node.correction, -0.5 * node.tail, 0.5 * node.tail);
  const double tau = node.tail;
  node.value += tau * (value1 + (0.5 * tau) * value2);
  node.slope += tau * (slope1 + (0.5 * tau) * slope2);
  // A small gap keeps its digits when it is carried on its own.
  node.stops = state.stops;
  for (const OpenStop<D> &open : mode.open) {
    if (chatters(open)) continue;
    StopState &stop = node.stops[open.stop];
    const auto &gap = open.gap.on_value;
    stop.gap += tau * (stop.speed + (0.5 * tau) * (gap * value2).sum());
    stop.speed += tau * ((gap * slope1).sum() + (0.5 * tau) * (gap * slope2).sum());
  }
}

}  // namespace vibro_impact
