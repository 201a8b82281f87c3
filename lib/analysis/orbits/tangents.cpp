#include "tangents.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "orbit_tolerances.hpp"
#include "vibro_impact/analysis/periodic_orbit.hpp"

namespace vibro_impact {

namespace {

// The value at x = 0 of the polynomial without x and x^2 through the values from `first` on.
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

bool joined_by_a_damper(const Scene &scene, int mass, int other) {
  return scene.beta > 0.0 && std::abs(mass - other) == 1 &&
         scene.stiffness[index_of(std::max(mass, other))] > 0.0;
}

// More values approach the limit faster, but amplify rounding: of the limits from the last 1, 2,
// ... values the one is taken that differs least from the one before.
Eigen::MatrixXd extrapolate_chatter(const std::vector<Eigen::MatrixXd> &values,
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

}  // namespace

TangentFlow::TangentFlow(const Scene &scene, const Held &held)
    : beta_(scene.beta), modes_(modal_basis(scene, free_masses(held))) {
}

void TangentFlow::move(Eigen::MatrixXd &tangents, double time) {
  const Eigen::Index n = modes_.shape.rows();
  y_.noalias() = modes_.inverse * tangents.topRows(n);
  dy_.noalias() = modes_.inverse * tangents.bottomRows(n);
  was_ = y_;
  for (Eigen::Index j = 0; j < y_.rows(); ++j) {
    const double lambda = modes_.lambda(j), kappa = beta_ * lambda;
    const auto [h, dh] = impulse_response(Oscillator<double>(lambda, kappa), time);
    y_.row(j) = (dh + kappa * h) * was_.row(j) + h * dy_.row(j);
    dy_.row(j) = -lambda * h * was_.row(j) + dh * dy_.row(j);
  }
  tangents.topRows(n).noalias() = modes_.shape * y_;
  tangents.bottomRows(n).noalias() = modes_.shape * dy_;
}

Tangents::Tangents(const Scene &scene, const MotionState &start, Eigen::MatrixXd first)
    : scene_(scene), clock_(scene.omega), before_(start), tangents_(std::move(first)) {
}

void Tangents::carry(const Held &held, double time, Eigen::MatrixXd &tangents) {
  flows_.try_emplace(held, scene_, held).first->second.move(tangents, time);
}

void Tangents::scale(double factor) {
  tangents_ *= factor;
  for (Node &node : nodes_) {
    node.tangents *= factor;
    node.dt *= factor;
  }
}

// (x', x'') at the knot, in a contact mode and at velocities of its own.
Eigen::VectorXd Tangents::vector_field(const Held &held, const std::vector<double> &v) const {
  const Eigen::Index n = force_.size();
  Eigen::VectorXd field(2 * n);
  for (Eigen::Index i = 0; i < n; ++i) {
    const auto k = static_cast<std::size_t>(i);
    field(i) = v[k];
    field(n + i) = held[k] != 0
                       ? 0.0
                       : (force_(i) + scene_.beta * spring_force(scene_, k, v)) / scene_.mass[k];
  }
  return field;
}

void Tangents::pass(const std::vector<Knot> &knots) {
  for (auto first = knots.begin() + 1; first != knots.end() && why_not_.empty();) {
    auto end = first;  // of the knots of one instant
    std::vector<Event> events;
    for (; end != knots.end() && end->state.instant == first->state.instant; ++end)
      if (end->event) events.push_back(*end->event);
    if (!events.empty() || end == knots.end()) {
      carry(before_.held, elapsed(before_.instant, first->state.instant, clock_), tangents_);
      if (!events.empty()) apply(events, (end - 1)->state);
      before_ = (end - 1)->state;
      at_start_ = false;
    }
    first = end;
  }
}

void Tangents::apply(const std::vector<Event> &events, const MotionState &after) {
  std::vector<Event> impacts;
  const Event *stick = nullptr, *root = nullptr;
  for (const Event &event : events) {
    if (event.kind == EventKind::impact) impacts.push_back(event);
    if (event.kind == EventKind::stick) stick = &event;
    if (event.kind == EventKind::release && !event.by_a_jump) root = &event;
  }
  const int stop = events.front().stop;
  const bool alone = events.size() == 1;
  if (!alone || stop != nodes_stop_ || root) nodes_.clear();
  nodes_stop_ = stop;
  const bool stick_of_impact =
      stick && std::ranges::find(impacts, stick->stop, &Event::stop) != impacts.end();
  if (!impacts.empty() && ((stick && !stick_of_impact) || root))
    why_not_ = line("an impact at ", impacts[0].time, " coincides with a stick or a release");
  else if (!impacts.empty())
    apply_impacts(impacts, after, alone);
  else if (stick)
    apply_stick(after);
}

void Tangents::apply_impacts(const std::vector<Event> &impacts, const MotionState &after,
                             bool alone) {
  force_ = forces_without_dampers(scene_, after);
  std::vector<double> velocity = after.velocity;
  for (auto impact = impacts.rbegin(); impact != impacts.rend(); ++impact)
    velocity[index_of(impact->mass)] = impact->velocity_before;
  for (std::size_t k = 0; k < impacts.size(); ++k) {
    const Event &impact = impacts[k];
    for (std::size_t j = 0; j < k; ++j)
      if (joined_by_a_damper(scene_, impacts[j].mass, impact.mass))
        why_not_ = line("masses ", impacts[j].mass, " and ", impact.mass, " hit at once at ",
                        impact.time, ": the derivative depends on which is first");
    const double speed = impact.velocity_before;
    if (speed == 0.0) why_not_ = line("mass ", impact.mass, " grazes at ", impact.time);
    if (!why_not_.empty()) return;
    const std::size_t mass = index_of(impact.mass);
    const auto row = static_cast<Eigen::Index>(mass);
    const Eigen::RowVectorXd dt = -tangents_.row(row) / speed;
    tangents_.noalias() += vector_field(before_.held, velocity) * dt;
    tangents_.row(row).setZero();
    tangents_.row(scene_.masses() + row) *=
        -law_of(scene_, stop_of(scene_, impact)).slope(std::abs(speed));
    velocity[mass] = impact.velocity_after;
    if (alone) {
      std::vector<double> at_rest = velocity;
      at_rest[mass] = 0.0;
      if (nodes_.size() == most_tangent_nodes) nodes_.erase(nodes_.begin());
      nodes_.push_back({impact.instant, tangents_, dt, vector_field(before_.held, at_rest)});
    }
    const Held &held = k + 1 < impacts.size() ? before_.held : after.held;
    tangents_.noalias() -= vector_field(held, velocity) * dt;
  }
}

// A mass comes to rest: at the end of a chatter, or in the initial state, where it counts as held.
void Tangents::apply_stick(const MotionState &after) {
  if (nodes_.empty()) {
    if (!(at_start_ && before_.instant == after.instant))
      why_not_ = line("a mass comes to rest at its stop at ", time_of(after.instant, clock_),
                      " without the impacts of a chatter");
    return;
  }
  // In the units of the coordinates the largest entry of a difference measures all of it.
  const Eigen::VectorXd units = length_units(scene_);
  std::vector<double> time_left;
  std::vector<Eigen::MatrixXd> values;
  for (const Node &node : nodes_) {
    time_left.push_back(elapsed(node.instant, after.instant, clock_));
    Eigen::MatrixXd tangents = node.tangents - node.held * node.dt;
    carry(after.held, time_left.back(), tangents);
    values.push_back(units.cwiseInverse().asDiagonal() * tangents);
  }
  const double last_error = std::pow(time_left.back() * rate_bound(scene_), 2);
  tangents_ = units.asDiagonal() * extrapolate_chatter(values, time_left, last_error);
}

Smooth<Eigen::MatrixXd> derivative_of(const Motion &motion, const Eigen::VectorXd &units) {
  const MotionState &start = motion.start();
  for (const Stop &stop : motion.scene.stops) {
    const std::size_t i = index_of(stop.mass);
    if (start.held[i] == 0 && start.displacement[i] == stop.position && start.velocity[i] == 0.0)
      return Smooth<Eigen::MatrixXd>::none(
          line("mass ", stop.mass, " is at rest at its stop without a force that holds it"));
  }
  const auto free = free_coordinates(start.held);
  if (free.empty()) return Eigen::MatrixXd(units.size(), 0);
  Eigen::MatrixXd first =
      Eigen::MatrixXd::Zero(units.size(), static_cast<Eigen::Index>(free.size()));
  for (std::size_t k = 0; k < free.size(); ++k) {
    const auto row = static_cast<Eigen::Index>(free[k]);
    first(row, static_cast<Eigen::Index>(k)) = units(row);
  }
  Tangents tangents(motion.scene, start, first);
  tangents.pass(motion.knots);
  const Smooth<Eigen::MatrixXd> last = tangents.get();
  if (!last.exists()) return last;
  if (!(*last).allFinite()) return Smooth<Eigen::MatrixXd>::none("the derivative is not finite");
  return Eigen::MatrixXd(units.cwiseInverse().asDiagonal() * *last);
}

}  // namespace vibro_impact
