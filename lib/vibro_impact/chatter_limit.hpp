// Complete chatter as a limit.
//
// Near the accumulation of a chatter sequence the impact map is smooth in the impact speed v, and
// v = 0 is a curve of fixed points with multiplier r: whatever depends smoothly on the state at an
// impact lies, over consecutive impacts, on a smooth curve of any x that is itself proportional to
// v to leading order. Taken here are x, the flight that follows to leading order, and what each
// impact predicts of the limit on its own (see chatter_series.hpp), up to x^4. The curve of these
// predictions starts with x^5 at x = 0, where it has the limit's value; a polynomial without the
// powers below through the last n impacts extrapolates it. (For masses hit together the predictions
// stop at x^2, and the curve starts with x^3.) For f = L + x^4 g(x) the extrapolation to zero of
// f / x^4 by Neville's table, divided by that of 1 / x^4, is exact when g is a polynomial of degree
// n - 1 that vanishes at x = 0.
#pragma once

#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "bounces.hpp"

namespace vibro_impact {

constexpr std::size_t max_chatter_nodes = 14;

// An impact of a chatter and what it predicts of the limit.
struct ChatterNode {
  double flight = 0.0;      // x, the time to the next impact to leading order
  double tail = 0.0;        // time to the accumulation point
  double correction = 0.0;  // its terms beyond the first, taken off `tail`
  double limit = 0.0;       // time of the accumulation point, since the first impact
  std::size_t impact = 0;   // its index in the bounces
  Shape shape;              // of the gap after it
};

struct ChatterTable {
  std::size_t size = 0;
  int power = 5;  // of x with which the curve of the predictions starts
  std::array<ChatterNode, max_chatter_nodes> nodes;  // oldest first
  // Last rows of Neville's tables: the limit extrapolated from the last 1, 2, ... predictions,
  // counted from the last of them, and 1 / x^(power - 1) likewise.
  std::array<double, max_chatter_nodes> limit{}, weight{};
  // How many are best to take, less one, and the estimated error of the limit then.
  std::size_t best = 0;
  double error = std::numeric_limits<double>::infinity();
};

// Use every k-th impact so that the speeds fall by a factor of at least 0.81 from node to node:
// closer nodes amplify rounding.
inline long long chatter_stride(double restitution) {
  if (restitution <= 0.81) return 1;
  return static_cast<long long>(std::ceil(std::log(0.81) / std::log(restitution)));
}

// What the latest impact predicts. All masses hit have the same flights ahead, so that the first
// may stand for them.
template <int D>
ChatterNode predict_limit(const Bounces<D> &bounces) {
  const ChatterSeries &series = bounces.series;
  const double *c = bounces.hits[0].gap.coefficient.data();  // in units of the span
  const double span = bounces.path.span, per_span = 1.0 / span, per_c = per_span / c[2];
  ChatterNode node;
  node.flight = -c[1] * per_c * span * span;
  node.shape.e = c[3] * per_c;
  node.shape.f = c[4] * per_c * per_span;
  node.shape.h = c[5] * per_c * per_span * per_span;
  const double x = node.flight, w = x * series.of.flights;
  double s2 = 0.0;
  for (std::size_t j = 0; j < bounces.hit(); ++j)
    s2 += bounces.hits[j].gap.coefficient[1] / c[1] * bounces.responses[j].second;
  node.correction = (node.shape.e - series.of.restitution * s2) * w * w;
  // For masses hit together the terms beyond the second are not known.
  if (bounces.hit() == 1) node.correction -= x * x * series.higher_orders(x, node.shape);
  // No more than half, far from the limit: the time left is not negative.
  node.tail = w - std::clamp(node.correction, -0.5 * w, 0.5 * w);
  node.limit = bounces.time + node.tail;
  node.impact = bounces.times.size() - 1;
  return node;
}

// x^(power - 1)
inline double start_of_curve(const ChatterTable &table, double x) {
  return table.power == 5 ? x * x * x * x : x * x;
}

// Enters a node and the next rows of the tables, from the last ones: O(nodes).
inline void extend(ChatterTable &table, const ChatterNode &node) {
  if (table.size > 0 && !(node.flight < table.nodes[table.size - 1].flight)) table.size = 0;
  if (!(node.flight > 0.0)) {
    table.size = 0;
    return;
  }
  if (table.size == max_chatter_nodes) {
    std::move(table.nodes.begin() + 1, table.nodes.end(), table.nodes.begin());
    --table.size;
  }
  const std::size_t last = table.size++;
  table.nodes[last] = node;
  const double near = node.flight,
               moved = last > 0 ? node.limit - table.nodes[last - 1].limit : 0.0;
  const double fall = last > 0 ? near / table.nodes[last - 1].flight : 0.0;
  const double smaller = fall * start_of_curve(table, fall);
  double limit = 0.0, weight = 1.0 / start_of_curve(table, near);
  double value = 0.0;  // limit / x^(power - 1), extrapolated
  double error_before = 0.0;
  table.error = std::numeric_limits<double>::infinity();
  for (std::size_t column = 1; column <= last; ++column) {
    double &above = table.limit[column - 1], &weight_above = table.weight[column - 1];
    const double ratio = near / (table.nodes[last - column].flight - near);
    const double without_newest = above - moved, without_oldest = limit;
    const double next = weight + (weight - weight_above) * ratio;
    value += (value - weight_above * without_newest) * ratio;
    limit = value / next;
    above = without_oldest;
    weight_above = weight;
    weight = next;
    const double error =
        std::max(std::abs(limit - without_oldest), smaller * std::abs(limit - without_newest));
    // Not much less than that of one impact less, which it may agree with by chance.
    const double believed = std::max(error, error_before / 64.0);
    if (believed <= table.error) {
      table.error = believed;
      table.best = column;
    }
    error_before = error;
  }
  table.limit[last] = limit;
  table.weight[last] = weight;
}

// Time left to the limit, extrapolated from the last `nodes` impacts with these weights.
struct ChatterLimit {
  double left = 0.0;
  std::size_t nodes = 0;
  std::array<double, max_chatter_nodes> weights{};
  double error = 0.0;  // relative to the fastest mode
};

// The limit, when its estimated error relative to `rate`, that of the fastest mode, is at most
// `tolerance`.
inline std::optional<ChatterLimit> extrapolate(const ChatterTable &table, double rate,
                                               double tolerance) {
  if (table.size == 0) return std::nullopt;
  const std::size_t last = table.size - 1;
  const ChatterNode &latest = table.nodes[last];
  // What is left is below rounding: the prediction is the limit, with an error of order tail^5.
  if (latest.tail * rate < 1e-9 && std::abs(latest.correction) * rate < 1e-15) {
    ChatterLimit limit{latest.tail, 1, {}, 0.0};
    limit.weights[last] = 1.0;
    return limit;
  }
  // Near a border orbit, where the press falls to zero as the chatter ends, the corrections are as
  // large as the tail until late, and the table may agree by chance.
  if (!(16.0 * std::abs(latest.correction) < latest.tail)) return std::nullopt;
  if (!(rate * table.error <= tolerance)) return std::nullopt;

  // Weights of the predictions in the extrapolated limit.
  ChatterLimit limit{latest.tail, table.best + 1, {}, rate * table.error};
  const std::size_t first = last - table.best;
  std::array<double, max_chatter_nodes> inverse{};
  for (std::size_t i = first; i <= last; ++i) inverse[i] = 1.0 / table.nodes[i].flight;
  double sum = 0.0;
  for (std::size_t i = first; i <= last; ++i) {
    const double x = table.nodes[i].flight;
    double product = start_of_curve(table, x);
    for (std::size_t j = first; j <= last; ++j)
      if (j != i) product *= 1.0 - x * inverse[j];
    limit.weights[i] = 1.0 / product;
    sum += limit.weights[i];
  }
  for (std::size_t i = first; i <= last; ++i) limit.weights[i] /= sum;
  for (std::size_t i = first; i < last; ++i)
    limit.left += limit.weights[i] * (table.nodes[i].limit - latest.limit);
  return limit;
}

}  // namespace vibro_impact
