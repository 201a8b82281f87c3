// Complete chatter as a limit.
//
// Each impact predicts the limit up to order x^3 (chatter_prediction.hpp). The curve of the
// predictions of consecutive impacts starts with x^3 at x = 0, where it has the limit's value; a
// polynomial without x and x^2 through the last n impacts extrapolates it. For f = L + x^m g(x) the
// extrapolation to zero of f / x^m by Neville's table, divided by that of 1 / x^m, is exact when g
// is a polynomial of degree n - 1 that vanishes at x = 0.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include "chatter_prediction.hpp"

namespace vibro_impact {

constexpr std::size_t max_chatter_nodes = 14;
// Times that differ by less than this, in units of the fastest mode, may differ by rounding: that
// of a period or two of motion.
constexpr double same_instant = 0x1p-46;

// Consecutive impacts at the same stop (or at the same set of stops at the same instants) in one
// contact mode, nothing else happening in between.
template <int D>
struct ChatterSequence {
  std::vector<std::size_t> stops;
  const ContactMode<D> *mode = nullptr;
  // The stops of the impacts at the present instant, and the time since the last that was entered.
  std::vector<std::size_t> gathered;
  double waited = 0.0;
  long long impacts = 0;
  double time = 0.0;
  std::size_t size = 0;
  std::array<ChatterNode<D>, max_chatter_nodes + 1> nodes;  // oldest first; one more for the next
  // Last rows of Neville's tables: the limit extrapolated from the last 1, 2, ... predictions,
  // counted from the last of them; 1 / x^m extrapolated likewise; and the estimated error of the
  // limit.
  std::array<double, max_chatter_nodes> limit{}, weight{}, error{};
};

template <int D>
struct ChatterLimit {
  double tau = 0.0;  // from the last impact to the accumulation point
  State<D> state;    // there; `now` is not set
  double error = 0.0;
};

// Use every k-th impact so that the speeds fall by a factor of at least 0.81 from node to node:
// closer nodes amplify rounding.
inline long long chatter_stride(double restitution) {
  if (restitution <= 0.81) return 1;
  return static_cast<long long>(std::ceil(std::log(0.81) / std::log(restitution)));
}

// Order up to which an impact predicts the limit: one where several masses chatter together, each
// of which presses on the others as it moves.
template <int D>
int prediction_order(const ChatterSequence<D> &sequence) {
  return sequence.stops.size() == 1 ? 2 : 1;
}

// The next rows of the tables, from the last ones: O(nodes).
template <int D>
void extend_table(ChatterSequence<D> &sequence) {
  const std::size_t last = sequence.size - 1;
  const ChatterNode<D> &latest = sequence.nodes[last];
  const double near = latest.flight,
               moved = last > 0 ? latest.limit - sequence.nodes[last - 1].limit : 0.0;
  const double fall = last > 0 ? near / sequence.nodes[last - 1].flight : 0.0;
  const double faster = prediction_order(sequence) == 2 ? fall * fall * fall : fall * fall;
  double limit = 0.0, weight = 1.0 / (prediction_order(sequence) == 2 ? near * near : near);
  double value = 0.0;  // limit / x^m, extrapolated
  for (std::size_t column = 1; column <= last; ++column) {
    double &above = sequence.limit[column - 1], &weight_above = sequence.weight[column - 1];
    const double ratio = near / (sequence.nodes[last - column].flight - near);
    const double without_newest = above - moved, without_oldest = limit;
    const double next = weight + (weight - weight_above) * ratio;
    value += (value - weight_above * without_newest) * ratio;
    limit = value / next;
    above = without_oldest;
    weight_above = weight;
    weight = next;
    sequence.error[column] =
        std::max(std::abs(limit - without_oldest), faster * std::abs(limit - without_newest));
  }
  sequence.limit[last] = limit;
  sequence.weight[last] = weight;
}

template <int D>
void forget(ChatterSequence<D> &sequence) {
  sequence.size = 0;
  sequence.gathered.clear();
}

// Masses that chatter in step lose it by rounding: impacts at one instant become several, in any
// order. Adds those at `stops` to the ones of this instant; false when more are to come before the
// state is one of the sequence's.
template <int D>
bool gather(ChatterSequence<D> &sequence, const State<D> &state,
            const std::vector<std::size_t> &stops, double since_last) {
  auto &gathered = sequence.gathered;
  const auto together = [&] {
    return sequence.size > 0 && gathered.size() < sequence.stops.size() &&
           std::includes(sequence.stops.begin(), sequence.stops.end(), gathered.begin(),
                         gathered.end());
  };
  if (since_last * state.mode->fastest > same_instant) {
    if (together()) sequence.size = 0;  // the others did not come
    gathered.clear();
  }
  for (const std::size_t stop : stops)
    if (std::find(gathered.begin(), gathered.end(), stop) == gathered.end())
      gathered.insert(std::upper_bound(gathered.begin(), gathered.end(), stop), stop);
  sequence.waited += since_last;
  return !together();
}

// Enters the impacts gathered, which `state` follows; true when they became a node.
template <int D>
bool extend(ChatterSequence<D> &sequence, const State<D> &state, const Scene &scene,
            long long stride) {
  const bool goes_on =
      sequence.size > 0 && sequence.mode == state.mode && sequence.stops == sequence.gathered;
  if (goes_on) {
    sequence.time += sequence.waited;
    sequence.waited = 0.0;
    if (++sequence.impacts % stride != 0) return false;
  }
  if (sequence.size == max_chatter_nodes) {
    for (std::size_t i = 1; i < max_chatter_nodes; ++i)
      std::swap(sequence.nodes[i - 1], sequence.nodes[i]);
    --sequence.size;
  }
  ChatterNode<D> &entered = sequence.nodes[sequence.size];
  predict_limit(state, sequence.gathered, scene, entered);
  if (!goes_on || !(entered.flight < sequence.nodes[sequence.size - 1].flight)) {
    sequence.stops = sequence.gathered;
    sequence.mode = state.mode;
    sequence.impacts = 0;
    sequence.time = 0.0;
    sequence.waited = 0.0;
    if (sequence.size > 0) std::swap(sequence.nodes[0], entered);
    sequence.size = 0;
  }
  ChatterNode<D> &latest = sequence.nodes[sequence.size++];
  latest.limit = sequence.time + latest.tail;
  extend_table(sequence);
  return true;
}

namespace detail {

// Weights of the predictions of the last `count` nodes in the extrapolated limit.
template <int D>
std::array<double, max_chatter_nodes> weights_at_rest(const ChatterSequence<D> &sequence,
                                                      std::size_t count) {
  std::array<double, max_chatter_nodes> weights{}, inverse{};
  const std::size_t first = sequence.size - count;
  for (std::size_t i = first; i < sequence.size; ++i) inverse[i] = 1.0 / sequence.nodes[i].flight;
  double sum = 0.0;
  for (std::size_t i = first; i < sequence.size; ++i) {
    const double x = sequence.nodes[i].flight;
    double product = prediction_order(sequence) == 2 ? x * x : x;
    for (std::size_t j = first; j < sequence.size; ++j)
      if (j != i) product *= 1.0 - x * inverse[j];
    weights[i] = 1.0 / product;
    sum += weights[i];
  }
  for (double &weight : weights) weight /= sum;
  return weights;
}

}  // namespace detail

// The limit of the sequence, when its estimated error (relative to the state, in time relative to
// the fastest mode) is at most `tolerance`.
template <int D>
std::optional<ChatterLimit<D>> extrapolate(const ChatterSequence<D> &sequence,
                                           const State<D> &state, double tolerance) {
  if (sequence.size < 2) return std::nullopt;
  // The table for the time alone decides how many nodes to use.
  const std::size_t last = sequence.size - 1;
  const ChatterNode<D> &latest = sequence.nodes[last];
  // Near a border orbit, where the press falls to zero as the chatter ends, the corrections are as
  // large as the tail until late, and the table may agree by chance.
  if (!(16.0 * std::abs(latest.correction) < latest.tail)) return std::nullopt;
  std::size_t best = 0;
  double best_error = tolerance;
  for (std::size_t column = 1; column <= last; ++column) {
    const double error = sequence.error[column] * sequence.mode->fastest;
    if (error <= best_error) {
      best_error = error;
      best = column;
    }
  }
  if (best == 0) return std::nullopt;

  const auto weights = detail::weights_at_rest(sequence, best + 1);
  const double oldest = sequence.nodes[last - best].flight;
  ChatterLimit<D> limit;
  limit.tau = latest.tail;
  limit.state = state;
  limit.state.value = latest.value;
  limit.state.slope = latest.slope;
  limit.state.stops = latest.stops;
  auto value_error = latest.value, slope_error = latest.slope;
  value_error.setZero();
  slope_error.setZero();
  double without_oldest = 0.0;
  for (std::size_t i = last - best + 1; i <= last; ++i)
    without_oldest += weights[i] * (1.0 - sequence.nodes[i].flight / oldest);
  for (std::size_t i = last - best; i < last; ++i) {
    // Differences from the latest node: what is extrapolated is small, and so is its rounding.
    const ChatterNode<D> &node = sequence.nodes[i];
    const double w = weights[i];
    const double dw = w - w * (1.0 - node.flight / oldest) / without_oldest;
    limit.tau += w * (node.limit - latest.limit);
    limit.state.value += w * (node.value - latest.value);
    limit.state.slope += w * (node.slope - latest.slope);
    value_error += dw * (node.value - latest.value);
    slope_error += dw * (node.slope - latest.slope);
    for (std::size_t k = 0; k < limit.state.stops.size(); ++k) {
      limit.state.stops[k].gap += w * (node.stops[k].gap - latest.stops[k].gap);
      limit.state.stops[k].speed += w * (node.stops[k].speed - latest.stops[k].speed);
    }
  }
  // The forcing lanes are known from the time, and have other units than the modes.
  const Eigen::Index modal = sequence.mode->lanes() - sequence.mode->forcing_lanes;
  const auto largest = [modal](const auto &of) -> double {
    return of.head(modal).abs().maxCoeff();
  };
  const double value = largest(limit.state.value), slope = largest(limit.state.slope);
  // Where all masses come to rest together the slope is zero: then relative to what it was.
  const double speed = std::max(slope, largest(state.slope));
  limit.error = std::max({best_error, value > 0.0 ? largest(value_error) / value : 0.0,
                          speed > 0.0 ? largest(slope_error) / speed : 0.0});
  if (limit.error > tolerance || !(limit.tau > 0.0)) return std::nullopt;
  return limit;
}

}  // namespace vibro_impact
