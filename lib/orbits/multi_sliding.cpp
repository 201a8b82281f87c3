#include "vibro_impact/multi_sliding.hpp"

#include <cmath>
#include <functional>
#include <utility>
#include <vector>

#include "fits.hpp"
#include "motion_state.hpp"
#include "vibro_impact/locate.hpp"
#include "vibro_impact/periodic_orbit.hpp"

namespace vibro_impact {

namespace {

// What is zero at a bifurcation: as a run tells of it, NaN where it is not defined, and from a
// state.
struct Quantity {
  std::function<double(const Moment &)> reading;
  std::function<bool(const MotionState &)> defined;
  std::function<double(const MotionState &)> value, rate;
};

// Its values at uniform times.
struct QuantityRecorder {
  const Quantity &quantity;
  double from, to, every;
  std::vector<double> values = {};

  double next_time() const {
    return sample_time(from, to, every, values.size());
  }
  void sample(const Moment &moment) {
    values.push_back(quantity.reading(moment));
  }
};

// Least interior local minimum over one period from `start`: found among samples, then sharpened as
// the zero of the rate of the state there.
std::optional<LeastValue> least_minimum(const Scene &scene, MotionState start,
                                        const Quantity &quantity) {
  start.instant.cycle = 0;  // times are then exact phases; to the motion all cycles are the same
  const double from = start.instant.phase, period = Clock(scene.omega).period;
  QuantityRecorder samples{quantity, from, from + period, period / 4096};
  stroboscopic_map(scene, start, 1, {}, samples);
  const auto time = [&samples](std::size_t k) {
    return samples.from + samples.every * static_cast<double>(k);
  };
  const auto state_at = [&](double t) {
    return require_complete(simulate_from(scene, start, t)).state;
  };
  const auto rate = [&](double t) { return quantity.rate(state_at(t)); };
  std::optional<LeastValue> least;
  const std::vector<double> &values = samples.values;
  for (std::size_t i = 1; i + 1 < values.size(); ++i) {
    // False beside a NaN: only minima inside a phase count.
    if (!(values[i] <= values[i - 1] && values[i] < values[i + 1])) continue;
    if (!quantity.defined(state_at(time(i)))) continue;
    if (!(rate(time(i - 1)) < 0.0 && rate(time(i + 1)) > 0.0)) continue;  // a kink, not a minimum
    MotionState at = state_at(zero(rate, time(i - 1), time(i + 1)).value);
    const double value = quantity.value(at);
    if (!least || value < least->value) least = {value, std::move(at)};
  }
  return least;
}

void require_stop(const Scene &scene, const Stop &stop) {
  check(scene);
  require_mass(scene, stop.mass);
  require(std::isfinite(stop.position), "stop on mass ", stop.mass, " at ", stop.position,
          ": must be finite");
}

}  // namespace

std::optional<LeastValue> where_pressing_force_is_least(const Scene &scene,
                                                        const MotionState &start,
                                                        const Stop &stop) {
  require_stop(scene, stop);
  return least_minimum(
      scene, start,
      {[&](const Moment &moment) { return sign(stop.side) * moment.hold_force(stop.mass); },
       // Not held at the stop across.
       [&](const MotionState &at) { return holds(stop, at.held); },
       [&](const MotionState &at) { return pressing_force(scene, stop, at); },
       [&](const MotionState &at) { return pressing_force_rate(scene, stop, at); }});
}

std::optional<LeastValue> where_gap_is_least(const Scene &scene, const MotionState &start,
                                             const Stop &stop) {
  require_stop(scene, stop);
  const double sigma = sign(stop.side);
  const auto p = static_cast<std::size_t>(stop.mass - 1);
  return least_minimum(
      scene, start,
      {[&](const Moment &moment) {
         return sigma * (stop.position - moment.displacement(stop.mass));
       },
       [](const MotionState &) { return true; },
       [&](const MotionState &at) { return sigma * (stop.position - at.displacement[p]); },
       [&](const MotionState &at) { return -sigma * at.velocity[p]; }});
}

std::optional<double> least_pressing_force(const Scene &scene, const MotionState &start,
                                           const Stop &stop) {
  const auto least = where_pressing_force_is_least(scene, start, stop);
  return least ? std::optional(least->value) : std::nullopt;
}

std::optional<double> least_gap(const Scene &scene, const MotionState &start, const Stop &stop) {
  const auto least = where_gap_is_least(scene, start, stop);
  return least ? std::optional(least->value) : std::nullopt;
}

}  // namespace vibro_impact
