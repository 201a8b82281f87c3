// Periodic orbits as fixed points of the stroboscopic map, found by Newton's method with the exact
// derivative of the map; their Floquet multipliers; and the period of a settled motion.
//
// The stroboscopic map takes the state at one phase of the forcing to the state n forcing periods
// later. Masses held at that phase have no freedom: the unknowns are the displacements and
// velocities of the free ones.
#pragma once

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <algorithm>
#include <limits>
#include <stdexcept>
#include <vector>

#include "simulate.hpp"
#include "tangent.hpp"

namespace vibro_impact {

// Rows of (x_1 .. x_N, x_1' .. x_N') that belong to free masses.
inline std::vector<Eigen::Index> free_coordinates(const Held &held) {
  std::vector<Eigen::Index> rows;
  const auto n = static_cast<Eigen::Index>(held.size());
  for (Eigen::Index part : {Eigen::Index{0}, n})
    for (Eigen::Index i = 0; i < n; ++i)
      if (held[static_cast<std::size_t>(i)] == 0) rows.push_back(part + i);
  return rows;
}

// (x_1 .. x_N, x_1' .. x_N').
inline Eigen::VectorXd coordinates(const MotionState &motion) {
  Eigen::VectorXd z(2 * motion.displacement.size());
  z << motion.displacement, motion.velocity;
  return z;
}

struct StroboscopicImage {
  MotionState state;           // n periods later, cycle count as at the start
  Eigen::MatrixXd derivative;  // 2N x 2N; rows and columns of held masses are zero
  bool differentiable = true;  // see TangentRecorder
  double chatter_error = 0.0;  // see TangentRecorder
  Counters counters;
};

namespace detail {

inline double time_after(const Scene &scene, const MotionState &start, int periods) {
  if (!(scene.omega > 0.0))
    throw std::invalid_argument(
        fmt::format("omega = {}: a stroboscopic map needs a forcing period", scene.omega));
  if (periods < 1)
    throw std::invalid_argument(fmt::format("periods = {}: must be at least 1", periods));
  return time_of({start.instant.cycle + periods, start.instant.phase}, Clock(scene.omega));
}

}  // namespace detail

// The state `periods` forcing periods after `start`, at the same phase and with the same cycle
// count. `recorders` see the run.
template <class... Recorders>
StroboscopicImage stroboscopic_map(const Scene &scene, const MotionState &start, int periods,
                                   const RunOptions &options, Recorders &...recorders) {
  const double until = detail::time_after(scene, start, periods);
  const Outcome end = simulate_from(scene, start, until, options, recorders...);
  StroboscopicImage image{end.state, {}, true, 0.0, end.counters};
  image.state.instant = start.instant;
  return image;
}

// The same with its derivative by the coordinates of the masses free at the start. `start` should
// lie away from events (`at_quiet_phase`): there the map is smooth.
inline StroboscopicImage stroboscopic_map_and_derivative(const Scene &scene,
                                                         const MotionState &start, int periods,
                                                         const RunOptions &options) {
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

// The motion from `start` brought to the phase, within the next forcing period, that is farthest
// from every event of that period; the cycle count is set to zero.
inline MotionState at_quiet_phase(const Scene &scene, const MotionState &start,
                                  const RunOptions &options = {}) {
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

// The motion after `periods` forcing periods from the scene's own initial state.
inline MotionState settled(const Scene &scene, int periods, const RunOptions &options = {}) {
  const MotionState start = start_of(scene);
  return stroboscopic_map(scene, start, periods, options).state;
}

struct NewtonOptions {
  RunOptions run;
  int max_iterations = 20;
  // Largest component of P(z) - z at which z counts as a fixed point, relative to that of z (or 1).
  double tolerance = 1e-13;
};

struct PeriodicOrbit {
  int periods = 1;
  MotionState state;              // at the section
  Eigen::VectorXcd multipliers;   // Floquet multipliers, largest modulus first
  Eigen::MatrixXd derivative;     // of the map, as in StroboscopicImage
  bool converged = false;         // false: the rest describes the last iterate
  std::vector<double> residuals;  // largest component of P(z) - z, one per map evaluation
  double error = 0.0;             // estimated error of `state`: the size of the next Newton step
  bool differentiable = true;
  double chatter_error = 0.0;
  Counters counters;         // of the last map evaluation
  long long expansions = 0;  // of all of them: the cost of the search

  bool stable() const {
    return multipliers.size() == 0 || std::abs(multipliers(0)) < 1.0;
  }
};

// The Floquet multipliers of a map with this derivative: the eigenvalues on the free coordinates.
inline Eigen::VectorXcd floquet_multipliers(const Eigen::MatrixXd &derivative, const Held &held) {
  const std::vector<Eigen::Index> free = free_coordinates(held);
  if (free.empty()) return {};
  Eigen::VectorXcd multipliers =
      Eigen::EigenSolver<Eigen::MatrixXd>(derivative(free, free), false).eigenvalues();
  std::sort(multipliers.begin(), multipliers.end(),
            [](const auto &a, const auto &b) { return std::abs(a) > std::abs(b); });
  return multipliers;
}

// Newton's method for the fixed point of the `periods`-fold stroboscopic map near `guess`, whose
// phase is the section. The contact mode at the section is that of the guess; the search ends
// without convergence when an iterate returns in another one or leaves the admissible region.
inline PeriodicOrbit find_periodic_orbit(const Scene &scene, const MotionState &guess,
                                         int periods = 1, const NewtonOptions &options = {}) {
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

// How often a settled motion repeats.
struct Recurrence {
  int periods = 0;        // smallest n <= most with z after n periods = z; 0 when there is none
  double distance = 0.0;  // largest component of z after `periods` periods minus z (0: the least)
};

// The period, in forcing periods, of the motion through `state`, which should lie on an attractor.
// States closer than `tolerance` count as equal. An orbit that does not repeat within `most`
// periods (quasi-periodic, chaotic, of longer period, not settled) gives 0.
inline Recurrence recurrence(const Scene &scene, const MotionState &state, int most = 8,
                             double tolerance = 1e-8, const RunOptions &options = {}) {
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
