#include <cmath>
#include <limits>

#include "polynomial.hpp"

namespace vibro_impact {

namespace {

// A lower bound, over the next h, of the polynomial with this jet, |p^(5)| / 5! being at most
// `fifth` there: the least value of the lowest parabola that the higher terms can make of it.
inline double lower_bound(const Jet &at, double fifth, double h) {
  const double third = at.third + h * std::min(0.0, at.fourth - h * fifth),
               second = at.second + h * std::min(0.0, third);
  const double lowest = second > 0.0 ? std::clamp(-0.5 * at.slope / second, 0.0, h) : h;
  return at.value + std::min(0.0, lowest * (at.slope + lowest * second));
}

// An upper bound of |p''| over the next h and the h before.
double curvature_bound(const Jet &at, double fifth, double h) {
  const double third =
      3.0 * std::abs(at.third) + h * (6.0 * std::abs(at.fourth) + h * 10.0 * fifth);
  return 2.0 * (std::abs(at.second) + h * third);
}

// A root at u of the polynomial with its first coefficients divided out, where it has this slope.
Root root_at(double u, double slope, int first) {
  for (int k = 0; k < first; ++k) slope *= u;
  return {u, slope};
}

// A step towards the root of a jet by the inverse of its series, to fourth order in Newton's step.
struct SeriesStep {
  double step;
  double slope;  // after the step, relative to the slope before it
  double error;  // of that slope, relative; that of the step, relative, is less
};

// `bent` bounds |p''| newton / |p'|: the step is kept within the distance from Newton's at which
// the root can lie.
SeriesStep series_step(const Jet &at, double newton, double bent, double fifth) {
  const double inverse = -1.0 / at.slope;
  const double a = at.second * inverse, b = at.third * inverse, c = at.fourth * inverse;
  const double aa = a * a, n2 = newton * newton;
  double correction = newton * (a + newton * (2.0 * aa + b + newton * (5.0 * (aa + b) * a + c)));
  if (std::abs(correction) > bent) [[unlikely]]
    correction = std::copysign(bent, correction);
  const double step = newton + newton * correction;
  const double next = 14.0 * aa * aa + 21.0 * aa * std::abs(b) + 6.0 * std::abs(a * c) +
                      3.0 * b * b + fifth * std::abs(inverse);
  return {step, 1.0 - step * (2.0 * a + step * (3.0 * b + step * (4.0 * c))), 5.0 * next * n2 * n2};
}

}  // namespace

std::optional<Root> first_root(const Polynomial &p, double limit, Counters &counters) {
  int first = 0;
  while (first <= p.order && p.coefficient[static_cast<std::size_t>(first)] == 0.0) ++first;
  if (first > p.order) return std::nullopt;  // identically zero: it never leaves, never returns
  const double *c = p.coefficient.data() + first;
  if (c[0] < 0.0) return Root{0.0, first == 0 ? c[1] : first == 1 ? c[0] : 0.0};
  Jet at{c[0], c[1], c[2], c[3], c[4]};  // zero beyond the order
  const double fifth = derivative_bound(p, first, 5);
  if (lower_bound(at, fifth, limit) > 0.0) {
    ++counters.roots_dismissed;
    return std::nullopt;
  }
  const double sum = at.value + at.slope + at.second + at.third + at.fourth + fifth;
  if (!std::isfinite(sum)) return std::nullopt;  // the run will be given up
  ++counters.roots_searched;
  constexpr double epsilon = std::numeric_limits<double>::epsilon();
  double u = 0.0, last_newton = std::numeric_limits<double>::infinity();
  // Ends: Newton's step is at least halved near a root; away from one u grows.
  while (true) {
    // Kantorovich, with a margin of two: p' varies by less than half of itself over twice Newton's
    // step, so that the root ahead is the only one there.
    const double newton = -at.value / at.slope, distance = std::abs(newton);
    const double bent = curvature_bound(at, fifth, 2.0 * distance) * distance / -at.slope;
    if (at.slope < 0.0 && bent <= 0.25) {
      const SeriesStep to = series_step(at, newton, bent, fifth);
      const bool stalled =  // by rounding
          !(distance < 0.5 * last_newton) &&
          std::abs(at.value) <= 32.0 * epsilon * derivative_bound(p, first, 0, u);
      if (to.error <= 0.25 * epsilon || stalled) {
        if (!(u + to.step <= limit)) return std::nullopt;
        return root_at(u + to.step, at.slope * to.slope, first);
      }
      if (u + to.step <= limit) {
        ++counters.root_iterations;
        last_newton = distance;
        u += to.step;
        at = jet_at(p, first, u);
        continue;
      }
    }
    // Else over a stretch that is clear of zero, by more than the rounding of the value here. (The
    // bound of p^(5) up to 1 is far too large for a small polynomial near 0: one up to there.)
    const double rounded = 0.5 * epsilon * derivative_bound(p, first, 0, u);
    double stretch = limit - u;
    const auto is_clear = [&] {
      const double reach = u + stretch;
      const double near = reach < 0.25 ? derivative_bound(p, first, 5, reach) : fifth;
      return lower_bound(at, near, stretch) > rounded;
    };
    while (u + stretch > u && !is_clear()) stretch *= 0.5;
    if (!(u + stretch > u)) return root_at(u, at.slope, first);
    ++counters.root_iterations;
    u += stretch;
    if (!(u < limit)) return std::nullopt;
    at = jet_at(p, first, u);
  }
}

}  // namespace vibro_impact
