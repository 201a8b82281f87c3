// The scene with every rigid stop replaced by a stiff spring and a damper beside it, integrated
// numerically: what one writes without an event-driven code.
//
// A mass m beyond its stop by d is pushed back by kappa d + 2 zeta sqrt(kappa m) d'. With
// zeta = -ln r / sqrt(pi^2 + ln^2 r) the mass alone leaves the stop after half a period of this
// oscillator at r times the speed it came with (Eq. 8 in the limit kappa -> infinity, where contact
// lasts pi sqrt(m / kappa) / sqrt(1 - zeta^2), its error being of that order). The damper may pull
// just before the mass leaves, as it must for r to be exact.
#pragma once

#include <string>
#include <vector>

#include "vibro_impact/scene.hpp"

namespace vibro_impact::stiff_spring {

enum class Stepper { dopri5, rosenbrock4 };

inline const char *name(Stepper stepper) {
  return stepper == Stepper::dopri5 ? "dopri5" : "rosenbrock4";
}

// Non-dimensional. `tolerance` bounds the estimated error of a step, absolute and relative.
struct Options {
  double kappa = 1e6;
  double tolerance = 1e-6;
  Stepper stepper = Stepper::dopri5;
  long long max_evaluations = 10'000'000;
};

struct Contact {
  double time;
  int mass;  // from 1
};

struct Result {
  std::vector<Contact> contacts;  // beginnings, in order of time
  std::vector<double> state;      // x_1 .. x_N, x_1' .. x_N' at `time`
  double time = 0.0;              // reached
  long long evaluations = 0;      // of the right-hand side
  long long jacobians = 0;        // of the right-hand side, rosenbrock4 only
  long long steps = 0;            // accepted
  std::string broke;              // why the run ended early; empty when it did not
};

// zeta of the damper that gives the coefficient of restitution r, 0 < r <= 1.
double damping_ratio(double r);

// Integrates `scene` from its start to time `until`, or as far as the integrator gets (`broke`).
// Throws std::invalid_argument for a scene that is not valid or r = 0.
Result integrate(const Scene &scene, double until, const Options &options);

}  // namespace vibro_impact::stiff_spring
