// Taylor expansion of the flow about an event, of nothing but what is looked at: by weights that
// the adjoint recurrence gives once per contact mode (lib/README.md). The variable is scaled, u =
// tau / span in [0, 1].
#pragma once

#include <Eigen/Core>
#include <cmath>

#include "polynomial.hpp"
#include "simulation/chain/motion.hpp"
#include "weights.hpp"

namespace vibro_impact {

// One stretch of flight: how far, at which rate (of the fastest lane in motion), to which order.
struct Expansion {
  double span = 0.0, rate = 0.0;
  int order = 0;  // 0: no series, any time in closed form
};

// Rate of the fastest lane that is in motion.
template <int D>
double fastest_in_motion(const State<D> &state) {
  const ContactMode<D> &mode = *state.mode;
  if (!mode.stiff) return mode.fastest;
  double fastest = 0.0;
  for (Eigen::Index j = 0; j < mode.lanes(); ++j)
    if (state.value(j) != 0.0 || state.slope(j) != 0.0 || mode.resonant(j) != 0.0)
      fastest = std::max(fastest, mode.rate(j));
  return fastest > 0.0 ? fastest : mode.fastest;  // nothing moves: any rate will do
}

// Opens an expansion of motion at this rate over [0, span]: of the smallest order p of the form 4 k
// + 3, one that fills whole packets, of which the remainder, its first term 2 x^(p-1) / (p+1)! with
// x = rate * span, is at most `remainder` of the second-order term: small gaps stay accurate.
inline void expand(double rate, double span, double remainder, Expansion &path,
                   Counters &counters) {
  const double x = rate * span, quartic = x * x * x * x;
  path.span = span;
  path.rate = rate;
  path.order = 3;
  for (double p = 3.0, term = x * x / 12.0; term > remainder && p < max_order; p = path.order) {
    term *= quartic / ((p + 2.0) * (p + 3.0) * (p + 4.0) * (p + 5.0));
    path.order += 4;
  }
  ++counters.expansions;
  counters.coefficients += path.order + 1;
}

// The next four coefficients that are linear in the lanes, of these weights. In line: what it
// returns is to stay in registers.
template <int D>
[[gnu::always_inline]] inline Packet weigh(const State<D> &state, const double *weight) {
  const Eigen::Index lanes = state.mode->lanes(), modal = state.mode->modal_lanes();
  Packet even = Packet::Zero(), odd = even;  // two chains of sums
  const auto add = [&](const auto &lane, Eigen::Index count) {
    Eigen::Index k = 0;
    for (; k + 1 < count; k += 2, weight += 8) {
      even += packet(weight) * lane(k);
      odd += packet(weight + 4) * lane(k + 1);
    }
    if (k < count) even += packet(weight) * lane(k), weight += 4;
  };
  add(state.value, lanes);
  add(state.slope, modal);
  return even + odd;
}

// Coefficients that lie below the rounding of the lanes are zero. A mass that moves less than that,
// because motion has yet to come along the chain, would be thrown back by them.
template <int D>
void drop_rounding(const State<D> &state, const ReadingWeights &of, const Expansion &path,
                   Polynomial &p) {
  const Eigen::Index lanes = state.mode->lanes(), modal = state.mode->modal_lanes();
  const double x = path.rate * path.span;
  double power = 1.0;
  for (int n = 0; n <= path.order; ++n, power *= x) {
    const auto row = of.weight.row(n % 4).segment((n / 4) * (lanes + modal), lanes + modal);
    const double size = (row.head(lanes).transpose() * state.value.matrix().array()).abs().sum() +
                        (row.tail(modal).transpose() * state.slope.head(modal)).abs().sum();
    const auto k = static_cast<std::size_t>(n);
    if (std::abs(p.coefficient[k]) < rounding * size * power) p.coefficient[k] = 0.0;
  }
}

// Sets `p` to what a contact of the mode watches, along the path, with what is known exactly in
// place of what rounding left: a gap and its speed, leading zeros and the coefficient behind them.
// `scene_rate` is the unit in which that is carried.
template <int D>
void read_along(const State<D> &state, const Contact<D> &contact, const Expansion &path,
                double scene_rate, Polynomial &p, Counters &counters) {
  const ContactMode<D> &mode = *state.mode;
  ReadingWeights &of = contact.weights;
  if (of.rate != path.rate) build_weights(mode, contact.watched, path.rate, of);
  const Eigen::Index columns = mode.lanes() + mode.modal_lanes();
  const double *weight = of.weight.data(), x = path.rate * path.span, quartic = x * x * x * x;
  Packet power = powers_of(x);
  for (int n = 0; n <= path.order; n += 4, weight += 4 * columns, power *= quartic)
    Eigen::Map<Packet>(p.coefficient.data() + n) = weigh(state, weight) * power;
  end_at(p, path.order);
  counters.products += (path.order + 1) * columns;

  const AtStop &stop = state.stops[contact.stop];
  // More than one zero, as at a root of a force: motion has yet to come along the chain.
  if (stop.below_rounding || stop.zeros > 1) drop_rounding(state, of, path, p);
  p.coefficient[0] += contact.watched.offset;
  if (stop.decided) {
    // The force on a free mass is the second derivative of its gap.
    const int known = contact.held ? stop.zeros : stop.zeros + 2;
    const int zeros = stays_at_rest(stop) ? path.order + 1 : std::min(known, path.order + 1);
    double term = stop.leading;
    for (int n = 0; n < zeros; ++n) {
      p.coefficient[static_cast<std::size_t>(n)] = 0.0;
      term *= path.span * scene_rate / (n + 1);
    }
    if (zeros <= path.order) p.coefficient[static_cast<std::size_t>(zeros)] = term;
  } else if (!contact.held) {
    p.coefficient[0] = stop.gap;
    p.coefficient[1] = stop.speed * path.span;
  }
}

// The change of lane j in a time after which S and S' - 1 are these. One solution, S with S(0) = 0
// and S'(0) = 1, gives all others: C = S' + kappa S, C' = -lambda S. (Changes are added up: C
// itself, a number next to 1, is rounded alike in all of many flights of one length.)
template <int D>
OscillatorState change_of(const ContactMode<D> &mode, Eigen::Index j, double value, double slope,
                          const OscillatorState &s) {
  return {value * (s.slope + mode.kappa(j) * s.value) + slope * s.value,
          slope * s.slope - mode.lambda(j) * value * s.value};
}

// Moves the lanes along the path by tau, and the time: a short way by the series of the flow, any
// way in closed form.
template <int D>
void move_lanes(State<D> &state, const Scene &scene, const Clock &clock, const Expansion &path,
                double tau) {
  using Pair = Eigen::Array<double, 2, 1>;
  const ContactMode<D> &mode = *state.mode;
  const double x = path.rate * tau;
  const Eigen::Index modal = mode.modal_lanes();
  const std::complex<double> before =
      mode.any_resonant ? std::complex(state.value(modal), state.value(modal + 1)) : 0.0;
  if (path.order == 0) {
    flow(mode, state.value, state.slope, tau);
  } else {
    FlowWeights<D> &weights = mode.flow_weights;
    if (weights.rate != path.rate) build_flow_weights(mode, path.rate, weights);
    const double w = x * x;
    const Eigen::Index stride = weights.response.rows();
    for (Eigen::Index j = 0; j < modal; j += 2) {
      const double *s = weights.response.data() + j + path.order * stride;
      const double *ds = weights.rate_of_response.data() + j + path.order * stride;
      const auto two = [](const double *at) { return Eigen::Map<const Pair>(at); };
      Pair even = Pair::Zero(), odd = even, even_slope = even, odd_slope = even;
      for (int n = path.order; n > 0; n -= 2, s -= 2 * stride, ds -= 2 * stride) {
        odd = odd * w + two(s);
        even = even * w + two(s - stride);
        odd_slope = odd_slope * w + two(ds);
        even_slope = even_slope * w + two(ds - stride);
      }
      const Pair response = even + x * odd, rate = even_slope + x * odd_slope;
      for (Eigen::Index i = j; i < std::min(modal, j + 2); ++i) {
        const auto change =
            change_of(mode, i, state.value(i), state.slope(i), {response(i - j), rate(i - j)});
        state.value(i) += change.value;
        state.slope(i) += change.slope;
      }
    }
  }
  state.now = later(state.now, tau, clock);
  set_forcing(state, scene);
  if (mode.any_resonant) add_resonance(state, scene, before, tau);
  tie_decays(state);
}

}  // namespace vibro_impact
