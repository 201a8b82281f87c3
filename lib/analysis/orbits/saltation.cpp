#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "motion_state.hpp"
#include "tangent_limit.hpp"
#include "tangents.hpp"
#include "tolerances.hpp"

namespace vibro_impact {

namespace {

using Kind = Parameter::Kind;

// The impacts of a chatter from one that is taken into account to the next. Where the speeds fall
// slowly, some are left out: nodes closer together amplify rounding.
long long stride_of(const ImpactLaw &law) {
  const double r = law.at_rest();
  if (!(r > tangent_node_ratio && r < 1.0)) return 1;
  return static_cast<long long>(std::ceil(std::log(tangent_node_ratio) / std::log(r)));
}

}  // namespace

Eigen::VectorXd TangentRecorder::Tangents::vector_field(const Held &mode,
                                                        const std::vector<double> &v) const {
  return vibro_impact::vector_field(scene, {at.instant, at.displacement, v, mode});
}

// `dt` is the change of the time of the event at a fixed scale of time: in units of 1 / Omega, that
// of its phase.
void TangentRecorder::Tangents::tell(const Event &event, const Row &dt, const Row &speed) {
  if (!options.events) return;
  Row time = dt;
  if (scene.omega > 0.0) time -= event.time / scene.omega * ones(Kind::omega, 0);
  told.push_back({event, {time.begin(), time.end()}, {speed.begin(), speed.end()}});
}

void TangentRecorder::Tangents::close() {
  const Held after = group.back().held;
  std::vector<const Event *> impacts;
  bool sticks = false;
  for (const Event &event : group) {
    if (event.kind == EventKind::impact) impacts.push_back(&event);
    sticks = sticks || event.kind == EventKind::stick;
  }
  if (!impacts.empty()) {
    saltation(impacts, after);
  } else if (sticks) {
    chatter_limit(after);
  } else {  // at roots of the hold force: state and vector field are continuous
    sequence.nodes.clear();
    if (options.events) releases();
  }
  held = after;
  hold(changes, held);
  if (!options.by.empty()) motion = {view(at.displacement), view(at.velocity)};
  group.clear();
}

void TangentRecorder::Tangents::saltation(const std::vector<const Event *> &impacts,
                                          const Held &after) {
  if (impacts.size() > 1) differentiable = false;  // it depends on which mass is first
  const bool alone = group.size() == 1;
  if (!alone) sequence.nodes.clear();
  std::vector<double> v = velocity_before;
  Eigen::VectorXd f = vector_field(held, v);
  for (const Event *impact : impacts) {
    const Eigen::Index x_row = impact->mass - 1, v_row = masses() + x_row;
    const double speed = impact->velocity_before;
    if (speed == 0.0) {
      differentiable = false;
      const Row none = Row::Constant(changes.cols(), std::numeric_limits<double>::quiet_NaN());
      tell(*impact, none, none);
      continue;
    }
    const Row stop = ones(Kind::stop, impact->stop + 1);
    const Row dt = (stop - changes.row(x_row)) / speed;
    changes += f * dt;
    tell(*impact, dt, changes.row(v_row));
    const ImpactLaw law = law_of(scene, scene.stops[impact->stop]);
    changes.row(x_row) = stop;
    changes.row(v_row) = -law.slope(std::abs(speed)) * changes.row(v_row) -
                         std::copysign(law.after_by_restitution(std::abs(speed)), speed) *
                             ones(Kind::restitution, impact->stop + 1);
    v[static_cast<std::size_t>(x_row)] = impact->velocity_after;
    f = impact == impacts.back() ? vector_field(after, at.velocity) : vector_field(held, v);
    if (alone) extend_sequence(*impact, dt);
    changes -= f * dt;
    if (impact == impacts.back())
      for (const Event &event : group)
        if (event.kind != EventKind::impact) tell(event, dt, 0.0 * dt);
  }
}

// The times of releases at a root of the hold force.
void TangentRecorder::Tangents::releases() {
  const PlainMotion here{view(at.displacement), view(at.velocity)};
  for (const Event &event : group) {
    const Stop &stop = scene.stops[event.stop];
    const Row force = force_change(scene, options.by, static_cast<std::size_t>(event.mass - 1),
                                   event.instant.phase, here, changes);
    const double rate = sign(stop.side) * pressing_force_rate(scene, stop, at);
    tell(event, -force / rate, 0.0 * force);
  }
}

// `changes` are here those at the event, not yet at the time of the event.
void TangentRecorder::Tangents::extend_sequence(const Event &impact, const Row &dt) {
  if (impact.falling == 0 || sequence.nodes.empty() || sequence.stop != impact.stop)
    sequence = {impact.stop};
  if (sequence.impacts++ % stride_of(law_of(scene, scene.stops[impact.stop])) != 0) return;
  if (sequence.nodes.size() == most_tangent_nodes) sequence.nodes.erase(sequence.nodes.begin());
  // As if the mass stuck here and now.
  const auto mass = static_cast<std::size_t>(impact.mass - 1);
  Held resting = held;
  resting[mass] = static_cast<signed char>(impact.side);
  std::vector<double> v = at.velocity;
  v[mass] = 0.0;
  Eigen::MatrixXd at_rest = changes - vector_field(resting, v) * dt;
  hold(at_rest, resting);
  const PlainMotion motion_at_rest{view(at.displacement), view(v)};
  Row limit = dt;
  if (options.events) limit += time_left(impact, motion_at_rest, at_rest, dt);
  sequence.nodes.push_back({impact.instant, std::move(at_rest), std::move(limit), motion_at_rest});
}

// How the time left changes that an impact predicts to leading order, 2 m v / (press (1 - r)) of
// the speed v after it. What it predicts is off by x^2 times a smooth function of x.
Row TangentRecorder::Tangents::time_left(const Event &impact, const PlainMotion &at_rest,
                                         const Eigen::MatrixXd &moved, const Row &dt) const {
  const Stop &stop = scene.stops[impact.stop];
  const double sigma = sign(stop.side), r = law_of(scene, stop).at_rest();
  const auto p = static_cast<std::size_t>(impact.mass - 1);
  const double press = pressing_force(scene, stop, at);
  if (!(press > 0.0 && r < 1.0)) return 0.0 * dt;
  const Row by_press =
      sigma * force_change(scene, options.by, p, impact.instant.phase, at_rest, moved) +
      pressing_force_rate(scene, stop, at) * dt;
  const Row by_speed = -sigma * changes.row(masses() + impact.mass - 1);
  const double speed = -sigma * impact.velocity_after;
  const double left = 2.0 * scene.mass[p] * speed / (press * (1.0 - r));
  Row change = by_speed / speed - by_press / press + ones(Kind::mass, p + 1) / scene.mass[p] +
               ones(Kind::restitution, impact.stop + 1) / (1.0 - r);
  // In units of 1 / Omega the same time is longer.
  if (scene.omega > 0.0) change += ones(Kind::omega, 0) / scene.omega;
  return left * change;
}

void TangentRecorder::Tangents::chatter_limit(const Held &after) {
  Sequence chatter = std::exchange(sequence, {});
  if (chatter.nodes.empty() || group.size() > 1 || chatter.stop != group.front().stop) {
    // A mass at rest at its stop in the initial state is as good as held.
    const bool at_start = elapsed(started, now, clock) == 0.0;
    if (!at_start) differentiable = false;
    const Row none =
        Row::Constant(changes.cols(), at_start ? 0.0 : std::numeric_limits<double>::quiet_NaN());
    for (const Event &event : group) tell(event, none, 0.0 * none);
    return;
  }
  std::vector<double> x;
  for (Node &node : chatter.nodes) {
    x.push_back(elapsed(node.instant, now, clock));
    carry_all(after, node.instant, x.back(), node.motion, node.changes);
  }
  const double last_error = std::pow(x.back() * modes.enter(unforced, held, counters).fastest, 2);
  // The speeds of late impacts fall as r^n; by r the n comes down as a factor.
  const ImpactLaw law = law_of(scene, scene.stops[chatter.stop]);
  const double ratio = std::pow(law.at_rest(), static_cast<double>(stride_of(law)));
  const Row by_ratio = ones(Kind::restitution, chatter.stop + 1);
  // Columns of the start by themselves: what else is asked for does not touch them.
  std::vector<std::vector<Eigen::Index>> kinds(3);
  for (Eigen::Index k = 0; k < changes.cols(); ++k)
    kinds[k < changes.cols() - parameters() ? 0 : by_ratio(k) == 0.0 ? 1 : 2].push_back(k);
  Row dt = Row::Zero(changes.cols());
  for (std::size_t kind = 0; kind < kinds.size(); ++kind) {
    const std::vector<Eigen::Index> &columns = kinds[kind];
    if (columns.empty()) continue;
    std::vector<Eigen::MatrixXd> of_state, of_time;
    for (std::size_t i = 0; i < x.size(); ++i) {
      of_state.emplace_back(chatter.nodes[i].changes(Eigen::all, columns));
      of_time.emplace_back(chatter.nodes[i].time(columns));
    }
    const Limit limit = kind == 2 ? limit_in_number(of_state, ratio, 3, true, last_error)
                                  : limit_in_time(of_state, x, last_error);
    changes(Eigen::all, columns) = limit.values;
    chatter_error = std::max(chatter_error, limit.error);
    if (options.events)
      dt(columns) = limit_in_number(of_time, ratio, 2, kind == 2, last_error).values;
  }
  tell(group.front(), dt, 0.0 * dt);
}

}  // namespace vibro_impact
