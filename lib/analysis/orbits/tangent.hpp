// Tangents of a run: the exact derivative of the state at a later time by the state at the start.
//
// Between events the difference of two neighbouring motions obeys the unforced equations of the
// contact mode. At an event it jumps (saltation), because the neighbour reaches the stop at another
// time. Let dz- and dz+ be the difference before and after the event, f- and f+ the vector fields
// before and after everything that happens at that instant (sticking at r = 0, the release of a
// neighbour by the jump of its hold force), and R the derivative of the impact law of Eq. 16. Then
//   dt = -dx_i / x_i',   E = dz- + f- dt,   dz+ = R E - f+ dt,
// where E is the difference of the states at their events. A release at a root of the hold force
// (Eqs. 12-13, 23) changes nothing: state and vector field are continuous there.
//
// Complete chatter: let x be the time from an impact to the accumulation point. The other masses
// move as if the chattering mass were held from that impact on, up to terms of order x^3. So do the
// tangents: those computed with the mass held from an impact on differ at the accumulation point by
// x^3 times a smooth function of x, which is extrapolated to x = 0 over consecutive impacts. A
// sticking mass has no freedom: each costs the derivative two of its rank.
#pragma once

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <utility>
#include <vector>

#include "motion_state.hpp"
#include "orbit_tolerances.hpp"
#include "vibro_impact/analysis/periodic_orbit.hpp"

namespace vibro_impact {

// Moves tangents through a flight in one contact mode. In modal coordinates they obey
// y'' + kappa y' + lambda y = 0 with kappa = beta lambda. With the response h to an impulse, y
// after a time is (h' + kappa h) y + h y', and its slope is h' y' - lambda h y.
class TangentFlow {
 public:
  TangentFlow(const Scene &scene, const Held &held)
      : beta_(scene.beta), modes_(detail::modal_basis(scene, free_masses(held))) {
  }

  // Rows of held masses become zero, also where no time passes.
  void move(Eigen::MatrixXd &tangents, double time) const {
    const Eigen::Index n = modes_.shape.rows();
    Eigen::MatrixXd y = modes_.inverse * tangents.topRows(n),
                    dy = modes_.inverse * tangents.bottomRows(n);
    for (Eigen::Index j = 0; j < y.rows(); ++j) {
      const double lambda = modes_.lambda(j), kappa = beta_ * lambda;
      const auto [h, dh] = impulse_response(Oscillator<double>(lambda, kappa), time);
      const Eigen::RowVectorXd value = y.row(j), slope = dy.row(j);
      y.row(j) = (dh + kappa * h) * value + h * slope;
      dy.row(j) = -lambda * h * value + dh * slope;
    }
    tangents << modes_.shape * y, modes_.shape * dy;
  }

 private:
  double beta_;
  detail::ModalBasis modes_;
};

// The value at x = 0 of the polynomial without x and x^2 through the values from `first` on. Its
// weights are those of Lagrange for 1/x^2 times the polynomial, divided by their sum.
inline Eigen::MatrixXd polynomial_at_zero(const std::vector<Eigen::MatrixXd> &values,
                                          const std::vector<double> &x, std::size_t first) {
  Eigen::MatrixXd weighted = 0.0 * values.back();
  double sum = 0.0;
  for (std::size_t i = first; i < values.size(); ++i) {
    double product = x[i] * x[i];
    for (std::size_t j = first; j < values.size(); ++j)
      if (j != i) product *= 1.0 - x[i] / x[j];
    weighted += (1.0 / product) * values[i];
    sum += 1.0 / product;
  }
  return weighted / sum;
}

// Extrapolates values at consecutive impacts to the limit of their chatter. Value k, a time x[k]
// before the limit, differs from the limit by x[k]^3 times a smooth function of x. `error` is the
// estimated relative error of the last value alone. More values approach the limit faster, but
// amplify rounding. So of the limits extrapolated from the last 1, 2, ... values the one is taken
// that differs least from the one before.
inline Eigen::MatrixXd extrapolate_chatter(const std::vector<Eigen::MatrixXd> &values,
                                           const std::vector<double> &x, double error) {
  Eigen::MatrixXd best = values.back(), previous = best;
  double least = error * best.lpNorm<Eigen::Infinity>();
  for (std::size_t first = values.size() - 1; first-- > 0;) {
    Eigen::MatrixXd limit = polynomial_at_zero(values, x, first);
    const double difference = (limit - previous).lpNorm<Eigen::Infinity>();
    if (difference < least) {
      best = limit;
      least = difference;
    }
    previous = std::move(limit);
  }
  return best;
}

// A recorder that carries the tangents from instant to instant, so that a run that does not ask for
// them pays nothing. The events of one instant are gathered in `group_` until a later event, or the
// end, shows that they are complete.
class TangentRecorder : public Recorder {
 public:
  // The tangents at the start of the run are the unit vectors of the free coordinates, and zero for
  // the coordinates of masses that are held.
  TangentRecorder(const Scene &scene, const MotionState &start)
      : scene_(scene),
        clock_(scene.omega),
        start_(start.instant),
        now_(start.instant),
        held_(start.held) {
    const auto size = static_cast<Eigen::Index>(2 * start.held.size());
    tangents_ = Eigen::MatrixXd::Zero(size, size);
    const std::vector<std::size_t> free = free_coordinates(start.held);
    tangents_(free, free).setIdentity();
  }

  void event(const Event &event, const Moment &moment) override {
    if (!group_.empty() && group_.front().instant < event.instant) apply_group();
    if (group_.empty()) carry_to(event.instant);
    state_ = state_at(moment, held_);
    if (group_.empty()) velocity_before_ = state_.velocity;
    // The moment of the first impact of an instant has the velocities after all of them.
    undo_jump(event, velocity_before_);
    group_.push_back(event);
  }

  // The tangents at the end of the run, 2N x 2N. To be called once, after the run.
  Eigen::MatrixXd finish(const Instant &end) {
    if (!group_.empty()) apply_group();
    carry_to(end);
    return tangents_;
  }

  // False when the motion met an event at which its state is not differentiable: impacts of several
  // masses at one instant, grazing, a mass coming to rest at its stop without chatter.
  bool differentiable() const {
    return differentiable_;
  }

 private:
  // An impact, and the tangents just after it with its mass held from then on.
  struct Node {
    Instant instant;
    Eigen::MatrixXd tangents;
  };

  Scene scene_;
  Clock clock_;
  Instant start_, now_;
  Held held_;  // before the events of the group
  Eigen::MatrixXd tangents_;
  std::map<Held, TangentFlow> flows_ = {};
  bool differentiable_ = true;
  std::vector<Event> group_ = {};
  MotionState state_ = {};                    // after the events of the group
  std::vector<double> velocity_before_ = {};  // before them
  std::vector<Node> nodes_ = {};  // consecutive impacts at one stop, with nothing in between
  int nodes_stop_ = 0;            // the number of the stop

  void carry(const Held &held, double time, Eigen::MatrixXd &tangents) {
    flows_.try_emplace(held, scene_, held).first->second.move(tangents, time);
  }

  void carry_to(const Instant &instant) {
    carry(held_, elapsed(now_, instant, clock_), tangents_);
    now_ = instant;
  }

  // (x', x'') where the masses are now, in a contact mode and at velocities of its own.
  Eigen::VectorXd vector_field(const Held &held, const std::vector<double> &velocity) const {
    const MotionState state{state_.instant, state_.displacement, velocity, held};
    const std::vector<double> a = acceleration_of(scene_, state);
    Eigen::VectorXd field(2 * static_cast<Eigen::Index>(a.size()));
    field << view(velocity), view(a);
    return field;
  }

  void apply_group() {
    const Held after = group_.back().held;
    const auto has = [this](EventKind kind) {
      return std::ranges::find(group_, kind, &Event::kind) != group_.end();
    };
    const int stop = group_.front().stop;
    if (group_.size() > 1 || has(EventKind::release) || stop != nodes_stop_) nodes_.clear();
    nodes_stop_ = stop;
    if (has(EventKind::impact))
      apply_impacts(after);
    else if (has(EventKind::stick))
      apply_stick(after);
    // A release at a root of the hold force changes nothing: state and vector field are continuous.
    held_ = after;
    group_.clear();
  }

  void apply_impacts(const Held &after) {
    std::vector<Event> impacts;
    std::ranges::copy_if(group_, std::back_inserter(impacts),
                         [](const Event &event) { return event.kind == EventKind::impact; });
    if (impacts.size() > 1) differentiable_ = false;  // it depends on which mass is first
    std::vector<double> velocity = velocity_before_;
    for (std::size_t k = 0; k < impacts.size(); ++k) {
      const Event &impact = impacts[k];
      const double speed = impact.velocity_before;
      if (speed == 0.0) {
        differentiable_ = false;
        continue;
      }
      const auto mass = static_cast<std::size_t>(impact.mass - 1);
      const auto row = static_cast<Eigen::Index>(mass);
      const Eigen::RowVectorXd dt = -tangents_.row(row) / speed;
      tangents_ += vector_field(held_, velocity) * dt;
      tangents_.row(row).setZero();
      const ImpactLaw law = law_of(scene_, stop_of(scene_, impact));
      tangents_.row(scene_.masses() + row) *= -law.slope(std::abs(speed));
      velocity[mass] = impact.velocity_after;
      if (group_.size() == 1) add_node(impact, dt, velocity);
      tangents_ -= vector_field(k + 1 < impacts.size() ? held_ : after, velocity) * dt;
    }
  }

  // To be called while the tangents are still those of the states at their events. The mass is held
  // from then on, at rest; its own rows drop out when the node is carried to the limit.
  void add_node(const Event &impact, const Eigen::RowVectorXd &dt, std::vector<double> velocity) {
    if (nodes_.size() == most_tangent_nodes) nodes_.erase(nodes_.begin());
    velocity[static_cast<std::size_t>(impact.mass - 1)] = 0.0;
    nodes_.push_back({impact.instant, tangents_ - vector_field(held_, velocity) * dt});
  }

  // A mass comes to rest: at the end of a chatter, or in the initial state, where it counts as
  // held. Without either the state is not differentiable.
  void apply_stick(const Held &after) {
    if (nodes_.empty()) {
      differentiable_ = differentiable_ && elapsed(start_, now_, clock_) == 0.0;
      return;
    }
    // In the units of the coordinates the largest entry of a difference measures all of it.
    const Eigen::VectorXd units = coordinate_units(scene_, Held(after.size(), 0));
    std::vector<double> time_left;
    std::vector<Eigen::MatrixXd> values;
    for (const Node &node : nodes_) {
      time_left.push_back(elapsed(node.instant, now_, clock_));
      Eigen::MatrixXd tangents = node.tangents;
      carry(after, time_left.back(), tangents);
      values.push_back(units.asDiagonal().inverse() * tangents * units.asDiagonal());
    }
    const double last_error = std::pow(time_left.back() * rate_bound(scene_), 2);
    tangents_ = units.asDiagonal() * extrapolate_chatter(values, time_left, last_error) *
                units.asDiagonal().inverse();
  }
};

}  // namespace vibro_impact
