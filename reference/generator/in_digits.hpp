// The scene that is simulated, in many digits: a chain of masses and its stops. The numbers of
// every scene stand in reference/scenes, in double.
#pragma once

#include "reference/scenes/paper_scenes.hpp"

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cstddef>
#include <vector>

namespace vibro_impact_reference {

/// The number type of the whole generator.
using Real = boost::multiprecision::cpp_bin_float_50;

using Vector = std::vector<Real>;
using Matrix = std::vector<Vector>;  // rows of equal length

using vibro_impact::Side;

/// A rigid stop. An upper stop keeps its mass at x <= position, a lower one at x >= position. The
/// side is explicit: the sign of the position does not tell it, and a stop may sit at zero.
struct Stop {
  std::size_t mass;  // counted from 0; tables count from 1
  Side side;
  Real position;
  Real restitution;  // r of Eq. 8 (rebuilt)
};

/// One run from given initial conditions at t = 0 to end_time. A list has an entry for each mass.
///
/// Link i joins mass i-1 to mass i, link 1 joins mass 1 to ground, the last mass is free: Eqs. 1-2.
/// The dampers are proportional to the springs, c_i = beta k_i (the paper's assumption before Eq.
/// 4). The forcing is f(t) = A cos(omega t) + B sin(omega t) + P. Everything is non-dimensional.
struct Scene {
  Vector mass, stiffness;
  Vector amplitude, sine, constant;  // A, B, P
  Vector ground;                     // springs from the masses to ground
  Vector displacement, velocity;
  Real beta, omega;
  std::vector<Stop> stops = {};
  Real end_time = 0;

  std::size_t masses() const {
    return mass.size();
  }
};

/// A scene of reference/scenes, which are in double, as the library computes: every number is taken
/// over exactly, so that 0.1 is the double nearest to 0.1, too. A list that is left out is zero.
inline Scene in_digits(const vibro_impact::Scene &given, double until) {
  const auto list = [&](const std::vector<double> &values) {
    Vector numbers(values.begin(), values.end());
    numbers.resize(given.mass.size());
    return numbers;
  };
  Scene scene{list(given.mass),         list(given.stiffness), list(given.amplitude),
              list(given.sine),         list(given.constant),  list(given.ground),
              list(given.displacement), list(given.velocity),  Real(given.beta),
              Real(given.omega)};
  scene.end_time = Real(until);
  for (const vibro_impact::Stop &stop : given.stops)
    scene.stops.push_back({static_cast<std::size_t>(stop.mass - 1), stop.side, Real(stop.position),
                           Real(stop.restitution.value_or(given.restitution))});
  return scene;
}

}  // namespace vibro_impact_reference
