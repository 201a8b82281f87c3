/// \file
/// Locating a parameter value: where a count of events changes, such as that of sticking phases,
/// and where a smooth function is zero.
#pragma once

#include <functional>

#include "vibro_impact/scene.hpp"

namespace vibro_impact {

/// Two parameter values and their counts, which differ.
struct CountJump {
  double below = 0.0, above = 0.0;
  int count_below = 0, count_above = 0;
};

/// Bisects [below, above] for the place where `count` first differs from its value at `below`, down
/// to `width` (0: neighbouring floating-point numbers). Throws std::invalid_argument when the
/// counts at the ends agree.
CountJump bisect(const std::function<int(double)> &count, double below, double above,
                 double width = 0.0);

/// The number of sticking phases of `mass` (from 1) that begin within `periods` forcing periods,
/// after `settling` periods, of the motion from the scene's own initial state. Throws
/// std::invalid_argument for a bad scene, mass or number of periods, and std::runtime_error when
/// the run is given up.
int sticking_phases(const Scene &scene, int mass, int settling, int periods);

/// The zero of f in [below, above], where it changes sign (TOMS 748). Throws std::invalid_argument
/// when f does not change sign, or is not a number.
double zero(const std::function<double(double)> &f, double below, double above);

}  // namespace vibro_impact
