// Scenes beyond the paper that several programs share, some of them with a free parameter.
//
// The drivers, the tests and the 50-digit generator include them, so that a scene is written down
// once.
#pragma once

#include <vector>

#include "vibro_impact/scene.hpp"

namespace vibro_impact::extremes {

// n unit masses on unit springs.
inline Scene chain(int n, double beta) {
  Scene scene;
  scene.mass.assign(static_cast<std::size_t>(n), 1.0);
  scene.stiffness = scene.mass;
  scene.beta = beta;
  return scene;
}

// One mass on a spring before an upper stop, forced by A cos(omega t).
inline Scene one_mass(double beta, double amplitude, double omega, double restitution, double stop,
                      double start = 0.0, double velocity = 0.0) {
  Scene scene = chain(1, beta);
  scene.amplitude = {amplitude};
  scene.omega = omega;
  scene.restitution = restitution;
  scene.stops = {{1, Side::upper, stop}};
  scene.displacement = {start};
  scene.velocity = {velocity};
  return scene;
}

// A chain of ten masses, with stops on three of them: no code may assume two.
// Equal masses and springs as the paper has them, forced at the beginning; stops at the beginning,
// in the middle and at the end. More damping than the paper's: the slowest mode, of natural
// frequency 0.149, would take thousands of forcing periods to settle at beta = 0.1.
inline Scene long_chain() {
  Scene scene = chain(10, 0.3);
  scene.amplitude.assign(10, 0.0);
  scene.amplitude.front() = 0.8;
  scene.omega = 0.3;
  scene.restitution = 0.7;
  scene.stops = {{1, Side::lower, -0.3}, {5, Side::upper, 0.1}, {10, Side::upper, 0.2}};
  return scene;
}

// A chain of equal masses, each forced alike and with a stop on either side, for two forcing
// periods. No mass sticks.
inline Scene chain_of_stops(int masses) {
  Scene scene = chain(masses, 0.1);
  scene.amplitude.assign(scene.mass.size(), 0.1);
  scene.omega = 0.2;
  scene.restitution = 0.7;
  for (int mass = 1; mass <= masses; ++mass)
    for (const Side side : {Side::lower, Side::upper})
      scene.stops.push_back({mass, side, sign(side) * 0.3});
  return scene;
}

}  // namespace vibro_impact::extremes
