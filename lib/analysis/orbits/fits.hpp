// What the analysis asks of its arguments beyond `check`: masses that the chain has, stops on them,
// states of its size.
#pragma once

#include "simulation/for_analysis.hpp"
#include "vibro_impact/simulate.hpp"

namespace vibro_impact {

inline void require_mass(const Scene &scene, int mass) {
  require(mass >= 1 && mass <= scene.masses(), "mass = ", mass, ": the chain has masses 1 to ",
          scene.masses());
}

// Of a stop that the scene need not contain.
inline void require_stop(const Scene &scene, const Stop &stop) {
  check(scene);
  require_mass(scene, stop.mass);
  require(stop.side == Side::lower || stop.side == Side::upper, "stop on mass ", stop.mass,
          ", side = ", static_cast<int>(stop.side), ": must be lower (-1) or upper (1)");
  require(std::isfinite(stop.position), "stop on mass ", stop.mass, " at ", stop.position,
          ": must be finite");
}

inline void require_held(const Scene &scene, const Held &held) {
  require(held.size() == scene.mass.size(), "held: ", held.size(), " values given, the chain has ",
          scene.mass.size(), " masses");
  for (const int how : held) require(how >= -1 && how <= 1, "held = ", how, ": must be -1, 0 or 1");
}

// Of what is worked out from a state itself; a run checks its start.
inline void require_fits(const Scene &scene, const MotionState &at) {
  const std::size_t n = scene.mass.size();
  require(at.displacement.size() == n, "displacement: ", at.displacement.size(),
          " values given, the chain has ", n, " masses");
  require(at.velocity.size() == n, "velocity: ", at.velocity.size(),
          " values given, the chain has ", n, " masses");
  require_held(scene, at.held);
}

// A run that resolves every chatter until what is left of it lies below rounding.
inline RunOptions every_impact() {
  RunOptions options;
  options.resolve_chatter = 0.0;
  return options;
}

}  // namespace vibro_impact
