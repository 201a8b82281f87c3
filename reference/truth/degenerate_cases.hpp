// Scenes with an instant at which several hold forces are zero together, so that no force
// tells who is held: chains of equal masses and links at rest on stops at zero.
//
// Included by the tests and the 50-digit generator, as the extreme cases are.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "case.hpp"
#include "reference/scenes/extreme_scenes.hpp"

namespace vibro_impact::truth {

// All masses at rest on stops at zero, the same forcing on each.
inline Scene on_equal_stops(int masses, Side side, double beta, double r) {
  Scene scene = extremes::chain(masses, beta);
  scene.amplitude.assign(scene.mass.size(), 0.5);
  scene.omega = 0.7;
  scene.restitution = r;
  for (int i = 1; i <= masses; ++i) scene.stops.push_back({i, side, 0.0});
  return scene;
}

// Ten masses of which only the first is forced; it has no stop, and pulls the others off theirs:
// mass j follows its neighbour as t^2j.
inline Scene following_the_first() {
  Scene scene = on_equal_stops(10, Side::lower, 0.0, 0.7);
  std::fill(scene.amplitude.begin() + 1, scene.amplitude.end(), 0.0);
  scene.stops.erase(scene.stops.begin());
  return scene;
}

// The forcing pulls masses off lower stops at the start and presses them into upper ones; all
// masses that rest beside resting neighbours are let go where cos(omega t) passes zero.
inline std::vector<Case> degenerate_cases() {
  std::vector<Case> cases;
  for (const Side side : {Side::lower, Side::upper})
    for (const int masses : {2, 3, 5})
      for (const double beta : {0.0, 0.5})
        for (const double r : {0.0, 0.7})
          cases.push_back({fmt::format("{} masses on {} stops: beta = {:g} r = {:g} omega = 0.7",
                                       masses, side == Side::upper ? "upper" : "lower", beta, r),
                           "degenerate", on_equal_stops(masses, side, beta, r), 30.0});
  cases.push_back({"10 masses that follow the first", "degenerate", following_the_first(), 30.0});
  return cases;
}

}  // namespace vibro_impact::truth
