// What is simulated: a chain of masses, its stops, and the scenes of the paper.
#pragma once

#include "digits.hpp"

#include <cstddef>
#include <stdexcept>
#include <string>
#include <vector>

namespace vibro_impact_reference {

/// Link i joins mass i-1 to mass i, link 1 joins mass 1 to ground, the last mass is free: Eqs. 1-2.
/// The dampers are proportional to the springs, c_i = damping_ratio * k_i (the paper's assumption
/// before Eq. 4). Vectors have one entry per mass; everything is non-dimensional.
struct Chain {
  std::vector<Real> masses;
  std::vector<Real> stiffnesses;
  Real damping_ratio;            // c/k, in units of time
  std::vector<Real> amplitudes;  // A in f(t) = A cos(frequency t)
  Real frequency;                // Omega
};

enum class Side { upper, lower };

/// A rigid stop. An upper stop keeps its mass at x <= position, a lower one at x >= position. The
/// side is explicit: the sign of the position does not tell it, and a stop may sit at zero.
struct Stop {
  std::size_t mass;  // counted from 0 here; from 1 in everything that is written out
  Side side;
  Real position;
};

/// One run from given initial conditions at t = 0 to end_time.
struct Scene {
  std::string name;
  Chain chain;
  std::vector<Stop> stops;
  Real restitution;  // r of Eq. 8
  std::vector<Real> initial_positions;
  std::vector<Real> initial_velocities;
  Real end_time;
};

/// Throws std::invalid_argument, naming the rule, if the scene is not one the generator can
/// simulate.
inline void require_valid(const Scene &scene) {
  const auto require = [](bool holds, const char *rule) {
    if (!holds) throw std::invalid_argument(rule);
  };
  const std::size_t n = scene.chain.masses.size();
  require(n > 0, "masses: at least one is needed");
  require(scene.chain.stiffnesses.size() == n, "stiffnesses: one per mass is needed");
  require(scene.chain.amplitudes.size() == n, "amplitudes: one per mass is needed");
  require(scene.initial_positions.size() == n, "initial positions: one per mass is needed");
  require(scene.initial_velocities.size() == n, "initial velocities: one per mass is needed");
  for (const Real &m : scene.chain.masses) require(m > 0, "masses: must be positive");
  for (const Real &k : scene.chain.stiffnesses) require(k > 0, "stiffnesses: must be positive");
  require(scene.chain.damping_ratio >= 0, "damping ratio: must not be negative");
  require(scene.chain.frequency >= 0, "frequency: must not be negative");
  require(scene.restitution >= 0 && scene.restitution <= 1, "restitution: must lie in [0, 1]");
  for (const Stop &stop : scene.stops) {
    require(stop.mass < n, "stop: its mass is not in the chain");
    const Real gap =
        (stop.side == Side::upper ? 1 : -1) * (stop.position - scene.initial_positions[stop.mass]);
    require(gap >= 0, "initial positions: a mass starts behind its stop");
  }
}

/// The two-mass system of section 3 of the paper, from rest. The arguments are doubles on purpose:
/// the library computes in double, so the reference must use exactly the numbers the library
/// receives (0.1 is the double nearest to 0.1). Each Real below is built from a double, which is
/// exact.
inline Scene paper_scene(const std::string &name, Stop stop_1, Stop stop_2, double restitution,
                         double frequency, double end_time) {
  const Chain chain{.masses = {Real(1), Real(1)},
                    .stiffnesses = {Real(1), Real(1)},
                    .damping_ratio = Real(0.1),
                    .amplitudes = {Real(0.5), Real(0)},
                    .frequency = Real(frequency)};
  return {.name = name,
          .chain = chain,
          .stops = {stop_1, stop_2},
          .restitution = Real(restitution),
          .initial_positions = {Real(0), Real(0)},
          .initial_velocities = {Real(0), Real(0)},
          .end_time = Real(end_time)};
}

/// The scenes of Figures 2, 4 and 5. Reconstructed, because missing in the paper's text: Omega of
/// Figures 2, 5(a) and 5(b), and both stops of Figure 5(c).
inline std::vector<Scene> paper_scenes() {
  const auto upper = [](std::size_t mass, double position) {
    return Stop{mass, Side::upper, Real(position)};
  };
  const auto lower = [](std::size_t mass, double position) {
    return Stop{mass, Side::lower, Real(position)};
  };
  return {
      paper_scene("figure2", lower(0, -0.3), upper(1, 0.1), 0.7, 0.2797, 750),
      paper_scene("figure4a", lower(0, -0.3), upper(1, 0.1), 0.7, 0.256, 750),
      paper_scene("figure4b", lower(0, -0.3), upper(1, 0.1), 0.7, 0.2561, 750),
      paper_scene("figure5a", upper(0, 0.3), upper(1, 0.3), 0.7, 0.1769, 964),
      paper_scene("figure5b", upper(0, 0.3), upper(1, 0.45), 0.001, 0.2995, 930),
      paper_scene("figure5c", upper(0, 0.3), upper(1, 0.3), 0.7, 0.02, 1000),
  };
}

/// The named scene of the paper; throws std::invalid_argument if there is none of that name.
inline Scene scene_named(const std::string &name) {
  for (const Scene &scene : paper_scenes()) {
    if (scene.name == name) return scene;
  }
  throw std::invalid_argument("scene '" + name +
                              "': must be one of figure2, figure4a, figure4b, figure5a, figure5b, "
                              "figure5c");
}

}  // namespace vibro_impact_reference
