#include "chatter_table.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

namespace vibro_impact::detail {

namespace {

using Packet = Eigen::Array<double, 4, 1>;
using NodeWeights = std::array<double, max_chatter_nodes>;

// The weights w_i of the nodes from `first` on, by which their predictions are extrapolated:
// Lagrange's weights at x = 0, divided by x_i and by the sum of these quotients.
NodeWeights node_weights(const ChatterTable &table, std::size_t first) {
  NodeWeights weights{};
  double sum = 0.0;
  for (std::size_t i = first; i < table.nodes.size(); ++i) {
    weights[i] = 1.0 / table.nodes[i].x;
    for (std::size_t j = first; j < table.nodes.size(); ++j)
      if (j != i) weights[i] *= table.nodes[j].x / (table.nodes[j].x - table.nodes[i].x);
    sum += weights[i];
  }
  for (double &weight : weights) weight /= sum;
  return weights;
}

// The same without the node `first`: its factor x / (x - x_i) is taken out of the others.
NodeWeights without_node(const ChatterTable &table, std::size_t first, NodeWeights weights) {
  double sum = 0.0;
  weights[first] = 0.0;
  for (std::size_t i = first + 1; i < table.nodes.size(); ++i) {
    weights[i] *= 1.0 - table.nodes[i].x / table.nodes[first].x;
    sum += weights[i];
  }
  for (double &weight : weights) weight /= sum;
  return weights;
}

// Drops the impacts before the oldest node, which no extrapolation reads.
void drop_old_impacts(Chatter &chatter) {
  const std::size_t old = chatter.table.nodes.front().impact - chatter.dropped;
  // Impacts are dropped in portions, so that the mean work for an impact is bounded.
  if (old < 64 || 2 * old < chatter.times.size()) return;
  const auto count = static_cast<std::ptrdiff_t>(old);
  chatter.times.erase(chatter.times.begin(), chatter.times.begin() + count);
  const auto jumps = count * static_cast<std::ptrdiff_t>(chatter.contacts.size());
  chatter.jumps.erase(chatter.jumps.begin(), chatter.jumps.begin() + jumps);
  chatter.dropped += old;
}

}  // namespace

void extend(ChatterTable &table, const ChatterTable::Node &node) {
  table.error = std::numeric_limits<double>::infinity();
  table.best = 0;
  if (table.nodes.size() == max_chatter_nodes) table.nodes.erase(table.nodes.begin());
  table.nodes.push_back(node);
  const std::size_t last = table.nodes.size() - 1;
  ChatterTable::Entry entry{node.predicted / node.x, 1.0 / node.x};
  double error_before = 0.0, limit_before = entry.limit();
  for (std::size_t column = 1; column <= last; ++column) {
    const ChatterTable::Entry without_newest = table.row[column - 1];
    table.row[column - 1] = entry;
    const double share = node.x / (table.nodes[last - column].x - node.x);
    entry.predicted += (entry.predicted - without_newest.predicted) * share;
    entry.one += (entry.one - without_newest.one) * share;
    const double limit = entry.limit(), error = std::abs(limit - limit_before);
    // Two limits may agree by chance: the estimate is not much below that with one node less.
    const double estimate = std::max(error, min_error_decay * error_before);
    if (estimate <= table.error) {
      table.error = estimate;
      table.best = column;
    }
    error_before = error;
    limit_before = limit;
  }
  table.row[last] = entry;
}

bool Chatter::hits(std::size_t contact) const {
  return std::find(contacts.begin(), contacts.end(), contact) != contacts.end();
}

void end(Chatter &chatter) {
  chatter.contacts.clear();
  chatter.times.clear();
  chatter.jumps.clear();
  chatter.dropped = 0;
  chatter.flight_time = chatter.since = 0.0;
  chatter.table.nodes.clear();
}

void begin(Chatter &chatter, const std::vector<std::size_t> &contacts, double restitution) {
  end(chatter);
  chatter.contacts = contacts;
  chatter.restitution = restitution;
  const double stride = std::log(node_ratio) / std::log(restitution);
  chatter.stride = static_cast<std::size_t>(std::ceil(std::max(1.0, stride)));
}

bool add_impact(Chatter &chatter, double flight_time, const std::vector<double> &jumps) {
  const double time = chatter.under_way() ? chatter.times.back() + chatter.since : 0.0;
  const std::size_t impact = chatter.dropped + chatter.times.size();
  chatter.times.push_back(time);
  chatter.jumps.insert(chatter.jumps.end(), jumps.begin(), jumps.end());
  chatter.flight_time = flight_time;
  chatter.since = 0.0;
  if (impact % chatter.stride != 0) return false;
  extend(chatter.table, {flight_time, time + flight_time / (1.0 - chatter.restitution), impact});
  drop_old_impacts(chatter);
  return true;
}

std::optional<ChatterLimit> extrapolate_limit(const Chatter &chatter, double tolerance) {
  const ChatterTable &table = chatter.table;
  if (table.nodes.size() < fewest_chatter_nodes || !(table.error <= tolerance)) return std::nullopt;
  const std::size_t last = table.nodes.size() - 1;
  const double now = chatter.times.back(), predicted = table.nodes[last].predicted - now;
  const double time_left = table.row[table.best].limit() - now;
  if (!(std::abs(time_left - predicted) < prediction_share * predicted)) return std::nullopt;
  return ChatterLimit{time_left, table.error, last - table.best};
}

// By (13) of lib/README.md a node at t_i predicts the moments J_i (T - t_i)^n q / (1 - q), q =
// r^(n+1), of all impacts after it. The impacts between it and the latest are subtracted:
//   M_n ~ sum_i w_i (J_i (T - t_i)^n q / (1 - q) - sum_(i < k <= latest) J_k (T - t_k)^n).
// The sums are formed in one pass over the impacts k, where `weight_before` is the sum of w_i over
// the nodes i < k.
ChatterMoments extrapolate_moments(const Chatter &chatter, const ChatterLimit &limit,
                                   std::size_t hit, double restitution, int order) {
  const ChatterTable &table = chatter.table;
  Terms ratio{};
  double power = restitution;
  for (int n = 0; n <= order; ++n, power *= restitution)
    ratio[static_cast<std::size_t>(n)] = power / (1.0 - power);
  const NodeWeights weights = node_weights(table, limit.oldest),
                    fewer = without_node(table, limit.oldest, weights);
  ChatterMoments moments;
  double weight_before = 0.0, difference_before = 0.0;
  std::size_t node = limit.oldest;
  for (std::size_t k = table.nodes[node].impact - chatter.dropped; k < chatter.times.size(); ++k) {
    double weight = 0.0, difference = 0.0;
    if (node < table.nodes.size() && table.nodes[node].impact == chatter.dropped + k) {
      weight = weights[node];
      difference = weight - fewer[node++];
    }
    const double x = (chatter.times.back() - chatter.times[k]) / limit.time_left + 1.0;
    const double quartic = x * x * x * x;
    Packet moment = chatter.jump(k, hit) * Packet(1.0, x, x * x, x * x * x);
    for (int n = 0; n <= order; n += 4, moment *= quartic) {
      const Packet ratios = Eigen::Map<const Packet>(ratio.data() + n);
      Eigen::Map<Packet>(moments.moment.data() + n) += moment * (weight * ratios - weight_before);
      Eigen::Map<Packet>(moments.difference.data() + n) +=
          moment * (difference * ratios - difference_before);
    }
    weight_before += weight;
    difference_before += difference;
  }
  return moments;
}

}  // namespace vibro_impact::detail
