#include "vibro_impact/analysis/periodic_orbit.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <utility>

#include "motion_state.hpp"
#include "orbit_tolerances.hpp"
#include "tangent.hpp"

namespace vibro_impact {

namespace {

// One iterate z of Newton's method: the map at z, P(z) - z, and the step to the next iterate.
struct Iterate {
  StroboscopicImage image;
  Eigen::VectorXd step = {};
  // The distance of P(z) from z, of z from zero, and of the next iterate from z.
  double residual = 0.0, size = 0.0, length_of_step = 0.0;
  std::string why_not_usable =
      {};  // empty: it returns in its own contact mode, with finite numbers
};

// The state with its free coordinates moved by a step.
MotionState moved_by(const Eigen::VectorXd &step, MotionState at) {
  const std::size_t n = at.held.size();
  Eigen::Index k = 0;
  for (const std::size_t row : free_coordinates(at.held))
    (row < n ? at.displacement[row] : at.velocity[row - n]) += step(k++);
  return at;
}

Iterate evaluate(const Scene &scene, const MotionState &at, int periods) {
  Iterate iterate{.image = stroboscopic_map_and_derivative(scene, at, periods)};
  if (iterate.image.state.held != at.held) {
    iterate.why_not_usable =
        line("returns with other masses held (", contact_mode_name(iterate.image.state.held),
             ") than it starts with (", contact_mode_name(at.held), ")");
    return iterate;
  }
  const std::vector<std::size_t> free = free_coordinates(at.held);
  const auto unknowns = static_cast<Eigen::Index>(free.size());
  const Eigen::VectorXd residual =
      (view(coordinates(iterate.image.state)) - view(coordinates(at)))(free);
  const std::vector<double> frequencies = local_frequencies(scene);
  iterate.residual = amplitude(frequencies, iterate.image.state, at);
  iterate.size = amplitude(frequencies, at);
  const Eigen::MatrixXd derivative = view(iterate.image.derivative)(free, free);
  if (!residual.allFinite() || !derivative.allFinite())
    iterate.why_not_usable = "the map or its derivative is not finite";
  else if (unknowns > 0) {
    const Eigen::VectorXd units = coordinate_units(scene, at.held);
    const Eigen::MatrixXd in_units = units.asDiagonal().inverse() * derivative * units.asDiagonal();
    const Eigen::VectorXd step = (Eigen::MatrixXd::Identity(unknowns, unknowns) - in_units)
                                     .partialPivLu()
                                     .solve(residual.cwiseQuotient(units));
    iterate.step = step.cwiseProduct(units);
    iterate.length_of_step = amplitude(frequencies, moved_by(iterate.step, at), at);
  }
  return iterate;
}

bool any_is_beyond_its_stop(const Scene &scene, const MotionState &at) {
  return std::ranges::any_of(scene.stops, [&at](const Stop &stop) {
    return is_beyond(stop, at.displacement[static_cast<std::size_t>(stop.mass - 1)]);
  });
}

}  // namespace

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
  TangentRecorder recorder(scene, start);
  EventRecorder events(-infinity);
  const Outcome end = simulation.advance(time_after(scene, start, periods), recorder, events);
  const Eigen::MatrixXd derivative = recorder.finish(require_complete(end).state.instant);
  MotionState state = end.state;
  state.instant = start.instant;
  return {state, matrix_of(derivative), recorder.differentiable(), std::move(events.events)};
}

MotionState at_quiet_phase(const Scene &scene, const MotionState &start,
                           const RunOptions &options) {
  const Clock clock(scene.omega);
  EventRecorder recorder(-infinity);
  stroboscopic_map(scene, start, 1, options, recorder);
  double after = 0.0, widest = 0.0, last = 0.0;
  const auto end_interval = [&](double time) {
    if (time - last > widest) {
      widest = time - last;
      after = 0.5 * (last + time);
    }
    last = time;
  };
  for (const Event &event : recorder.events)
    end_interval(elapsed(start.instant, event.instant, clock));
  end_interval(clock.period);  // the motion need not be periodic: the period ends the last interval
  const double until = time_of(start.instant, clock) + after;
  MotionState state = require_complete(Simulation(scene, start, options).advance(until)).state;
  state.instant.cycle = 0;
  return state;
}

MotionState state_after_periods(const Scene &scene, int periods, const RunOptions &options) {
  Simulation simulation(scene, options);
  MotionState state = require_complete(simulation.advance(time_after(scene, {}, periods))).state;
  state.instant = {};
  return state;
}

std::vector<std::complex<double>> floquet_multipliers(const Matrix &derivative, const Held &held) {
  const std::size_t size = 2 * held.size();
  require(derivative.rows == size && derivative.columns == size &&
              derivative.values.size() == size * size,
          "derivative: ", derivative.values.size(), " values of ", derivative.rows, " x ",
          derivative.columns, ", the chain has ", size, " coordinates");
  const std::vector<std::size_t> free = free_coordinates(held);
  if (free.empty()) return {};
  Eigen::MatrixXd map = view(derivative)(free, free);
  require(map.allFinite(), "derivative: all values must be finite");
  // Velocities are measured in the unit of time in which the blocks beside the diagonal are equally
  // large, so that the rounding of the multipliers does not depend on the unit of the scene.
  const Eigen::Index half = map.rows() / 2;
  auto by_velocity = map.topRightCorner(half, half), of_velocity = map.bottomLeftCorner(half, half);
  const double unit =
      std::sqrt(of_velocity.cwiseAbs().maxCoeff() / by_velocity.cwiseAbs().maxCoeff());
  if (std::isfinite(unit) && unit > 0.0) {
    by_velocity *= unit;
    of_velocity /= unit;
  }
  const Eigen::VectorXcd found = Eigen::EigenSolver<Eigen::MatrixXd>(map, false).eigenvalues();
  std::vector<std::complex<double>> multipliers(found.begin(), found.end());
  std::sort(multipliers.begin(), multipliers.end(),
            [](const auto &a, const auto &b) { return std::abs(a) > std::abs(b); });
  return multipliers;
}

PeriodicOrbit find_periodic_orbit(const Scene &scene, const MotionState &guess, int periods,
                                  int most_iterations) {
  require(most_iterations >= 0, "most_iterations = ", most_iterations, ": must be non-negative");
  PeriodicOrbit orbit;
  MotionState at = orbit.state = moved_into(scene, guess);
  double best = infinity;
  const auto ended = [&orbit](std::string why) {
    orbit.why_not = std::move(why);
    return orbit;
  };
  for (int iteration = 0;; ++iteration) {
    const Iterate iterate = evaluate(scene, at, periods);
    if (!iterate.why_not_usable.empty())
      return ended(line("iterate ", iteration, ": ", iterate.why_not_usable));
    orbit.residuals.push_back(iterate.residual);
    const double allowed = newton_tolerance * iterate.size;
    orbit.converged = iterate.residual <= allowed;
    if (orbit.converged || iterate.residual < best) {
      best = iterate.residual;
      orbit.state = at;
      orbit.multipliers = floquet_multipliers(iterate.image.derivative, at.held);
      orbit.events = iterate.image.events;
    }
    if (orbit.converged) return orbit;
    if (iteration == most_iterations)
      return ended(line("residual = ", best, " after ", iteration, " iterations: above ", allowed));
    // A multiplier that rounding keeps from 1 leads so far away that any state there would count.
    if (!iterate.step.allFinite() || newton_tolerance * iterate.length_of_step >= iterate.residual)
      return ended(line("iterate ", iteration, ": a Floquet multiplier is 1, no step leads on"));
    at = moved_by(iterate.step, at);
    if (any_is_beyond_its_stop(scene, at))
      return ended(line("iterate ", iteration + 1, ": a mass is beyond its stop"));
  }
}

}  // namespace vibro_impact
