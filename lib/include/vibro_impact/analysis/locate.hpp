// Locating a parameter value: where a count of events changes, and where a smooth function is zero.
#pragma once

#include <functional>

namespace vibro_impact {

// A located parameter value and its estimated absolute error.
struct Located {
  double value = 0.0, error = 0.0;
};

// Two parameter values and their counts, which differ.
struct CountJump {
  double below = 0.0, above = 0.0;
  int count_below = 0, count_above = 0;
};

// Bisects [below, above] for the place where `count` first differs from its value at `below`, down
// to `width` (0: neighbouring floating-point numbers). Throws std::invalid_argument when the counts
// at the ends agree.
CountJump bisect(const std::function<int(double)> &count, double below, double above,
                 double width = 0.0);

// The zero of f in [below, above], where it changes sign (TOMS 748). Throws std::invalid_argument
// when f does not change sign, or is not a number.
Located zero(const std::function<double(double)> &f, double below, double above);

}  // namespace vibro_impact
