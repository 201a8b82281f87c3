// Every tolerance of the simulation. The table in lib/README.md gives the measured reason of each.
#pragma once

#include <cstddef>

namespace vibro_impact::detail {

// The decomposition of a contact mode.

// Two modes p, q are rotated when sqrt(lambda_p lambda_q) <= soft_pair lambda_max.
constexpr double soft_pair = 1.0 / 16.0;
constexpr int most_jacobi_sweeps = 30;
// A mode is near resonance when |lambda - Omega^2 + i kappa Omega| is below this times lambda +
// Omega^2.
constexpr double near_resonance = 0x1p-6;
// A coordinate is slow when its rate is below this times the Omega of its forcing.
constexpr double slow_rate = 1.0 / 16.0;
// Damping ratio beyond which a mode is split into two decays.
constexpr double strong_damping = 1.5;
// Ratio of the largest to the smallest rate beyond which a contact mode is stiff.
constexpr double stiff_ratio = 16.0;
// Number of contact modes that a run keeps.
constexpr std::size_t most_contact_modes = 64;

// Rounding.

// Error of (3), relative to the sum of the moduli of its terms.
constexpr double row_rounding = 0x1p-49;
// A term is left out when it is smaller than this, relative to the sum of the other terms.
constexpr double negligible = 0x1p-60;
// Error of a deviation from the steady response, relative to the amplitude of that response.
constexpr double response_rounding = 0x1p-49;
// Ratio of a gap to the sum of the moduli of its terms in (3), below which the gap is carried.
constexpr double gap_reread_ratio = 0x1p-10;
// Difference of a carried and an evaluated gap, relative to the same sum, beyond which the gap is
// evaluated.
constexpr double carried_gap_drift = 0x1p-46;
// Margin of the contacts out of reach of a chatter limit, relative to the same sum.
constexpr double limit_margin = 0x1p-30;
// Time between simultaneous events, times the fastest rate.
constexpr double same_instant = 0x1p-46;
// The same after a short flight of time x: at most short_flight_ratio same_instant x.
constexpr double short_flight_ratio = 0x1p30;

// Steps.

// Rate times length of the longest step.
constexpr double max_step_radians = 2.0;
// Length of the step after an impact, relative to the expected flight.
constexpr double expected_flight_margin = 1.2;
// Least length of a flight in closed form, in longest steps.
constexpr double quiet_steps = 4.0;
// Window in which impacts are counted, times the fastest rate.
constexpr double budget_window = 6283.0;

// Chatter, with x the flight time after an impact.

constexpr std::size_t max_chatter_nodes = 10;    // of the extrapolation
constexpr std::size_t fewest_chatter_nodes = 4;  // of an accepted limit
// Largest ratio of x at one node to x at the node before.
constexpr double node_ratio = 0.75;
// Least ratio of an estimated error to the estimate with one node less.
constexpr double min_error_decay = 1.0 / 4.0;
// Error of the responses, relative to the difference that the oldest node makes to them.
constexpr double response_error_share = 1.0 / 32.0;
// Error of the jump of the gap speed at an impact, relative to this jump.
constexpr double impact_rounding = 0x1p-52;
// Largest difference of the extrapolated and the predicted time left, relative to the latter.
constexpr double prediction_share = 1.0 / 16.0;
// Bound of the sum of the jumps to come, relative to the geometric series J r / (1 - r).
constexpr double jump_sum_factor = 1.5;
// Bound of the next closing speed, relative to the latest rebound speed.
constexpr double next_speed_factor = 1.125;
// Least distance in impacts of the nodes of a slow chatter, which the impact budget does not count.
constexpr std::size_t slow_chatter_stride = 256;
// Largest distance of them, in impact budgets.
constexpr std::size_t longest_stride = 10;
// Number of falling impacts from which the counter of incomplete chatters takes them for a chatter.
constexpr int chatter_impacts = 5;

}  // namespace vibro_impact::detail
