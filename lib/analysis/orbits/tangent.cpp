#include <utility>

#include "motion_state.hpp"
#include "tangents.hpp"
#include "tolerances.hpp"

namespace vibro_impact {

void TangentRecorder::Tangents::event(const Event &event, const Moment &moment) {
  if (!group.empty() && group.front().instant < event.instant) close();
  if (group.empty()) carry_to(event.instant);
  at = state_at(moment, held);
  if (group.empty()) velocity_before = at.velocity;
  // All impacts of an instant have been applied when the first of them is told.
  if (event.kind == EventKind::impact) {
    const auto hit = static_cast<std::size_t>(event.mass - 1);
    velocity_before[hit] = event.velocity_before;
    at.velocity[hit] = event.velocity_after;
  }
  group.push_back(event);
}

void TangentRecorder::Tangents::finish(const Instant &end) {
  if (!group.empty()) close();
  carry_to(end);
}

Row TangentRecorder::Tangents::ones(Parameter::Kind kind, std::size_t index) const {
  return columns_of(scene, options.by, kind, index, changes.cols());
}

// A held mass moves with its stop.
void TangentRecorder::Tangents::hold(Eigen::MatrixXd &columns, const Held &mode) const {
  for (std::size_t s = 0; s < scene.stops.size(); ++s) {
    const auto row = static_cast<Eigen::Index>(scene.stops[s].mass - 1);
    if (!holds(scene.stops[s], mode)) continue;
    columns.row(row) = ones(Parameter::Kind::stop, s + 1);
    columns.row(masses() + row).setZero();
  }
}

// A short time always by the series: modal coordinates would lose the small change of a chattering
// mass beside the others.
void TangentRecorder::Tangents::carry_all(const Held &mode, const Instant &from, double tau,
                                          PlainMotion &with, Eigen::MatrixXd &columns) {
  const auto &of_mode = modes.enter(unforced, mode, counters);
  if (of_mode.fastest * tau < short_flight)
    return carry(scene, options.by, mode, from.phase, tau, with, columns);
  Eigen::MatrixXd by_start = columns.leftCols(columns.cols() - parameters()),
                  by_parameters = columns.rightCols(parameters());
  carry_by_modes(of_mode, tau, by_start);
  if (!options.by.empty()) carry(scene, options.by, mode, from.phase, tau, with, by_parameters);
  columns << by_start, by_parameters;
}

void TangentRecorder::Tangents::carry_to(const Instant &instant) {
  carry_all(held, now, elapsed(now, instant, clock), motion, changes);
  now = instant;
}

TangentRecorder::TangentRecorder(const Scene &scene, const MotionState &start,
                                 const Matrix &columns, const TangentOptions &options) {
  check(scene);
  require_differentiable(scene, options.by);
  require_fits(scene, start);
  const std::size_t n = scene.mass.size();
  require(columns.rows == 2 * n && columns.values.size() % (2 * n) == 0 &&
              columns.values.size() / (2 * n) == columns.columns,
          "columns: ", columns.rows, " rows given, the chain has ", 2 * n,
          " coordinates and velocities");
  require(columns.columns >= options.by.size(), "columns: ", columns.columns,
          " given, fewer than the ", options.by.size(), " parameters");
  for (std::size_t i = 0; i < 2 * n; ++i)
    for (std::size_t k = 0; k + options.by.size() < columns.columns; ++k)
      require(start.held[i % n] == 0 || columns(i, k) == 0.0, "column ", k + 1,
              ": must be zero for mass ", i % n + 1, ", which is held");
  tangents_ = std::make_unique<Tangents>(
      Tangents{.scene = scene,
               .options = options,
               .clock = Clock(scene.omega),
               .started = start.instant,
               .now = start.instant,
               .held = start.held,
               .changes = view(columns),
               .motion = {view(start.displacement), view(start.velocity)},
               .unforced = scene});
  tangents_->unforced.amplitude.clear();
  tangents_->unforced.stops.clear();
  tangents_->hold(tangents_->changes, start.held);
}

TangentRecorder::~TangentRecorder() = default;

void TangentRecorder::event(const Event &event, const Moment &moment) {
  require(tangents_ != nullptr, "tangents: an event after the end");
  const Scene &scene = tangents_->scene;
  require(event.stop < scene.stops.size() && scene.stops[event.stop].mass == event.mass &&
              moment.masses() == scene.masses(),
          "tangents: an event at stop ", event.stop, " of mass ", event.mass, " of ",
          moment.masses(), ": not of the scene they were made for");
  tangents_->event(event, moment);
}

ChangesAtEnd TangentRecorder::finish(const Instant &end) {
  require(tangents_ != nullptr, "tangents: finished already");
  const Clock &clock = tangents_->clock;
  require(end.phase >= 0.0 && end.phase < clock.period &&
              static_cast<double>(end.cycle) <= most_periods &&
              elapsed(tangents_->started, end, clock) >= -repeats * clock.period,
          "tangents: an end at phase ", end.phase, " in period ", end.cycle,
          ": must not lie before the start");
  const auto at_end = std::exchange(tangents_, nullptr);
  at_end->finish(end);
  return {matrix_of(at_end->changes), at_end->differentiable, at_end->chatter_error,
          std::move(at_end->told)};
}

}  // namespace vibro_impact
