#include "vibro_impact/analysis/minima.hpp"

#include <algorithm>
#include <functional>
#include <utility>
#include <vector>

#include "change_flow.hpp"
#include "motion_state.hpp"
#include "tolerances.hpp"
#include "vibro_impact/analysis/locate.hpp"
#include "vibro_impact/analysis/periodic_orbit.hpp"

namespace vibro_impact {

namespace {

// What is zero at a bifurcation, where it is defined, and its time derivative.
struct Quantity {
  std::function<bool(const MotionState &)> defined;
  std::function<double(const MotionState &)> value, rate;
};

// Where the quantity falls, and whether it rises at the next node. Nodes are the events, on both
// sides of which the motion is looked at, and uniform times close enough for the fastest mode.
struct MinimumRecorder {
  const Scene &scene;
  const Quantity &quantity;
  Held held;
  double from, to, every;
  std::size_t asked = 0;
  std::optional<MotionState> falling = {};
  struct Bracket {
    MotionState start;
    double length;
    bool rises;  // at its end
  };
  std::vector<Bracket> brackets = {};

  double next_time() const {
    return sample_time(from, to, every, asked);
  }
  void sample(const Moment &moment) {
    ++asked;
    const MotionState at = state_at(moment, held);
    node(at, at);
  }
  void event(const Event &event, const Moment &moment) {
    MotionState before = state_at(moment, held);
    if (event.kind == EventKind::impact)
      before.velocity[static_cast<std::size_t>(event.mass - 1)] = event.velocity_before;
    held = event.held;
    node(before, state_at(moment, held));
  }
  void node(const MotionState &before, const MotionState &after) {
    if (falling && quantity.defined(before))
      brackets.push_back({*falling, elapsed(falling->instant, before.instant, Clock(scene.omega)),
                          quantity.rate(before) > 0.0});
    falling.reset();
    if (quantity.defined(after) && quantity.rate(after) < 0.0) falling = after;
  }
};

// The motion later, no event in between.
MotionState flown(const Scene &scene, const MotionState &from, double time) {
  PlainMotion motion{view(from.displacement), view(from.velocity)};
  Eigen::MatrixXd none(2 * motion.displacement.size(), 0);
  carry(scene, {}, from.held, from.instant.phase, time, motion, none);
  return {later(from.instant, time, Clock(scene.omega)),
          {motion.displacement.begin(), motion.displacement.end()},
          {motion.velocity.begin(), motion.velocity.end()},
          from.held};
}

// Where the rate is largest between two nodes at which it is negative, if there: a minimum and a
// maximum may lie between them.
std::optional<double> largest_between(const std::function<double(double)> &rate, double length) {
  const double step = curvature_step * length;
  const auto bend = [&](double time) { return rate(time + step) - rate(time); };
  if (!(bend(0.0) > 0.0 && bend(length - step) < 0.0)) return std::nullopt;
  return zero(bend, 0.0, length - step).value + 0.5 * step;
}

// Least interior local minimum over one period from `start`: the zero of the rate between nodes.
std::optional<LeastValue> least_minimum(const Scene &scene, MotionState start,
                                        const Quantity &quantity) {
  start.instant.cycle = 0;  // times are then exact phases; to the motion all cycles are the same
  const double from = start.instant.phase, period = Clock(scene.omega).period,
               every = std::min(period / 64.0, 0.125 / rate_of(scene));
  require(period <= 1e8 * every, "rate = ", rate_of(scene),
          ": too fast to look at a whole forcing period of ", period);
  MinimumRecorder nodes{scene, quantity, start.held, from, from + period, every};
  stroboscopic_map(scene, start, 1, {}, nodes);
  std::optional<LeastValue> least;
  for (const auto &[at, length, rises] : nodes.brackets) {
    const auto rate = [&, &node = at](double t) { return quantity.rate(flown(scene, node, t)); };
    const std::optional<double> until =
        rises ? std::optional(length) : largest_between(rate, length);
    if (!until || !(rate(*until) > 0.0)) continue;  // at the node itself, to rounding
    MotionState lowest = flown(scene, at, zero(rate, 0.0, *until).value);
    const double value = quantity.value(lowest);
    if (!least || value < least->value) least = {value, std::move(lowest)};
  }
  return least;
}

}  // namespace

std::optional<LeastValue> least_pressing_force(const Scene &scene, const MotionState &start,
                                               const Stop &stop) {
  require_stop(scene, stop);
  return least_minimum(
      scene, start,
      {[&](const MotionState &at) { return holds(stop, at.held); },  // not at the stop across
       [&](const MotionState &at) { return pressing_force(scene, stop, at); },
       [&](const MotionState &at) { return pressing_force_rate(scene, stop, at); }});
}

std::optional<LeastValue> least_gap(const Scene &scene, const MotionState &start,
                                    const Stop &stop) {
  require_stop(scene, stop);
  const double sigma = sign(stop.side);
  const auto p = static_cast<std::size_t>(stop.mass - 1);
  return least_minimum(
      scene, start,
      {[p](const MotionState &at) { return at.held[p] == 0; },
       [&](const MotionState &at) { return sigma * (stop.position - at.displacement[p]); },
       [&](const MotionState &at) { return -sigma * at.velocity[p]; }});
}

}  // namespace vibro_impact
