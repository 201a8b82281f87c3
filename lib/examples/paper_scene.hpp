// The two masses of the paper with the stops of its Figures 2 to 4, at any forcing frequency.
#pragma once

#include "vibro_impact/scene.hpp"

inline vibro_impact::Scene paper_scene(double omega) {
  using namespace vibro_impact;
  Scene scene;
  scene.mass = {1.0, 1.0};
  scene.stiffness = {1.0, 1.0};
  scene.beta = 0.1;
  scene.amplitude = {0.5, 0.0};
  scene.omega = omega;
  scene.restitution = 0.7;
  scene.stops = {{1, Side::lower, -0.3}, {2, Side::upper, 0.1}};
  return scene;
}
