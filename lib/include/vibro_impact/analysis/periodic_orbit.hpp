/// \file
/// Periodic orbits as fixed points of the stroboscopic map, found by Newton's method with the exact
/// derivative of the map, and their Floquet multipliers.
///
/// The stroboscopic map takes the state at one phase of the forcing, the section, to the state a
/// whole number of forcing periods later. Masses held at the section have no freedom: the unknowns
/// are the displacements and velocities of the free masses.
///
///     #include <vibro_impact/analysis/analysis.hpp>
///     #include <cstdio>
///     int main() {
///       using namespace vibro_impact;
///       const Scene scene{.mass = {1}, .stiffness = {1}, .beta = 0.1, .amplitude = {0.5},
///                         .omega = 0.8, .restitution = 0.7, .stops = {{1, Side::upper, 0.2}}};
///       const MotionState settled = state_after_periods(scene, 50);
///       const PeriodicOrbit orbit = find_periodic_orbit(scene, at_quiet_phase(scene, settled));
///       for (const auto &z : orbit.multipliers) std::printf("%.12f %.12fi\n", z.real(), z.imag());
///       std::printf("%s\n", orbit.stable() ? "stable" : "not found or not stable");
///     }
///
/// All functions throw std::invalid_argument for a scene, a state or a number of periods out of
/// range, and std::runtime_error when a run is given up.
#pragma once

#include <complex>
#include <string>
#include <vector>

#include "matrix.hpp"
#include "smooth.hpp"
#include "vibro_impact/simulate.hpp"

namespace vibro_impact {

/// Rows of (x_1 .. x_N, x_1' .. x_N') that belong to free masses.
std::vector<std::size_t> free_coordinates(const Held &held);

/// (x_1 .. x_N, x_1' .. x_N').
std::vector<double> coordinates(const MotionState &motion);

/// The time `periods` forcing periods after the start. Throws std::invalid_argument for a scene
/// without a forcing period and for periods < 1.
double time_after(const Scene &scene, const MotionState &start, int periods);

/// The state `periods` forcing periods after `start`; the period has the number that it had at the
/// start. `recorders` see the run. Of a simulation, its scene and options count, and it stands at
/// the end of the run afterwards.
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
  /// 2N x 2N; rows and columns of held masses are zero. It does not exist where the motion meets an
  /// event at which it is not differentiable: impacts of neighbours at one instant with a damper
  /// between them, a graze, a mass coming to rest at its stop without a chatter.
  Smooth<Matrix> derivative = {};
  std::vector<Event> events = {};  ///< of the run
};

/// The same with its derivative by the coordinates of the masses that are free at the start.
/// `start` should lie away from events (`at_quiet_phase`), where the map is smooth.
StroboscopicImage stroboscopic_map_and_derivative(const Scene &scene, const MotionState &start,
                                                  int periods, const RunOptions &options = {});

/// The motion from `start` brought to the middle of the longest interval without events in the next
/// forcing period, which does not lie between the impacts of a chatter and its limit. The returned
/// instant counts its forcing period as number 0.
MotionState at_quiet_phase(const Scene &scene, const MotionState &start,
                           const RunOptions &options = {});

/// The state `periods` forcing periods after the scene's own initial state. The
/// returned instant counts its forcing period as number 0.
MotionState state_after_periods(const Scene &scene, int periods, const RunOptions &options = {});

/// Floquet multipliers, largest modulus first.
using Multipliers = std::vector<std::complex<double>>;

/// Whether small perturbations of an orbit die out. They neither die out nor grow at a neutral one,
/// whose largest multiplier has the modulus 1 within 1e-9. It is unknown of an orbit that was not
/// found or has no derivative.
enum class Stability { stable, neutral, unstable, unknown };

/// Returns "stable", "neutral", "unstable" or "unknown".
const char *name(Stability stability);

struct PeriodicOrbit {
  MotionState state = {};  ///< at the section
  Smooth<Multipliers> multipliers = {};
  bool converged = false;              ///< if false, this is the best iterate
  std::string why_not = {};            ///< ... and this says why, in one line
  std::vector<double> residuals = {};  ///< the distances of P(z) from z, one per map evaluation
  std::vector<Event> events = {};      ///< from the state on, over the periods of the orbit

  Stability stability() const;
  bool stable() const {
    return stability() == Stability::stable;
  }
};

/// The Floquet multipliers of a map with this derivative: the eigenvalues on the free coordinates.
Multipliers floquet_multipliers(const Scene &scene, const Matrix &derivative, const Held &held);

/// Newton's method for the fixed point of the `periods`-fold stroboscopic map near `guess`, whose
/// phase is the section. The contact mode at the section is that of the guess. The search ends
/// without convergence, and says so in `why_not`, when an iterate returns in another contact mode,
/// has no derivative or has a mass beyond its stop, when a multiplier is so near to 1 that 1e-13 of
/// the next step is no less than the distance of P(z) from z, and after `most_iterations`. An
/// iterate z counts as a fixed point when the distance of P(z) from z is at most 1e-13 of the size
/// of the motion, or at most 1e-10 where rounding keeps it from falling further, as next to a
/// graze. The distance is that of settle.hpp. The size is the largest distance from zero of the
/// states at the section and after the events.
PeriodicOrbit find_periodic_orbit(const Scene &scene, const MotionState &guess, int periods = 1,
                                  int most_iterations = 20);

}  // namespace vibro_impact
