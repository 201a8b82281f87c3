// The numbers of a scene by name, as sweeps vary them. All are non-dimensional.
//
// The names are omega, beta and restitution (of every stop that has none of its own), and, with an
// index from 1, amplitude2, sine1, constant1 (force), ground1 (stiffness of a spring to the
// ground), mass1, stiffness1 (of a link), displacement1 and velocity1 (at t = 0), stop1 (the
// position of a stop, in the order of Scene::stops) and restitution2 (of a stop).
//
// Both functions throw std::invalid_argument for any other name, and for an index that the scene
// does not have.
#pragma once

#include <string_view>

#include "vibro_impact/scene.hpp"

namespace vibro_impact {

double get(const Scene &scene, std::string_view name);

// The scene with another value of the number. A number that the scene leaves out is first written
// out with the value it stands for: an empty vector becomes zeros, the restitution of a stop that
// of the scene. `check` judges the value.
Scene with(Scene scene, std::string_view name, double value);

}  // namespace vibro_impact
