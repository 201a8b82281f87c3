// The state at the limit of a chatter: the flight from the latest impact, and the responses to the
// impacts to come, which depend on them through the moments sum J_k (T - t_k)^n only.
#pragma once

#include "chatter_limit.hpp"

namespace vibro_impact {

// The way from the latest impact to the limit.
template <int D>
struct Tail {
  Expansion path;  // over the time left
  // Moments of the impacts to come, by stop hit and n = 0 ... order, in units of the nth power of
  // the time left.
  std::vector<double> moments;
  // A gap or hold force along the path as if no impact came, and its responses to unit jumps.
  struct Along {
    Polynomial free;
    std::vector<Polynomial> response;  // per stop hit
  };
  std::vector<Along> gaps;  // of the stops hit
  Along other;

  double operator()(std::size_t j, int n) const {
    return moments[j * static_cast<std::size_t>(path.order + 1) + static_cast<std::size_t>(n)];
  }
};

namespace detail {

template <int D>
void read_responses(const Bounces<D> &bounces, const ContactMode<D> &mode,
                    const Reading<D> &reading, const Expansion &path,
                    typename Tail<D>::Along &along, Counters &counters) {
  along.response.resize(bounces.hit());
  for (std::size_t j = 0; j < bounces.hit(); ++j)
    read_linear_along(mode, reading, bounces.hits[j].jump_value, bounces.hits[j].jump_slope, path,
                      along.response[j], counters);
}

// A reading at the limit, and its slope per unit of the path.
template <int D>
OscillatorState<double> at_limit(const typename Tail<D>::Along &along, const Tail<D> &tail) {
  const auto order = static_cast<std::size_t>(tail.path.order);
  const double *c = along.free.coefficient.data();
  double value = c[0], slope = 0.0;
  for (std::size_t n = 1; n <= order; ++n) {
    value += c[n];
    slope += static_cast<double>(n) * c[n];
  }
  for (std::size_t j = 0; j < along.response.size(); ++j) {
    const double *s = along.response[j].coefficient.data();
    const double *moment = tail.moments.data() + j * (order + 1);
    value += s[0] * moment[0];
    for (std::size_t n = 1; n <= order; ++n) {
      value += s[n] * moment[n];
      slope += static_cast<double>(n) * s[n] * moment[n - 1];
    }
  }
  return {value, slope};
}

}  // namespace detail

// Sets `tail` to the moments of the impacts between the latest and the limit. That the gaps and
// their speeds are zero at the limit gives the first two; the others are extrapolated. Returns the
// error of the second one, extrapolated as well, in terms of the time of the limit.
template <int D>
double find_tail(const Bounces<D> &bounces, const State<D> &state, const ChatterTable &table,
                 const ChatterLimit &limit, Tail<D> &tail, Counters &counters) {
  using detail::Four;
  const ContactMode<D> &mode = *state.mode;
  const std::size_t hit = bounces.hit(), last = table.size - 1;
  const double left = limit.left;
  expand(mode, state.value, state.slope, left, tail.path, counters);
  const auto top = static_cast<std::size_t>(tail.path.order);
  tail.gaps.resize(hit);
  for (std::size_t i = 0; i < hit; ++i) {
    const OpenStop<D> &open = *bounces.hits[i].open;
    read_gap(state, open, tail.path, tail.gaps[i].free, counters);
    detail::read_responses(bounces, mode, open.gap, tail.path, tail.gaps[i], counters);
    for (Polynomial &response : tail.gaps[i].response) response.coefficient[0] = 0.0;
  }
  tail.moments.assign(hit * (top + 1), 0.0);
  // The impacts from the latest back, each with the sum of the weights of the nodes before it.
  double before = 1.0;
  std::size_t node = last;
  const std::size_t oldest = table.nodes[last + 1 - limit.nodes].impact;
  for (std::size_t k = bounces.times.size(); k-- > oldest;) {
    const double x = (bounces.time - bounces.times[k] + left) / left;
    double weight = 0.0;
    const ChatterNode &at = table.nodes[node];
    if (at.impact == k) weight = limit.weights[node--];
    before -= weight;
    const double quartic = x * x * x * x;
    for (std::size_t j = 0; j < hit; ++j) {
      Four moment = bounces.jumps[k * hit + j] * detail::four_powers(x);
      double *to = tail.moments.data() + j * (top + 1);
      for (std::size_t n = 0; n <= top; n += 4, moment *= quartic)
        Eigen::Map<Four>(to + n) +=
            moment * (weight * detail::four(bounces.series.of.moments.data() + n) - before);
      if (weight == 0.0 || hit > 1) continue;
      const auto rise = bounces.series.rise_of_moments(x * left, at.shape);
      const double size = weight * bounces.jumps[k] * x;
      to[1] += size * bounces.series.of.moments[1] * rise[0];
      to[2] += size * x * bounces.series.of.moments[2] * rise[1];
    }
  }
  // The first two, the lower one last. The responses start with t.
  double off = 0.0;
  for (std::size_t i = 0; i < hit; ++i) tail.moments[i * (top + 1)] = 0.0;
  for (std::size_t i = 0; i < hit; ++i) {
    double &first = tail.moments[i * (top + 1) + 1];
    const double extrapolated = std::exchange(first, 0.0);
    first = -detail::at_limit(tail.gaps[i], tail).value / left;
    off = std::max(off, std::abs(extrapolated - first) / state.stops[bounces.stops[i]].speed);
  }
  for (std::size_t i = 0; i < hit; ++i)
    tail.moments[i * (top + 1)] = -detail::at_limit(tail.gaps[i], tail).slope / left;
  return 0.5 * off * table.nodes[last].flight;
}

// Moves the state to the limit, at time `then`. `before` is set to what it was.
template <int D>
void move_to_limit(const Bounces<D> &bounces, Tail<D> &tail, const Scene &scene,
                   const Instant &then, State<D> &state, State<D> &before, Counters &counters) {
  using detail::Two, detail::two;
  const ContactMode<D> &mode = *state.mode;
  before = state;
  move_lanes(state, tail.path, 1.0, scene);
  state.now = then;
  // What the impacts to come add: as in `advance`, with moments in place of powers.
  const double rate = tail.path.rate;
  if (mode.series.rate != rate) build_flow_series(mode, rate);
  const Eigen::Index modal = mode.modal_lanes(), stride = mode.series.response.rows();
  for (std::size_t j = 0; j < bounces.hit(); ++j) {
    const auto &hit = bounces.hits[j];
    for (Eigen::Index i = 0; i < modal; i += 2) {
      const double *s = mode.series.response.data() + i;
      const double *ds = mode.series.rate_of_response.data() + i;
      Two response = Two::Zero(), rate_of = response;
      for (int n = 0; n <= tail.path.order; ++n, s += stride, ds += stride) {
        const double moment = tail(j, n) * tail.path.power[static_cast<std::size_t>(n)];
        response += moment * two(s);
        rate_of += moment * two(ds);
      }
      for (Eigen::Index l = i; l < std::min(modal, i + 2); ++l) {
        const auto added = lane_after(mode, l, hit.jump_value(l), hit.jump_slope(l),
                                      {response(l - i), rate_of(l - i)});
        state.value(l) += added.value;
        state.slope(l) += added.slope;
      }
    }
  }
  set_forcing(state, scene);
  tie_decays(state);
  for (const OpenStop<D> &open : mode.open) {
    if (bounces.hits_stop(open.stop)) {
      place_at_stop(state, scene, open, 0.0);
    } else if (!refresh(state, open)) {
      read_gap(before, open, tail.path, tail.other.free, counters);
      detail::read_responses(bounces, mode, open.gap, tail.path, tail.other, counters);
      state.stops[open.stop] = carried(detail::at_limit(tail.other, tail), tail.path.span);
    }
  }
  for (const std::size_t stop : bounces.stops) state.stops[stop] = {};
}

// True when no other stop comes into play up to the limit, whatever the impacts to come.
template <int D>
bool undisturbed(const Bounces<D> &bounces, const State<D> &state, Tail<D> &tail,
                 Counters &counters) {
  const ContactMode<D> &mode = *state.mode;
  const double left = tail.path.span;
  double jumps = 0.0;
  for (std::size_t j = 0; j < bounces.hit(); ++j) jumps += tail(j, 0);
  if (bounces.time + left <= bounces.clear_until && jumps <= bounces.clear_jumps) return true;
  if (detail::others_stay_clear(bounces, state, left, jumps)) return true;
  const auto stays_positive = [&](const Reading<D> &reading) {
    detail::read_responses(bounces, mode, reading, tail.path, tail.other, counters);
    double pushed = 0.0;
    for (std::size_t j = 0; j < bounces.hit(); ++j)
      pushed += size_at(tail.other.response[j], 0, 1.0) * tail(j, 0);
    return detail::lower_bound(tail.other.free, 0, [](int) { return 1.0; }) > pushed;
  };
  for (const OpenStop<D> &open : mode.open) {
    if (bounces.hits_stop(open.stop)) continue;
    read_gap(state, open, tail.path, tail.other.free, counters);
    if (!stays_positive(open.gap)) return false;
  }
  for (const ClosedStop<D> &closed : mode.closed) {
    read_along(mode, closed.press, state.value, state.slope, tail.path, tail.other.free, counters);
    if (!stays_positive(closed.press)) return false;
  }
  return true;
}

// A chatter being followed.
template <int D>
struct Chatter {
  std::vector<std::size_t> together;  // the stops of the impacts at the present instant
  Bounces<D> bounces;
  ChatterTable table;
  Tail<D> tail;
  State<D> before;
};

}  // namespace vibro_impact
