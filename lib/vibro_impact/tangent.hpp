// Tangents of a run: the exact derivative of the state at a later time by the state at the start.
//
// Between events the difference of two neighbouring motions obeys the unforced equations of the
// contact mode. At an event it jumps (saltation), because the neighbour reaches the stop at another
// time: with E = dz- + f- dt the change of the state *at the event* and R the impact law of Eq. 16,
//   dt = -dx_i / x_i',   dz+ = R E - f+ dt,
// f- and f+ being the vector fields before the event and after everything that happens at that
// instant (sticking at r = 0, the release of a neighbour by the jump of its hold force). A release
// at a root of the hold force (Eqs. 12-13, 23) changes nothing: state and vector field are
// continuous there.
//
// Complete chatter: on consecutive impacts R E and dt are smooth functions of the impact speed, as
// the states and times themselves are (chatter_limit.hpp); their value at speed zero is the
// derivative of the state and time at the accumulation point. The held mass has no freedom left:
// each sticking mass costs the derivative two of its rank.
//
// A recorder, so that a run that does not ask for tangents pays nothing.
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <limits>
#include <vector>

#include "chatter_limit.hpp"
#include "expansion.hpp"
#include "record.hpp"
#include "scene.hpp"

namespace vibro_impact {

// Forces of the links of the chain on its masses, -K x, for every column of x (N rows).
inline Eigen::MatrixXd link_forces(const Scene &scene, const Eigen::MatrixXd &x) {
  Eigen::MatrixXd force(x.rows(), x.cols());
  for (Eigen::Index i = 0; i < x.rows(); ++i) {
    const auto link = static_cast<std::size_t>(i);
    force.row(i) = -scene.stiffness[link] * x.row(i);
    if (i > 0) force.row(i) += scene.stiffness[link] * x.row(i - 1);
    if (i + 1 < x.rows()) force.row(i) += scene.stiffness[link + 1] * (x.row(i + 1) - x.row(i));
  }
  return force;
}

// Accelerations of all masses in the contact mode `held` (Eq. 4); zero for a held mass.
inline Eigen::VectorXd acceleration(const Scene &scene, const Held &held, const Eigen::VectorXd &x,
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

struct TangentRecorder {
  // The derivative of (x_1 .. x_N, x_1' .. x_N') at `now`, 2N x columns. Rows of held masses are
  // zero.
  Eigen::MatrixXd tangent;
  // False when the motion met an event at which its state is not differentiable: impacts of several
  // masses at one instant, grazing, a mass coming to rest at its stop without chatter.
  bool differentiable = true;
  // Largest estimated error of a chatter limit of the tangents, relative to the tangents there.
  double chatter_error = 0.0;
  Instant now;

  // `start` is the state the run starts from, `columns` (2N x any number) the changes of it that
  // are followed; the rows of masses held there must be zero.
  TangentRecorder(const Scene &scene_of_run, const MotionState &start, Eigen::MatrixXd columns)
      : tangent(std::move(columns)),
        now(start.instant),
        scene(scene_of_run),
        unforced(scene_of_run),
        clock(scene_of_run.omega),
        held(start.held),
        stride(scene.restitution > 0.0 && scene.restitution < 1.0
                   ? chatter_stride(scene.restitution)
                   : 1) {
    unforced.amplitude.clear();
    started = now;
  }

  void event(const Event &event, const Moment &moment) {
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

  // Brings the tangents to the end of the run. To be called once, after the run.
  void finish(const Instant &end) {
    if (!group.empty()) close();
    flow_to(end);
  }

 private:
  // An impact of a chatter sequence: the derivatives of its instant (first row) and of the state
  // just after it (2N rows).
  struct Node {
    double speed;
    Instant instant;
    Eigen::MatrixXd derivative;
  };

  Scene scene, unforced;
  Clock clock;
  Instant started;
  Held held;  // up to the events of `group`
  long long stride;
  Modes<Eigen::Dynamic> modes = {};
  Counters counters = {};
  // The events of one instant, gathered until a later one shows that they are all.
  std::vector<Event> group = {};
  Eigen::VectorXd displacement = {}, velocity_before = {}, velocity = {};
  std::vector<Node> sequence = {};  // consecutive impacts of one mass
  int sequence_mass = 0;
  long long sequence_impacts = 0;
  double sequence_speed = 0.0;

  Eigen::Index masses() const {
    return tangent.rows() / 2;
  }
  static bool same(const Instant &a, const Instant &b) {
    return a.cycle == b.cycle && a.phase == b.phase;
  }
  void clear_rows_of_held() {
    for (Eigen::Index i = 0; i < masses(); ++i)
      if (held[static_cast<std::size_t>(i)] != 0) {
        tangent.row(i).setZero();
        tangent.row(masses() + i).setZero();
      }
  }
  Eigen::VectorXd vector_field(const Held &mode, const Eigen::VectorXd &v) const {
    Eigen::VectorXd f(2 * masses());
    f << v, acceleration(scene, mode, displacement, v, group.front().instant);
    return f;
  }

  void flow_to(const Instant &instant) {
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

  // Short flights in physical coordinates: late in a chatter the change of the chattering mass is
  // small, and modal coordinates would lose it beside the others.
  void flow_by_series(double tau, int order) {
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

  void close() {
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

  void saltation(const std::vector<const Event *> &impacts, const Held &after, bool impacts_only) {
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

  // `tangent` is here the derivative of the state at the event.
  void extend_sequence(const Event &impact, const Eigen::RowVectorXd &dt) {
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

  void chatter_limit(const Held &after) {
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
};

}  // namespace vibro_impact
