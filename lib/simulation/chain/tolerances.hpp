// Every tolerance of the simulation but the two of `RunOptions`, each with its reason.
#pragma once

#include <cstddef>

namespace vibro_impact::detail {

// The decomposition of a contact mode.

// Two modes p, q are rotated when sqrt(lambda_p lambda_q) <= soft_pair lambda_max. The eigenvalue
// solver separates all other pairs.
constexpr double soft_pair = 1.0 / 16.0;
// LAPACK's dgesvj has the same bound; ten sweeps are rare.
constexpr int most_jacobi_sweeps = 30;
// A mode is near resonance when |lambda - Omega^2 + i kappa Omega| is below this times lambda +
// Omega^2. The steady response then grows slowly out of a motion that it is far larger than.
constexpr double near_resonance = 0x1p-6;
// Largest ratio of the steady response near resonance to the motion in a long flight: it cancels
// three bits.
constexpr double largest_response = 8.0;
// A coordinate is slow when its rate is below this times the Omega of its forcing, in steps longer
// than this over Omega. Sums over the steps round a faster coordinate by less than 64 units in the
// last place.
constexpr double slow_rate = 1.0 / 16.0;
// Damping ratio beyond which a mode is split into two decays, which are then far enough apart.
constexpr double strong_damping = 1.5;
// Ratio of the rate of a coordinate to Omega below which following the steady response saves few
// steps.
constexpr double least_ratio_to_follow = 16.0;
// Number of contact modes that a run keeps. 100 masses with 200 stops stay below 62 MB, and below
// 130 MB if every mode is strongly damped.
constexpr std::size_t most_contact_modes = 64;

// Rounding.

// Error of (3), a sum of up to 100 products, relative to the sum of the moduli of its terms.
constexpr double row_rounding = 0x1p-49;
// Least first coefficient of a decided force: a positive number, far below every motion.
constexpr double least_coefficient = 1e-290;
// A term that is smaller than this, relative to the sum of the other terms, changes no digit and is
// left out.
constexpr double negligible = 0x1p-60;
// Error of a deviation from the steady response, relative to the amplitude of that response: eight
// units in the last place.
constexpr double response_rounding = 0x1p-49;
// Ratio of a gap to the sum of the moduli of its terms in (3), below which coordinates of one
// precision do not resolve it. A gap that loses ten bits still has a relative error of 1e-13.
constexpr double resolved_ratio = 0x1p-10;
// Margin of the contacts out of reach of a chatter limit, relative to the same sum. It is far above
// the rounding of a gap.
constexpr double limit_margin = 0x1p-30;
// Time between simultaneous events, times the fastest rate: the rounding of one or two periods.
constexpr double same_instant = 0x1p-46;
// Two roots u1 < u2 of a step are one instant only if u2 - u1 is also at most this times u1,
// however small u1 is, and at most the rounding of both roots.
constexpr double same_instant_of_flight = 0x1p-16;

// Orders of a decision at rest that take as long as a step, for chains of 2 to 200 masses.
constexpr int orders_as_a_step = 20;
// Largest number of iterations of the search for a root. Searches of ordinary scenes need some ten.
constexpr int most_root_iterations = 10000;

// Steps.

// Largest sum of the modal coordinates and their speeds, 1e-3 of the largest double. A motion
// beyond it is given up, because products in a step may overflow where no number of the motion
// does.
constexpr double largest_motion = 0x1p1014;
// Rate times length of the longest step. The order is then 23; other lengths cost more.
constexpr double max_step_radians = 2.0;
// Longest step of a motion of any rate, whose square has to be finite.
constexpr double longest_step = 1e150;
// Least `flight_tolerance`. The remainder of order 27 over the longest step is 4.4e-22.
constexpr double least_flight_tolerance = 1e-21;
// Length of the step after an impact, relative to the expected flight. Impacts of a chatter are at
// most 20 percent late.
constexpr double expected_flight_margin = 1.2;
// Least length of a flight in closed form, in longest steps. Shorter flights save no work.
constexpr double quiet_steps = 4.0;

// Chatter, with x the flight time after an impact.

// Nodes of the extrapolation. More nodes amplify rounding, fewer need more impacts.
constexpr std::size_t max_chatter_nodes = 10;
// Nodes of an accepted limit. With three, the estimates of a limit at r = 0.05 agreed by chance and
// were off by 14 tolerances.
constexpr std::size_t fewest_chatter_nodes = 4;
// Largest ratio of x at one node to x at the node before. Closer nodes amplify rounding.
constexpr double node_ratio = 0.75;
// Least ratio of an estimated error to the estimate with one node less. With 1/8, limits were off
// by six tolerances.
constexpr double min_error_decay = 1.0 / 4.0;
// Error of the state at a limit, relative to the difference that the oldest node makes to it.
constexpr double state_error_share = 1.0 / 8.0;
// Error of the jump of the gap speed at an impact, relative to this jump, in the sum of 1 / (1 - r)
// jumps.
constexpr double impact_rounding = 0x1p-52;
// Largest difference of the extrapolated and the predicted time left, relative to the latter. Near
// a border orbit the two differ until late.
constexpr double prediction_share = 1.0 / 16.0;
// Bound of the sum of the jumps to come, relative to the geometric series J r / (1 - r).
constexpr double jump_sum_factor = 1.5;
// Bound of the next closing speed, relative to the latest rebound speed. `limit_below_speed`
// reports every faster impact.
constexpr double next_speed_factor = 1.125;
// Number of falling impacts from which the counter of incomplete chatters takes them for a chatter.
constexpr int chatter_impacts = 5;

}  // namespace vibro_impact::detail
