// Frequencies at which the settled motion of a scene of the paper changes, as brackets read off the
// bifurcation diagrams. The library and the 50-digit generator bisect them, each by itself.
#pragma once

#include "paper_scenes.hpp"

#include <vector>

namespace vibro_impact::paper {

// The motion from rest settles to another number of sticking phases of `mass` (from 1) at `near`
// than at `far`. At `near` every chatter in question is complete, so that the motion on that side
// is smooth in the frequency up to the change. Unless the change is a jump, the motion must be
// smooth as far beyond `near` as `far` is before it.
struct StickingChange {
  const char *symbol;  // of the key number
  int mass;
  double near, far;   // forcing frequencies
  bool jump = false;  // two motions are stable on both sides, and the one reached from rest changes
};

// In the scene of Figures 2 to 4, all between Omega = 0.25 and 0.5. At a multi-sliding bifurcation
// a sticking phase splits in two. At a border orbit a chatter ceases to be complete. At the jump
// two motions are stable: mass 1 sticks every other period in one of them and never in the other.
// Below the jump, rest lies in the basin of the first one, above in that of the second.
inline const std::vector<StickingChange> &sticking_changes() {
  static const std::vector<StickingChange> changes{
      {"multi_sliding_mass_1", 1, 0.256, 0.25601},      {"border_mass_1_1", 1, 0.25745, 0.25746},
      {"multi_sliding_mass_2", 2, 0.26809, 0.2681},     {"border_mass_2_1", 2, 0.26846, 0.26847},
      {"border_mass_1_2", 1, 0.29654, 0.29655},         {"border_mass_1_3", 1, 0.33099, 0.33098},
      {"border_mass_2_2", 2, 0.367, 0.36701},           {"border_mass_1_4", 1, 0.36782, 0.367821},
      {"jump_mass_1", 1, 0.36782291, 0.36782292, true}, {"border_mass_2_3", 2, 0.403829, 0.403827},
      {"border_mass_1_5", 1, 0.40384, 0.40383},         {"border_mass_1_6", 1, 0.46421, 0.46422},
      {"border_mass_2_4", 2, 0.47474, 0.47475}};
  return changes;
}

// The first of the two motions at the jump, followed from below, ends here at its own border orbit.
inline StickingChange border_beyond_the_jump() {
  return {"border_beyond_the_jump", 1, 0.3678229, 0.367823};
}

// Figure 5(b) without the stop of mass 2, which moves below its place at the lower frequency and
// reaches it at the higher one.
constexpr double grazing_below = 0.2995, grazing_above = 0.2996;
inline Scene figure5b_without_second_stop(double omega) {
  Scene scene = figure5b();
  scene.omega = omega;
  scene.stops.pop_back();
  return scene;
}

}  // namespace vibro_impact::paper
