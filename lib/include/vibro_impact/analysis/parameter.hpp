// The numbers of a scene by name, as sweeps vary them.
#pragma once

#include <string>
#include <string_view>

#include "vibro_impact/scene.hpp"

namespace vibro_impact {

// One number of a scene (non-dimensional). `index` counts from 1: the masses, the links for
// `stiffness`, and for `stop` (the position of a stop) and `restitution` the stops in the order of
// Scene::stops. omega and beta have the index 0. So has the restitution of the scene, which holds
// for every stop that has none of its own.
struct Parameter {
  enum class Kind {
    omega,
    beta,
    restitution,
    stop,
    amplitude,
    mass,
    stiffness,
    displacement,
    velocity
  };
  Kind kind = Kind::omega;
  int index = 0;

  friend bool operator==(const Parameter &, const Parameter &) = default;
};

// The name: omega, beta, restitution, or restitution2, stop1, amplitude2, mass1, stiffness1,
// displacement1, velocity1 (the last two at t = 0).
std::string name(const Parameter &parameter);

// The parameter of that name. Throws std::invalid_argument for any other text.
Parameter parameter_named(std::string_view name);

// The value of the parameter. Throws std::invalid_argument for an index that the scene does not
// have.
double get(const Scene &scene, const Parameter &parameter);

// The scene with another value of the parameter. A number that the scene leaves out is first
// written out with the value it stands for: an empty vector becomes zeros, the restitution of a
// stop that of the scene. Throws std::invalid_argument for an index that the scene does not have;
// `check` judges the value.
Scene with(Scene scene, const Parameter &parameter, double value);

}  // namespace vibro_impact
