// When dual sticking is possible: in closed form, for two masses.
#pragma once

#include <algorithm>
#include <cmath>

#include "vibro_impact/scene.hpp"

namespace vibro_impact {

// The greatest force, over a forcing period, that presses both masses of a two-mass chain into
// their stops `first` and `second` at once (the smaller of the two forces). Positive if and only if
// dual sticking is possible.
//
// With both masses at rest at their stops, u = cos(Omega t), and A = (A1, A2), Eqs. 12-13 read
//   F1 = k2 (s2 - s1) - k1 s1 + A1 u,   F2 = k2 (s1 - s2) + A2 u,
// and dual sticking needs sigma1 F1 > 0 and sigma2 F2 > 0 at the same u in [-1, 1]. The condition
// is sufficient, too: both forces stay positive for some time about such an instant, two masses at
// rest at their stops stay there for that time, and so do, after complete chatter, masses that
// arrive slowly enough. (It does not say that a given initial state leads there.)
//
// For A2 = 0, the paper's case, F2 is constant: sigma2 (s1 - s2) > 0, which for an upper stop is
// s2 < s1, and sigma1 (k2 (s2 - s1) - k1 s1) + |A1| > 0. At s2 = s1, Figure 5(c), F2 is zero: mass
// 2 bounces about its own equilibrium at a constant interval, for ever, and does not stick.
inline double greatest_common_press(const Scene &scene, const Stop &first, const Stop &second) {
  const double s1 = first.position, s2 = second.position, link = scene.stiffness[1] * (s2 - s1);
  const double sigma1 = sign(first.side), sigma2 = sign(second.side);
  const double press1 = sigma1 * (link - scene.stiffness[0] * s1), press2 = -sigma2 * link;
  const double slope1 = sigma1 * scene.amplitude[0], slope2 = sigma2 * scene.amplitude[1];
  const auto smaller = [&](double u) { return std::min(press1 + slope1 * u, press2 + slope2 * u); };
  // The smaller of two straight lines is greatest at an end of [-1, 1] or where they cross.
  const double ends = std::max(smaller(1.0), smaller(-1.0));
  const double crossing = (press2 - press1) / (slope1 - slope2);
  return std::abs(crossing) <= 1.0 ? std::max(ends, smaller(crossing)) : ends;
}

}  // namespace vibro_impact
