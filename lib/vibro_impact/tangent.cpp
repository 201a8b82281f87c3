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
  flow_columns(tangent, elapsed(now, instant, clock), held);
  now = instant;
}

void TangentRecorder::flow_columns(Eigen::MatrixXd &columns, double tau, const Held &in) {
  if (!(tau > 0.0)) return;
  const ContactMode<Eigen::Dynamic> &mode = modes.enter(unforced, in, counters);
  if (mode.fastest * tau < 0.5) {
    flow_by_series(columns, tau, order_for(mode.fastest * tau, below_rounding), in);
    return;
  }
  const Eigen::MatrixXd x = columns.topRows(masses()), v = columns.bottomRows(masses());
  const Eigen::MatrixXd value = mode.to_modal * x + mode.velocity_to_modal * v,
                        slope = mode.to_modal * v;
  const Eigen::ArrayXd one = Eigen::ArrayXd::Ones(mode.lanes()), none = 0.0 * one;
  Eigen::ArrayXd value_by_value, slope_by_value, value_by_slope, slope_by_slope;
  flow(mode, unforced, one, none, tau, value_by_value, slope_by_value);
  flow(mode, unforced, none, one, tau, value_by_slope, slope_by_slope);
  columns << mode.shape * (value_by_value.matrix().asDiagonal() * value +
                           value_by_slope.matrix().asDiagonal() * slope),
      mode.shape * (slope_by_value.matrix().asDiagonal() * value +
                    slope_by_slope.matrix().asDiagonal() * slope);
}

void TangentRecorder::flow_by_series(Eigen::MatrixXd &columns, double tau, int order,
                                     const Held &in) const {
  Eigen::MatrixXd term = columns.topRows(masses()), next = tau * columns.bottomRows(masses());
  Eigen::MatrixXd x = term + next, v = next;
  for (int n = 0; n + 2 <= order; ++n) {
    Eigen::MatrixXd last =
        link_forces(unforced, tau * tau * term + (tau * scene.beta * (n + 1)) * next) /
        ((n + 1.0) * (n + 2.0));
    for (Eigen::Index i = 0; i < masses(); ++i) {
      const auto mass = static_cast<std::size_t>(i);
      last.row(i) *= in[mass] != 0 ? 0.0 : 1.0 / scene.mass[mass];
    }
    x += last;
    v += (n + 2) * last;
    term = std::move(next);
    next = std::move(last);
  }
  columns << x, v / tau;
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
  // As if the mass stuck here and now.
  const Eigen::Index row = impact.mass - 1;
  Held resting = held;
  resting[static_cast<std::size_t>(row)] = static_cast<signed char>(impact.side);
  Eigen::VectorXd v = velocity;
  v(row) = 0.0;
  Eigen::MatrixXd derivative = tangent - vector_field(resting, v) * dt;
  derivative.row(row).setZero();
  derivative.row(masses() + row).setZero();
  sequence.push_back({impact.instant, std::move(derivative)});
}

void TangentRecorder::chatter_limit(const Held &after) {
  const bool one_mass = group.size() == 1;
  if (sequence.empty() || !one_mass || sequence_mass != group.front().mass) {
    // A mass at rest at its stop in the initial state is as good as held.
    if (!same(now, started)) differentiable = false;
    sequence.clear();
    return;
  }
  std::vector<double> x;
  for (Node &node : sequence) {
    x.push_back(elapsed(node.instant, now, clock));
    flow_columns(node.derivative, x.back(), after);
  }
  // The polynomial without x and x^2 through the last nodes, at x = 0; of all of them the one that
  // differs least from that with one node less.
  const std::size_t last = sequence.size() - 1;
  tangent = sequence[last].derivative;
  const double size = std::max(tangent.cwiseAbs().maxCoeff(), 1e-300);
  double error = std::pow(x[last] * modes.enter(unforced, held, counters).fastest, 2);
  Eigen::MatrixXd previous = tangent;
  for (std::size_t first = last; first-- > 0;) {
    Eigen::MatrixXd limit = Eigen::MatrixXd::Zero(tangent.rows(), tangent.cols());
    double sum = 0.0;
    for (std::size_t i = first; i <= last; ++i) {
      double product = x[i] * x[i];
      for (std::size_t j = first; j <= last; ++j)
        if (j != i) product *= 1.0 - x[i] / x[j];
      limit += (1.0 / product) * sequence[i].derivative;
      sum += 1.0 / product;
    }
    limit /= sum;
    const double difference = (limit - previous).cwiseAbs().maxCoeff() / size;
    if (difference < error) {
      error = difference;
      tangent = limit;
    }
    previous = limit;
  }
  chatter_error = std::max(chatter_error, error);
  sequence.clear();
}

}  // namespace vibro_impact
