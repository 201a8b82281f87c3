// Complete chatter as a limit.
//
// Near the accumulation of a chatter sequence the impact map is smooth in the impact speed v, and
// v = 0 is a curve of fixed points with multiplier r: whatever depends smoothly on the state at an
// impact lies, over consecutive impacts, on a smooth curve of any x that is itself proportional to
// v to leading order. Taken here are
//   x = 2 v / a, the flight that follows to leading order (a: the pressing acceleration then), and
//   what each impact predicts of the limit on its own. With w = x / (1 - r), a' the rate of a with
//   the mass at rest, and kappa the damping of the mass itself, c / m of its links, its chatter
//   ends after
//     w - (a' / a + kappa / 2) w^2 / 3 + O(x^3)
//   and meanwhile the others move as if it stuck: the impulse of the damper over a bounce is zero,
//   that of the spring of order x^3.
// So the curve of the predictions starts with x^3 at x = 0, where it has the limit's value; a
// polynomial without x and x^2 through the last n impacts extrapolates it. For f = L + x^m g(x) the
// extrapolation to zero of f / x^m by Neville's table, divided by that of 1 / x^m, is exact when g
// is a polynomial of degree n - 1 that vanishes at x = 0.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include "motion.hpp"

namespace vibro_impact {

constexpr std::size_t max_chatter_nodes = 14;
// Times that differ by less than this, in units of the fastest mode, may differ by rounding: that
// of a period or two of motion.
constexpr double same_instant = 0x1p-46;

// An impact of a chatter and what it predicts of the limit.
template <int D>
struct ChatterNode {
  double flight = 0.0;                    // x, the time to the next impact to leading order
  double tail = 0.0;                      // time to the accumulation point
  double correction = 0.0;                // |second-order term| of `tail`, or with none all of it
  double limit = 0.0;                     // time of the accumulation point, since the first node
  typename State<D>::Lanes value, slope;  // there, and the gaps and gap speeds of the other stops
  std::vector<StopState> stops;
};

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

// Sets `node` to what the impact just applied to `state` at `stops` predicts of the limit of its
// chatter.
template <int D>
void predict_limit(const State<D> &state, const std::vector<std::size_t> &stops, const Scene &scene,
                   ChatterNode<D> &node) {
  using Lanes = typename State<D>::Lanes;
  const ContactMode<D> &mode = *state.mode;
  const auto change = [&](Lanes &lanes, const Eigen::MatrixXd &to_lanes, const OpenStop<D> &open,
                          double gap_rate) {
    const auto i = static_cast<Eigen::Index>(open.mass);
    lanes -= to_lanes.col(i).array() * (sign(scene.stops[open.stop].side) * gap_rate);
  };
  const auto chatters = [&](const OpenStop<D> &open) {
    return std::find(stops.begin(), stops.end(), open.stop) != stops.end();
  };
  // The lanes with the chattering masses brought to rest, and their derivatives with them held:
  // what holds them raises their gap accelerations by a, and the rates of these by a'.
  node.value = state.value;
  node.slope = state.slope;
  for (const OpenStop<D> &open : mode.open) {
    if (!chatters(open)) continue;
    const double speed = state.stops[open.stop].speed;
    change(node.slope, mode.to_modal, open, -speed);
    if (!mode.any_decay) continue;
    change(node.value, mode.velocity_to_modal, open, -speed);
    node.slope = mode.decay.select(-mode.kappa * node.value, node.slope);
  }
  Lanes value1 = node.slope, slope1 = -mode.kappa * node.slope - mode.lambda * node.value,
        slope2 = -mode.lambda * node.slope;
  if (mode.any_resonant) {
    slope1 += mode.resonant * node.value(mode.lanes() - 2);
    slope2 += mode.resonant * node.slope(mode.lanes() - 2);
  }
  const Lanes curvature = slope1;
  Lanes pushed = Lanes::Zero(mode.any_decay ? mode.lanes() : 0);
  for (const OpenStop<D> &open : mode.open) {
    if (!chatters(open)) continue;
    const double m = scene.mass[open.mass], a = open.press(node.value, node.slope) / m;
    const double rate =
        ((open.press.on_value * node.slope).sum() + (open.press.on_slope * curvature).sum()) / m;
    change(slope1, mode.to_modal, open, a);
    change(slope2, mode.to_modal, open, rate);
    if (mode.any_decay) {
      change(value1, mode.velocity_to_modal, open, a);
      change(pushed, mode.velocity_to_modal, open, rate);
    }
    if (open.stop != stops.front()) continue;
    const double links =
        scene.stiffness[open.mass] +
        (open.mass + 1 < scene.stiffness.size() ? scene.stiffness[open.mass + 1] : 0.0);
    node.flight = 2.0 * state.stops[open.stop].speed / a;
    node.tail = node.flight / (1.0 - scene.restitution);
    node.correction = (rate / a + scene.beta * links / (2.0 * m)) * node.tail * node.tail / 3.0;
  }
  slope2 -= mode.kappa * slope1;
  Lanes value2 = slope1;
  if (mode.any_decay) value2 = mode.decay.select(pushed - mode.kappa * value1, slope1);
  if (stops.size() == 1) node.tail -= node.correction;
  const double tau = node.tail;
  node.value += tau * (value1 + (0.5 * tau) * value2);
  node.slope += tau * (slope1 + (0.5 * tau) * slope2);
  // A small gap keeps its digits when it is carried on its own.
  node.stops = state.stops;
  for (const OpenStop<D> &open : mode.open) {
    if (chatters(open)) continue;
    StopState &stop = node.stops[open.stop];
    const auto &gap = open.gap.on_value;
    stop.gap += tau * (stop.speed + (0.5 * tau) * (gap * value2).sum());
    stop.speed += tau * ((gap * slope1).sum() + (0.5 * tau) * (gap * slope2).sum());
  }
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
