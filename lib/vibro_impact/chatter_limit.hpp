// Complete chatter as a limit.
//
// Near the accumulation of a chatter sequence the impact map is smooth in the impact speed v, and
// v = 0 is a curve of fixed points with multiplier r: whatever depends smoothly on the state at an
// impact lies, over consecutive impacts, on a smooth curve of any x that is itself proportional to
// v to leading order. Taken here are
//   x, the flight that follows to leading order, and
//   what each impact predicts of the limit on its own. With the gap v t + c2 t^2 + c3 t^3 + c4 t^4
//   after it, x = -v / c2, e = c3 / c2, f = c4 / c2, and with the response t + s2 t^2 + s3 t^3 to a
//   unit jump of the gap speed, its chatter ends after
//     x / (1 - r) - (e - r s2) x^2 / (1 - r)^2
//       + [(2 + 3 r + 2 r^2) e^2 - (1 + r)^2 f + r (1 + r) (1 + r^2) s2^2
//          - r (4 + 3 r + 3 r^2) s2 e + r^2 (1 + r) s3] x^3 / ((1 - r)^2 (1 - r^3)) + O(x^4)
//   (what is left after the next impact, by the same formula, and the flight to it must add up to
//   it); the moments of its later impacts, sum J_k (T - t_k)^n up to the limit T, are to leading
//   order J w^n r^(n+1) / (1 - r^(n+1)), of its own jump J and w = x / (1 - r); that of order one
//   is needed to the next order, 1 + s2 w / (1 + r + r^2) times as much.
// The curve of the predictions of consecutive impacts starts with x^4 at x = 0, where it has the
// limit's value; a polynomial without x, x^2 and x^3 through the last n impacts extrapolates it.
// (For masses hit together the third-order term is left out, and the curve starts with x^3.) For
// f = L + x^3 g(x) the extrapolation to zero of f / x^3 by Neville's table, divided by that of
// 1 / x^3, is exact when g is a polynomial of degree n - 1 that vanishes at x = 0.
#pragma once

#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "after_bounces.hpp"

namespace vibro_impact {

constexpr std::size_t max_chatter_nodes = 14;

// An impact of a chatter and what it predicts of the limit.
struct ChatterNode {
  double flight = 0.0;      // x, the time to the next impact to leading order
  double tail = 0.0;        // time to the accumulation point
  double correction = 0.0;  // second-order term, taken off `tail`
  double limit = 0.0;       // time of the accumulation point on the path of the bounces
  std::size_t impact = 0;   // its index in the bounces
};

struct ChatterTable {
  std::size_t size = 0;
  int power = 4;  // of x with which the curve of the predictions starts
  std::array<ChatterNode, max_chatter_nodes> nodes;  // oldest first
  // Last rows of Neville's tables: the limit extrapolated from the last 1, 2, ... predictions,
  // counted from the last of them, and 1 / x^2 likewise.
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
  const double *c = bounces.reading[0].coefficient.data();  // in units of the span
  const double per_c = 1.0 / c[2], x = -c[1] * per_c, e = c[3] * per_c;
  double s2 = 0.0, s3 = 0.0;
  for (std::size_t j = 0; j < bounces.hit(); ++j) {
    const double jump = bounces.reading[j].coefficient[1] / (c[1] * bounces.span);
    s2 += jump * bounces.response_term(0, j, 2);
    s3 += jump * bounces.response_term(0, j, 3);
  }
  const ChatterRatio &ratio = bounces.ratio;
  const double w = x * ratio.flights;
  double correction = (e - ratio.restitution * s2) * w * w;
  if (bounces.hit() == 1)
    correction -= x * x * x *
                  (e * (ratio.ee * e + ratio.se * s2) + ratio.f * c[4] * per_c +
                   ratio.ss * s2 * s2 + ratio.s3 * s3);
  ChatterNode node;
  node.flight = x * bounces.span;
  node.correction = correction * bounces.span;
  // No more than half, far from the limit: the time left is not negative.
  node.tail = (w - std::clamp(correction, -0.5 * w, 0.5 * w)) * bounces.span;
  node.limit = bounces.time + node.tail;
  node.impact = bounces.times.size() - 1;
  return node;
}

// x^(power - 1)
inline double start_of_curve(const ChatterTable &table, double x) {
  return table.power == 4 ? x * x * x : x * x;
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
  // What is left is below rounding: the prediction is the limit, with an error of order tail^3.
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

// Sets `tail` to the moments of the impacts between the latest and the limit. That the gaps and
// their speeds are zero at the limit gives the first two; the others are extrapolated. Returns the
// error of the second one, extrapolated as well, in terms of the time of the limit.
template <int D>
double find_tail(const Bounces<D> &bounces, const ChatterTable &table, const ChatterLimit &limit,
                 Tail &tail) {
  using detail::Four;
  const std::size_t hit = bounces.hit(), last = table.size - 1;
  const double left = limit.left;
  const auto top = static_cast<std::size_t>(bounces.order);
  tail.left = left;
  tail.order = bounces.order;
  tail.moments.assign(hit * (top + 1), 0.0);
  // The second-order term of the moment of order one: like the time left it has to be known up to
  // where the curve starts.
  const double r = bounces.ratio.restitution, s2 = bounces.response[0].coefficient[2] * left /
                                                   (bounces.path.span * bounces.path.span);
  const double second = hit == 1 ? s2 * bounces.ratio.moments[1] / (1.0 + r + r * r) : 0.0;
  // The impacts from the latest back, each with the sum of the weights of the nodes before it.
  double before = 1.0;
  std::size_t node = last;
  const std::size_t oldest = table.nodes[last + 1 - limit.nodes].impact;
  for (std::size_t k = bounces.times.size(); k-- > oldest;) {
    const double x = (bounces.time - bounces.times[k] + left) / left;
    double weight = 0.0;
    if (table.nodes[node].impact == k) weight = limit.weights[node--];
    before -= weight;
    const double quartic = x * x * x * x;
    for (std::size_t j = 0; j < hit; ++j) {
      Four moment = bounces.jumps[k * hit + j] * detail::four_powers(x);
      double *to = tail.moments.data() + j * (top + 1);
      for (std::size_t n = 0; n <= top; n += 4, moment *= quartic)
        Eigen::Map<Four>(to + n) +=
            moment * (weight * detail::four(bounces.ratio.moments.data() + n) - before);
      to[1] += weight * second * bounces.jumps[k * hit + j] * x * x;
    }
  }
  // The first two, the lower one last.
  double off = 0.0;
  for (std::size_t i = 0; i < hit; ++i) tail.moments[i * (top + 1)] = 0.0;
  for (std::size_t i = 0; i < hit; ++i) {
    double &first = tail.moments[i * (top + 1) + 1];
    const double extrapolated = std::exchange(first, 0.0);
    first = -reading_after(bounces, i, tail).value / left;
    off = std::max(off, std::abs(extrapolated - first) / bounces.speed(i));
  }
  for (std::size_t i = 0; i < hit; ++i)
    tail.moments[i * (top + 1)] = -reading_after(bounces, i, tail).slope;
  return 0.5 * off * table.nodes[last].flight;
}

// True when no other stop comes into play up to the limit, whatever the impacts to come.
template <int D>
bool undisturbed(const Bounces<D> &bounces, const Tail &tail) {
  const std::size_t hit = bounces.hit();
  double jumps = 0.0;
  for (std::size_t j = 0; j < hit; ++j) jumps += tail(j, 0);
  for (std::size_t k = 0; k < bounces.unwatched_size; ++k)
    if (!(bounces.unwatched[k].slack >
          jumps * detail::most_pushed(bounces.unwatched[k], bounces.path, tail.left)))
      return false;
  detail::Powers scale;
  detail::set_powers(scale, tail.left / bounces.span, bounces.order);
  for (std::size_t i = hit; i < hit + bounces.watched.size(); ++i) {
    Polynomial ahead = bounces.reading[i];
    ahead.order = bounces.order;
    rescale(ahead, bounces.order, scale);
    double pushed = 0.0;
    for (std::size_t j = 0; j < hit; ++j)
      pushed +=
          size_at(bounces.response[i * hit + j], 0, tail.left / bounces.path.span) * tail(j, 0);
    if (!(detail::lower_bound(ahead, 0, [](int) { return 1.0; }) > pushed)) return false;
  }
  return true;
}

// A chatter being followed.
template <int D>
struct Chatter {
  std::vector<std::size_t> together;  // the stops of the impacts at the present instant
  Bounces<D> bounces;
  ChatterTable table;
  Tail tail;
  bool ahead = false;  // of the lanes of the run
};

}  // namespace vibro_impact
