#include "newton.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

#include "orbit_tolerances.hpp"
#include "tangents.hpp"

namespace vibro_impact {

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

Multipliers eigenvalues_of(const Eigen::MatrixXd &matrix) {
  if (matrix.size() == 0) return {};
  const Eigen::VectorXcd found = Eigen::EigenSolver<Eigen::MatrixXd>(matrix, false).eigenvalues();
  Multipliers multipliers(found.begin(), found.end());
  std::ranges::sort(multipliers, std::greater(), [](const auto &z) { return std::abs(z); });
  return multipliers;
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

}  // namespace vibro_impact
