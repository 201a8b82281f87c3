// The scenes of the paper's figures.
//
// Every number is *printed* (it stands in the paper's text, its captions or on the axes of its
// figures) or *inferred* (the text does not give it; it was found by matching what the text
// says of the figure and its axis box). Everything is non-dimensional.
#pragma once

#include <stdexcept>
#include <string>
#include <vector>

#include "vibro_impact/scene.hpp"

namespace vibro_impact::paper {

// Two equal masses with two stops, at rest at t = 0. Printed (Section 3): m = k = 1, c = 0.1,
// A = (0.5, 0), zero initial conditions. c enters as beta = c / k.
inline Scene two_masses(Stop first, Stop second, double restitution, double omega) {
  Scene scene;
  scene.mass = {1.0, 1.0};
  scene.stiffness = {1.0, 1.0};
  scene.beta = 0.1;
  scene.amplitude = {0.5, 0.0};
  scene.omega = omega;
  scene.restitution = restitution;
  scene.stops = {first, second};
  return scene;
}

// Figure 3, and the chain of Figures 2 and 4: stops of different sign. Printed: s1 = -0.3, s2 = 0.1
// (caption of Figure 2), r = 0.7 (Section 3), Omega from 0.25 to 0.7 (Section 3.2 and the axis).
inline Scene figure3(double omega) {
  return two_masses({1, Side::lower, -0.3}, {2, Side::upper, 0.1}, 0.7, omega);
}

// Figure 2. Inferred (inferred_frequencies.hpp): Omega = 0.2, the only value that fits and has one
// decimal.
inline Scene figure2() {
  return figure3(0.2);
}

// Figure 4. Printed: Omega (caption), just before and just after the multi-sliding bifurcation.
inline Scene figure4a() {
  return figure3(0.256);
}
inline Scene figure4b() {
  return figure3(0.2561);
}

// Figure 5(a). Printed: s1 = s2 = 0.3 (Section 3.3), r = 0.7. Inferred (inferred_frequencies.hpp):
// Omega = 0.2561, the only value that fits and is printed elsewhere (caption of Figure 4).
inline Scene figure5a() {
  return two_masses({1, Side::upper, 0.3}, {2, Side::upper, 0.3}, 0.7, 0.2561);
}

// Figure 5(b). Printed: s2 "moved to" 0.45, so that s1 stays at 0.3, and r = 0.001 (Section 3.3).
// Inferred (inferred_frequencies.hpp): Omega = 0.2995, just below the grazing of mass 2.
inline Scene figure5b() {
  return two_masses({1, Side::upper, 0.3}, {2, Side::upper, 0.45}, 0.001, 0.2995);
}

// Figure 5(c). Printed: Omega = 0.02, r = 0.7 (Section 3.3). Inferred: s1 = s2 = 0.3.
inline Scene figure5c() {
  return two_masses({1, Side::upper, 0.3}, {2, Side::upper, 0.3}, 0.7, 0.02);
}

// The scenes that a run of its own is shown of, under their names in file names, and how far each
// is followed: to the end of its window; in Figure 4, whose window is within a period, as in
// Figure 2. The parameters that are not printed have the names of `parameter.hpp`.
struct NamedScene {
  std::string name;
  Scene scene;
  double until;
  std::vector<std::string> inferred = {};
};

inline std::vector<NamedScene> named_scenes() {
  return {{"figure2", figure2(), 750.0, {"omega"}},
          {"figure4a", figure4a(), 750.0},
          {"figure4b", figure4b(), 750.0},
          {"figure5a", figure5a(), 964.0, {"omega"}},
          {"figure5b", figure5b(), 930.0, {"omega"}},
          {"figure5c", figure5c(), 1000.0, {"stop1", "stop2"}}};
}

// Throws std::invalid_argument if there is none of that name.
inline NamedScene scene_named(const std::string &name) {
  for (const NamedScene &named : named_scenes())
    if (named.name == name) return named;
  throw std::invalid_argument("scene '" + name +
                              "': must be one of figure2, figure4a, figure4b, figure5a, figure5b, "
                              "figure5c");
}

// Forcing periods left out before a motion counts as settled (ours: the paper does not say how long
// it waits). A chatter that ends in sticking forgets most of what came before, so that the motion
// of Figure 4 settles early; without sticking it may creep, and Figure 3 waits longer: at 150
// periods about one frequency in eight above 0.57 has not settled, at 300 few have not.
constexpr int figure3_settling_periods = 400;
constexpr int figure4_settling_periods = 150;

// Impacts faster than this are resolved one by one rather than carried to the chatter limit: below
// it a bounce cannot be seen in any of the figures (ours).
constexpr double slowest_impact_shown = 1e-4;

}  // namespace vibro_impact::paper
