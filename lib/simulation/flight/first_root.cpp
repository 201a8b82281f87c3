#include "first_root.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace vibro_impact {

namespace {

// An upper bound on [0, reach] of -p'' of the polynomial with its first coefficients divided out.
double curvature_bound(const Polynomial &p, int first, double reach) {
  const auto within = [&](int n) {
    const double k = n - first;
    return k * (k - 1.0) * std::pow(reach, k - 2.0);
  };
  return std::max(0.0, -detail::lower_bound(p, first + 2, within));
}

// The positive root of value + slope d - curvature d^2 / 2 for value > 0, in the form that does not
// cancel: a mass that leaves its stop slowly and is pulled away has slope^2 >> curvature value.
double safe_step(double value, double slope, double curvature) {
  const double root = std::sqrt(slope * slope + 2.0 * curvature * value);
  return slope > 0.0 ? (slope + root) / curvature : 2.0 * value / (root - slope);
}

// The same where p'' > 0, from p'' >= 2 second - twist d over the next d: superlinear even at a
// tangency, and over a dip in one step.
double convex_step(const Jet &at, double twist) {
  if (at.slope >= 0.0) return 2.0 * at.second / twist;  // p' >= 0 that far
  const double d = -at.slope / at.second, curvature = 2.0 * at.second - twist * d;
  if (curvature <= 0.0) return 0.0;
  const double square = at.slope * at.slope - 2.0 * curvature * at.value;
  return square < 0.0 ? d : std::min(d, 2.0 * at.value / (std::sqrt(square) - at.slope));
}

// A root at u of the polynomial with its first coefficients divided out, where it has this slope.
Root root_at(double u, double slope, int first) {
  for (int k = 0; k < first; ++k) slope *= u;
  return {u, slope};
}

// A step towards the root of a jet by the inverse of its series, to fourth order in Newton's step.
struct SeriesStep {
  double newton, step;
  double slope;  // after the step, relative to the slope before it
  double error;  // of that slope, relative; that of the step, relative, is less
};

// `bent` bounds |p''| newton / |p'|: the step is kept within the distance from Newton's at which
// the root can lie.
SeriesStep series_step(const Jet &at, double bent, double fifth) {
  const double inverse = -1.0 / at.slope, newton = at.value * inverse;
  const double a = at.second * inverse, b = at.third * inverse, c = at.fourth * inverse;
  const double aa = a * a, n2 = newton * newton;
  double correction = newton * (a + newton * (2.0 * aa + b + newton * (5.0 * (aa + b) * a + c)));
  if (std::abs(correction) > bent) [[unlikely]]
    correction = std::copysign(bent, correction);
  const double step = newton + newton * correction;
  const double next = 14.0 * aa * aa + 21.0 * aa * std::abs(b) + 6.0 * std::abs(a * c) +
                      3.0 * b * b + fifth * std::abs(inverse);
  return {newton, step, 1.0 - step * (2.0 * a + step * (3.0 * b + step * (4.0 * c))),
          5.0 * next * n2 * n2};
}

}  // namespace

std::optional<Root> first_root(const Polynomial &p, double limit, Counters &counters) {
  int first = 0;
  while (first <= p.order && p.coefficient[static_cast<std::size_t>(first)] == 0.0) ++first;
  if (first > p.order) return std::nullopt;  // identically zero: it never leaves, never returns
  const double *c = p.coefficient.data() + first;
  if (c[0] < 0.0) return Root{0.0, first == 0 ? c[1] : first == 1 ? c[0] : 0.0};
  if (detail::lower_bound(p, first, [](int) { return 1.0; }) > 0.0) {
    ++counters.roots_dismissed;
    return std::nullopt;
  }
  const double most_bent = 2.0 * detail::derivative_bound(p, first, 2);  // |p''|
  const double size = c[0] + std::abs(c[1]) + most_bent;
  if (!(size >= 0x1p-430 && size <= 0x1p430)) {  // squares under- or overflow: in units of its size
    if (!std::isfinite(detail::derivative_bound(p, first, 0))) return std::nullopt;  // given up
    Polynomial other = p;
    const double unit = std::ldexp(1.0, std::clamp(std::ilogb(size), -900, 900));
    for (double &term : other.coefficient) term /= unit;
    auto root = first_root(other, limit, counters);
    if (root) root->slope *= unit;
    return root;
  }
  ++counters.roots_searched;
  const double fifth = detail::derivative_bound(p, first, 5);
  constexpr double epsilon = std::numeric_limits<double>::epsilon();
  double reach = 1.0, growth = 4.0, curvature = -1.0, twist = -1.0;  // not known yet
  double u = 0.0, last_newton = std::numeric_limits<double>::infinity();
  const auto known = [&](int n) { return n <= p.order - first ? c[n] : 0.0; };
  Jet at{c[0], known(1), known(2), known(3), known(4)};
  int steps = 0;
  // The bound over [0, 1] says nothing of a small polynomial near 0: where steps are small or many,
  // one nearer by is set up, which then grows again, the faster the longer it holds.
  const auto bound_within = [&](double distance) {
    reach = std::min(1.0, distance);
    curvature = curvature_bound(p, first, reach);
  };
  // Ends: u grows by at least one unit in the last place per step away from a root, Newton's step
  // is at least halved near one.
  while (true) {
    // Kantorovich, with a margin of two: p' varies by less than half of itself over twice Newton's
    // step, so that the root ahead is the only one there.
    const double bent = most_bent * std::abs(at.value), square = at.slope * at.slope;
    if (at.slope < 0.0 && bent <= 0.25 * square) {
      const SeriesStep to = series_step(at, bent / square, fifth);
      const bool stalled =  // by rounding
          !(std::abs(to.newton) < 0.5 * last_newton) &&
          std::abs(at.value) <= 32.0 * epsilon * size_at(p, first, u);
      if (to.error <= 0.25 * epsilon || stalled) {
        if (!(u + to.step <= limit)) return std::nullopt;
        return root_at(u + to.step, at.slope * to.slope, first);
      }
      if (u + to.step <= limit) {
        ++counters.root_iterations;
        last_newton = std::abs(to.newton);
        u += to.step;
        at = jet_at(p, first, u);
        continue;
      }
    }
    if (curvature < 0.0) bound_within(1.0);
    double step = at.value <= 0.0 ? 0.0 : safe_step(at.value, at.slope, curvature);
    if (at.value > 0.0 && at.second > 0.0 && steps >= 2) {
      if (twist < 0.0) twist = 6.0 * detail::derivative_bound(p, first, 3);
      step = std::max(step, convex_step(at, twist));
    }
    if (step <= 1e-6 * u) {
      if (u < 0.25 * reach) {
        growth = 4.0;
        bound_within(growth * u);
        continue;
      }
      if (u + step == u || at.value <= 0.5 * epsilon * size_at(p, first, u)) {
        if (!(u <= limit)) return std::nullopt;
        return root_at(u, at.slope, first);
      }
    }
    ++counters.root_iterations;
    if (reach < 1.0 && u + step > reach) {  // not beyond where the bound holds
      step = reach - u;
      bound_within(growth * reach);
      growth *= growth;
    } else {
      const bool grown_too_far = growth > 4.0 && step < u;
      growth = 4.0;
      if ((++steps % 32 == 0 || grown_too_far) && u < 0.25 * reach)
        bound_within(growth * (u + step));
    }
    if (!(u + step <= limit)) return std::nullopt;  // also when the step is infinite
    u += step;
    at = jet_at(p, first, u);
  }
}

}  // namespace vibro_impact
