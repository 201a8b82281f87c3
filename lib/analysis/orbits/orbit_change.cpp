#include "vibro_impact/analysis/orbit_change.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "change_flow.hpp"
#include "fits.hpp"
#include "motion_state.hpp"
#include "vibro_impact/analysis/border_orbit.hpp"
#include "vibro_impact/analysis/multi_sliding.hpp"

namespace vibro_impact {

namespace {

using Kind = Parameter::Kind;

// The changes of the motion up to `until`, a time, that go with the changes of the orbit.
ChangesAtEnd along(const Scene &scene, const PeriodicOrbit &orbit, const OrbitChange &change,
                   double until, const RunOptions &options = {}, bool events = false) {
  TangentRecorder tangents(scene, orbit.state, change.state, {.by = change.by, .events = events});
  return tangents.finish(
      require_complete(simulate_from(scene, orbit.state, until, options, tangents)).state.instant);
}

Eigen::MatrixXd changes_at(const Scene &scene, const PeriodicOrbit &orbit,
                           const OrbitChange &change, const Instant &at) {
  return view(along(scene, orbit, change, time_of(at, Clock(scene.omega))).changes);
}

// One in the entries of the parameters that are the position of this stop.
Eigen::RowVectorXd stop_change(const Scene &scene, const std::vector<Parameter> &by,
                               const Stop &stop) {
  Eigen::RowVectorXd change = Eigen::RowVectorXd::Zero(static_cast<Eigen::Index>(by.size()));
  for (std::size_t k = 0; k < by.size(); ++k) {
    if (by[k].kind != Kind::stop) continue;
    const Stop &named = scene.stops[static_cast<std::size_t>(by[k].index - 1)];
    if (named.mass == stop.mass && named.side == stop.side)
      change(static_cast<Eigen::Index>(k)) = 1.0;
  }
  return change;
}

ValueChange value_change(double value, const Eigen::RowVectorXd &by) {
  return {value, {by.begin(), by.end()}};
}

// The orbit with its cycle count at zero, as least_gap and the like count time.
PeriodicOrbit from_zero(PeriodicOrbit orbit) {
  orbit.state.instant.cycle = 0;
  return orbit;
}

}  // namespace

OrbitChange orbit_change(const Scene &scene, const PeriodicOrbit &orbit,
                         const std::vector<Parameter> &by, const RunOptions &options) {
  require(orbit.converged, "orbit: has not converged, its changes mean nothing");
  const StroboscopicImage image =
      stroboscopic_map_and_derivative(scene, orbit.state, orbit.periods, options, by);
  const std::vector<std::size_t> free = free_coordinates(orbit.state.held);
  const auto unknowns = static_cast<Eigen::Index>(free.size());
  Eigen::MatrixXd change = view(image.by_parameters);  // of held masses: with their stops
  const Eigen::MatrixXd matrix =
      Eigen::MatrixXd::Identity(unknowns, unknowns) - view(image.derivative)(free, free);
  if (unknowns > 0)
    change(free, Eigen::all) = matrix.partialPivLu().solve(change(free, Eigen::all)).eval();
  if (!change.allFinite())
    throw std::runtime_error("orbit: a Floquet multiplier is 1, it has no derivative");
  OrbitChange result{by, matrix_of(change), {}, image.differentiable};
  const double until = time_after(scene, orbit.state, orbit.periods);
  result.events = along(scene, orbit, result, until, options, true).events;
  return result;
}

MotionState predicted(const Scene &scene, const PeriodicOrbit &orbit, const OrbitChange &change,
                      std::size_t k, double step) {
  require(k < change.by.size(), "parameter ", k, ": the change has ", change.by.size());
  const Scene moved = with(scene, change.by[k], get(scene, change.by[k]) + step);
  MotionState at = orbit.state;
  at.instant.phase *= scene.omega / moved.omega;
  for (const std::size_t row : free_coordinates(at.held))
    coordinate(at, row) += step * change.state(row, k);
  hold_at_stops(moved, at);
  return at;
}

std::optional<ValueChange> least_gap_change(const Scene &scene, const PeriodicOrbit &orbit,
                                            const OrbitChange &change, const Stop &stop) {
  const PeriodicOrbit counted = from_zero(orbit);
  const auto least = least_gap(scene, counted.state, stop);
  if (!least) return std::nullopt;
  const Eigen::MatrixXd moved = changes_at(scene, counted, change, least->at.instant);
  return value_change(least->value, sign(stop.side) * (stop_change(scene, change.by, stop) -
                                                       moved.row(stop.mass - 1)));
}

std::optional<ValueChange> least_pressing_force_change(const Scene &scene,
                                                       const PeriodicOrbit &orbit,
                                                       const OrbitChange &change,
                                                       const Stop &stop) {
  const PeriodicOrbit counted = from_zero(orbit);
  const auto least = least_pressing_force(scene, counted.state, stop);
  if (!least) return std::nullopt;
  const MotionState &at = least->at;
  const Eigen::MatrixXd moved = changes_at(scene, counted, change, at.instant);
  return value_change(
      least->value,
      sign(stop.side) * force_change(scene, change.by, static_cast<std::size_t>(stop.mass - 1),
                                     at.instant.phase, {view(at.displacement), view(at.velocity)},
                                     moved));
}

ValueChange border_excess_change(const Scene &scene, const std::vector<Parameter> &by,
                                 const EventChange &one, const EventChange &next) {
  require(one.event.kind == EventKind::impact && next.event.kind == EventKind::impact &&
              one.event.stop == next.event.stop,
          "events: must be impacts at one stop");
  require(by.size() <= one.velocity_before.size() &&
              one.velocity_before.size() == next.velocity_before.size(),
          "events: ", one.velocity_before.size(), " and ", next.velocity_before.size(),
          " changes given, by ", by.size(), " parameters");
  const double r = law_of(scene, scene.stops[one.event.stop]).at_rest();
  const BorderChatter border = border_chatter(r);
  // (3 - s) (1 - s)^2 = r (3 - 2 s) differentiated; the ratio is (1 - s)^2.
  const double q = border.press_ratio, s = border.flight;
  const double by_r = 2.0 * q * (3.0 - 2.0 * s) / (q * q + 2.0 * (3.0 - s) * q - 2.0 * r);
  const double ratio = next.event.velocity_before / one.event.velocity_before;
  ValueChange excess{ratio - border.speed_ratio, {}};
  const std::size_t first = one.velocity_before.size() - by.size();
  for (std::size_t k = 0; k < one.velocity_before.size(); ++k) {
    const bool of_stop =
        k >= first && is_of_stop(scene, by[k - first], Kind::restitution, one.event.stop);
    excess.by.push_back((next.velocity_before[k] - ratio * one.velocity_before[k]) /
                            one.event.velocity_before -
                        (of_stop ? by_r : 0.0));
  }
  return excess;
}

}  // namespace vibro_impact
