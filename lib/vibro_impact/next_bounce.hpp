// The next impact of a chatter that is followed on the gaps alone: finding and applying it.
#pragma once

#include "bounces.hpp"

namespace vibro_impact {

// Finds the next impact, at `roots` of the flight ahead; false when it is not certain to be the
// next event, or when it is not covered.
template <int D>
bool find_next(Bounces<D> &bounces, Counters &counters) {
  const std::size_t hit = bounces.hit();
  const auto look_ahead = [&] {
    detail::trim(bounces);
    ++counters.flights_followed;
    for (std::size_t j = 0; j < hit; ++j) {
      const auto root = first_root(bounces.reading[j], 1, 1.0, counters);
      if (!root) return false;
      bounces.roots[j] = *root;
    }
    return true;
  };
  if (!look_ahead()) {
    if (bounces.time + 2.0 * bounces.span > bounces.covered) return false;
    detail::rescale(bounces, 2.0);
    if (!look_ahead()) return false;  // a flight so much longer than expected is not a chatter's
  }
  const double u = bounces.roots[0].at, together = same_instant / bounces.path.rate;
  if (!(u > 0.0) || bounces.time + u * bounces.span > bounces.covered) return false;
  for (std::size_t j = 1; j < hit; ++j)
    if (std::abs(bounces.roots[j].at - u) * bounces.span > together) return false;
  for (std::size_t k = 0; k < bounces.watched.size(); ++k)
    if (first_root(bounces.reading[hit + k], 0, u, counters)) return false;
  return true;
}

// Follows no further than `left` after the latest impact: with fewer terms.
template <int D>
void expect_end(Bounces<D> &bounces, double left) {
  bounces.covered = std::min(bounces.covered, bounces.time + left);
  detail::drop_terms(bounces);
}

// Applies the impacts found (Eqs. 8-11), `flight` later. `closing` is set to the gap speeds before
// them.
template <int D>
void bounce(Bounces<D> &bounces, const Scene &scene, std::vector<double> &closing) {
  const std::size_t hit = bounces.hit();
  const double r = scene.restitution, u = bounces.roots[0].at, flight = u * bounces.span;
  closing.resize(hit);
  for (std::size_t j = 0; j < hit; ++j)
    closing[j] = std::min(0.0, bounces.roots[j].slope / bounces.span);
  bounces.time += flight;
  detail::Powers at;
  detail::set_powers(at, u, bounces.order);
  const std::size_t readings = hit + bounces.watched.size();
  for (std::size_t i = 0; i < readings; ++i)
    recentre(bounces.reading[i], bounces.order, at, bounces.ratio);
  // Half as much again as is left when all flights fall by r.
  expect_end(bounces, 1.5 * r * flight * bounces.flights);
  detail::set_span(bounces, flight * bounces.ratio[1]);
  const int order = bounces.order;
  bounces.times.push_back(bounces.time);
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
      for (int n = 0; n <= order; n += 4)
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
