// A chain of ten masses, stops on three of them: nothing here or in the library counts on two.
#pragma once

#include "vibro_impact/scene.hpp"

namespace vibro_impact::figures {

// Equal masses and springs as the paper has them, forced at the beginning; stops at the beginning,
// in the middle and at the end. More damping than the paper's: the slowest mode, of natural
// frequency 0.149, would take thousands of forcing periods to settle at beta = 0.1.
inline Scene long_chain() {
  Scene scene;
  scene.mass.assign(10, 1.0);
  scene.stiffness.assign(10, 1.0);
  scene.beta = 0.3;
  scene.amplitude.assign(10, 0.0);
  scene.amplitude.front() = 0.8;
  scene.omega = 0.3;
  scene.restitution = 0.7;
  scene.stops = {{1, Side::lower, -0.3}, {5, Side::upper, 0.1}, {10, Side::upper, 0.2}};
  return scene;
}

}  // namespace vibro_impact::figures
