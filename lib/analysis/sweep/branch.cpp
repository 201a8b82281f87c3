#include "branch.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <stdexcept>
#include <utility>

#include "analysis/orbits/orbit_tolerances.hpp"
#include "event_counts.hpp"

namespace vibro_impact {

using Vector = Eigen::VectorXd;

MotionState Branch::state_of(const Scene &scene, const Vector &u) const {
  const std::size_t n = held_.size();
  Vector z = Vector::Zero(2 * static_cast<Eigen::Index>(n));
  z(free_coordinates(held_)) = u.head(u.size() - 1).cwiseProduct(unit_);
  MotionState state{.instant = {0, part_ * Clock(scene.omega).period}, .held = held_};
  state.displacement.assign(z.begin(), z.begin() + static_cast<std::ptrdiff_t>(n));
  state.velocity.assign(z.begin() + static_cast<std::ptrdiff_t>(n), z.end());
  return moved_into(scene, std::move(state));
}

Scene Branch::scene_at(const Vector &u) const {
  Scene scene = with(scene_, range_.parameter, parameter(u));
  scene.displacement.resize(scene.mass.size(), 0.0);
  move_inside(scene, scene.displacement);
  return scene;
}

Vector Branch::vector_of(const MotionState &state, double q) const {
  Vector u(unit_.size() + 1);
  u << view(coordinates(state))(free_coordinates(held_)).cwiseQuotient(unit_), q / width();
  return u;
}

void Branch::set_section(const MotionState &state, double q) {
  const Scene scene = with(scene_, range_.parameter, q);
  const double size = amplitude(local_frequencies(scene), state);
  length_ = size > 0.0 ? size : 1.0;
  held_ = state.held;
  part_ = state.instant.phase / Clock(scene.omega).period;
  unit_ = length_ * coordinate_units(scene, held_);
}

std::optional<Orbit> Branch::correct(const Vector &guess, const Vector &normal,
                                     double length) const {
  const Eigen::Index n = unit_.size();
  const std::vector<std::size_t> free = free_coordinates(held_);
  // The difference by q is taken towards the orbits that are known.
  const double step = -std::copysign(difference_step * length, normal(n));
  Orbit orbit{.u = guess};
  double residual = infinity;
  for (int iteration = 0; iteration < most_corrections; ++iteration) {
    const Scene scene = scene_at(orbit.u);
    const MotionState state = state_of(scene, orbit.u);
    const StroboscopicImage image = stroboscopic_map_and_derivative(scene, state, periods_);
    if (image.state.held != held_) return std::nullopt;
    orbit.derivative =
        unit_.asDiagonal().inverse() * view(image.derivative)(free, free) * unit_.asDiagonal();
    const Vector images = vector_of(image.state, parameter(orbit.u));
    const double before = residual;
    residual = (images - orbit.u).norm();
    if (residual <= newton_tolerance ||
        (residual <= rounding_of_orbit && residual > 0.5 * before)) {
      orbit.point = {.parameter = parameter(orbit.u),
                     .orbit = {.state = state,
                               .multipliers = floquet_multipliers(image.derivative, held_),
                               .converged = true,
                               .residuals = {residual * length_},
                               .events = image.events},
                     .counts = counts_of(scene, image.events, periods_, held_)};
      orbit.events = without_chatters(scene, image.events, true);
      return orbit;
    }
    Vector moved = orbit.u;
    moved(n) += step;
    const Scene other = scene_at(moved);
    const MotionState end = stroboscopic_map(other, state_of(other, moved), periods_);
    if (end.held != held_) return std::nullopt;
    Eigen::MatrixXd matrix(n + 1, n + 1);
    matrix.topLeftCorner(n, n) = orbit.derivative;
    matrix.topLeftCorner(n, n).diagonal().array() -= 1.0;
    matrix.topRightCorner(n, 1) = (vector_of(end, parameter(moved)) - images).head(n) / step;
    matrix.bottomRows(1) = normal.transpose();
    Vector right(n + 1);
    right << (orbit.u - images).head(n), normal.dot(guess - orbit.u);
    orbit.u += matrix.partialPivLu().solve(right);
    if (!orbit.u.allFinite()) return std::nullopt;
  }
  return std::nullopt;
}

std::optional<Orbit> Branch::orbit_at(const Vector &guess, const Vector &normal,
                                      double length) const {
  try {
    return correct(guess, normal, length);
  } catch (const std::invalid_argument &) {
    return std::nullopt;
  } catch (const std::runtime_error &) {
    return std::nullopt;
  }
}

bool Branch::move_section(Orbit &last, Orbit &before) {
  if (last.events.empty()) return true;
  const Scene scene = scene_at(last.u);
  const Clock clock(scene.omega);
  const double first = elapsed(last.point.orbit.state.instant, last.events.front().instant, clock),
               rest = periods_ * clock.period -
                      elapsed(last.point.orbit.state.instant, last.events.back().instant, clock);
  if (std::min(first, rest) > least_distance * clock.period) return true;
  const double q = parameter(last.u), q_before = parameter(before.u);
  const MotionState moved = at_quiet_phase(scene, last.point.orbit.state);
  const Scene scene_before = scene_at(before.u);
  set_section(moved, q);
  const Instant target{0, part_ * Clock(scene_before.omega).period};
  const bool later_period = target < before.point.orbit.state.instant;
  Simulation simulation(scene_before, before.point.orbit.state);
  MotionState moved_before =
      require_complete(simulation.advance(time_of({later_period ? 1 : 0, target.phase},
                                                  Clock(scene_before.omega))))
          .state;
  moved_before.instant = target;
  if (moved_before.held != held_) return false;
  const Vector u = vector_of(moved, q), u_before = vector_of(moved_before, q_before);
  const Vector chord = u - u_before, normal = chord.normalized();
  const std::optional<Orbit> a = orbit_at(u_before, normal, chord.norm()),
                             b = orbit_at(u, normal, chord.norm());
  if (!a || !b) return false;
  before = *a;
  last = *b;
  return true;
}

}  // namespace vibro_impact
