#include "periodic_orbit.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>

namespace vibro_impact {

std::vector<Eigen::Index> free_coordinates(const Held &held) {
  std::vector<Eigen::Index> rows;
  const auto n = static_cast<Eigen::Index>(held.size());
  for (Eigen::Index part : {Eigen::Index{0}, n})
    for (Eigen::Index i = 0; i < n; ++i)
      if (held[static_cast<std::size_t>(i)] == 0) rows.push_back(part + i);
  return rows;
}

Eigen::VectorXd coordinates(const MotionState &motion) {
  Eigen::VectorXd z(2 * motion.displacement.size());
  z << motion.displacement, motion.velocity;
  return z;
}

StroboscopicImage stroboscopic_map_and_derivative(const Scene &scene, const MotionState &start,
                                                  int periods, const RunOptions &options) {
  const auto n = static_cast<Eigen::Index>(start.held.size());
  const std::vector<Eigen::Index> free = free_coordinates(start.held);
  Eigen::MatrixXd columns = Eigen::MatrixXd::Zero(2 * n, static_cast<Eigen::Index>(free.size()));
  for (std::size_t k = 0; k < free.size(); ++k) columns(free[k], static_cast<Eigen::Index>(k)) = 1;
  TangentRecorder tangents(scene, start, columns);
  const double until = detail::time_after(scene, start, periods);
  const Outcome end = simulate_from(scene, start, until, options, tangents);
  tangents.finish(end.state.instant);
  StroboscopicImage image{end.state, Eigen::MatrixXd::Zero(2 * n, 2 * n), tangents.differentiable,
                          tangents.chatter_error, end.counters};
  image.state.instant = start.instant;
  for (std::size_t k = 0; k < free.size(); ++k)
    image.derivative.col(free[k]) = tangents.tangent.col(static_cast<Eigen::Index>(k));
  return image;
}

MotionState at_quiet_phase(const Scene &scene, const MotionState &start,
                           const RunOptions &options) {
  const Clock clock(scene.omega);
  EventRecorder recorder;
  stroboscopic_map(scene, start, 1, options, recorder);
  double after = 0.0, widest = 0.0, last = 0.0;
  std::vector<double> times;
  for (const Event &event : recorder.events)
    times.push_back(elapsed(start.instant, event.instant, clock));
  // The motion need not be periodic: only intervals inside the period count.
  times.push_back(clock.period);
  for (double time : times) {
    if (time - last > widest) {
      widest = time - last;
      after = 0.5 * (last + time);
    }
    last = time;
  }
  const double until = time_of(start.instant, clock) + after;
  MotionState state = simulate_from(scene, start, until, options).state;
  state.instant.cycle = 0;
  return state;
}

MotionState settled(const Scene &scene, int periods, const RunOptions &options) {
  const MotionState start = start_of(scene);
  return stroboscopic_map(scene, start, periods, options).state;
}

Eigen::VectorXcd floquet_multipliers(const Eigen::MatrixXd &derivative, const Held &held) {
  const std::vector<Eigen::Index> free = free_coordinates(held);
  if (free.empty()) return {};
  Eigen::VectorXcd multipliers =
      Eigen::EigenSolver<Eigen::MatrixXd>(derivative(free, free), false).eigenvalues();
  std::sort(multipliers.begin(), multipliers.end(),
            [](const auto &a, const auto &b) { return std::abs(a) > std::abs(b); });
  return multipliers;
}

PeriodicOrbit find_periodic_orbit(const Scene &scene, const MotionState &guess, int periods,
                                  const NewtonOptions &options) {
  const std::vector<Eigen::Index> free = free_coordinates(guess.held);
  const auto unknowns = static_cast<Eigen::Index>(free.size());
  PeriodicOrbit orbit;
  orbit.periods = periods;
  orbit.state = guess;
  Eigen::VectorXd z = coordinates(guess);
  const Eigen::Index n = z.size() / 2;
  double best = std::numeric_limits<double>::infinity();
  for (int iteration = 0; iteration <= options.max_iterations; ++iteration) {
    MotionState at = guess;
    at.displacement = z.head(n);
    at.velocity = z.tail(n);
    const StroboscopicImage image =
        stroboscopic_map_and_derivative(scene, at, periods, options.run);
    orbit.expansions += image.counters.expansions;
    if (image.state.held != guess.held) return orbit;
    const Eigen::VectorXd residual = (coordinates(image.state) - z)(free);
    const double size = unknowns == 0 ? 0.0 : residual.cwiseAbs().maxCoeff();
    orbit.residuals.push_back(size);
    if (!std::isfinite(size)) return orbit;
    const Eigen::MatrixXd matrix =
        Eigen::MatrixXd::Identity(unknowns, unknowns) - image.derivative(free, free);
    const Eigen::VectorXd step = unknowns == 0 ? residual : matrix.partialPivLu().solve(residual);
    if (size < best) {
      best = size;
      orbit.state = at;
      orbit.derivative = image.derivative;
      orbit.multipliers = floquet_multipliers(image.derivative, guess.held);
      orbit.error = unknowns == 0 ? 0.0 : step.cwiseAbs().maxCoeff();
      orbit.differentiable = image.differentiable;
      orbit.chatter_error = image.chatter_error;
      orbit.counters = image.counters;
    }
    const double scale = std::max(1.0, z.cwiseAbs().maxCoeff());
    orbit.converged = size <= options.tolerance * scale;
    if (orbit.converged) return orbit;
    for (Eigen::Index k = 0; k < unknowns; ++k) z(free[static_cast<std::size_t>(k)]) += step(k);
    for (const Stop &stop : scene.stops) {
      const auto i = static_cast<Eigen::Index>(stop.mass - 1);
      if (guess.held[static_cast<std::size_t>(i)] == 0 &&
          !(sign(stop.side) * (stop.position - z(i)) > 0.0))
        return orbit;
    }
  }
  return orbit;
}

Recurrence recurrence(const Scene &scene, const MotionState &state, int most, double tolerance,
                      const RunOptions &options) {
  MotionState at = state;
  double least = std::numeric_limits<double>::infinity();
  for (int n = 1; n <= most; ++n) {
    at = stroboscopic_map(scene, at, 1, options).state;
    const double distance = (coordinates(at) - coordinates(state)).cwiseAbs().maxCoeff();
    if (at.held == state.held && distance <= tolerance) return {n, distance};
    least = std::min(least, distance);
  }
  return {0, least};
}

}  // namespace vibro_impact
