#include "vibro_impact/analysis/tangent.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

#include "motion_state.hpp"
#include "tolerances.hpp"
#include "vibro_impact/analysis/natural_modes.hpp"
#include "vibro_impact/analysis/pressing_force.hpp"

namespace vibro_impact {

namespace {

// Moves tangents through a flight in one contact mode. In modal coordinates they obey
// y'' + beta lambda y' + lambda y = 0.
class TangentFlow {
 public:
  TangentFlow(const Scene &scene, const Held &held)
      : beta_(scene.beta), modes_(natural_modes(scene, held)), shape_(view(modes_.shape)) {
    to_modal_ = shape_.transpose() * view(scene.mass).asDiagonal();
  }

  void move(Eigen::MatrixXd &tangents, double time) const {
    const Eigen::Index n = shape_.rows();
    Eigen::MatrixXd y = to_modal_ * tangents.topRows(n), dy = to_modal_ * tangents.bottomRows(n);
    for (Eigen::Index j = 0; j < y.rows(); ++j) {
      const double lambda = modes_.lambda[static_cast<std::size_t>(j)];
      const OscillatorState of_value = free_response(beta_ * lambda, lambda, {1.0, 0.0}, time);
      const OscillatorState of_slope = free_response(beta_ * lambda, lambda, {0.0, 1.0}, time);
      const Eigen::RowVectorXd value = y.row(j), slope = dy.row(j);
      y.row(j) = of_value.value * value + of_slope.value * slope;
      dy.row(j) = of_value.slope * value + of_slope.slope * slope;
    }
    tangents << shape_ * y, shape_ * dy;
  }

 private:
  double beta_;
  NaturalModes modes_;
  Eigen::MatrixXd shape_, to_modal_;
};

// The extrapolated limit of a chatter, and its estimated error relative to the largest value.
struct ExtrapolatedLimit {
  Eigen::MatrixXd values;
  double error;
};

double largest(const Eigen::MatrixXd &matrix) {
  return matrix.size() == 0 ? 0.0 : matrix.cwiseAbs().maxCoeff();
}

// The value at x = 0 of the polynomial without x and x^2 through the values from `first` on. Its
// weights are those of Lagrange for 1/x^2 times the polynomial, divided by their sum.
Eigen::MatrixXd polynomial_at_zero(const std::vector<Eigen::MatrixXd> &values,
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
ExtrapolatedLimit extrapolate_chatter(const std::vector<Eigen::MatrixXd> &values,
                                      const std::vector<double> &x, double error) {
  ExtrapolatedLimit best{values.back(), error};
  const double size = std::max(largest(values.back()), 1e-300);
  Eigen::MatrixXd previous = values.back();
  for (std::size_t first = values.size() - 1; first-- > 0;) {
    Eigen::MatrixXd limit = polynomial_at_zero(values, x, first);
    const double difference = largest(limit - previous) / size;
    if (difference < best.error) best = {limit, difference};
    previous = std::move(limit);
  }
  return best;
}

}  // namespace

// The tangents, carried from instant to instant. The events of one instant are gathered in `group_`
// until a later event, or the end, shows that they are complete.
class TangentRecorder::Tangents {
 public:
  Tangents(const Scene &scene, const MotionState &start, const Matrix &columns)
      : scene_(scene),
        clock_(scene.omega),
        start_(start.instant),
        now_(start.instant),
        held_(start.held),
        tangents_(view(columns)) {
  }

  void event(const Event &event, const Moment &moment) {
    require(event.stop < scene_.stops.size() && scene_.stops[event.stop].mass == event.mass &&
                moment.masses() == scene_.masses(),
            "tangents: an event at stop ", event.stop, " of mass ", event.mass, " of ",
            moment.masses(), ": not of the scene they were made for");
    if (!group_.empty() && group_.front().instant < event.instant) apply_group();
    if (group_.empty()) carry_to(event.instant);
    state_ = state_at(moment, held_);
    if (group_.empty()) velocity_before_ = state_.velocity;
    // The moment of the first impact of an instant has the velocities after all of them.
    if (event.kind == EventKind::impact) {
      const auto mass = static_cast<std::size_t>(event.mass - 1);
      velocity_before_[mass] = event.velocity_before;
    }
    group_.push_back(event);
  }

  TangentsAtEnd finish(const Instant &end) {
    require(end.phase >= 0.0 && end.phase < clock_.period &&
                static_cast<double>(end.cycle) <= most_periods &&
                elapsed(start_, end, clock_) >= 0.0,
            "tangents: an end at phase ", end.phase, " in period ", end.cycle,
            ": must not lie before the start");
    if (!group_.empty()) apply_group();
    carry_to(end);
    return {matrix_of(tangents_), differentiable_, chatter_error_};
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
  double chatter_error_ = 0.0;
  std::vector<Event> group_ = {};
  MotionState state_ = {};                    // after the events of the group
  std::vector<double> velocity_before_ = {};  // before them
  std::vector<Node> nodes_ = {};  // consecutive impacts at one stop, with nothing in between
  std::size_t nodes_stop_ = 0;    // the index of the stop

  // Rows of held masses become zero, also where no time passes.
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
    const std::vector<double> a = acceleration(scene_, state);
    Eigen::VectorXd field(2 * static_cast<Eigen::Index>(a.size()));
    field << view(velocity), view(a);
    return field;
  }

  void apply_group() {
    const Held after = group_.back().held;
    std::vector<Event> impacts;
    bool sticks = false;
    for (const Event &event : group_) {
      if (event.kind == EventKind::impact) impacts.push_back(event);
      sticks = sticks || event.kind == EventKind::stick;
    }
    const Event &first = group_.front();
    if (group_.size() > 1 || first.kind == EventKind::release || first.stop != nodes_stop_)
      nodes_.clear();
    nodes_stop_ = first.stop;
    if (!impacts.empty())
      apply_impacts(impacts, after);
    else if (sticks)
      apply_stick(after);
    // A release at a root of the hold force changes nothing: state and vector field are continuous.
    held_ = after;
    group_.clear();
  }

  void apply_impacts(const std::vector<Event> &impacts, const Held &after) {
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
      const ImpactLaw law = law_of(scene_, scene_.stops[impact.stop]);
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
    std::vector<double> time_left;
    std::vector<Eigen::MatrixXd> values;
    for (const Node &node : nodes_) {
      time_left.push_back(elapsed(node.instant, now_, clock_));
      values.push_back(node.tangents);
      carry(after, time_left.back(), values.back());
    }
    const double last_error = std::pow(time_left.back() * rate_bound(scene_), 2);
    const ExtrapolatedLimit limit = extrapolate_chatter(values, time_left, last_error);
    tangents_ = limit.values;
    chatter_error_ = std::max(chatter_error_, limit.error);
  }
};

TangentRecorder::TangentRecorder(const Scene &scene, const MotionState &start,
                                 const Matrix &columns) {
  check(scene);
  require_fits(scene, start);
  const std::size_t n = scene.mass.size();
  require(columns.rows == 2 * n && columns.values.size() % (2 * n) == 0 &&
              columns.values.size() / (2 * n) == columns.columns,
          "columns: ", columns.rows, " rows given, the chain has ", 2 * n,
          " coordinates and velocities");
  for (std::size_t i = 0; i < 2 * n; ++i)
    for (std::size_t k = 0; k < columns.columns; ++k)
      require(start.held[i % n] == 0 || columns(i, k) == 0.0, "column ", k + 1,
              ": must be zero for mass ", i % n + 1, ", which is held");
  tangents_ = std::make_unique<Tangents>(scene, start, columns);
}

TangentRecorder::~TangentRecorder() = default;

void TangentRecorder::event(const Event &event, const Moment &moment) {
  require(tangents_ != nullptr, "tangents: an event after the end");
  tangents_->event(event, moment);
}

TangentsAtEnd TangentRecorder::finish(const Instant &end) {
  require(tangents_ != nullptr, "tangents: finished already");
  return std::exchange(tangents_, nullptr)->finish(end);
}

}  // namespace vibro_impact
