#include "special_points.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <utility>

#include "analysis/orbits/newton.hpp"
#include "tolerances.hpp"

namespace vibro_impact::branches {

namespace {

// The product of (shift + mu), which is zero where a multiplier is -shift.
double product_of(const Multipliers &multipliers, double shift) {
  double product = 1.0;
  for (const auto &mu : multipliers)
    product *= mu.imag() == 0.0 ? shift + mu.real() : std::abs(shift + mu);
  return product;
}

// The product of mu_i mu_j - 1, which is zero where two multipliers have the product 1.
double product_of_pairs(const Multipliers &multipliers) {
  std::complex<double> product = 1.0;
  for (size_t i = 0; i < multipliers.size(); ++i)
    for (size_t j = 0; j < i; ++j) product *= multipliers[i] * multipliers[j] - 1.0;
  return product.real();
}

using Test = std::function<double(const Place &)>;

// The weights of values at these parts in the polynomial through them at another part.
std::vector<double> weights_at(const std::vector<double> &parts, double part) {
  std::vector<double> weights(parts.size(), 1.0);
  for (size_t k = 0; k < parts.size(); ++k)
    for (size_t j = 0; j < parts.size(); ++j)
      if (j != k) weights[k] *= (part - parts[j]) / (parts[k] - parts[j]);
  return weights;
}

// The zero near a part of the polynomial through values at these parts, by the secant method.
double zero_of_interpolant(const std::vector<double> &parts, const std::vector<double> &values,
                           double near) {
  const auto value = [&](double part) {
    const std::vector<double> weights = weights_at(parts, part);
    return std::inner_product(weights.begin(), weights.end(), values.begin(), 0.0);
  };
  double a = near, b = near + 0.1 * (parts.back() - near);
  for (int k = 0; k < 40 && b != a; ++k) {
    const double at_a = value(a), at_b = value(b);
    if (at_b == at_a) break;
    a = std::exchange(b, b - at_b * (b - a) / (at_b - at_a));
  }
  return b;
}

// The zero of a test function on the chord of two orbits, by the regula falsi with bisections.
struct Zero {
  const Problem &problem;
  const Place &a, &b;

  // The orbit of the branch near a guess; without unknowns if none is found.
  Place near(Vector u) const {
    const Condition plane = on_plane(problem, a.sequence, u, a.direction);
    Vector to_rounding = u;
    if (solve(problem, a.sequence, to_rounding, plane, true))
      u = to_rounding;
    else if (!solve(problem, a.sequence, u, plane))
      return {};
    return place_of(problem, a.sequence, u, a.direction);
  }

  std::optional<SpecialPoint> find(BranchPoint kind, const Test &test, double within) const {
    double left = 0.0, right = 1.0, at_left = test(a), at_right = test(b);
    const double size = std::abs(at_left) + std::abs(at_right);
    double least = std::abs(at_left);
    SpecialPoint point{kind, a.sequence, a.u};
    double q_left = a.parameter(), q_right = b.parameter();
    for (int k = 0; k < 60 && right - left > 4.0 * rounding; ++k) {
      const double part = k % 4 == 3 ? 0.5 * (left + right)
                                     : left + (right - left) * at_left / (at_left - at_right);
      if (!(part > left && part < right)) break;
      const Place place = near(a.u + part * (b.u - a.u));
      if (place.u.size() == 0) break;
      const double value = test(place);
      if (std::abs(value) < least) {
        least = std::abs(value);
        point.u = place.u;
        point.part = part;
      }
      if (value == 0.0) break;
      const bool is_left = (value < 0.0) == (at_left < 0.0);
      (is_left ? left : right) = part;
      (is_left ? at_left : at_right) = value;
      (is_left ? q_left : q_right) = place.parameter();
    }
    if (!(least < within * size + 1e-9)) return {};
    // The part of the bracket that the test function leaves open.
    const double open = std::min(1.0, least / (std::abs(at_left - at_right) + least));
    point.error = std::abs(q_right - q_left) * open + 8.0 * rounding * std::abs(point.u(0));
    return point;
  }

  // The zero of a test function where Newton's method is singular, as at a branching. Orbits on
  // both sides, at the distances d, 2d and 3d, are exact, and the test function and the unknowns
  // are smooth along the branch. They are interpolated, with a smaller d each time.
  std::optional<SpecialPoint> find_between(BranchPoint kind, const Test &test) const {
    SpecialPoint point{kind, a.sequence, a.u, infinity};
    point.part = test(a) / (test(a) - test(b));
    std::vector<double> parts = {0.0, 1.0};  // of the step
    std::vector<Vector> us = {a.u, b.u};
    const auto interpolated = [&](double part) {
      const std::vector<double> weights = weights_at(parts, part);
      Vector u = Vector::Zero(a.u.size());
      for (size_t k = 0; k < us.size(); ++k) u += weights[k] * us[k];
      return u;
    };
    for (const double d : {1.0 / 7.0, 0.03, 0.006, 0.0012}) {
      std::vector<double> new_parts, values;
      std::vector<Vector> new_us;
      for (const double distance : {-3.0, -2.0, -1.0, 1.0, 2.0, 3.0}) {
        new_parts.push_back(point.part + distance * d);
        const Place place = near(interpolated(new_parts.back()));
        if (place.u.size() == 0) break;
        values.push_back(test(place));
        new_us.push_back(place.u);
      }
      if (values.size() < 6) break;
      parts = std::move(new_parts);
      us = std::move(new_us);
      const double zero = zero_of_interpolant(parts, values, point.part);
      if (!(std::abs(zero - point.part) < 3.0 * d)) break;
      const Vector u = interpolated(zero);
      const double moved = std::abs(u(0) - point.u(0));
      if (!(moved < point.error)) {  // rounding has begun
        point.error = moved;
        break;
      }
      point.u = u;
      point.part = zero;
      // Next to the singular point, an orbit is known to its rounding over the distance.
      point.error = moved + 4.0 * rounding * std::abs(u(0)) / d;
    }
    if (!(point.error < infinity)) return {};
    return point;
  }
};

// The flip of the orbit of half the periods, near an orbit that has come to repeat itself after
// them.
std::optional<SpecialPoint> flip_of_parent(const Problem &problem, const Sequence &s,
                                           const Vector &u, double most) {
  if (half_of_period(problem, s, u) == 0) return {};
  const double near = u(0);
  const SequenceOrbit first = first_half(problem, s, u);
  const Sequence &half = first.first;
  Vector v = first.second;
  if (!solve(problem, half, v, at_parameter(problem, half, near))) return {};
  const auto test = [&](double q) {
    if (!solve(problem, half, v, at_parameter(problem, half, q), true)) return infinity;
    const Equations equations = evaluate(problem, half, v, nullptr, true);
    return product_of(multipliers_of(problem, half, equations.jacobian), 1.0);
  };
  double a = near, b = near + 1e-5 * problem.width, at_a = test(a), at_b = test(b);
  for (int k = 0; k < 30; ++k) {
    const double c = b - at_b * (b - a) / (at_b - at_a);
    if (!std::isfinite(c) || std::abs(c - near) > most) return {};
    const double step = std::abs(c - b);
    a = b;
    at_a = at_b;
    b = c;
    at_b = test(b);
    if (!(step < 16.0 * rounding * problem.parameter_size(b)) && at_b != 0.0) continue;
    return SpecialPoint{BranchPoint::parent_flip, half, v,
                        step + 8.0 * rounding * problem.parameter_size(b)};
  }
  return {};
}

// Two complex multipliers have the modulus 1, not two real ones the product 1.
bool has_pair_on_the_circle(const Multipliers &multipliers) {
  return std::ranges::any_of(multipliers, [](const auto &mu) {
    return mu.imag() != 0.0 && std::abs(std::abs(mu) - 1.0) < 1e-6;
  });
}

// True if multipliers may cross the unit circle twice between two orbits: one lies near the circle,
// or the largest one changes much, as next to a graze.
bool may_cross_twice(const Place &a, const Place &b) {
  const double at_a = largest_modulus(a.multipliers), at_b = largest_modulus(b.multipliers);
  const auto is_near = [](const auto &mu) {
    return std::abs(std::abs(mu) - 1.0) < near_the_circle;
  };
  return std::ranges::any_of(a.multipliers, is_near) ||
         std::ranges::any_of(b.multipliers, is_near) ||
         std::max(at_a, at_b) > 2.0 * std::min(at_a, at_b);
}

SpecialPoints special_points_in_part(const Problem &problem, const Place &a, const Place &b) {
  SpecialPoints found;
  const Zero zero{problem, a, b};
  const auto add = [&found](std::optional<SpecialPoint> point) {
    if (point) found.points.push_back(*std::move(point));
    return point.has_value();
  };
  const bool turns = a.direction(0) * b.direction(0) < 0.0,
             branches_off = a.orientation * b.orientation < 0.0;
  if (turns && !branches_off)
    add(zero.find(
        BranchPoint::fold, [](const Place &at) { return at.direction(0); }, 1e-6));
  if (branches_off) {
    const Vector middle = 0.5 * (a.u + b.u);
    const double step = (b.u - a.u).cwiseQuotient(units_of(problem, a.sequence)).norm();
    if (turns && add(flip_of_parent(problem, a.sequence, middle, step * problem.width))) {
      found.ends_the_branch = true;
      return found;
    }
    // The parameter is stationary where the branch turns round.
    const Test test = turns ? Test([](const Place &at) { return at.direction(0); })
                            : [](const Place &at) { return product_of(at.multipliers, -1.0); };
    const bool located = add(zero.find_between(BranchPoint::branching, test));
    if (turns) {
      if (!located)
        found.points.push_back(
            {BranchPoint::branching, a.sequence, middle, std::abs(a.u(0) - b.u(0))});
      found.ends_the_branch = true;
      return found;
    }
  }
  if (product_of(a.multipliers, 1.0) * product_of(b.multipliers, 1.0) < 0.0)
    add(zero.find(
        BranchPoint::flip, [](const Place &at) { return product_of(at.multipliers, 1.0); }, 1e-6));
  if (product_of_pairs(a.multipliers) * product_of_pairs(b.multipliers) < 0.0) {
    const auto torus = zero.find(
        BranchPoint::torus, [](const Place &at) { return product_of_pairs(at.multipliers); }, 1e-6);
    if (torus) {
      const Place place = place_of(problem, torus->sequence, torus->u, a.direction);
      if (has_pair_on_the_circle(place.multipliers)) add(torus);
    }
  }
  std::ranges::sort(found.points, {}, &SpecialPoint::part);
  return found;
}

// Divides the step into so many halves of halves, where two special points may lie close together.
SpecialPoints special_points_in(const Problem &problem, const Place &a, const Place &b,
                                int divisions) {
  if (divisions == 0 || !may_cross_twice(a, b)) return special_points_in_part(problem, a, b);
  const Place middle = Zero{problem, a, b}.near(0.5 * (a.u + b.u));
  // A step that turns round or branches off is taken as a whole.
  if (middle.u.size() == 0 || a.orientation != b.orientation || a.orientation != middle.orientation)
    return special_points_in_part(problem, a, b);
  SpecialPoints first = special_points_in(problem, a, middle, divisions - 1);
  const SpecialPoints second = special_points_in(problem, middle, b, divisions - 1);
  first.points.insert(first.points.end(), second.points.begin(), second.points.end());
  first.ends_the_branch = second.ends_the_branch;
  return first;
}

}  // namespace

SpecialPoints special_points_between(const Problem &problem, const Place &a, const Place &b) {
  return special_points_in(problem, a, b, 3);
}

}  // namespace vibro_impact::branches
