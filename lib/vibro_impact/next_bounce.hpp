// The next impact of a chatter that is followed on the gaps alone: finding and applying it.
#pragma once

#include "bounces.hpp"

namespace vibro_impact {

namespace detail {

// True when p(u) / u, positive at 0, falls all the way to a negative value at 1.
inline bool falls_to_a_root(const Polynomial &p) {
  const double *c = p.coefficient.data();
  Four rise = Four::Zero(), sum = rise;
  for (int n = 4; n <= p.order; n += 4) {
    const Four at = four(c + n);
    rise += (four_binomials(1, n) - 1.0) * at.abs();
    sum += at;
  }
  return c[2] + 2.0 * std::abs(c[3]) + rise.sum() < 0.0 && c[1] + c[2] + c[3] + sum.sum() < 0.0;
}

// An estimate of the first root of p in (0, 1]; nothing where there is none.
inline std::optional<double> estimate_root(const Polynomial &p, Counters &counters) {
  const double *c = p.coefficient.data();
  if (falls_to_a_root(p)) {
    constexpr double good = 1e-3, any = std::numeric_limits<double>::infinity();
    SeriesStep to = series_step({c[1], c[2], c[3], c[4], c[5]}, any, std::abs(c[6]));
    double u = to.step;
    if (good < to.error && to.error < 0.5 && u < 1.0) {
      ++counters.root_iterations;
      to = series_step(jet_at(p, 1, u), any, std::abs(c[6]));
      u += to.step;
    }
    if (to.error <= good && u > 0.0 && u <= 1.0) {
      ++counters.roots_searched;
      return u;
    }
  }
  const auto root = first_root(p, 1, 1.0, counters);
  return root ? std::optional(root->at) : std::nullopt;
}

// The step to the root of a polynomial that is near to 0.
inline SeriesStep step_ahead(const Polynomial &p) {
  const double *c = p.coefficient.data();
  return series_step({c[0], c[1], c[2], c[3], c[4]}, std::numeric_limits<double>::infinity(),
                     std::abs(c[5]));
}

}  // namespace detail

// Finds the next impact, `flight` after the latest; false when it is not certain to be the next
// event, or when it is not covered. The readings are re-centred at an estimate of it: the rest is a
// step of a series.
template <int D>
bool find_next(Bounces<D> &bounces, Counters &counters) {
  const std::size_t hit = bounces.hit(), readings = hit + bounces.watched.size();
  std::optional<double> estimate;
  const auto estimated = [&] {
    detail::trim(bounces);
    ++counters.flights_followed;
    estimate = detail::estimate_root(bounces.reading[0], counters);
    return estimate.has_value();
  };
  if (!estimated()) {
    if (bounces.time + 2.0 * bounces.span > bounces.covered) return false;
    detail::rescale(bounces, 2.0);
    if (!estimated()) return false;  // a flight so much longer than expected is not a chatter's
  }
  constexpr double close = 0x1p-11;  // powers from the fifth on are below rounding
  double u = *estimate;
  for (int step = 0;; ++step) {
    if (!(u > 0.0) || bounces.time + u * bounces.span > bounces.covered) return false;
    ++counters.root_iterations;
    detail::Powers at;
    detail::set_powers(at, u, bounces.order);
    recentre(bounces.reading[0], bounces.order, at, bounces.ratio.span, bounces.ahead[0]);
    const detail::SeriesStep to = detail::step_ahead(bounces.ahead[0]);
    bounces.off = to.step;
    const double moved = u * bounces.ratio.span[1] * to.step;
    if (std::abs(to.step) <= close && to.error <= 0x1p-47) {
      if (u + moved > 1.0) return false;  // not looked at, as far as other stops go
      bounces.flight = (u + moved) * bounces.span;
      bounces.span_ahead = u * bounces.ratio.span[1] * bounces.span;
      for (std::size_t i = 1; i < readings; ++i)
        recentre(bounces.reading[i], bounces.order, at, bounces.ratio.span, bounces.ahead[i]);
      break;
    }
    if (step == 3) return false;
    u += moved;
  }
  const double together = same_instant / bounces.path.rate;
  for (std::size_t j = 1; j < hit; ++j) {
    const auto root = first_root(bounces.reading[j], 1, 1.0, counters);
    if (!root || std::abs(root->at * bounces.span - bounces.flight) > together) return false;
  }
  for (std::size_t k = 0; k < bounces.watched.size(); ++k)
    if (first_root(bounces.reading[hit + k], 0, bounces.flight / bounces.span, counters))
      return false;
  return true;
}

// Follows no further than `left` after the latest impact: with fewer terms.
template <int D>
void expect_end(Bounces<D> &bounces, double left) {
  bounces.covered = std::min(bounces.covered, bounces.time + left);
  detail::drop_terms(bounces);
}

// Applies the impacts found (Eqs. 8-11). `closing` is set to the gap speeds before them.
template <int D>
void bounce(Bounces<D> &bounces, const Scene &scene, std::vector<double> &closing) {
  const std::size_t hit = bounces.hit(), readings = hit + bounces.watched.size();
  const double r = scene.restitution;
  bounces.time += bounces.flight;
  bounces.times.push_back(bounces.time);
  std::swap(bounces.reading, bounces.ahead);
  // Half as much again as is left when all flights fall by r.
  expect_end(bounces, 1.5 * r * bounces.flight * bounces.ratio.flights);
  detail::set_span(bounces, bounces.span_ahead);
  for (std::size_t i = 0; i < readings; ++i) shift(bounces.reading[i], bounces.off);
  closing.resize(hit);
  for (std::size_t j = 0; j < hit; ++j) closing[j] = std::min(0.0, bounces.speed(j));
  for (std::size_t j = 0; j < hit; ++j) {
    const double jump = -(1.0 + r) * closing[j];
    bounces.jumps.push_back(jump);
    for (std::size_t k = 0; k < bounces.unwatched_size; ++k) {
      Unwatched &reading = bounces.unwatched[k];
      if (reading.slack <= jump * reading.pushed)
        reading.pushed = detail::most_pushed(reading, bounces.path, bounces.covered - bounces.time);
      reading.slack -= jump * reading.pushed;
    }
    for (std::size_t i = 0; i < readings; ++i) {
      double *c = bounces.reading[i].coefficient.data();
      const double *s = bounces.response[i * hit + j].coefficient.data();
      for (int n = 0; n <= bounces.order; n += 4)
        Eigen::Map<detail::Four>(c + n) +=
            jump * detail::four(s + n) * detail::four(bounces.scale.data() + n);
    }
  }
  for (std::size_t j = 0; j < hit; ++j) {
    bounces.reading[j].coefficient[0] = 0.0;
    bounces.reading[j].coefficient[1] = -r * closing[j] * bounces.span;
  }
}

// False when something else follows from the impacts just applied: a mass left at rest, a hold
// force that is no longer positive, a gap or hold force not watched that may come to zero.
template <int D>
bool goes_on(const Bounces<D> &bounces) {
  const std::size_t hit = bounces.hit();
  for (std::size_t i = 0; i < hit; ++i)
    if (!(bounces.speed(i) > 0.0)) return false;
  for (std::size_t k = 0; k < bounces.watched.size(); ++k)
    if (!(bounces.reading[hit + k].coefficient[0] > 0.0)) return false;
  for (std::size_t k = 0; k < bounces.unwatched_size; ++k)
    if (!(bounces.unwatched[k].slack > 0.0)) return false;
  return true;
}

}  // namespace vibro_impact
