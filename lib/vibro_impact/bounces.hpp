// The impacts of a chatter, followed on the gaps alone.
//
// Within one contact mode the motion is linear: an impact adds the response to a jump J of the gap
// speed. A gap, or a hold force, is
//   g(t) = G(t) + sum_k J_k S(t - t_k),
// G as if no mass had been hit and S its response to a unit jump. One expansion of G and S serves
// many impacts: from impact to impact the polynomials are re-centred and J S is added. The lanes
// are not needed meanwhile. They are the undisturbed flight plus the responses, which depend on the
// impacts through the moments sum_k J_k (t - t_k)^n only.
#pragma once

#include <algorithm>
#include <vector>

#include "first_event.hpp"

namespace vibro_impact {

// Times that differ by less than this, in units of the fastest mode, may differ by rounding: that
// of a period or two of motion.
constexpr double same_instant = 0x1p-46;

// A gap or hold force of another stop that is not watched, for it stays positive: the least it is
// without the impacts to come, less what those since have taken off it at most; and, in terms of
// the path, the moduli of its response to a unit jump, the largest of those of the stops hit, with
// a bound of what it comes to on the rest of the path.
struct Unwatched {
  double slack = 0.0, pushed = 0.0;
  Polynomial push;
};

// What follows from the coefficient of restitution alone: all flights to come in terms of the next,
// to leading order; the third-order terms of the time left (see chatter_limit.hpp); powers of the
// next span in terms of the flight before it; moments of the impacts after one of unit jump, in
// units of powers of the time left, to leading order.
struct ChatterRatio {
  double restitution = -1.0, flights = 0.0;
  double ee = 0.0, f = 0.0, ss = 0.0, se = 0.0, s3 = 0.0;
  detail::Powers span{}, moments{};

  void set(double r) {
    if (r == restitution) return;
    restitution = r;
    flights = 1.0 / (1.0 - r);
    const double common = flights * flights / (1.0 - r * r * r);
    ee = common * (2.0 + 3.0 * r + 2.0 * r * r);
    f = -common * (1.0 + r) * (1.0 + r);
    ss = common * r * (1.0 + r) * (1.0 + r * r);
    se = -common * r * (4.0 + 3.0 * r + 3.0 * r * r);
    s3 = common * r * r * (1.0 + r);
    detail::set_powers(span, 1.2 * std::max(r, 0x1p-30), max_order);
    double power = r;
    for (double &moment : moments) {
      moment = power / (1.0 - power);
      power *= r;
    }
  }
};

template <int D>
struct Bounces {
  using Lanes = typename State<D>::Lanes;
  const ContactMode<D> *mode = nullptr;
  std::vector<std::size_t> stops;  // hit together, at every impact
  // The gaps at `stops`, then the gaps and hold forces of other stops that may come to zero, in
  // u = (time since the latest impact) / span; and the response of reading i to a unit jump of the
  // gap speed at stop j, response[i * hit() + j], in (time since the jump) / path.span.
  std::vector<Polynomial> reading, response;
  std::vector<Polynomial> ahead;     // the readings about a point near the next impact
  detail::Powers scale{};            // of span / path.span
  std::vector<std::size_t> watched;  // the stops of the readings from hit() on
  std::vector<Unwatched> unwatched;
  std::size_t unwatched_size = 0;
  int order = 0;
  double span = 0.0;
  // The flight to the next impact, and where that is on the readings ahead: at off * span_ahead.
  double flight = 0.0, off = 0.0, span_ahead = 0.0;
  // The flight on which all this rests: `path` expands it, `time` is that of the latest impact on
  // it, the polynomials hold up to `covered`.
  Lanes value, slope;
  Expansion path;
  double time = 0.0, covered = 0.0;
  ChatterRatio ratio;
  // What a unit jump of the gap speed at each stop hit does to the lanes.
  std::vector<Lanes> jump_value, jump_slope;
  // Times on the path and jumps of the impacts, hit() per impact; the path starts just after that
  // of index `base`, earlier ones have negative times.
  std::vector<double> times, jumps;
  std::size_t base = 0;

  std::size_t hit() const {
    return stops.size();
  }
  // The place of a stop among those hit, hit() for others.
  std::size_t place(std::size_t stop) const {
    return static_cast<std::size_t>(std::find(stops.begin(), stops.end(), stop) - stops.begin());
  }
  double speed(std::size_t i) const {
    return reading[i].coefficient[1] / span;
  }
  // Coefficient n of that response, in terms of u.
  double response_term(std::size_t i, std::size_t j, std::size_t n) const {
    return response[i * hit() + j].coefficient[n] * scale[n];
  }
};

namespace detail {

template <int D>
void set_span(Bounces<D> &bounces, double span) {
  bounces.span = span;
  set_powers(bounces.scale, span / bounces.path.span, bounces.order);
}

template <int D>
void rescale(Bounces<D> &bounces, double scale) {
  Powers powers;
  set_powers(powers, scale, bounces.order);
  for (std::size_t i = 0; i < bounces.hit() + bounces.watched.size(); ++i)
    rescale(bounces.reading[i], bounces.order, powers);
  set_span(bounces, bounces.span * scale);
}

// The part of a polynomial that matters over the flight ahead.
template <int D>
void trim(Bounces<D> &bounces) {
  const int order = std::min(bounces.order, order_over(bounces.path, bounces.span));
  for (std::size_t i = 0; i < bounces.hit() + bounces.watched.size(); ++i)
    bounces.reading[i].order = order;
}

// Drops the terms that do not matter over what is still covered.
template <int D>
void drop_terms(Bounces<D> &bounces) {
  const int order = order_over(bounces.path, bounces.covered - bounces.time);
  if (order >= bounces.order) return;
  bounces.order = order;
  for (std::size_t i = 0; i < bounces.hit() + bounces.watched.size(); ++i)
    end_at(bounces.reading[i], order);
}

// Reads one gap or hold force along the path, and its responses, into place `i`.
template <int D, class Read>
void carry(Bounces<D> &bounces, std::size_t i, const Reading<D> &reading, Counters &counters,
           Read read) {
  const std::size_t hit = bounces.hit();
  if (bounces.reading.size() <= i) {
    bounces.reading.resize(i + 1);
    bounces.ahead.resize(i + 1);
  }
  if (bounces.response.size() < (i + 1) * hit) bounces.response.resize((i + 1) * hit);
  read(bounces.reading[i]);
  for (std::size_t j = 0; j < hit; ++j)
    read_linear_along(*bounces.mode, reading, bounces.jump_value[j], bounces.jump_slope[j],
                      bounces.path, bounces.response[i * hit + j], counters);
}

// The most a unit jump can change an unwatched reading within `time`.
inline double most_pushed(const Unwatched &reading, const Expansion &path, double time) {
  return size_at(reading.push, 0, time / path.span);
}

// Decides whether the reading carried at the next place is watched. It is not when it would have to
// fall by twice as much as the impacts to come, of these moments, are likely to push it, to come
// down to `least`.
template <int D>
void watch(Bounces<D> &bounces, std::size_t stop, double least, const Powers &moments) {
  const std::size_t hit = bounces.hit(), place = hit + bounces.watched.size();
  if (bounces.unwatched.size() == bounces.unwatched_size) bounces.unwatched.emplace_back();
  Unwatched &reading = bounces.unwatched[bounces.unwatched_size];
  reading.slack = bounds_of(bounces.reading[place], 0).lowest - least;
  if (reading.slack > 0.0) {
    end_at(reading.push, bounces.order);
    Four pushed = Four::Zero(), most = pushed;
    for (int n = 0; n <= bounces.order; n += 4) {
      Four push = Four::Zero();
      for (std::size_t j = 0; j < hit; ++j)
        push = push.max(four(bounces.response[place * hit + j].coefficient.data() + n).abs());
      Eigen::Map<Four>(reading.push.coefficient.data() + n) = push;
      pushed += push * four(moments.data() + n);
      most += push;
    }
    reading.pushed = most.sum();
    if (reading.slack > 2.0 * pushed.sum()) {
      ++bounces.unwatched_size;
      return;
    }
  }
  bounces.watched.push_back(stop);
}

}  // namespace detail

// Starts to follow the impacts at `stops`, which have just happened, over `covered` time units; the
// next one is expected after `flight`. With `on`, the impacts before are kept. False when another
// stop is not certain to stay as it is.
template <int D>
bool follow(Bounces<D> &bounces, const State<D> &state, const Scene &scene,
            const std::vector<std::size_t> &stops, double flight, double covered, bool on,
            Counters &counters) {
  const ContactMode<D> &mode = *state.mode;
  const std::size_t hit = stops.size();
  bounces.stops = stops;
  for (const OpenStop<D> &open : mode.open)
    if (bounces.place(open.stop) == hit && state.stops[open.stop].zeros != 0) return false;
  for (const ClosedStop<D> &closed : mode.closed)
    if (state.stops[closed.stop].zeros != 0) return false;

  bounces.mode = &mode;
  bounces.watched.clear();
  bounces.unwatched_size = 0;
  if (on) {
    for (double &time : bounces.times) time -= bounces.time;
  } else {
    bounces.times.assign(1, 0.0);
    bounces.jumps.clear();
    for (const std::size_t stop : stops)
      bounces.jumps.push_back((1.0 + scene.restitution) *
                              (state.stops[stop].speed / scene.restitution));
  }
  bounces.base = bounces.times.size() - 1;
  bounces.value = state.value;
  bounces.slope = state.slope;
  bounces.time = 0.0;
  bounces.covered = bounces.span = covered;
  expand(mode, state.value, state.slope, covered, bounces.path, counters);
  bounces.order = bounces.path.order;
  bounces.jump_value.resize(hit);
  bounces.jump_slope.resize(hit);
  double jumps = 0.0;
  for (const OpenStop<D> &open : mode.open) {
    const std::size_t j = bounces.place(open.stop);
    if (j == hit) continue;
    const double sigma = sign(scene.stops[open.stop].side);
    const auto i = static_cast<Eigen::Index>(open.mass);
    bounces.jump_value[j] = -sigma * mode.velocity_to_modal.col(i).array();
    bounces.jump_slope[j] = -sigma * mode.to_modal.col(i).array();
    if (mode.any_decay)
      bounces.jump_slope[j] =
          mode.decay.select(-mode.kappa * bounces.jump_value[j], bounces.jump_slope[j]);
    jumps += bounces.jumps[bounces.base * hit + j];
  }
  bounces.ratio.set(scene.restitution);
  detail::Powers moments;  // of the impacts to come
  detail::set_powers(moments, std::min(1.0, flight * bounces.ratio.flights / covered),
                     bounces.order);
  for (std::size_t n = 0; n <= static_cast<std::size_t>(bounces.order); ++n)
    moments[n] *= jumps * bounces.ratio.moments[n];
  for (const OpenStop<D> &open : mode.open) {
    const auto read = [&](Polynomial &p) { read_gap(state, open, bounces.path, p, counters); };
    const std::size_t j = bounces.place(open.stop);
    const std::size_t place = j < hit ? j : hit + bounces.watched.size();
    detail::carry(bounces, place, open.gap, counters, read);
    for (std::size_t k = 0; k < hit; ++k) bounces.response[place * hit + k].coefficient[0] = 0.0;
    if (j < hit)
      bounces.reading[j].coefficient[0] = 0.0;
    else
      detail::watch(bounces, open.stop, 2.0 * wide_gap(open, state.value), moments);
  }
  for (const ClosedStop<D> &closed : mode.closed) {
    const std::size_t place = hit + bounces.watched.size();
    detail::carry(bounces, place, closed.press, counters, [&](Polynomial &p) {
      read_along(mode, closed.press, state.value, state.slope, bounces.path, p, counters);
    });
    detail::watch(bounces, closed.stop, 0.0, moments);
  }
  for (std::size_t k = 0; k < bounces.watched.size(); ++k)
    if (!(bounces.reading[hit + k].coefficient[0] > 0.0)) return false;
  detail::rescale(bounces, std::min(1.0, 1.2 * flight / covered));
  return true;
}

}  // namespace vibro_impact
