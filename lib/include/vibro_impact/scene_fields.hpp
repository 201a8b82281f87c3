/// \file
/// The numbers of a scene in one list, without its stops. Parameters of sweeps, scene files and the
/// options of the program follow this list. A new field of a scene is added to Scene and to this
/// list, enters the equations of motion, and has its values checked by `check`.
#pragma once

#include "scene.hpp"

namespace vibro_impact {

/// A field that is one number, or a list with one number for each mass.
template <class Value>
struct SceneField {
  const char *name;  ///< that of the member
  Value Scene::*value;
  bool optional;  ///< an empty list stands for zeros
  const char *meaning;
};

inline constexpr SceneField<std::vector<double>> list_fields[] = {
    {"mass", &Scene::mass, false, "m_i > 0"},
    {"stiffness", &Scene::stiffness, false,
     "k_i > 0, link by link; k_1 = 0: a free chain, not tied to the ground"},
    {"amplitude", &Scene::amplitude, true,
     "A_i of the forcing A cos(Omega t); 0.5 forces all masses, 0.5,0,0 the first of three"},
    {"sine", &Scene::sine, true, "B_i of a further forcing B sin(Omega t)"},
    {"constant", &Scene::constant, true, "Constant force P_i, as a weight or a preload"},
    {"ground", &Scene::ground, true, "Stiffness >= 0 of a spring from mass i to the ground"},
    {"displacement", &Scene::displacement, true, "x_i at t = 0"},
    {"velocity", &Scene::velocity, true, "x_i' at t = 0"}};

inline constexpr SceneField<double> scalar_fields[] = {
    {"beta", &Scene::beta, false,
     "Factor of the damping C = beta K, the paper's c / k: the dampers of the links\n"
     "are proportional to their stiffness"},
    {"omega", &Scene::omega, false, "Forcing frequency Omega >= 0"},
    {"restitution", &Scene::restitution, false,
     "Coefficient of restitution r in [0, 1] of the stops that have none of their own"}};

}  // namespace vibro_impact
