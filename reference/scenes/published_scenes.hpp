// The scenes of published results beside the oscillator of extreme_scenes.hpp.
#pragma once

#include "vibro_impact/scene.hpp"

namespace vibro_impact::published {

// A mass thrown at a lower stop at 0, under a constant force (omega = 0: the cosine is one) and,
// with k > 0, on a spring.
inline Scene ball(double mass, double k, double force, double restitution, double height,
                  double velocity) {
  return {.mass = {mass},
          .stiffness = {k},
          .amplitude = {force},
          .omega = 0.0,
          .restitution = restitution,
          .stops = {{1, Side::lower, 0.0}},
          .displacement = {height},
          .velocity = {velocity}};
}

// A bar of elements thrown at a wall, r = 0. E = 210e9, rho = 7800, section 3.14e-4, length 1, as
// in the example of Siconos. Masses lumped at the nodes, half of one at each end; `elements` of
// them have the length of 1 / `per_length`.
constexpr double elasticity = 210e9, density = 7800.0, section = 0.000314;

inline Scene bar(int elements, int per_length) {
  const double length = 1.0 / per_length;
  const auto nodes = static_cast<std::size_t>(elements) + 1;
  Scene scene;
  scene.mass.assign(nodes, density * section * length);
  scene.mass.front() *= 0.5;
  scene.mass.back() *= 0.5;
  scene.stiffness.assign(nodes, elasticity * section / length);
  scene.stiffness.front() = 0.0;
  scene.restitution = 0.0;
  scene.stops = {{1, Side::lower, 0.0}};
  scene.displacement.assign(nodes, 0.00005);
  scene.velocity.assign(nodes, -0.1);
  return scene;
}

}  // namespace vibro_impact::published
