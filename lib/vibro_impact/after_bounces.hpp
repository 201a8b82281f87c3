// The state after the impacts of a chatter that is followed on the gaps alone: after the latest
// one, or at the limit.
#pragma once

#include "bounces.hpp"
#include "impact.hpp"

namespace vibro_impact {

// Moments of impacts still to come, sum J (t - t_k)^n by stop hit and n = 0 ... order, in units of
// the nth power of t less the time of the latest impact.
struct Tail {
  double left = 0.0;  // that time
  int order = -1;     // none
  std::vector<double> moments;

  double operator()(std::size_t j, int n) const {
    return moments[j * static_cast<std::size_t>(order + 1) + static_cast<std::size_t>(n)];
  }
};

// Reading i at the end of the tail: its value, and its rate in time.
template <int D>
OscillatorState<double> reading_after(const Bounces<D> &bounces, std::size_t i, const Tail &tail) {
  detail::Powers power;
  detail::set_powers(power, tail.left / bounces.span, bounces.order);
  const double *c = bounces.reading[i].coefficient.data();
  double value = c[0], slope = 0.0;
  for (std::size_t n = 1; n <= static_cast<std::size_t>(bounces.order); ++n) {
    value += power[n] * c[n];
    slope += static_cast<double>(n) * power[n - 1] * c[n];
  }
  for (std::size_t j = 0; j < bounces.hit() && tail.order >= 0; ++j) {
    value += bounces.response_term(i, j, 0) * tail(j, 0);
    for (int n = 1; n <= bounces.order; ++n) {
      const double at = power[static_cast<std::size_t>(n - 1)] *
                        bounces.response_term(i, j, static_cast<std::size_t>(n));
      value += at * (tail.left / bounces.span) * tail(j, n);
      slope += n * at * tail(j, n - 1);
    }
  }
  return {value, slope / bounces.span};
}

// Sets the lanes of `state` to those `tail.left` after the latest impact.
template <int D>
void set_lanes_after(const Bounces<D> &bounces, const Tail &tail, const Scene &scene,
                     State<D> &state) {
  using detail::Four, detail::Two, detail::two;
  const ContactMode<D> &mode = *bounces.mode;
  const double time = bounces.time + tail.left, rate = bounces.path.rate;
  const int top = std::min(bounces.path.order, order_over(bounces.path, time));
  if (mode.any_resonant) {
    flow(mode, scene, bounces.value, bounces.slope, time, state.value, state.slope);
  } else {
    state.value = bounces.value;
    state.slope = bounces.slope;
    advance(mode, bounces.path, time / bounces.path.span, state.value, state.slope);
  }
  if (mode.series.rate != rate) build_flow_series(mode, rate);
  const Eigen::Index modal = mode.modal_lanes(), stride = mode.series.response.rows();
  for (std::size_t j = 0; j < bounces.hit(); ++j) {
    detail::Powers moments{};
    for (std::size_t k = bounces.base + 1; k < bounces.times.size(); ++k) {
      const double x = rate * (time - bounces.times[k]), quartic = x * x * x * x;
      Four power = bounces.jumps[k * bounces.hit() + j] * detail::four_powers(x);
      for (int n = 0; n <= top; n += 4) {
        Eigen::Map<Four>(moments.data() + n) += power;
        power *= quartic;
      }
    }
    double power = 1.0;
    for (int n = 0; n <= std::min(top, tail.order); ++n, power *= rate * tail.left)
      moments[static_cast<std::size_t>(n)] += tail(j, n) * power;
    for (Eigen::Index i = 0; i < modal; i += 2) {
      const double *s = mode.series.response.data() + i;
      const double *ds = mode.series.rate_of_response.data() + i;
      Two response = Two::Zero(), rate_of = response;
      for (int n = 0; n <= top; ++n, s += stride, ds += stride) {
        response += moments[static_cast<std::size_t>(n)] * two(s);
        rate_of += moments[static_cast<std::size_t>(n)] * two(ds);
      }
      response /= rate;
      for (Eigen::Index l = i; l < std::min(modal, i + 2); ++l) {
        const double dv = bounces.jump_value[j](l), ds_l = bounces.jump_slope[j](l);
        state.value(l) +=
            dv * (rate_of(l - i) + mode.kappa(l) * response(l - i)) + ds_l * response(l - i);
        state.slope(l) += ds_l * rate_of(l - i) - mode.lambda(l) * dv * response(l - i);
      }
    }
  }
  set_forcing(state, scene);
  tie_decays(state);
}

// Sets the lanes and stops of `state`, whose time is `tail.left` after the latest impact.
template <int D>
void set_state_after(const Bounces<D> &bounces, const Tail &tail, const Scene &scene,
                     State<D> &state) {
  set_lanes_after(bounces, tail, scene, state);
  const std::size_t hit = bounces.hit();
  const bool at_limit = tail.order >= 0;  // where the masses hit are at rest
  for (const OpenStop<D> &open : state.mode->open) {
    const std::size_t j = bounces.place(open.stop);
    if (j == hit) continue;
    const double speed = at_limit ? 0.0 : bounces.speed(j);
    place_at_stop(state, scene, open, speed);
    state.stops[open.stop] = {0.0, speed, 1, speed};
  }
  for (const OpenStop<D> &open : state.mode->open) {
    if (bounces.place(open.stop) < hit) continue;
    StopState &stop = state.stops[open.stop];
    const auto watched = std::find(bounces.watched.begin(), bounces.watched.end(), open.stop);
    if (watched != bounces.watched.end()) {
      const auto place = hit + static_cast<std::size_t>(watched - bounces.watched.begin());
      const auto after = reading_after(bounces, place, tail);
      stop = {std::max(0.0, after.value), after.slope, 0, 0.0};
    } else {
      stop = {open.gap(state.value, state.slope), (open.gap.on_value * state.slope).sum(), 0, 0.0};
    }
  }
}

}  // namespace vibro_impact
