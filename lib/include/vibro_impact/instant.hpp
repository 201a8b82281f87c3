/// \file
/// Time as a whole number of forcing periods and a phase, which is the time within the period.
/// Times are non-dimensional.
///
/// The argument of cos(Omega t) is never large: after 1e6 periods the phase is as exact as in the
/// first. The period is carried to twice double precision, so that subtracting periods adds no
/// drift.
#pragma once

#include <cmath>
#include <compare>
#include <limits>

namespace vibro_impact {

/// A time that never comes, or a bound that excludes nothing.
inline constexpr double infinity = std::numeric_limits<double>::infinity();

namespace detail {

/// Both throw std::invalid_argument with one line. Omega must be >= 0 with a finite period. A time
/// must have at most `most_periods` periods.
[[noreturn]] void refuse_omega(double omega);
[[noreturn]] void refuse_time(double time);

}  // namespace detail

/// The forcing period T = 2 pi / Omega, as the unevaluated sum period + period_low. It is infinite
/// when Omega = 0. The constructor throws std::invalid_argument for a bad Omega.
struct Clock {
  double period = infinity;
  double period_low = 0.0;

  Clock() = default;
  explicit Clock(double omega) {
    constexpr double two_pi = 6.283185307179586477, two_pi_low = 2.4492935982947064e-16;
    if (!(omega >= 0.0 && omega < infinity)) detail::refuse_omega(omega);
    if (omega == 0.0) return;
    period = two_pi / omega;
    if (!std::isfinite(period)) detail::refuse_omega(omega);
    const double rest = (std::fma(-omega, period, two_pi) + two_pi_low) / omega,
                 nearest = period + rest;
    period_low = rest - (nearest - period);
    period = nearest;
  }
};

/// t = cycle T + phase, 0 <= phase < T.
struct Instant {
  long long cycle = 0;
  double phase = 0.0;
  friend auto operator<=>(const Instant &, const Instant &) = default;
};

/// The largest number of whole periods that a double counts exactly.
constexpr double most_periods = 0x1p53;

/// The time of an instant, counted from t = 0.
inline double time_of(const Instant &instant, const Clock &clock) {
  if (instant.cycle == 0) return instant.phase;
  const auto cycles = static_cast<double>(instant.cycle);
  return std::fma(cycles, clock.period, std::fma(cycles, clock.period_low, instant.phase));
}

/// The instant a time tau >= 0 after another. Throws std::invalid_argument beyond `most_periods`.
inline Instant later(Instant instant, double tau, const Clock &clock) {
  instant.phase += tau;
  while (!(instant.phase < clock.period)) {  // again where the quotient was rounded down
    const double cycles = std::floor(instant.phase / clock.period);
    if (!(cycles + static_cast<double>(instant.cycle) <= most_periods))
      detail::refuse_time(instant.phase);
    instant.phase = std::fma(-cycles, clock.period, instant.phase) - cycles * clock.period_low;
    instant.cycle += static_cast<long long>(cycles);
    if (instant.phase < 0.0) instant.phase = 0.0;  // rounding at the period boundary
  }
  return instant;
}

/// The instant at a time >= 0, which has this time: its phase has more digits. Throws as `later`
/// does.
inline Instant instant_at(double time, const Clock &clock) {
  const Instant instant = later(Instant{}, time, clock);
  if (!(time_of(instant, clock) > time)) return instant;
  // The time lies just before a multiple of the period.
  const auto cycles = static_cast<double>(instant.cycle - 1);
  return {instant.cycle - 1, std::fma(-cycles, clock.period, time) - cycles * clock.period_low};
}

/// The time from a to b. The difference of the cycle counts is exact up to `most_periods`.
inline double elapsed(const Instant &a, const Instant &b, const Clock &clock) {
  if (a.cycle == b.cycle) return b.phase - a.phase;
  const double cycles = static_cast<double>(b.cycle) - static_cast<double>(a.cycle);
  return std::fma(cycles, clock.period, std::fma(cycles, clock.period_low, b.phase - a.phase));
}

}  // namespace vibro_impact
