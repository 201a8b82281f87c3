#include "vibro_impact/analysis/orbit_change.hpp"

#include <Eigen/LU>
#include <stdexcept>

#include "change_flow.hpp"
#include "motion_state.hpp"
#include "vibro_impact/analysis/multi_sliding.hpp"

namespace vibro_impact {

namespace {

// The changes of the motion up to `until`, a time, that go with the changes of the orbit.
ChangesAtEnd along(const Scene &scene, const PeriodicOrbit &orbit, const OrbitChange &change,
                   double until, const RunOptions &options = {}, bool events = false) {
  TangentRecorder tangents(scene, orbit.state, change.state, {.by = change.by, .events = events});
  return tangents.finish(
      require_complete(simulate_from(scene, orbit.state, until, options, tangents)).state.instant);
}

// Those at an instant that is counted, as least_gap and the like do, from the start of the orbit.
Eigen::MatrixXd changes_at(const Scene &scene, const PeriodicOrbit &orbit,
                           const OrbitChange &change, Instant at) {
  require(change.state.columns == change.by.size(), "change: ", change.state.columns,
          " columns for ", change.by.size(), " parameters");
  time_after(scene, orbit.state, orbit.periods);  // refuses periods beyond counting
  at.cycle += orbit.state.instant.cycle;
  return view(along(scene, orbit, change, time_of(at, Clock(scene.omega))).changes);
}

// One in the entries of the parameters that are the position of this stop.
Eigen::RowVectorXd stop_change(const Scene &scene, const std::vector<Parameter> &by,
                               const Stop &stop) {
  std::size_t s = 0;
  while (s < scene.stops.size() &&
         (scene.stops[s].mass != stop.mass || scene.stops[s].side != stop.side))
    ++s;
  return columns_of(scene, by, Parameter::Kind::stop, s + 1, static_cast<Eigen::Index>(by.size()));
}

ValueChange value_change(double value, const Eigen::RowVectorXd &by) {
  return {value, {by.begin(), by.end()}};
}

}  // namespace

OrbitChange orbit_change(const Scene &scene, const PeriodicOrbit &orbit,
                         const std::vector<Parameter> &by, const RunOptions &options) {
  require(orbit.converged, "orbit: has not converged, its changes mean nothing");
  require(!by.empty(), "orbit: no parameters to change");
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
  OrbitChange result{by, matrix_of(change), {}};
  const double until = time_after(scene, orbit.state, orbit.periods);
  result.events = along(scene, orbit, result, until, options, true).events;
  return result;
}

std::optional<ValueChange> least_gap_change(const Scene &scene, const PeriodicOrbit &orbit,
                                            const OrbitChange &change, const Stop &stop) {
  const auto least = least_gap(scene, orbit.state, stop);
  if (!least) return std::nullopt;
  const Eigen::MatrixXd moved = changes_at(scene, orbit, change, least->at.instant);
  return value_change(least->value, sign(stop.side) * (stop_change(scene, change.by, stop) -
                                                       moved.row(stop.mass - 1)));
}

std::optional<ValueChange> least_pressing_force_change(const Scene &scene,
                                                       const PeriodicOrbit &orbit,
                                                       const OrbitChange &change,
                                                       const Stop &stop) {
  const auto least = least_pressing_force(scene, orbit.state, stop);
  if (!least) return std::nullopt;
  const MotionState &at = least->at;
  const Eigen::MatrixXd moved = changes_at(scene, orbit, change, at.instant);
  return value_change(
      least->value,
      sign(stop.side) * force_change(scene, change.by, static_cast<std::size_t>(stop.mass - 1),
                                     at.instant.phase, {view(at.displacement), view(at.velocity)},
                                     moved));
}

}  // namespace vibro_impact
