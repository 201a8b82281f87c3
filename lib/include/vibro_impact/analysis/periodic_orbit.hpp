// Periodic orbits as fixed points of the stroboscopic map, found by Newton's method with the exact
// derivative of the map, and their Floquet multipliers.
//
// The stroboscopic map takes the state at one phase of the forcing, the section, to the state a
// whole number of forcing periods later. Masses held at the section have no freedom: the unknowns
// are the displacements and velocities of the free masses.
//
//   #include <vibro_impact/analysis/analysis.hpp>
//   #include <cstdio>
//   int main() {
//     using namespace vibro_impact;
//     const Scene scene{.mass = {1}, .stiffness = {1}, .beta = 0.1, .amplitude = {0.5},
//                       .omega = 0.8, .restitution = 0.7, .stops = {{1, Side::upper, 0.2}}};
//     const MotionState settled = state_after_periods(scene, 50);
//     const PeriodicOrbit orbit = find_periodic_orbit(scene, at_quiet_phase(scene, settled));
//     for (const auto &z : orbit.multipliers) std::printf("%.12f %.12fi\n", z.real(), z.imag());
//     std::printf("%s\n", orbit.stable() ? "stable" : "not found or not stable");
//   }
//
// All functions throw std::invalid_argument for a scene, a state or a number of periods out of
// range, and std::runtime_error when a run is given up.
#pragma once

#include <complex>
#include <string>
#include <vector>

#include "matrix.hpp"
#include "vibro_impact/simulate.hpp"

namespace vibro_impact {

// Rows of (x_1 .. x_N, x_1' .. x_N') that belong to free masses.
std::vector<std::size_t> free_coordinates(const Held &held);

// (x_1 .. x_N, x_1' .. x_N').
std::vector<double> coordinates(const MotionState &motion);

// The time `periods` forcing periods after the start. Throws std::invalid_argument for a scene
// without a forcing period and for periods < 1.
double time_after(const Scene &scene, const MotionState &start, int periods);

// The state `periods` forcing periods after `start`; the period has the number that it had at the
// start. `recorders` see the run. Of a simulation, its scene and options count, and it stands at
// the end of the run afterwards.
template <std::derived_from<Recorder>... Recorders>
MotionState stroboscopic_map(Simulation &simulation, const MotionState &start, int periods,
                             Recorders &...recorders) {
  const double until = time_after(simulation.scene(), start, periods);
  simulation.start_from(start);
  MotionState state = require_complete(simulation.advance(until, recorders...)).state;
  state.instant = start.instant;
  return state;
}
template <std::derived_from<Recorder>... Recorders>
MotionState stroboscopic_map(const Scene &scene, const MotionState &start, int periods,
                             const RunOptions &options = {}, Recorders &...recorders) {
  Simulation simulation(scene, options);
  return stroboscopic_map(simulation, start, periods, recorders...);
}

struct StroboscopicImage {
  MotionState state;
  Matrix derivative;  // 2N x 2N; rows and columns of held masses are zero
  // False when the motion met an event at which its state is not differentiable: impacts of several
  // masses at one instant, grazing, a mass coming to rest at its stop without chatter.
  bool differentiable = true;
  std::vector<Event> events = {};  // of the run
};

// The same with its derivative by the coordinates of the masses that are free at the start. `start`
// should lie away from events (`at_quiet_phase`), where the map is smooth.
StroboscopicImage stroboscopic_map_and_derivative(const Scene &scene, const MotionState &start,
                                                  int periods, const RunOptions &options = {});

// The motion from `start` brought to the phase, within the next forcing period, that is farthest
// from every event of that period. The returned instant counts its forcing period as number 0.
MotionState at_quiet_phase(const Scene &scene, const MotionState &start,
                           const RunOptions &options = {});

// The state `periods` forcing periods after the scene's own initial state. The
// returned instant counts its forcing period as number 0.
MotionState state_after_periods(const Scene &scene, int periods, const RunOptions &options = {});

struct PeriodicOrbit {
  MotionState state = {};  // at the section
  // Floquet multipliers, largest modulus first
  std::vector<std::complex<double>> multipliers = {};
  bool converged = false;              // if false, this is the best iterate
  std::string why_not = {};            // ... and this says why, in one line
  std::vector<double> residuals = {};  // the distances of P(z) from z, one per map evaluation
  std::vector<Event> events = {};      // from the state on, over the periods of the orbit

  // True of an orbit that was found and whose multipliers all lie inside the unit circle.
  bool stable() const {
    return converged && (multipliers.empty() || std::abs(multipliers.front()) < 1.0);
  }
};

// The Floquet multipliers of a map with this derivative: the eigenvalues on the free coordinates.
std::vector<std::complex<double>> floquet_multipliers(const Matrix &derivative, const Held &held);

// Newton's method for the fixed point of the `periods`-fold stroboscopic map near `guess`, whose
// phase is the section. The contact mode at the section is that of the guess. The search ends
// without convergence, and says so in `why_not`, when an iterate returns in another contact mode or
// has a mass beyond its stop, when a multiplier is so near to 1 that 1e-13 of the next step is no
// less than the distance of P(z) from z, and after `most_iterations`. An iterate z counts as a
// fixed point when the distance of P(z) from z, the length of settle.hpp, is at most 1e-13 of that
// of z from zero.
PeriodicOrbit find_periodic_orbit(const Scene &scene, const MotionState &guess, int periods = 1,
                                  int most_iterations = 20);

}  // namespace vibro_impact
