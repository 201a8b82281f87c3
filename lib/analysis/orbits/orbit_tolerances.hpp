// Every tolerance of the analysis but those that its callers choose, each with its reason.
#pragma once

#include <cstddef>

namespace vibro_impact {

// Nodes of the extrapolation of tangents. 16 and 24 nodes give the same.
constexpr std::size_t most_tangent_nodes = 10;

// Error of a fixed point relative to the state: the rounding of the map.
constexpr double newton_tolerance = 1e-13;

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

// Distances relative to the amplitude of the motion. `settle_tolerance` and `repeats` are above the
// errors of rounding and of chatter limits. Between `same_section` and `not_decided`, a motion may
// turn around its orbit. The periods bound the work.
constexpr int most_periods_run = 1'000'000'000;  // forcing periods of which no sum overflows
constexpr int most_periods_of_orbit = 1000;      // forcing periods
constexpr double settle_tolerance = 1e-10;       // what is still to come
constexpr double repeats = 1e-12;                // distance of two sections
constexpr double graze_margin = 10.0;            // shift of a stop, in distances still to come
constexpr double at_section = 1e-6;              // time of an event from a section, in periods
constexpr double same_section = 10.0;            // distance, in tolerances of what is still to come
constexpr double not_decided = 1e4;              // likewise
constexpr double approaching = 0.5;              // fall of the largest distance from block to block

// A perturbation does not overflow within `rescaled_after`. The lengths of blocks were measured in
// lyapunov_test.
constexpr int rescaled_after = 8;         // forcing periods
constexpr int block_length = 40;          // forcing periods
constexpr std::size_t least_blocks = 16;  // of a mean growth
constexpr double least_change = 0.25;     // of ln of the length of a perturbation, by its norm
constexpr double exponent_error = 1e-7;   // of ln|mu| at a state that has settled
constexpr double mark_error = 0x1p-24;    // of the mark of an attractor, relative to its terms
constexpr double slow_impact = 1e-4;      // speed, relative to the fastest impact
constexpr int periods_counted = 40;       // forcing periods, of a motion that has not settled

}  // namespace vibro_impact
