/// \file
/// The numbers of a scene by name, as sweeps vary them. All are non-dimensional.
///
/// A parameter has the name of its field in scene_fields.hpp. Where the field is a list, an index
/// from 1 follows: amplitude2 is the force on mass 2. Also stop1 is the position of a stop, in the
/// order of Scene::stops, and restitution2 the coefficient of a stop. `restitution` is that of
/// every stop that has none of its own.
///
/// Both functions throw std::invalid_argument for any other name, and for an index that the scene
/// does not have.
#pragma once

#include <string_view>

#include "vibro_impact/scene.hpp"

namespace vibro_impact {

double get(const Scene &scene, std::string_view name);

/// The scene with another value of the number. A number that the scene leaves out is first written
/// out with the value it stands for: an empty vector becomes zeros, the restitution of a stop that
/// of the scene. `check` judges the value.
Scene with(Scene scene, std::string_view name, double value);

}  // namespace vibro_impact
