#include "vibro_impact/analysis/periodic_orbit.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
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

Multipliers eigenvalues_of(const Eigen::MatrixXd &matrix) {
  if (matrix.size() == 0) return {};
  const Eigen::VectorXcd found = Eigen::EigenSolver<Eigen::MatrixXd>(matrix, false).eigenvalues();
  Multipliers multipliers(found.begin(), found.end());
  std::ranges::sort(multipliers, std::greater(), [](const auto &z) { return std::abs(z); });
  return multipliers;
}

namespace {

// The state with its free lengths, in the order of `free_coordinates`, moved by a step.
MotionState moved_by(const Eigen::VectorXd &step, const Eigen::VectorXd &units, MotionState at) {
  const std::size_t n = at.held.size();
  Eigen::Index k = 0;
  for (const std::size_t row : free_coordinates(at.held))
    (row < n ? at.displacement[row] : at.velocity[row - n]) +=
        step(k++) * units(static_cast<Eigen::Index>(row));
  return at;
}

bool any_is_beyond_its_stop(const Scene &scene, const MotionState &at) {
  return std::ranges::any_of(scene.stops, [&at](const Stop &stop) {
    return is_beyond(stop, at.displacement[index_of(stop.mass)]);
  });
}

}  // namespace

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

NewtonOrbit newton(const Scene &scene, const MotionState &guess, int periods, int most,
                   const RunOptions &options, NewtonGuess kind) {
  const std::vector<double> frequencies = local_frequencies(scene);
  const Eigen::VectorXd units = length_units(scene);
  const std::vector<std::size_t> free = free_coordinates(guess.held);
  const auto n = static_cast<Eigen::Index>(free.size());
  NewtonOrbit orbit{.guess = lengths(frequencies, guess)(free)};
  Smooth<Eigen::MatrixXd> derivative;
  double best = infinity, size_of_guess = 0.0;
  MotionState at = guess;
  at.instant.cycle = 0;
  const auto ended = [&orbit](std::string why) {
    orbit.why_not = std::move(why);
    return orbit;
  };
  for (int iteration = 0;; ++iteration) {
    Motion motion = motion_of(scene, at, periods, options);
    if (motion.end().held != at.held)
      return ended(line("iterate ", iteration, ": returns with other masses held (",
                        contact_mode_name(motion.end().held), ") than it starts with (",
                        contact_mode_name(at.held), ")"));
    const Eigen::VectorXd z = lengths(frequencies, at)(free),
                          image = lengths(frequencies, motion.end())(free);
    const double before = orbit.residuals.empty() ? infinity : orbit.residuals.back(),
                 residual = (image - z).stableNorm(),
                 size = std::max(size_of(motion), size_of_guess);
    if (!std::isfinite(residual))
      return ended(line("iterate ", iteration, ": the map or its derivative is not finite"));
    orbit.residuals.push_back(residual);
    if (iteration == 0) size_of_guess = size;
    if (iteration == 0) orbit.image_of_guess = image;
    orbit.found = residual <= newton_tolerance * size ||
                  (residual <= rounding_of_orbit * size && residual > 0.5 * before);
    if (kind == NewtonGuess::late_motion && residual > before && !orbit.found)
      return ended(line("residual = ", residual, " rises in iteration ", iteration));
    if (kind == NewtonGuess::anywhere || orbit.found || residual > much_nearer * before ||
        iteration == 0)
      derivative = derivative_of(motion, units);
    // Without a derivative no step leads nearer.
    orbit.found = orbit.found || (!derivative.exists() && residual <= rounding_of_orbit * size);
    if (orbit.found || residual < best) {
      best = residual;
      orbit.z = z;
      orbit.size = size;
      orbit.motion = std::move(motion);
      orbit.derivative = derivative.exists()
                             ? Smooth<Eigen::MatrixXd>((*derivative)(free, Eigen::all))
                             : derivative;
    }
    if (orbit.found) return orbit;
    if (iteration == most)
      return ended(line("residual = ", best, " after ", iteration, " iterations: above ",
                        newton_tolerance * size));
    if (!derivative.exists()) return ended(line("iterate ", iteration, ": ", derivative.why_not()));
    const Eigen::MatrixXd matrix =
        Eigen::MatrixXd::Identity(n, n) - (*derivative)(free, Eigen::all);
    const Eigen::VectorXd step =
        n > 0 ? Eigen::VectorXd(matrix.partialPivLu().solve(image - z)) : Eigen::VectorXd();
    // A multiplier that rounding keeps from 1 leads so far away that any state there would count.
    if (!step.allFinite() || newton_tolerance * step.stableNorm() >= residual)
      return ended(line("iterate ", iteration, ": a Floquet multiplier is 1, no step leads on"));
    at = moved_by(step, units, at);
    if (any_is_beyond_its_stop(scene, at))
      return ended(line("iterate ", iteration + 1, ": a mass is beyond its stop"));
  }
}

Smooth<Multipliers> multipliers_of(const NewtonOrbit &orbit) {
  if (!orbit.derivative.exists()) return Smooth<Multipliers>::none(orbit.derivative.why_not());
  return eigenvalues_of(*orbit.derivative);
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

PeriodicOrbit as_periodic_orbit(const NewtonOrbit &orbit) {
  if (orbit.motion.knots.empty())
    return {.multipliers = Smooth<Multipliers>::none(orbit.why_not), .why_not = orbit.why_not};
  return {.state = orbit.motion.start(),
          .multipliers = multipliers_of(orbit),
          .converged = orbit.found,
          .why_not = orbit.why_not,
          .residuals = orbit.residuals,
          .events = events_of(orbit.motion)};
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
