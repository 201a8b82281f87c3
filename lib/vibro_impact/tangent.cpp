#include "tangent.hpp"

#include <cmath>

#include "chatter_limit.hpp"
#include "expansion.hpp"

namespace vibro_impact {

Eigen::MatrixXd link_forces(const Scene &scene, const Eigen::MatrixXd &x) {
  Eigen::MatrixXd force(x.rows(), x.cols());
  for (Eigen::Index i = 0; i < x.rows(); ++i) {
    const auto link = static_cast<std::size_t>(i);
    force.row(i) = -scene.stiffness[link] * x.row(i);
    if (i > 0) force.row(i) += scene.stiffness[link] * x.row(i - 1);
    if (i + 1 < x.rows()) force.row(i) += scene.stiffness[link + 1] * (x.row(i + 1) - x.row(i));
  }
  return force;
}

Eigen::VectorXd acceleration(const Scene &scene, const Held &held, const Eigen::VectorXd &x,
                             const Eigen::VectorXd &v, const Instant &instant) {
  Eigen::VectorXd a = link_forces(scene, x + scene.beta * v);
  const double forcing = std::cos(scene.omega * instant.phase);
  for (Eigen::Index i = 0; i < a.size(); ++i) {
    const auto mass = static_cast<std::size_t>(i);
    if (scene.forced()) a(i) += scene.amplitude[mass] * forcing;
    a(i) = held[mass] != 0 ? 0.0 : a(i) / scene.mass[mass];
  }
  return a;
}

TangentRecorder::TangentRecorder(const Scene &scene_of_run, const MotionState &start,
                                 Eigen::MatrixXd columns)
    : tangent(std::move(columns)),
      now(start.instant),
      scene(scene_of_run),
      unforced(scene_of_run),
      clock(scene_of_run.omega),
      held(start.held),
      stride(scene.restitution > 0.0 && scene.restitution < 1.0 ? chatter_stride(scene.restitution)
                                                                : 1) {
  unforced.amplitude.clear();
  started = now;
}

void TangentRecorder::event(const Event &event, const Moment &moment) {
  if (!group.empty() && same(group.front().instant, event.instant) == false) close();
  if (group.empty()) {
    flow_to(event.instant);
    velocity_before.resize(masses());
    for (Eigen::Index i = 0; i < masses(); ++i)
      velocity_before(i) = moment.velocity(static_cast<int>(i) + 1);
  }
  // All impacts of an instant have been applied when the first of them is told.
  if (event.kind == EventKind::impact) velocity_before(event.mass - 1) = event.velocity_before;
  displacement.resize(masses());
  velocity.resize(masses());
  for (Eigen::Index i = 0; i < masses(); ++i) {
    displacement(i) = moment.displacement(static_cast<int>(i) + 1);
    velocity(i) = moment.velocity(static_cast<int>(i) + 1);
  }
  if (event.kind == EventKind::impact) velocity(event.mass - 1) = event.velocity_after;
  group.push_back(event);
}

void TangentRecorder::finish(const Instant &end) {
  if (!group.empty()) close();
  flow_to(end);
}

void TangentRecorder::clear_rows_of_held() {
  for (Eigen::Index i = 0; i < masses(); ++i)
    if (held[static_cast<std::size_t>(i)] != 0) {
      tangent.row(i).setZero();
      tangent.row(masses() + i).setZero();
    }
}

Eigen::VectorXd TangentRecorder::vector_field(const Held &mode, const Eigen::VectorXd &v) const {
  Eigen::VectorXd f(2 * masses());
  f << v, acceleration(scene, mode, displacement, v, group.front().instant);
  return f;
}

void TangentRecorder::flow_to(const Instant &instant) {
  const double tau = elapsed(now, instant, clock);
  now = instant;
  if (!(tau > 0.0)) return;
  const ContactMode<Eigen::Dynamic> &mode = modes.enter(unforced, held, counters);
  if (mode.fastest * tau < 0.5) {
    flow_by_series(tau, order_for(mode.fastest * tau));
    return;
  }
  const Eigen::MatrixXd x = tangent.topRows(masses()), v = tangent.bottomRows(masses());
  const Eigen::MatrixXd value = mode.to_modal * x + mode.velocity_to_modal * v,
                        slope = mode.to_modal * v;
  const Eigen::ArrayXd one = Eigen::ArrayXd::Ones(mode.lanes()), none = 0.0 * one;
  Eigen::ArrayXd value_by_value, slope_by_value, value_by_slope, slope_by_slope;
  flow(mode, unforced, one, none, tau, value_by_value, slope_by_value);
  flow(mode, unforced, none, one, tau, value_by_slope, slope_by_slope);
  tangent << mode.shape * (value_by_value.matrix().asDiagonal() * value +
                           value_by_slope.matrix().asDiagonal() * slope),
      mode.shape * (slope_by_value.matrix().asDiagonal() * value +
                    slope_by_slope.matrix().asDiagonal() * slope);
}

void TangentRecorder::flow_by_series(double tau, int order) {
  Eigen::MatrixXd term = tangent.topRows(masses()), next = tau * tangent.bottomRows(masses());
  Eigen::MatrixXd x = term + next, v = next;
  for (int n = 0; n + 2 <= order; ++n) {
    Eigen::MatrixXd last =
        link_forces(unforced, tau * tau * term + (tau * scene.beta * (n + 1)) * next) /
        ((n + 1.0) * (n + 2.0));
    for (Eigen::Index i = 0; i < masses(); ++i) {
      const auto mass = static_cast<std::size_t>(i);
      last.row(i) *= held[mass] != 0 ? 0.0 : 1.0 / scene.mass[mass];
    }
    x += last;
    v += (n + 2) * last;
    term = std::move(next);
    next = std::move(last);
  }
  tangent << x, v / tau;
}

void TangentRecorder::close() {
  const Held after = group.back().held;
  std::vector<const Event *> impacts;
  bool impacts_only = true, sticks = false;
  for (const Event &event : group) {
    if (event.kind == EventKind::impact) impacts.push_back(&event);
    impacts_only = impacts_only && event.kind == EventKind::impact;
    sticks = sticks || event.kind == EventKind::stick;
  }
  if (!impacts.empty()) {
    saltation(impacts, after, impacts_only);
  } else if (sticks) {
    chatter_limit(after);
  } else {
    sequence.clear();  // release at a root of the hold force
  }
  held = after;
  clear_rows_of_held();
  group.clear();
}

void TangentRecorder::saltation(const std::vector<const Event *> &impacts, const Held &after,
                                bool impacts_only) {
  if (impacts.size() > 1) differentiable = false;  // it depends on which mass is first
  Eigen::VectorXd f = vector_field(held, velocity_before), v = velocity_before;
  Eigen::RowVectorXd dt;
  for (const Event *impact : impacts) {
    const Eigen::Index x_row = impact->mass - 1, v_row = masses() + x_row;
    if (impact->velocity_before == 0.0) {
      differentiable = false;
      continue;
    }
    dt = -tangent.row(x_row) / impact->velocity_before;
    tangent += f * dt;
    tangent.row(x_row).setZero();
    tangent.row(v_row) *= -scene.restitution;
    v(x_row) = impact->velocity_after;
    const bool last = impact == impacts.back();
    f = last ? vector_field(after, velocity) : vector_field(held, v);
    if (last && impacts.size() == 1 && impacts_only)
      extend_sequence(*impact, dt);
    else if (last)
      sequence.clear();
    tangent -= f * dt;
  }
}

void TangentRecorder::extend_sequence(const Event &impact, const Eigen::RowVectorXd &dt) {
  const double speed = std::abs(impact.velocity_after);
  if (sequence.empty() || sequence_mass != impact.mass || !(speed < sequence_speed)) {
    sequence.clear();
    sequence_mass = impact.mass;
    sequence_impacts = 0;
  }
  sequence_speed = speed;
  if (sequence_impacts++ % stride != 0) return;
  if (sequence.size() == 16) sequence.erase(sequence.begin());
  Eigen::MatrixXd derivative(tangent.rows() + 1, tangent.cols());
  derivative << dt, tangent;
  sequence.push_back({speed, impact.instant, std::move(derivative)});
}

void TangentRecorder::chatter_limit(const Held &after) {
  const bool one_mass = group.size() == 1;
  if (sequence.empty() || !one_mass || sequence_mass != group.front().mass) {
    // A mass at rest at its stop in the initial state is as good as held.
    if (!same(now, started)) differentiable = false;
    sequence.clear();
    return;
  }
  // Neville's table in the impact speed; the column that differs least from the one before.
  const std::size_t last = sequence.size() - 1;
  Eigen::MatrixXd limit = sequence[last].derivative;
  const double size = limit.cwiseAbs().maxCoeff();
  double error =
      elapsed(sequence[last].instant, now, clock) * modes.enter(unforced, held, counters).fastest;
  for (std::size_t column = 1; column <= last; ++column) {
    const Eigen::MatrixXd previous = sequence[last].derivative;
    for (std::size_t i = last; i >= column; --i) {
      const double near = sequence[i].speed, far = sequence[i - column].speed;
      sequence[i].derivative +=
          (sequence[i].derivative - sequence[i - 1].derivative) * (near / (far - near));
    }
    const double difference =
        (sequence[last].derivative - previous).cwiseAbs().maxCoeff() / std::max(size, 1e-300);
    if (difference < error) {
      error = difference;
      limit = sequence[last].derivative;
    }
  }
  chatter_error = std::max(chatter_error, error);
  tangent = limit.bottomRows(tangent.rows()) - vector_field(after, velocity) * limit.row(0);
  sequence.clear();
}

}  // namespace vibro_impact
