// The scene that is simulated, in many digits: a chain of masses and its stops. The numbers of
// every scene stand in reference/scenes, in double.
#pragma once

#include "reference/scenes/paper_scenes.hpp"

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cstddef>
#include <string>
#include <vector>

namespace vibro_impact_reference {

/// The number type of the whole generator.
using Real = boost::multiprecision::cpp_bin_float_50;

/// Link i joins mass i-1 to mass i, link 1 joins mass 1 to ground, the last mass is free: Eqs. 1-2.
/// The dampers are proportional to the springs, c_i = damping_ratio * k_i (the paper's assumption
/// before Eq. 4). Vectors have one entry per mass; everything is non-dimensional.
struct Chain {
  std::vector<Real> masses;
  std::vector<Real> stiffnesses;
  Real damping_ratio;            // c/k, in units of time
  std::vector<Real> amplitudes;  // A in f(t) = A cos(frequency t) + B sin(frequency t) + P
  Real frequency;                // Omega
  std::vector<Real> sines;       // B
  std::vector<Real> constants;   // P
  std::vector<Real> grounds;     // stiffness of a spring from each mass to the ground
};

using vibro_impact::Side;

/// A rigid stop. An upper stop keeps its mass at x <= position, a lower one at x >= position. The
/// side is explicit: the sign of the position does not tell it, and a stop may sit at zero.
struct Stop {
  std::size_t mass;  // counted from 0; tables count from 1
  Side side;
  Real position;
};

/// One run from given initial conditions at t = 0 to end_time.
struct Scene {
  Chain chain;
  std::vector<Stop> stops;
  Real restitution;  // r of Eq. 8
  std::vector<Real> initial_positions;
  std::vector<Real> initial_velocities;
  Real end_time;
};

/// A scene of reference/scenes, which are in double, as the library computes: every number is taken
/// over exactly, so that 0.1 is the double nearest to 0.1, too.
inline Scene in_digits(const vibro_impact::Scene &given, double until) {
  const auto digits = [](const std::vector<double> &values, std::size_t size) {
    std::vector<Real> result(size);  // at rest at zero where none are given
    for (std::size_t i = 0; i < values.size(); ++i) result[i] = Real(values[i]);
    return result;
  };
  const std::size_t n = given.mass.size();
  Scene scene{.chain = {.masses = digits(given.mass, n),
                        .stiffnesses = digits(given.stiffness, n),
                        .damping_ratio = Real(given.beta),
                        .amplitudes = digits(given.amplitude, n),
                        .frequency = Real(given.omega),
                        .sines = digits(given.sine, n),
                        .constants = digits(given.constant, n),
                        .grounds = digits(given.ground, n)},
              .stops = {},
              .restitution = Real(given.restitution),
              .initial_positions = digits(given.displacement, n),
              .initial_velocities = digits(given.velocity, n),
              .end_time = Real(until)};
  for (const vibro_impact::Stop &stop : given.stops) {
    scene.stops.push_back(
        {static_cast<std::size_t>(stop.mass - 1), stop.side, Real(stop.position)});
  }
  return scene;
}

/// The named scene of the paper; throws std::invalid_argument if there is none of that name.
inline Scene scene_named(const std::string &name) {
  const auto [its_name, scene, until] = vibro_impact::paper::scene_named(name);
  return in_digits(scene, until);
}

}  // namespace vibro_impact_reference
