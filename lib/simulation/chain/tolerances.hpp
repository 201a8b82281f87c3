// The tolerances of the simulation but the two of `RunOptions`, each with its reason. The lengths
// of series stand with the series.
#pragma once

#include <cstddef>
#include <limits>

namespace vibro_impact::detail {

// Decisions.

// A number is zero if it lies below this times the sum of the moduli of its terms over the latest
// flight. Numbers of twice the precision err by 2^-102 = 2e-31 of that in an operation: this leaves
// room for 10^4 operations on the way. A gap or force that is truly smaller was never seen.
constexpr double zero_threshold = 1e-26;
// Rounding of what is found in double precision: of a displacement, relative to the terms of the
// gap, and of the time of a root or of the first instant at which a contact is seen below zero,
// relative to its flight. Sums of a step err by some 1e-15 of their terms, but at a slow impact the
// time errs by more.
constexpr double step_rounding = 1e-13;
// A displacement beyond a stop by no more than its rounding is reported as the position of the
// stop. So is one that is zero beside the motion of the chain and the way of its forces: that of a
// mass that a wave has not reached, since the orders of a step end before it, and that of a mass
// just released at the root of its force, since the root is rounded. Below the normal numbers of
// double precision, any displacement is.
constexpr bool is_rounding_at_stop(double beyond, double terms, double terms_of_chain) {
  return beyond <= step_rounding * terms + zero_threshold * terms_of_chain +
                       std::numeric_limits<double>::min();
}
// Orders of a decision at rest that take as long as a step, for chains of 2 to 200 masses.
constexpr int orders_as_a_step = 20;
// Most radians of a mode that swings on. Its phase rounds to 1e-4 there.
constexpr double most_radians = 1e12;
// e^-37 of an amplitude is below the rounding of a double.
constexpr double dead_after = 37.0;
// The last of equal steps over a range may lie beyond its end by the rounding of both, relative to
// it.
constexpr double range_rounding = 4e-16;

// Steps.

// Rate times length of the longest step, whose order is 25 with the default tolerance. Longer steps
// cost fewer orders a time, but their terms are larger, and so is the rounding of their sums.
constexpr double max_step_radians = 2.0;
// Longest step of a motion of any rate, whose square has to be finite.
constexpr double longest_step = 0x1p500;
// Least `flight_tolerance`. The remainder of order 27 over the longest step is 4.4e-22.
constexpr double least_flight_tolerance = 1e-21;
// Length of the step after an impact, relative to the expected flight. Impacts of a chatter are at
// most 20 percent late.
constexpr double expected_flight_margin = 1.2;
// Length of the longest step, relative to a mean of the times between the latest events. A longer
// step is cut short at the next event, and its higher orders are in vain: that of 200 masses with
// stops is 15 then, and 25 without.
constexpr double longest_in_flights = 8.0;
// Least length of a step, relative to the longest: a flight may be shorter than any bound (r =
// 1e-300), but the product of a slope and a length must not underflow.
constexpr double shortest_step = 0x1p-60;
// Margin of a bound of the change of a gap over a step, for its rounding.
constexpr double travel_margin = 1.001;
// Orders up to which a coefficient is divided by the mass and the order. A product with a rounded
// reciprocal errs alike in every step, and the energy at r = 1 then drifts.
constexpr int last_divided_order = 8;
// Largest displacement or velocity, 1e-3 of the largest double. A motion beyond it is given up,
// because products in a step may overflow where no number of the motion does.
constexpr double largest_motion = 0x1p1014;
// Steps after which e^(i Omega t) is computed anew: each adds a rounding of 2^-53 of a second-order
// change.
constexpr int most_turns = 50;

// Roots.

// Largest number of iterations of the search for a root. Searches of ordinary scenes need some ten.
constexpr int most_root_iterations = 10000;
// Steps that polish a root, and the largest, relative to the way from where they began, after which
// none follows: a step leaves out its fifth power. One is ordinary.
constexpr int most_newton_steps = 8;
constexpr double newton_accuracy = 1e-3;
// Rounding of a polynomial, relative to the sum of the moduli of its terms.
constexpr double polynomial_rounding = 0x1p-53;
// Depth to which a hold force may fall below zero without a release, relative to the sum of the
// moduli of the forces on its mass: eight roundings. The mass would leave its stop by some 1e-30.
constexpr double touch_rounding = 0x1p-50;
// Two roots u1 < u2 of a step are one instant if u2 - u1 is at most this times u1: eight roundings.
constexpr double same_instant = 0x1p-50;

// Long flights.

// Steps without an event after which a flight goes on in closed form. With 8 the work of ten masses
// is 40 percent more: a search costs as much as 16 steps. The modes of N masses cost as much as
// some N^2 / 8 steps.
constexpr long long fewest_short_steps = 16;
constexpr long long short_steps_divisor = 8;
// Order of the bounds of a contact. Where a motion has hardly begun, at the end of a long chain,
// many derivatives are as small as the value, and steps by a parabola would be 1e-8 long.
constexpr int bound_order = 12;
// Sweeps of one-sided rotations.
constexpr int most_sweeps = 40;

// Chatter, with x the flight time after an impact.

// Nodes of the extrapolation. More nodes amplify rounding, fewer need more impacts.
constexpr std::size_t most_chatter_nodes = 12;
// Nodes of an accepted limit: two estimates may agree by chance.
constexpr std::size_t fewest_chatter_nodes = 4;
// Largest ratio of x at one node to x at the node before. Closer nodes amplify rounding.
constexpr double node_ratio = 0.75;
// Largest change of this ratio from one node to the next, relative to it. Where it changes more,
// the extrapolation begins anew. Without this, limits at r = 0.3 were off by eight tolerances.
constexpr double ratio_change = 1.0 / 16.0;
// Error of a limit, relative to the difference that its oldest node makes. The error of one limit
// of Figure 4(a) is 19 times this difference.
constexpr double error_share = 24.0;
// Bound of the sum of the jumps to come, relative to that of the geometric series, J / (1 - r).
constexpr double jump_sum_factor = 1.5;
// Longest time to a limit, in radians of the fastest rate: accelerations then hardly change.
constexpr double longest_rest_of_chatter = 0.5;
// A chatter whose time left is this share of the time since its first impact is over: it is below
// the rounding of a double.
constexpr double chatter_end = 1e-17;
// Bound of the next closing speed, relative to the latest rebound speed. `limit_below_speed`
// reports every faster impact.
constexpr double next_speed_factor = 1.125;
// Number of falling impacts from which the counter of incomplete chatters takes them for a chatter.
constexpr int chatter_impacts = 5;

// The memory of a run.

// Contact modes that are kept.
constexpr std::size_t most_contact_modes = 64;

}  // namespace vibro_impact::detail
