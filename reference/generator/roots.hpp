// Zeros of a signal that is sampled along a motion: brackets, narrowed down by bisection or by
// Newton's method.
#pragma once

#include "in_digits.hpp"

#include <algorithm>
#include <optional>

namespace vibro_impact_reference {

/// A quantity that is positive while nothing happens (the gap of a free mass, the hold force of a
/// stuck one), with its first two time derivatives.
struct Signal {
  Real value, rate, curvature;
};

/// Bisection: `before` holds at a and no longer at b, on either side of a. Returns the end at b of
/// a bracket of the wanted width.
template <class Predicate>
Real bisect(const Predicate &before, Real a, Real b, const Real &width) {
  while (abs(b - a) > width) {
    const Real middle = (a + b) / 2;
    if (middle == a || middle == b) break;
    (before(middle) ? a : b) = middle;
  }
  return b;
}

/// How far, and how, a zero is narrowed down.
struct RootSearch {
  Real width = Real("1e-36");  // a bracket this part of its right end is a zero
  bool newton = false;  // steps by the rate, inside the bracket: fewer, and not to the last bit
  Real least = 0;       // and so is a bracket this wide

  Real width_at(const Real &b) const {
    return std::max<Real>(width * b, least);
  }
};

/// The signal falls through zero between a, where `before` holds of it, and b, where it does not.
/// Bisection returns the end of the last bracket at b. Newton's method may return a time on either
/// side of the zero: where its step is shorter than the width, or the signal smaller than 1e-49.
template <class SignalAt, class Before>
Real fall_between(const SignalAt &signal_at, const Before &before, Real a, Real b,
                  const RootSearch &search) {
  if (!search.newton)
    return bisect([&](const Real &tau) { return before(signal_at(tau)); }, a, b,
                  search.width_at(b));
  const Real rounding = Real("1e-49");  // of a signal of order one
  Real latest = b, last = b - a;
  for (Signal signal = signal_at(b); b - a > search.width_at(b);) {
    Real next = signal.rate < 0 ? Real(latest - signal.value / signal.rate) : b;
    if (next <= a || next >= b || abs(next - latest) > last / 2) next = (a + b) / 2;
    last = abs(next - latest);
    if (last <= search.width_at(b)) return next;
    signal = signal_at(next);
    latest = next;
    (before(signal) ? a : b) = next;
    if (abs(signal.value) <= rounding && signal.rate < 0) return next;
  }
  return b;
}

/// First time in (a, b] at which the signal falls through zero, if there is one. The piece is cut
/// where the curvature changes sign, so that the rate is monotone on every part: then a part has at
/// most one extremum, and a dip below zero between two positive samples (grazing) is found on the
/// way to the minimum, itself bisected for from the rate.
template <class SignalAt>
std::optional<Real> first_fall(const SignalAt &signal_at, const Real &a, const Signal &at_a,
                               const Real &b, const Signal &at_b, const RootSearch &search) {
  const Real h = b - a;
  const Real reach =
      h * (abs(at_a.rate) + abs(at_b.rate) + 2 * h * (abs(at_a.curvature) + abs(at_b.curvature)));
  if (at_a.value > reach && at_b.value > reach)
    return std::nullopt;  // too far from zero to get there and back

  if ((at_a.curvature > 0 && at_b.curvature < 0) || (at_a.curvature < 0 && at_b.curvature > 0)) {
    const bool positive = at_a.curvature > 0;
    const Real m =
        bisect([&](const Real &tau) { return (signal_at(tau).curvature > 0) == positive; }, a, b,
               search.width_at(b));
    Signal at_m = signal_at(m);
    at_m.curvature = 0;  // so that neither part is cut again
    if (m < b) {
      if (auto root = first_fall(signal_at, a, at_a, m, at_m, search)) return root;
      return first_fall(signal_at, m, at_m, b, at_b, search);
    }
  }

  if (at_a.rate >= 0) {
    if (at_b.rate >= 0 || at_b.value > 0) return std::nullopt;
    // Up, over the only maximum, and down through zero.
    return fall_between(
        signal_at, [](const Signal &s) { return s.rate > 0 || s.value > 0; }, a, b, search);
  }
  if (at_b.rate > 0) {
    // A minimum lies between: that, or the zero that is met on the way to it.
    const auto above_and_falling = [&](const Real &tau) {
      const Signal s = signal_at(tau);
      return s.rate < 0 && s.value > 0;
    };
    const Real low = bisect(above_and_falling, a, b, search.width_at(b));
    return signal_at(low).value > 0 ? std::nullopt : std::optional(low);
  }
  if (at_b.value > 0) return std::nullopt;
  return fall_between(
      signal_at, [](const Signal &s) { return s.value > 0; }, a, b, search);
}

}  // namespace vibro_impact_reference
