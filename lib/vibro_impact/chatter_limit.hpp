// Complete chatter as a limit.
//
// Near the accumulation of a chatter sequence the impact map is smooth in the impact speed v, and
// v = 0 is a curve of fixed points with multiplier r: times and states of consecutive impacts lie
// on a smooth curve z(v). The limit is z(0), obtained by polynomial extrapolation in v through the
// last impacts (Aitken-Neville on the actual speeds: a Richardson table of ratio r that needs no
// exact geometric decay). The difference of the last two columns estimates the error.
#pragma once

#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include "motion.hpp"

namespace vibro_impact {

constexpr std::size_t max_chatter_nodes = 14;

template <int D>
struct ChatterNode {
  double speed = 0.0, time = 0.0;  // time since the first node
  State<D> state;                  // just after the impact
};

// Consecutive impacts at the same stop (or at the same set of stops at the same instants) in one
// contact mode, nothing else happening in between.
template <int D>
struct ChatterSequence {
  std::vector<std::size_t> stops;
  const ContactMode<D> *mode = nullptr;
  long long impacts = 0;
  double time = 0.0;
  std::size_t size = 0;
  std::array<ChatterNode<D>, max_chatter_nodes> nodes;  // oldest first
  // Last row of Neville's table for the time of accumulation, counted from the last node, and how
  // far apart its entries with one node less and one node more lie.
  std::array<double, max_chatter_nodes> row{}, difference{};
};

template <int D>
struct ChatterLimit {
  double tau = 0.0;  // from the last impact to the accumulation point
  State<D> state;    // there; `now` is not set
  double error = 0.0;
};

// Use every k-th impact so that the speeds fall by a factor of at least sqrt(2) from node to node:
// closer nodes amplify rounding.
inline long long chatter_stride(double restitution) {
  if (restitution <= 0.71) return 1;
  return static_cast<long long>(std::ceil(std::log(0.71) / std::log(restitution)));
}

// The next row of Neville's table, from the last one: O(nodes).
template <int D>
void extend_table(ChatterSequence<D> &sequence) {
  const std::size_t last = sequence.size - 1;
  const double near = sequence.nodes[last].speed;
  const double passed = last > 0 ? sequence.nodes[last].time - sequence.nodes[last - 1].time : 0.0;
  double current = 0.0;
  for (std::size_t column = 1; column <= last; ++column) {
    const double above = sequence.row[column - 1] - passed;  // the same with one node less, older
    const double far = sequence.nodes[last - column].speed;
    const double next = current + (current - above) * (near / (far - near));
    sequence.row[column - 1] = current;
    sequence.difference[column] = std::abs(next - current);
    current = next;
  }
  sequence.row[last] = current;
}

// Enters the impact just applied to `state`; true when it became a node.
template <int D>
bool extend(ChatterSequence<D> &sequence, const State<D> &state,
            const std::vector<std::size_t> &stops, double since_last, long long stride) {
  const double speed = state.stops[stops.front()].speed;
  const bool goes_on = sequence.size > 0 && sequence.mode == state.mode &&
                       sequence.stops == stops && speed < sequence.nodes[sequence.size - 1].speed;
  if (!goes_on) {
    sequence.stops = stops;
    sequence.mode = state.mode;
    sequence.impacts = 0;
    sequence.time = 0.0;
    sequence.size = 0;
  } else {
    sequence.time += since_last;
    if (++sequence.impacts % stride != 0) return false;
  }
  if (sequence.size == max_chatter_nodes) {
    for (std::size_t i = 1; i < max_chatter_nodes; ++i)
      std::swap(sequence.nodes[i - 1], sequence.nodes[i]);
    --sequence.size;
  }
  ChatterNode<D> &node = sequence.nodes[sequence.size++];
  node.speed = speed;
  node.time = sequence.time;
  node.state = state;
  extend_table(sequence);
  return true;
}

namespace detail {

// Weights of the value at v = 0 of the interpolating polynomial through the last `count` nodes.
template <int D>
std::array<double, max_chatter_nodes> weights_at_rest(const ChatterSequence<D> &sequence,
                                                      std::size_t count) {
  std::array<double, max_chatter_nodes> weights{};
  for (std::size_t i = sequence.size - count; i < sequence.size; ++i) {
    weights[i] = 1.0;
    for (std::size_t j = sequence.size - count; j < sequence.size; ++j)
      if (j != i)
        weights[i] *= sequence.nodes[j].speed / (sequence.nodes[j].speed - sequence.nodes[i].speed);
  }
  return weights;
}

}  // namespace detail

// The limit of the sequence, when its estimated error (relative to the state, in time relative to
// the fastest mode) is at most `tolerance`.
template <int D>
std::optional<ChatterLimit<D>> extrapolate(const ChatterSequence<D> &sequence, double tolerance) {
  if (sequence.size < 4) return std::nullopt;
  // The table for the time alone decides how many nodes to use.
  const std::size_t last = sequence.size - 1;
  std::size_t best = 0;
  double best_error = tolerance;
  for (std::size_t column = 2; column <= last; ++column) {
    const double error = sequence.difference[column] * sequence.mode->fastest;
    if (error <= best_error) {
      best_error = error;
      best = column;
    }
  }
  if (best == 0) return std::nullopt;

  const auto weights = detail::weights_at_rest(sequence, best + 1);
  const double oldest = sequence.nodes[last - best].speed;
  const ChatterNode<D> &latest = sequence.nodes[last];
  ChatterLimit<D> limit;
  limit.state = latest.state;
  auto value_error = latest.state.value, slope_error = latest.state.slope;
  value_error.setZero();
  slope_error.setZero();
  for (std::size_t i = last - best; i < last; ++i) {
    // Differences from the latest node: what is extrapolated is small, and so is its rounding.
    const ChatterNode<D> &node = sequence.nodes[i];
    // Without the oldest node the weight is less by the factor (oldest - v) / oldest.
    const double w = weights[i], dw = w * (node.speed / oldest);
    limit.tau += w * (node.time - latest.time);
    limit.state.value += w * (node.state.value - latest.state.value);
    limit.state.slope += w * (node.state.slope - latest.state.slope);
    value_error += dw * (node.state.value - latest.state.value);
    slope_error += dw * (node.state.slope - latest.state.slope);
    for (std::size_t k = 0; k < limit.state.stops.size(); ++k) {
      limit.state.stops[k].gap += w * (node.state.stops[k].gap - latest.state.stops[k].gap);
      limit.state.stops[k].speed += w * (node.state.stops[k].speed - latest.state.stops[k].speed);
    }
  }
  // The forcing lanes are known from the time, and have other units than the modes.
  const Eigen::Index modal = sequence.mode->lanes() - sequence.mode->forcing_lanes;
  const auto largest = [modal](const auto &of) -> double {
    return of.head(modal).abs().maxCoeff();
  };
  const double value = largest(limit.state.value), slope = largest(limit.state.slope);
  // Where all masses come to rest together the slope is zero: then relative to what it was.
  const double speed = std::max(slope, largest(sequence.nodes[last - best].state.slope));
  limit.error = std::max({best_error, value > 0.0 ? largest(value_error) / value : 0.0,
                          speed > 0.0 ? largest(slope_error) / speed : 0.0});
  if (limit.error > tolerance || !(limit.tau > 0.0)) return std::nullopt;
  return limit;
}

}  // namespace vibro_impact
