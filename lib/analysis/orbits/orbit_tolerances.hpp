// The tolerances of motions, orbits and sweeps but those that their callers choose, each with its
// reason.
#pragma once

#include <cstddef>

namespace vibro_impact {

// Nodes of the extrapolation of tangents. 16 and 24 nodes give the same.
constexpr std::size_t most_tangent_nodes = 10;

constexpr int most_corrections = 10;  // Newton steps from a near guess to an orbit
// Error of a fixed point relative to the size of its motion: the rounding of the map. Next to a
// graze the rounding is larger, and keeps the residual from falling.
constexpr double newton_tolerance = 1e-13;
constexpr double rounding_of_orbit = 1e-10;
constexpr double much_nearer = 0.01;  // residual after a step, relative to that before
// Distance of the largest modulus of a multiplier from 1, of which rounding decides the sign.
constexpr double neutral_modulus = 1e-9;

// Minima that are closer to each other than the nodes of a search may be missed. `most_nodes`
// bounds the work.
constexpr double fewest_nodes = 64.0;    // in a forcing period, where a minimum is looked for
constexpr double node_distance = 0.125;  // time between them, in units of 1 / rate_bound(scene)
constexpr double most_nodes = 1e8;       // in a forcing period

// An impact that begins 1e-15 deep in its stop is 1e-7 early. Slow impacts at an equilibrium do not
// graze.
constexpr double simultaneous = 1e-6;  // time between events of a pair, relative to its scale
constexpr double slow_contact = 1e-6;  // speed of a contact that may be grazing
constexpr double pulled_off = 1e-9;    // force on it

// Settling. Distances are relative to the size of the motion. An orbit is looked for where a
// section is `near_return` to one before it, and again where it is nearer by `nearer_return`; a
// slow motion at powers of two and at its end from `far_return` on. These five steer the work
// alone.
constexpr double near_return = 1e-4;
constexpr double nearer_return = 0.1;
constexpr double far_return = 0.05;
constexpr int earliest_resort = 32;         // forcing periods
constexpr int few_corrections = 6;          // Newton steps from a late motion
constexpr double settle_tolerance = 1e-10;  // distance of two sections of a motion that repeats:
                                            // above the errors of rounding and of chatter limits
constexpr double nonlinear_part = 0.1;      // of what a distance falls by in one return
constexpr double same_orbit = 1e-9;         // distance of one orbit, found twice
constexpr double graze_margin = 10.0;       // shift of a stop, in distances still to come
constexpr int most_periods_run = 1'000'000'000;  // forcing periods of which no sum overflows
constexpr int most_periods_of_orbit = 1000;      // forcing periods

// A perturbation does not overflow within `rescaled_after`. The lengths of blocks were measured in
// lyapunov_test.
constexpr int rescaled_after = 8;         // forcing periods
constexpr int block_length = 40;          // forcing periods
constexpr std::size_t least_blocks = 16;  // of a mean growth
constexpr double least_change = 0.25;     // of ln of the length of a perturbation, by its norm
constexpr double exponent_error = 1e-7;   // of ln|mu| at a state that has settled
constexpr double slow_impact = 1e-4;      // speed, relative to the fastest impact
constexpr int periods_counted = 40;       // forcing periods, of a motion that has not settled

}  // namespace vibro_impact
