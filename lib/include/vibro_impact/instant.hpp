// Time as a whole number of forcing periods and a phase time within the period.
//
// cos(Omega t) then never sees a large argument: after 1e6 periods the phase is as exact as in the
// first. The period is carried to twice double precision, so that counting it off does not drift.
#pragma once

#include <cmath>
#include <limits>

namespace vibro_impact {

namespace detail {

// Throw std::invalid_argument: Omega >= 0 with a finite period, and times of at most so many
// periods as a double counts.
[[noreturn]] void refuse_omega(double omega);
[[noreturn]] void refuse_time(double time);

}  // namespace detail

// The forcing period T = 2 pi / Omega as an unevaluated sum; infinite when Omega = 0.
struct Clock {
  double omega = 0.0;
  double period = std::numeric_limits<double>::infinity();
  double period_rest = 0.0;

  Clock() = default;
  explicit Clock(double omega_of_forcing) : omega(omega_of_forcing) {
    constexpr double two_pi = 6.283185307179586477, two_pi_rest = 2.4492935982947064e-16;
    if (!(omega >= 0.0 && omega < std::numeric_limits<double>::infinity()))
      detail::refuse_omega(omega);
    if (omega == 0.0) return;
    period = two_pi / omega;
    if (!std::isfinite(period)) detail::refuse_omega(omega);
    period_rest = (std::fma(-omega, period, two_pi) + two_pi_rest) / omega;
  }
};

// t = cycle T + phase, 0 <= phase < T.
struct Instant {
  long long cycle = 0;
  double phase = 0.0;
};

// Up to here a double counts whole periods exactly.
constexpr double most_periods = 0x1p53;

inline double time_of(const Instant &instant, const Clock &clock) {
  if (instant.cycle == 0) return instant.phase;
  const auto cycles = static_cast<double>(instant.cycle);
  return std::fma(cycles, clock.period, std::fma(cycles, clock.period_rest, instant.phase));
}

inline Instant later(Instant instant, double tau, const Clock &clock) {
  instant.phase += tau;
  while (!(instant.phase < clock.period)) {  // again where the quotient was rounded down
    const double cycles = std::floor(instant.phase / clock.period);
    if (!(cycles + static_cast<double>(instant.cycle) <= most_periods))
      detail::refuse_time(instant.phase);
    instant.phase = std::fma(-cycles, clock.period, instant.phase) - cycles * clock.period_rest;
    instant.cycle += static_cast<long long>(cycles);
    if (instant.phase < 0.0) instant.phase = 0.0;  // rounding at the period boundary
  }
  return instant;
}

inline Instant instant_at(double time, const Clock &clock) {
  return later(Instant{}, time, clock);
}

inline bool operator<(const Instant &a, const Instant &b) {
  return a.cycle != b.cycle ? a.cycle < b.cycle : a.phase < b.phase;
}

// b - a, exact in the cycle count up to `most_periods`.
inline double elapsed(const Instant &a, const Instant &b, const Clock &clock) {
  if (a.cycle == b.cycle) return b.phase - a.phase;
  const double cycles = static_cast<double>(b.cycle) - static_cast<double>(a.cycle);
  return std::fma(cycles, clock.period, std::fma(cycles, clock.period_rest, b.phase - a.phase));
}

}  // namespace vibro_impact
