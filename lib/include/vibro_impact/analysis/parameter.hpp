// The scalars of a scene by name: what is swept, continued in, or differentiated by.
#pragma once

#include <string>
#include <string_view>

#include "vibro_impact/scene.hpp"

namespace vibro_impact {

// One scalar of a scene. `index` counts from 1: masses (of `stiffness`, links), or for `stop`, the
// position of a stop, and `restitution` the stops in the order of Scene::stops. Restitution without
// an index (0) is the scene's, that of every stop that has none of its own; omega and beta have no
// index. All are non-dimensional.
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

// Its value. Throws std::invalid_argument for an index that the scene does not have.
double get(const Scene &scene, const Parameter &parameter);

// The scene with another value of it. Where the scene leaves it out it is written out first with
// the value it stands for: an empty vector becomes zeros, a stop's restitution that of the scene.
// Throws as `get` does; what the scene as a whole must fulfil is left to `check`.
Scene with(Scene scene, const Parameter &parameter, double value);

}  // namespace vibro_impact
