// Periodic orbits as fixed points of the stroboscopic map, found by Newton's method with the exact
// derivative of the map, and their Floquet multipliers.
//
// The stroboscopic map takes the state at one phase of the forcing to the state n forcing periods
// later. Masses held at that phase have no freedom: the unknowns are the displacements and
// velocities of the free ones.
//
// A run that is given up on the way ends these functions with std::runtime_error.
#pragma once

#include <complex>
#include <string>
#include <vector>

#include "matrix.hpp"
#include "parameter.hpp"
#include "vibro_impact/simulate.hpp"

namespace vibro_impact {

// Rows of (x_1 .. x_N, x_1' .. x_N') that belong to free masses.
std::vector<std::size_t> free_coordinates(const Held &held);

// (x_1 .. x_N, x_1' .. x_N').
std::vector<double> coordinates(const MotionState &motion);

// The time `periods` forcing periods after the start. Throws std::invalid_argument for a scene
// without a forcing period and for periods < 1.
double time_after(const Scene &scene, const MotionState &start, int periods);

struct StroboscopicImage {
  MotionState state;           // n periods later, cycle count as at the start
  Matrix derivative;           // 2N x 2N; rows and columns of held masses are zero
  Matrix by_parameters;        // 2N x parameters, at a fixed phase of the section
  bool differentiable = true;  // see ChangesAtEnd
  double chatter_error = 0.0;  // see ChangesAtEnd
  Counters counters;
};

// The state `periods` forcing periods after `start`, at the same phase and with the same cycle
// count. `recorders` see the run.
template <class... Recorders>
StroboscopicImage stroboscopic_map(const Scene &scene, const MotionState &start, int periods,
                                   const RunOptions &options = {}, Recorders &...recorders) {
  const Outcome end =
      simulate_from(scene, start, time_after(scene, start, periods), options, recorders...);
  StroboscopicImage image{require_complete(end).state, {}, {}, true, 0.0, end.counters};
  image.state.instant = start.instant;
  return image;
}

// The same with its derivative by the coordinates of the masses free at the start, and by
// parameters of the scene (TangentRecorder). `start` should lie away from events
// (`at_quiet_phase`): there the map is smooth.
StroboscopicImage stroboscopic_map_and_derivative(const Scene &scene, const MotionState &start,
                                                  int periods, const RunOptions &options = {},
                                                  const std::vector<Parameter> &by = {});

// The motion from `start` brought to the phase, within the next forcing period, that is farthest
// from every event of that period; the cycle count is set to zero.
MotionState at_quiet_phase(const Scene &scene, const MotionState &start,
                           const RunOptions &options = {});

// The motion after `periods` forcing periods from the scene's own initial state.
MotionState state_after_periods(const Scene &scene, int periods, const RunOptions &options = {});

struct NewtonOptions {
  int max_iterations = 20;
  // Largest component of P(z) - z at which z counts as a fixed point, relative to that of z (or 1).
  double tolerance = 1e-13;
};

struct PeriodicOrbit {
  int periods = 1;
  MotionState state;                              // at the section
  std::vector<std::complex<double>> multipliers;  // Floquet multipliers, largest modulus first
  bool converged = false;                         // false: the rest describes the best iterate
  std::string why_not;                            // ... and why, in one line
  std::vector<double> residuals;  // largest component of P(z) - z, one per map evaluation

  bool stable() const {
    return multipliers.empty() || std::abs(multipliers.front()) < 1.0;
  }
};

// The Floquet multipliers of a map with this derivative: the eigenvalues on the free coordinates.
std::vector<std::complex<double>> floquet_multipliers(const Matrix &derivative, const Held &held);

// Newton's method for the fixed point of the `periods`-fold stroboscopic map near `guess`, whose
// phase is the section. The contact mode at the section is that of the guess; the search ends
// without convergence, and says so in `why_not`, when an iterate returns in another one or leaves
// the admissible region, when a multiplier is 1, and after the most iterations allowed.
PeriodicOrbit find_periodic_orbit(const Scene &scene, const MotionState &guess, int periods = 1,
                                  const NewtonOptions &options = {});

// The periodic orbit near `seed`: by Newton's method, or where that fails (a border in between) by
// following the motion for `settling` periods.
MotionState orbit_near(const Scene &scene, const MotionState &seed, int periods,
                       int settling = 200);

}  // namespace vibro_impact
