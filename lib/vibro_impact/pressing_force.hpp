// The force that presses a mass, at rest at its stop, into it: Eqs. 12-13 times the sign of the
// side. Negative when the mass is pulled off.
#pragma once

#include <cmath>

#include "scene.hpp"

namespace vibro_impact {

// Force of its links on a mass (from 1) at rest at `position`; displacement(i) and velocity(i) are
// those of mass i, asked of the neighbours only.
template <class Displacement, class Velocity>
double force_of_links(const Scene &scene, int mass, double position,
                      const Displacement &displacement, const Velocity &velocity) {
  const auto p = static_cast<std::size_t>(mass - 1);
  double force = mass == 1 ? -scene.stiffness[0] * position : 0.0;
  const auto add = [&](int neighbour, double link) {
    force += link * (displacement(neighbour) - position + scene.beta * velocity(neighbour));
  };
  if (mass > 1) add(mass - 1, scene.stiffness[p]);
  if (mass < scene.masses()) add(mass + 1, scene.stiffness[p + 1]);
  return force;
}

// The pressing force at a time `phase` within the forcing period.
template <class Displacement, class Velocity>
double pressing_force(const Scene &scene, const Stop &stop, double phase,
                      const Displacement &displacement, const Velocity &velocity) {
  double force = force_of_links(scene, stop.mass, stop.position, displacement, velocity);
  if (scene.forced())
    force +=
        scene.amplitude[static_cast<std::size_t>(stop.mass - 1)] * std::cos(scene.omega * phase);
  return sign(stop.side) * force;
}

}  // namespace vibro_impact
