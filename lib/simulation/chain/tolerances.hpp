// Every tolerance of the engine. Why each is what it is: the table in lib/README.md.
#pragma once

#include <cstddef>

namespace vibro_impact {

constexpr double soft_pair = 1.0 / 16.0;  // product of the rates of two modes, in the largest lambda
constexpr int most_jacobi_sweeps = 30;    // LAPACK's dgesvj ends at as many; ten are rare

constexpr double near_resonance = 0x1p-6;  // |lambda - Omega^2| in lambda + Omega^2
constexpr double strong_damping = 1.5;     // damping ratio of a mode that is split in two decays
constexpr double stiff_ratio = 16.0;       // of rates from which on lanes may die out

constexpr double rounding = 0x1p-49;      // of a reading, in the sum of the moduli of its terms
constexpr double lost = 0x1p-60;          // what is lost in the rounding of the rest
constexpr double wide = 0x1p-10;          // gap in the size of its reading: read off the lanes
constexpr double drifted = 0x1p-46;       // of a carried gap, in the size of its reading
constexpr double narrow = 0x1p-30;        // margin of what stays clear beside a limit
constexpr double same_instant = 0x1p-46;  // time, in units of the fastest rate

constexpr double max_reach = 2.0;        // rate * span of the longest expansion
constexpr double beyond_expected = 1.2;  // span of a short one, in the flight expected

constexpr std::size_t max_chatter_nodes = 10;    // of the extrapolation
constexpr std::size_t fewest_chatter_nodes = 4;  // at which a limit may be taken
constexpr double node_ratio = 0.75;              // of x from node to node, at most
constexpr double luck = 1.0 / 4.0;               // of the estimate before, that one may be believed
constexpr double responses_share = 1.0 / 32.0;   // of what the oldest node changes, as their error
constexpr double near_limit = 1.0 / 16.0;  // of the time left, that it may differ from predicted
constexpr double jumps_to_come = 1.5;      // in those of a geometric sequence
constexpr double next_speed = 1.125;       // of the next impact, in that after the latest

}  // namespace vibro_impact
