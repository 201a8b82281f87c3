// States and stops as the analysis takes them: what they must fulfil, a state at a moment of a run,
// and the vectors and matrices of the public headers as Eigen sees them.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "simulation/for_analysis.hpp"
#include "vibro_impact/analysis/matrix.hpp"
#include "vibro_impact/record.hpp"

namespace vibro_impact {

using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

inline Eigen::Map<const Eigen::VectorXd> view(const std::vector<double> &values) {
  return {values.data(), static_cast<Eigen::Index>(values.size())};
}

inline Eigen::Map<const RowMajor> view(const Matrix &matrix) {
  return {matrix.values.data(), static_cast<Eigen::Index>(matrix.rows),
          static_cast<Eigen::Index>(matrix.columns)};
}

inline Matrix matrix_of(const Eigen::MatrixXd &from) {
  Matrix matrix{static_cast<std::size_t>(from.rows()), static_cast<std::size_t>(from.cols()),
                std::vector<double>(static_cast<std::size_t>(from.size()))};
  Eigen::Map<RowMajor>(matrix.values.data(), from.rows(), from.cols()) = from;
  return matrix;
}

// The scene, which has been checked, need not contain the stop.
inline void require_stop(const Scene &scene, const Stop &stop) {
  require_mass(stop.mass, scene.masses());
  require(stop.side == Side::lower || stop.side == Side::upper, "stop on mass ", stop.mass,
          ", side = ", static_cast<int>(stop.side), ": must be lower (-1) or upper (1)");
  require(std::isfinite(stop.position), "stop on mass ", stop.mass, " at ", stop.position,
          ": must be finite");
}

inline void require_held(const Scene &scene, const Held &held) {
  require(held.size() == scene.mass.size(), "held: ", held.size(), " values given, the chain has ",
          scene.mass.size(), " masses");
  for (const int how : held) require(how >= -1 && how <= 1, "held = ", how, ": must be -1, 0 or 1");
}

// The indices of the masses that no stop holds, from 0.
inline std::vector<std::size_t> free_masses(const Held &held) {
  std::vector<std::size_t> free;
  for (std::size_t i = 0; i < held.size(); ++i)
    if (held[i] == 0) free.push_back(i);
  return free;
}

// A run checks its start by itself; functions of a state have to. A mass may lie beyond a stop.
inline void require_fits(const Scene &scene, const MotionState &at) {
  const std::size_t n = scene.mass.size();
  require(at.displacement.size() == n, "displacement: ", at.displacement.size(),
          " values given, the chain has ", n, " masses");
  require(at.velocity.size() == n, "velocity: ", at.velocity.size(),
          " values given, the chain has ", n, " masses");
  require_held(scene, at.held);
  check_place(scene, at.instant, at.held);
  for (const auto &[values, what] :
       {std::pair{&at.displacement, "displacement"}, {&at.velocity, "velocity"}})
    for (const double value : *values)
      require(std::isfinite(value), what, " = ", value, ": must be finite");
}

// The frequency of each mass between neighbours that stand still. On no spring it is Omega, or 1.
inline std::vector<double> local_frequencies(const Scene &scene) {
  std::vector<double> frequencies;
  for (std::size_t i = 0; i < scene.mass.size(); ++i) {
    const double stiffness = stiffness_at(scene, i);
    const double without_spring = scene.omega > 0.0 ? scene.omega : 1.0;
    frequencies.push_back(stiffness > 0.0 ? std::sqrt(stiffness / scene.mass[i]) : without_spring);
  }
  return frequencies;
}

// Replaces the velocities just after an event by those just before it. Only an impact changes one.
inline void undo_jump(const Event &event, std::vector<double> &velocity) {
  if (event.kind == EventKind::impact)
    velocity[static_cast<std::size_t>(event.mass - 1)] = event.velocity_before;
}

inline std::size_t index_of(int mass) {
  return static_cast<std::size_t>(mass - 1);
}

// The forces of springs and forcing on all masses.
Eigen::VectorXd forces_without_dampers(const Scene &scene, const MotionState &state);
// The functions of pressing_force.hpp, of a scene, a stop and a state that have been checked.
std::vector<double> acceleration_of(const Scene &scene, const MotionState &state);
double pressing_force_of(const Scene &scene, const Stop &stop, MotionState state);

// True where the contact mode holds a mass at this stop.
inline bool holds(const Stop &stop, const Held &held) {
  return held[static_cast<std::size_t>(stop.mass - 1)] == static_cast<signed char>(stop.side);
}

// True where a mass at x is beyond this stop.
inline bool is_beyond(const Stop &stop, double x) {
  return sign(stop.side) * (x - stop.position) > 0.0;
}

// Moves masses that are beyond a stop of the scene to this stop.
inline void move_inside(const Scene &scene, std::vector<double> &displacement) {
  for (const Stop &stop : scene.stops) {
    double &x = displacement[static_cast<std::size_t>(stop.mass - 1)];
    if (is_beyond(stop, x)) x = stop.position;
  }
}

// The state in this scene, which may not be quite the one it was found in: its phase lies within
// the period, and held masses are at rest at their stops. The scene has been checked.
inline MotionState moved_into(const Scene &scene, MotionState state) {
  require(std::isfinite(state.instant.phase), "start: phase = ", state.instant.phase,
          ": must be finite");
  state.instant = later({state.instant.cycle, 0.0}, state.instant.phase, Clock(scene.omega));
  require_fits(scene, state);
  for (const Stop &stop : scene.stops) {
    if (!holds(stop, state.held)) continue;
    const auto i = static_cast<std::size_t>(stop.mass - 1);
    state.displacement[i] = stop.position;
    state.velocity[i] = 0.0;
  }
  return state;
}

}  // namespace vibro_impact
