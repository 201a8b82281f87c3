// The times of a table of samples, which may go on behind that of another run.
#pragma once

#include <algorithm>
#include <limits>

#include "vibro_impact/record.hpp"

namespace vibro_impact::runner {

// From, from + every, ... up to `to`, of which the first are taken.
struct SampleTimes {
  double from = 0.0, to = 0.0, every = 0.0;
  std::size_t taken = 0;

  double next() const {
    return sample_time(from, to, every, taken);
  }
  // Goes on behind a run to `time`, which has taken its samples.
  void skip_to(double time) {
    if (time < from) return;
    // The quotient is right but for rounding.
    taken = static_cast<std::size_t>(std::clamp((time - from) / every - 1.0, 0.0, 0x1p53));
    while (sample_time(from, time, every, taken) < std::numeric_limits<double>::infinity()) ++taken;
  }
  // The time up to which the table reaches when the run has ended at `time`: that itself, but for
  // the rounding beside a sample. `skip_to` comes to `taken` there.
  double reach(double time) const {
    if (taken > 0) time = std::max(time, sample_time(from, to, every, taken - 1));
    // `sample_time` takes one that lies beyond by rounding for one that is due.
    return std::min(time, next() * (1.0 - 1e-15));
  }
};

}  // namespace vibro_impact::runner
