#include "vibro_impact/analysis/periodic_orbit.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "newton.hpp"
#include "orbit_tolerances.hpp"
#include "tangents.hpp"

namespace vibro_impact {

std::vector<std::size_t> free_coordinates(const Held &held) {
  std::vector<std::size_t> rows = free_masses(held);
  const std::size_t masses = rows.size();
  for (std::size_t k = 0; k < masses; ++k) rows.push_back(held.size() + rows[k]);
  return rows;
}

std::vector<double> coordinates(const MotionState &motion) {
  std::vector<double> z = motion.displacement;
  z.insert(z.end(), motion.velocity.begin(), motion.velocity.end());
  return z;
}

double time_after(const Scene &scene, const MotionState &start, int periods) {
  require(scene.omega > 0.0, "omega = ", scene.omega,
          ": a stroboscopic map needs a forcing period");
  require(periods >= 1, "periods = ", periods, ": must be at least 1");
  require(start.instant.cycle >= 0 && static_cast<double>(start.instant.cycle) <= most_periods,
          "start: period ", start.instant.cycle, ": must lie in [0, 2^53]");
  return time_of({start.instant.cycle + periods, start.instant.phase}, Clock(scene.omega));
}

StroboscopicImage stroboscopic_map_and_derivative(const Scene &scene, const MotionState &start,
                                                  int periods, const RunOptions &options) {
  Simulation simulation(scene, start, options);
  const Motion motion = next_motion(simulation, start, periods, options);
  StroboscopicImage image{motion.end(), {}, events_of(motion)};
  image.state.instant = start.instant;
  const Eigen::VectorXd units = length_units(scene);
  const Smooth<Eigen::MatrixXd> in_units = derivative_of(motion, units);
  if (in_units.exists()) {
    const std::vector<std::size_t> free = free_coordinates(start.held);
    Eigen::MatrixXd derivative = Eigen::MatrixXd::Zero(units.size(), units.size());
    derivative(Eigen::all, free) =
        units.asDiagonal() * *in_units * units(free).cwiseInverse().asDiagonal();
    image.derivative = matrix_of(derivative);
  } else {
    image.derivative = Smooth<Matrix>::none(in_units.why_not());
  }
  return image;
}

MotionState at_quiet_phase(const Scene &scene, const MotionState &start,
                           const RunOptions &options) {
  time_after(scene, start, 1);
  return quiet_section(motion_of(scene, start, 1, options));
}

MotionState state_after_periods(const Scene &scene, int periods, const RunOptions &options) {
  Simulation simulation(scene, options);
  MotionState state = require_complete(simulation.advance(time_after(scene, {}, periods))).state;
  state.instant = {};
  return state;
}

Multipliers floquet_multipliers(const Scene &scene, const Matrix &derivative, const Held &held) {
  check(scene);
  require_held(scene, held);
  const std::size_t size = 2 * held.size();
  require(derivative.rows == size && derivative.columns == size &&
              derivative.values.size() == size * size,
          "derivative: ", derivative.values.size(), " values of ", derivative.rows, " x ",
          derivative.columns, ", the chain has ", size, " coordinates");
  const std::vector<std::size_t> free = free_coordinates(held);
  const Eigen::MatrixXd map = view(derivative)(free, free);
  require(map.allFinite(), "derivative: all values must be finite");
  const Eigen::VectorXd units = length_units(scene)(free);
  return eigenvalues_of(units.cwiseInverse().asDiagonal() * map * units.asDiagonal());
}

Stability PeriodicOrbit::stability() const {
  if (!converged || !multipliers.exists()) return Stability::unknown;
  const double largest = largest_modulus(*multipliers);
  if (std::abs(largest - 1.0) <= neutral_modulus) return Stability::neutral;
  return largest < 1.0 ? Stability::stable : Stability::unstable;
}

const char *name(Stability stability) {
  constexpr std::array<const char *, 4> names{"stable", "neutral", "unstable", "unknown"};
  const auto k = static_cast<std::size_t>(stability);
  require(k < names.size(), "stability = ", k, ": there are 0 to ", names.size() - 1);
  return names[k];
}

PeriodicOrbit find_periodic_orbit(const Scene &scene, const MotionState &guess, int periods,
                                  int most_iterations) {
  require(most_iterations >= 0, "most_iterations = ", most_iterations, ": must be non-negative");
  check(scene);
  const MotionState start = moved_into(scene, guess);
  time_after(scene, start, periods);
  PeriodicOrbit orbit = as_periodic_orbit(newton(scene, start, periods, most_iterations));
  if (orbit.residuals.empty()) orbit.state = start;
  orbit.state.instant.cycle = start.instant.cycle;
  return orbit;
}

}  // namespace vibro_impact
