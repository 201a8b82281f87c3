// Bifurcation points of a settled motion in the forcing frequency (or any other parameter): where a
// count of events changes, where the hold force of a sticking mass becomes tangent to zero
// (multi-sliding, Section 3.2), where a chatter just fails to complete (border orbits), and where a
// mass grazes its stop (Section 3.3).
//
// Each is found in two ways. Bisection on the number of sticking phases of a motion from rest needs
// no theory. Beside it stands a smooth function of the parameter, computed on the periodic orbit,
// whose zero is the bifurcation.
#pragma once

#include <algorithm>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <stdexcept>
#include <utility>
#include <vector>

#include "periodic_orbit.hpp"

namespace vibro_impact {

// A located parameter value and its estimated absolute error.
struct Located {
  double value = 0.0, error = 0.0;
};

// --- Counting
// -------------------------------------------------------------------------------------

// Sticking phases of `mass` (from 1) begun within `periods` forcing periods, after `settling` ones,
// of the motion from the scene's own initial state.
inline int sticking_phases(const Scene &scene, int mass, int settling, int periods,
                           const RunOptions &options = {}) {
  const Clock clock(scene.omega);
  EventRecorder recorder;
  recorder.from = time_of({settling, 0.0}, clock);
  simulate(scene, time_of({settling + periods, 0.0}, clock), options, recorder);
  return static_cast<int>(std::count_if(
      recorder.events.begin(), recorder.events.end(),
      [mass](const Event &event) { return event.kind == EventKind::stick && event.mass == mass; }));
}

// Two neighbouring parameter values with different counts.
struct Change {
  double below = 0.0, above = 0.0;
  int count_below = 0, count_above = 0;
};

// Bisects [below, above] for the place where `count` first differs from its value at `below`, down
// to `width` (0: neighbouring floating-point numbers). Throws std::invalid_argument when the counts
// at the ends agree.
template <class Count>
Change bisect(Count &&count, double below, double above, double width = 0.0) {
  Change change{below, above, count(below), count(above)};
  if (change.count_below == change.count_above)
    throw std::invalid_argument(fmt::format("count = {} at both {} and {}: no change to locate",
                                            change.count_below, below, above));
  while (change.above - change.below > width) {
    const double middle = 0.5 * (change.below + change.above);
    if (!(change.below < middle && middle < change.above)) break;
    const int counted = count(middle);
    if (counted == change.count_below) {
      change.below = middle;
    } else {
      change.above = middle;
      change.count_above = counted;
    }
  }
  return change;
}

// --- Zeros
// ----------------------------------------------------------------------------------------

// The zero of f in [below, above], where it changes sign.
template <class Function>
Located zero(Function &&f, double below, double above) {
  std::uintmax_t steps = 100;
  const double at_below = f(below), at_above = f(above);
  if (!(at_below * at_above <= 0.0))
    throw std::invalid_argument(fmt::format("f = {} at {} and {} at {}: no change of sign",
                                            at_below, below, at_above, above));
  if (at_below == 0.0) return {below, 0.0};
  if (at_above == 0.0) return {above, 0.0};
  const auto [a, b] = boost::math::tools::toms748_solve(
      f, below, above, at_below, at_above, boost::math::tools::eps_tolerance<double>(52), steps);
  return {0.5 * (a + b), 0.5 * (b - a)};
}

// The zero of a function that exists, positive and falling, on one side of it only: inverse
// interpolation from that side, never stepping across. `far` and `near` are two points on it,
// f(far) > f(near) > 0. The error estimate is the last correction.
template <class Function>
Located zero_from_one_side(Function &&f, double far, double near) {
  std::vector<std::pair<double, double>> points{{far, f(far)}, {near, f(near)}};
  Located root{near, std::abs(far - near)};
  for (int step = 0; step < 40; ++step) {
    if (!(points.back().second > 0.0) || points.back().second >= points[points.size() - 2].second)
      throw std::runtime_error(fmt::format("f = {} at {}: not falling to zero",
                                           points.back().second, points.back().first));
    // x as a polynomial in f through the last four points, at f = 0.
    const std::size_t first = points.size() > 4 ? points.size() - 4 : 0;
    double estimate = 0.0;
    for (std::size_t i = first; i < points.size(); ++i) {
      double weight = 1.0;
      for (std::size_t j = first; j < points.size(); ++j)
        if (j != i) weight *= points[j].second / (points[j].second - points[i].second);
      estimate += weight * (points[i].first - near);
    }
    estimate += near;
    const double correction = std::abs(estimate - root.value);
    root = {estimate, correction};
    const double distance = estimate - points.back().first;
    if (step > 2 && std::abs(distance) < 1e-10 * std::abs(estimate)) break;
    const double next = estimate - distance / 8;
    points.emplace_back(next, f(next));
  }
  return root;
}

// --- Hold force and multi-sliding
// -------------------------------------------------------------------

// The force that presses mass `stop.mass`, at rest at its stop, into it (Eqs. 12-13 times the sign
// of the side), and its time derivative.
inline OscillatorState<double> pressing_force(const Scene &scene, const Stop &stop,
                                              const MotionState &at) {
  const auto p = static_cast<Eigen::Index>(stop.mass - 1);
  Eigen::VectorXd x = at.displacement, v = at.velocity;
  x(p) = stop.position;
  v(p) = 0.0;
  Eigen::VectorXd a = acceleration(scene, at.held, x, v, at.instant);
  a(p) = 0.0;
  const double sigma = sign(stop.side), angle = scene.omega * at.instant.phase;
  const double amplitude = scene.forced() ? scene.amplitude[static_cast<std::size_t>(p)] : 0.0;
  return {sigma * (link_forces(scene, x + scene.beta * v)(p) + amplitude * std::cos(angle)),
          sigma * (link_forces(scene, v + scene.beta * a)(p) -
                   amplitude * scene.omega * std::sin(angle))};
}

namespace detail {

// Values at uniform times of what is zero at a bifurcation; NaN where it is not defined.
template <class Reading>
struct WatchRecorder {
  Reading reading;
  double from = 0.0, to = 0.0, every = 0.0;
  std::vector<double> values = {};

  double next_time() const {
    const double next = from + every * static_cast<double>(values.size());
    return next < to ? next : std::numeric_limits<double>::infinity();
  }
  void sample(const Moment &moment) {
    values.push_back(reading(moment));
  }
};

// Least interior local minimum, over one period from `start`, of a quantity: found among samples of
// `coarse`, then sharpened as the zero of `rate` at the state there.
template <class Coarse, class Exact>
std::optional<double> least_minimum(const Scene &scene, const MotionState &start, Coarse coarse,
                                    Exact exact) {
  const Clock clock(scene.omega);
  const double from = time_of(start.instant, clock);
  WatchRecorder<Coarse> watch{coarse, from, from + clock.period, clock.period / 4096};
  stroboscopic_map(scene, start, 1, {}, watch);
  std::optional<double> least;
  for (std::size_t i = 1; i + 1 < watch.values.size(); ++i) {
    // False beside a NaN: only minima inside a phase count.
    if (!(watch.values[i] <= watch.values[i - 1] && watch.values[i] < watch.values[i + 1]))
      continue;
    const auto time = [&](std::size_t k) { return from + watch.every * static_cast<double>(k); };
    const auto state_at = [&](double t) { return simulate_from(scene, start, t, {}).state; };
    const auto rate = [&](double t) { return exact(state_at(t)).slope; };
    if (!(rate(time(i - 1)) < 0.0 && rate(time(i + 1)) > 0.0)) continue;  // a kink, not a minimum
    const Located at = zero(rate, time(i - 1), time(i + 1));
    const double value = exact(state_at(at.value)).value;
    if (!least || value < *least) least = value;
  }
  return least;
}

}  // namespace detail

// Least interior local minimum of the pressing force over the sticking phases of `stop` in the
// period after `start`: where it reaches zero the phase is about to split (multi-sliding). Nothing
// when the force has no minimum inside a phase.
inline std::optional<double> least_pressing_force(const Scene &scene, const MotionState &start,
                                                  const Stop &stop) {
  return detail::least_minimum(
      scene, start,
      [&](const Moment &moment) { return sign(stop.side) * moment.hold_force(stop.mass); },
      [&](const MotionState &at) { return pressing_force(scene, stop, at); });
}

// Least local minimum of the gap of `mass` to a stop (which the scene need not contain) in the
// period after `start`: where it reaches zero the mass grazes the stop.
inline std::optional<double> least_gap(const Scene &scene, const MotionState &start,
                                       const Stop &stop) {
  const double sigma = sign(stop.side);
  return detail::least_minimum(
      scene, start,
      [&](const Moment &moment) {
        return sigma * (stop.position - moment.displacement(stop.mass));
      },
      [&](const MotionState &at) {
        const auto i = static_cast<Eigen::Index>(stop.mass - 1);
        return OscillatorState<double>{sigma * (stop.position - at.displacement(i)),
                                       -sigma * at.velocity(i)};
      });
}

// --- Following an orbit
// -----------------------------------------------------------------------------

// The periodic orbit of `scene` near `seed`: by Newton's method, or where that fails (a border in
// between) by following the motion for `settling` periods.
inline MotionState orbit_near(const Scene &scene, const MotionState &seed, int periods,
                              const RunOptions &options, int settling = 200) {
  NewtonOptions newton;
  newton.run = options;
  const PeriodicOrbit orbit = find_periodic_orbit(scene, seed, periods, newton);
  if (orbit.converged) return orbit.state;
  return stroboscopic_map(scene, seed, settling - settling % periods, options).state;
}

// --- Border orbits
// ----------------------------------------------------------------------------------

// On a border orbit the accumulation point of the chatter is also the zero of the pressing force.
// With v the speed after an impact, a the pressing acceleration there and b = -a' > 0, the flight s
// (in units of a / b) that follows obeys v b / a^2 = s/2 - s^2/6, and the chatter is self-similar
// where the next impact has the same v b / a^2:
//   (3 - s) (1 - s)^2 = r (3 - 2 s).
// Pressing force and speed then fall by the factors below; the fixed point repels the neighbouring
// orbits by `escape` per impact: a chatter that completes turns towards speed ratio r, one that
// does not falls below the ratio of the border orbit, and its mass is let go.
struct BorderChatter {
  double flight = 0.0;       // s
  double press_ratio = 0.0;  // 1 - s
  double speed_ratio = 0.0;  // (1 - s)^2
  double escape = 0.0;
};

// Throws std::invalid_argument unless 0 < r < 1.
inline BorderChatter border_chatter(double r) {
  if (!(r > 0.0 && r < 1.0))
    throw std::invalid_argument(
        fmt::format("restitution = {}: a border chatter needs 0 < r < 1", r));
  const auto balance = [r](double s) { return (3 - s) * (1 - s) * (1 - s) - r * (3 - 2 * s); };
  const double s = zero(balance, 0.0, 1.0).value, q = 1 - s;
  const double by_flight =
      r * ((0.5 - 2 * s / 3) / (q * q) + 2 * (s / 2 - s * s / 3) / (q * q * q));
  return {s, q, q * q, by_flight / (0.5 - s / 3)};
}

// One sequence of impacts of one mass on a followed orbit, each slower than the one before.
struct FallingSequence {
  double begin = 0.0;          // time of the first impact since the start of the run
  std::vector<double> speeds;  // just before the impacts
  bool complete = false;       // it ended in sticking
};

// All of them in `periods` forcing periods from `start`; chatter is resolved impact by impact down
// to rounding.
inline std::vector<FallingSequence> falling_sequences(const Scene &scene, const MotionState &start,
                                                      int mass, int periods) {
  const Clock clock(scene.omega);
  RunOptions every_impact;
  every_impact.resolve_chatter = 0.0;
  EventRecorder recorder;
  recorder.from = -std::numeric_limits<double>::infinity();
  stroboscopic_map(scene, start, periods, every_impact, recorder);
  std::vector<FallingSequence> sequences;
  bool open = false;
  for (const Event &event : recorder.events) {
    if (event.mass != mass) continue;
    if (event.kind != EventKind::impact) {
      if (event.kind == EventKind::stick && open) sequences.back().complete = true;
      open = false;
      continue;
    }
    const double speed = std::abs(event.velocity_before);
    if (!open || !(speed < sequences.back().speeds.back()))
      sequences.push_back({elapsed(start.instant, event.instant, clock), {}, false});
    sequences.back().speeds.push_back(speed);
    open = true;
  }
  return sequences;
}

struct BorderOrbit {
  Located parameter;
  int depth = 0;                // impacts resolved before the accumulation point
  double convergence = 0.0;     // observed factor per impact; press_ratio / escape is expected
  double speed_at_depth = 0.0;  // the slowest impact used
};

// The border orbit of `mass` between two parameter values: the chatter that sticks at `complete`
// and does not at `incomplete`. `scene_at(parameter)` gives the scene; `seed` lies on the orbit at
// `complete`, of `periods` forcing periods, away from events (`at_quiet_phase`), and `chatter` is
// the time from there to the first impact of the sequence.
//
// The zero in the parameter of (ratio of the speeds of impacts n and n + 1) - speed_ratio converges
// with n by press_ratio / escape per impact; no sticking is decided on the way. Nothing when the
// ratio does not change sign: the sequence completes, or fails to, at both values.
template <class SceneAt>
std::optional<BorderOrbit> find_border_orbit(SceneAt &&scene_at, int mass, const MotionState &seed, double chatter,
                              int periods, double complete, double incomplete) {
  const BorderChatter border = border_chatter(scene_at(complete).restitution);
  RunOptions every_impact;
  every_impact.resolve_chatter = 0.0;
  double slowest = 0.0;
  const auto excess = [&](double parameter, std::size_t n) {
    const Scene scene = scene_at(parameter);
    const MotionState at = orbit_near(scene, seed, periods, every_impact);
    const auto sequences = falling_sequences(scene, at, mass, periods);
    const auto found =
        std::min_element(sequences.begin(), sequences.end(), [&](const auto &a, const auto &b) {
          return std::abs(a.begin - chatter) < std::abs(b.begin - chatter);
        });
    if (found == sequences.end()) return -border.speed_ratio;
    if (found->speeds.size() < n + 2)
      return found->complete ? scene.restitution - border.speed_ratio : -border.speed_ratio;
    slowest = found->speeds[n + 1];
    return found->speeds[n + 1] / found->speeds[n] - border.speed_ratio;
  };
  BorderOrbit result;
  const double below = std::min(complete, incomplete), above = std::max(complete, incomplete);
  double last = std::numeric_limits<double>::quiet_NaN(), last_step = last;
  constexpr int stride = 6;
  for (int n = 12; n <= 60; n += stride) {
    const auto f = [&](double parameter) { return excess(parameter, static_cast<std::size_t>(n)); };
    // Early in the chatter the zero may still lie outside.
    if (!(f(complete) > 0.0 && f(incomplete) < 0.0)) continue;
    const Located root = zero(f, below, above);
    f(root.value);
    const double step = std::abs(root.value - last), noise = 4e-16 * std::abs(root.value);
    result = {
        {root.value, std::max(step, noise)}, n, std::pow(step / last_step, 1.0 / stride), slowest};
    if (step <= 8.0 * noise) break;
    last = root.value;
    last_step = step;
  }
  if (!std::isfinite(result.parameter.error) || result.depth == 0)
    throw std::runtime_error(
        fmt::format("mass {}: no border orbit between {} and {}", mass, complete, incomplete));
  return result;
}

}  // namespace vibro_impact
