// What is zero at a multi-sliding bifurcation (Section 3.2) and at a grazing (Section 3.3): the
// least pressing force inside a sticking phase, the least gap between impacts, of the motion over
// one forcing period. Both are smooth functions of a parameter as far as the motion is.
#pragma once

#include <optional>
#include <vector>

#include "locate.hpp"
#include "periodic_orbit.hpp"
#include "pressing_force.hpp"

namespace vibro_impact {

// The pressing force on mass `stop.mass` and its time derivative: there the neighbours' velocities
// and accelerations take the place of their displacements and velocities, and the stop stands.
inline OscillatorState<double> pressing_force_and_rate(const Scene &scene, const Stop &stop,
                                                       const MotionState &at) {
  const auto p = static_cast<Eigen::Index>(stop.mass - 1);
  Eigen::VectorXd x = at.displacement, v = at.velocity;
  x(p) = stop.position;
  v(p) = 0.0;
  const Eigen::VectorXd a = acceleration(scene, at.held, x, v, at.instant);
  const auto of = [](const Eigen::VectorXd &values) {
    return [&values](int mass) { return values(mass - 1); };
  };
  const double phase = at.instant.phase;
  const double amplitude = scene.forced() ? scene.amplitude[static_cast<std::size_t>(p)] : 0.0;
  return {pressing_force(scene, stop, phase, of(x), of(v)),
          sign(stop.side) * (force_of_links(scene, stop.mass, 0.0, of(v), of(a)) -
                             amplitude * scene.omega * std::sin(scene.omega * phase))};
}

namespace detail {

// Values at uniform times of what is zero at a bifurcation; NaN where it is not defined.
template <class Reading>
struct WatchRecorder {
  Reading reading;
  double from = 0.0, to = 0.0, every = 0.0;
  std::vector<double> values = {};

  double next_time() const {
    return sample_time(from, to, every, values.size());
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
      [&](const MotionState &at) { return pressing_force_and_rate(scene, stop, at); });
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

}  // namespace vibro_impact
