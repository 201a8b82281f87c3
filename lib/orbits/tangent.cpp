#include "vibro_impact/tangent.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "eigen_views.hpp"
#include "fits.hpp"
#include "tangent_flow.hpp"
#include "vibro_impact/hold_force.hpp"

namespace vibro_impact {

namespace {

bool same(const Instant &a, const Instant &b) {
  return a.cycle == b.cycle && a.phase == b.phase;
}

// The impacts of a chatter from one that is taken into account to the next. Where the speeds fall
// slowly, some are left out: nodes closer together than a factor of 0.81 amplify rounding.
long long stride_of(const ImpactLaw &law) {
  const double r = law.at_rest();
  if (!(r > 0.81 && r < 1.0)) return 1;
  return static_cast<long long>(std::ceil(std::log(0.81) / std::log(r)));
}

void clear_rows(Eigen::MatrixXd &changes, std::size_t mass) {
  const auto row = static_cast<Eigen::Index>(mass);
  changes.row(row).setZero();
  changes.row(changes.rows() / 2 + row).setZero();
}

double largest(const Eigen::MatrixXd &matrix) {
  return matrix.size() == 0 ? 0.0 : matrix.cwiseAbs().maxCoeff();
}

// An impact of a chatter, and the changes just after it with the mass held from then on.
struct Node {
  Instant instant;
  Eigen::MatrixXd changes;
};
constexpr std::size_t most_nodes = 16;

// Consecutive impacts at one stop, each slower than the one before, nothing else in between.
struct Sequence {
  std::size_t stop = 0;
  long long impacts = 0;
  std::vector<Node> nodes = {};
};

// Changes extrapolated to the end of a chatter, and their error relative to the largest.
struct Limit {
  Eigen::MatrixXd changes;
  double error;
};

// The value at x = 0 of the polynomial without x and x^2 through the nodes from `first` on.
Eigen::MatrixXd extrapolated(const std::vector<Node> &nodes, const std::vector<double> &x,
                             std::size_t first) {
  Eigen::MatrixXd limit = 0.0 * nodes.back().changes;
  double sum = 0.0;
  for (std::size_t i = first; i < nodes.size(); ++i) {
    double product = x[i] * x[i];
    for (std::size_t j = first; j < nodes.size(); ++j)
      if (j != i) product *= 1.0 - x[i] / x[j];
    limit += (1.0 / product) * nodes[i].changes;
    sum += 1.0 / product;
  }
  return limit / sum;
}

// Of the polynomials through the last 1, 2, ... nodes, a time x before the limit each, the one that
// differs least from that through one node less. `error` is that of the last node alone.
Limit limit_of(const std::vector<Node> &nodes, const std::vector<double> &x, double error) {
  Limit best{nodes.back().changes, error};
  const double size = std::max(largest(best.changes), 1e-300);
  Eigen::MatrixXd previous = best.changes;
  for (std::size_t first = nodes.size() - 1; first-- > 0;) {
    Eigen::MatrixXd limit = extrapolated(nodes, x, first);
    const double difference = largest(limit - previous) / size;
    if (difference < best.error) best = {limit, difference};
    previous = std::move(limit);
  }
  return best;
}

}  // namespace

struct TangentRecorder::Tangents {
  Scene scene;
  Clock clock;
  Instant started, now;
  Held held;  // up to the events of `group`
  Eigen::MatrixXd changes;
  TangentFlow flow;
  bool differentiable = true;
  double chatter_error = 0.0;
  // The events of one instant, gathered until a later one shows that they are all.
  std::vector<Event> group = {};
  std::vector<double> displacement = {}, velocity_before = {}, velocity = {};
  Sequence sequence = {};

  void event(const Event &event, const Moment &moment);
  void finish(const Instant &end);

 private:
  Eigen::Index masses() const {
    return changes.rows() / 2;
  }
  void carry_to(const Instant &instant);
  void read(const Moment &moment);
  Eigen::VectorXd vector_field(const Held &mode, const std::vector<double> &v) const;
  void close();
  void saltation(const std::vector<const Event *> &impacts, const Held &after);
  void extend_sequence(const Event &impact, const Eigen::RowVectorXd &dt);
  void chatter_limit(const Held &after);
};

void TangentRecorder::Tangents::event(const Event &event, const Moment &moment) {
  if (!group.empty() && !same(group.front().instant, event.instant)) close();
  read(moment);
  if (group.empty()) {
    carry_to(event.instant);
    velocity_before = velocity;
  }
  // All impacts of an instant have been applied when the first of them is told.
  if (event.kind == EventKind::impact) {
    const auto hit = static_cast<std::size_t>(event.mass - 1);
    velocity_before[hit] = event.velocity_before;
    velocity[hit] = event.velocity_after;
  }
  group.push_back(event);
}

void TangentRecorder::Tangents::finish(const Instant &end) {
  if (!group.empty()) close();
  carry_to(end);
}

void TangentRecorder::Tangents::carry_to(const Instant &instant) {
  carry(flow, held, elapsed(now, instant, clock), changes);
  now = instant;
}

void TangentRecorder::Tangents::read(const Moment &moment) {
  for (std::size_t i = 0; i < displacement.size(); ++i) {
    const int mass = static_cast<int>(i) + 1;
    displacement[i] = moment.displacement(mass);
    velocity[i] = moment.velocity(mass);
  }
}

Eigen::VectorXd TangentRecorder::Tangents::vector_field(const Held &mode,
                                                        const std::vector<double> &v) const {
  const auto a = acceleration(scene, {group.front().instant, displacement, v, mode});
  Eigen::VectorXd f(changes.rows());
  f << view(v), view(a);
  return f;
}

void TangentRecorder::Tangents::close() {
  const Held after = group.back().held;
  std::vector<const Event *> impacts;
  bool sticks = false;
  for (const Event &event : group) {
    if (event.kind == EventKind::impact) impacts.push_back(&event);
    sticks = sticks || event.kind == EventKind::stick;
  }
  if (!impacts.empty())
    saltation(impacts, after);
  else if (sticks)
    chatter_limit(after);
  else  // release at a root of the hold force
    sequence.nodes.clear();
  held = after;
  for (std::size_t i = 0; i < held.size(); ++i)
    if (held[i] != 0) clear_rows(changes, i);
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
    if (impact->velocity_before == 0.0) {
      differentiable = false;
      continue;
    }
    const Eigen::RowVectorXd dt = -changes.row(x_row) / impact->velocity_before;
    changes += f * dt;
    changes.row(x_row).setZero();
    changes.row(v_row) *=
        -law_of(scene, scene.stops[impact->stop]).slope(std::abs(impact->velocity_before));
    v[static_cast<std::size_t>(x_row)] = impact->velocity_after;
    f = impact == impacts.back() ? vector_field(after, velocity) : vector_field(held, v);
    if (alone) extend_sequence(*impact, dt);
    changes -= f * dt;
  }
}

// `changes` are here those at the event, not yet at the time of the event.
void TangentRecorder::Tangents::extend_sequence(const Event &impact, const Eigen::RowVectorXd &dt) {
  if (impact.falling == 0 || sequence.nodes.empty() || sequence.stop != impact.stop)
    sequence = {impact.stop};
  if (sequence.impacts++ % stride_of(law_of(scene, scene.stops[impact.stop])) != 0) return;
  if (sequence.nodes.size() == most_nodes) sequence.nodes.erase(sequence.nodes.begin());
  // As if the mass stuck here and now.
  const auto mass = static_cast<std::size_t>(impact.mass - 1);
  Held resting = held;
  resting[mass] = static_cast<signed char>(impact.side);
  std::vector<double> v = velocity;
  v[mass] = 0.0;
  Eigen::MatrixXd at_rest = changes - vector_field(resting, v) * dt;
  clear_rows(at_rest, mass);
  sequence.nodes.push_back({impact.instant, std::move(at_rest)});
}

void TangentRecorder::Tangents::chatter_limit(const Held &after) {
  Sequence chatter = std::exchange(sequence, {});
  if (chatter.nodes.empty() || group.size() > 1 || chatter.stop != group.front().stop) {
    // A mass at rest at its stop in the initial state is as good as held.
    if (!same(now, started)) differentiable = false;
    return;
  }
  std::vector<double> x;
  for (Node &node : chatter.nodes) {
    x.push_back(elapsed(node.instant, now, clock));
    carry(flow, after, x.back(), node.changes);
  }
  Limit limit = limit_of(chatter.nodes, x, std::pow(x.back() * fastest_rate(flow, held), 2));
  changes = std::move(limit.changes);
  chatter_error = std::max(chatter_error, limit.error);
}

TangentRecorder::TangentRecorder(const Scene &scene, const MotionState &start,
                                 const Matrix &columns) {
  check(scene);
  require_fits(scene, start);
  const std::size_t n = scene.mass.size();
  require(columns.rows == 2 * n && columns.values.size() == columns.rows * columns.columns,
          "columns: ", columns.rows, " rows given, the chain has ", 2 * n,
          " coordinates and velocities");
  for (std::size_t i = 0; i < 2 * n; ++i)
    for (std::size_t k = 0; k < columns.columns; ++k)
      require(start.held[i % n] == 0 || columns(i, k) == 0.0, "column ", k + 1,
              ": must be zero for mass ", i % n + 1, ", which is held");
  tangents_ = std::make_unique<Tangents>(Tangents{.scene = scene,
                                                  .clock = Clock(scene.omega),
                                                  .started = start.instant,
                                                  .now = start.instant,
                                                  .held = start.held,
                                                  .changes = view(columns),
                                                  .flow = tangent_flow(scene)});
  tangents_->displacement.resize(n);
  tangents_->velocity.resize(n);
}

TangentRecorder::~TangentRecorder() = default;
TangentRecorder::TangentRecorder(TangentRecorder &&) noexcept = default;
TangentRecorder &TangentRecorder::operator=(TangentRecorder &&) noexcept = default;

void TangentRecorder::event(const Event &event, const Moment &moment) {
  tangents_->event(event, moment);
}

void TangentRecorder::finish(const Instant &end) {
  tangents_->finish(end);
}

Matrix TangentRecorder::tangent() const {
  return matrix_of(tangents_->changes);
}

bool TangentRecorder::differentiable() const {
  return tangents_->differentiable;
}

double TangentRecorder::chatter_error() const {
  return tangents_->chatter_error;
}

}  // namespace vibro_impact
