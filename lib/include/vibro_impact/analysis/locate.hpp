// Locating a parameter value: where a count of events changes, and where a smooth function is zero.
#pragma once

#include <functional>

#include "vibro_impact/simulate.hpp"

namespace vibro_impact {

// A located parameter value and its estimated absolute error.
struct Located {
  double value = 0.0, error = 0.0;
};

// Sticking phases of `mass` (from 1) begun within `periods` forcing periods, after `settling` ones,
// of the motion from the scene's own initial state. Throws std::runtime_error when the run is given
// up.
int sticking_phases(const Scene &scene, int mass, int settling, int periods);

// Two neighbouring parameter values with different counts.
struct Change {
  double below = 0.0, above = 0.0;
  int count_below = 0, count_above = 0;
};

// Bisects [below, above] for the place where `count` first differs from its value at `below`, down
// to `width` (0: neighbouring floating-point numbers). Throws std::invalid_argument when the counts
// at the ends agree.
Change bisect(const std::function<int(double)> &count, double below, double above,
              double width = 0.0);

// The zero of f in [below, above], where it changes sign (TOMS 748). Throws std::invalid_argument
// when it does not, or is no number.
Located zero(const std::function<double(double)> &f, double below, double above);

// The zero of a function that exists, positive and falling, on one side of it only: inverse
// interpolation from that side, never stepping across. `far` and `near` are two points on it,
// f(far) > f(near) > 0. The error estimate is the last correction. Throws std::runtime_error when f
// does not fall.
Located zero_from_one_side(const std::function<double(double)> &f, double far, double near);

}  // namespace vibro_impact
