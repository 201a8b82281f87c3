// Every tolerance of the simulation. The table in lib/README.md gives the measured reason of each.
#pragma once

#include <cstddef>

namespace vibro_impact::detail {

// The decomposition of a contact mode.
constexpr double soft_pair =
    1.0 / 16.0;                         // product of the rates of two modes, in the largest lambda
constexpr double light_mass = 1e-4;     // in the heaviest
constexpr int most_jacobi_sweeps = 30;  // LAPACK's dgesvj ends at as many; ten are rare
constexpr double near_resonance = 0x1p-6;  // |lambda - Omega^2| in lambda + Omega^2
constexpr double slow_rate = 1.0 / 16.0;   // of a coordinate, in the Omega that forces it
constexpr double strong_damping = 1.5;     // damping ratio from which a mode is split in two decays
constexpr double stiff_ratio = 16.0;       // of the largest rate to the smallest of a stiff mode
constexpr std::size_t most_contact_modes = 64;  // kept by a run

// Rounding.
constexpr double row_rounding = 0x1p-49;       // of a row of weights, in the moduli of its terms
constexpr double negligible = 0x1p-60;         // a share that is lost in the rounding of the rest
constexpr double response_rounding = 0x1p-49;  // of a deviation, in the amplitude of the response
constexpr double gap_reread_ratio = 0x1p-10;   // of a gap to the moduli of its terms
constexpr double carried_gap_drift = 0x1p-46;  // of a carried gap, in the moduli of its terms
constexpr double limit_margin = 0x1p-30;  // by which other contacts are out of reach of a limit
constexpr double same_instant = 0x1p-46;  // time, in units of the fastest rate
constexpr double short_flight_ratio =
    0x1p30;  // of the time scale to a flight, from which the flight counts

// Steps.
constexpr double max_step_radians = 2.0;        // rate times the longest step
constexpr double expected_flight_margin = 1.2;  // step after an impact, in the flight expected
constexpr double quiet_steps = 4.0;             // longest steps that a quiet motion takes at once

constexpr double budget_window =
    6283.0;  // radians of the fastest rate in which impacts are counted

// Chatter.
constexpr std::size_t max_chatter_nodes = 10;        // of the extrapolation
constexpr std::size_t fewest_chatter_nodes = 4;      // at which a limit may be taken
constexpr double node_ratio = 0.75;                  // of x from node to node, at most
constexpr double min_error_decay = 1.0 / 4.0;        // of the estimate with one node less
constexpr double response_error_share = 1.0 / 32.0;  // of what the oldest node changes
constexpr double impact_rounding = 0x1p-52;          // of the jump of an impact
constexpr double prediction_share = 1.0 / 16.0;   // of the time left, that predictions may differ
constexpr double jump_sum_factor = 1.5;           // of the jumps to come, in a geometric sequence
constexpr double next_speed_factor = 1.125;       // of the next impact, in the latest rebound
constexpr std::size_t slow_chatter_stride = 256;  // of a chatter that the budget cannot pay for
constexpr double slowest_chatter = 0x1p-24;       // 1 - r, up to which all impacts are waited for
constexpr int chatter_impacts = 5;                // falling impacts that are counted as a chatter

}  // namespace vibro_impact::detail
