// The time of a motion: a number of forcing periods and a phase of twice the precision. A sum of
// many steps then has no rounding, even of steps that a double does not resolve.
#pragma once

#include <algorithm>
#include <cmath>

#include "twofold.hpp"
#include "vibro_impact/instant.hpp"

namespace vibro_impact::detail {

struct TwofoldInstant {
  long long cycle = 0;
  Real phase = 0.0;

  TwofoldInstant() = default;
  explicit TwofoldInstant(const Instant &instant) : cycle(instant.cycle), phase(instant.phase) {
  }
  // The instant that is reported.
  Instant rounded() const {
    return {cycle, std::max(0.0, phase.hi)};
  }
};

// The time from a to b.
inline Real elapsed(const TwofoldInstant &a, const TwofoldInstant &b, const Clock &clock) {
  const Real rest = b.phase - a.phase;
  if (a.cycle == b.cycle) return rest;
  return rest + Real(clock.period, clock.period_low) * static_cast<double>(b.cycle - a.cycle);
}

// Moves an instant on by a time. Throws std::invalid_argument beyond `most_periods`.
inline void pass(const Real &time, const Clock &clock, TwofoldInstant &instant) {
  instant.phase += time;
  while (!(instant.phase.hi < clock.period)) {
    const double cycles = std::floor(instant.phase.hi / clock.period);
    if (!(cycles + static_cast<double>(instant.cycle) <= most_periods))
      refuse_time(instant.phase.hi);
    instant.phase -= Real(clock.period, clock.period_low) * cycles;
    instant.cycle += static_cast<long long>(cycles);
  }
}

}  // namespace vibro_impact::detail
