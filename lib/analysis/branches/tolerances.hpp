// The tolerances of branches, each with its reason. Lengths are in units of the unknowns, parts in
// steps of the branch.
#pragma once

#include <limits>

namespace vibro_impact::branches {

constexpr double rounding = std::numeric_limits<double>::epsilon();

// Newton's method. A step shorter than `near` keeps the Jacobian. A solution off the special points
// serves the next step alone and needs few digits.
constexpr int newton_iterations = 16;
constexpr double longest_correction = 2.0;
constexpr double near = 1e-4;
constexpr double solved = 1e-9, solved_by_old_jacobian = 1e-12;
// In a narrower range, relative to the parameter, the rounding of the parameter would be no small
// part of it.
constexpr double least_width = 1e-3;

// The last flight of a chatter times the rate: its cube is below rounding.
constexpr double last_flight = 3e-6;

// Steps of a branch, in parts of the longest one.
constexpr double least_step = 1e-7, small_step = 1e-3;
constexpr double least_cosine = 0.9;             // of the angle between tangents
constexpr double least_cosine_of_chord = 0.995;  // of the angle between a chord and their mean
constexpr double farthest_from_guess = 0.3;

constexpr double same_part = 1e-6;  // of a step, of two solutions at one place
// A solved end belongs to a step if it lies this near to the part that a test function predicts, or
// at most so far along the step where none does. Further guesses are not solved behind an end.
constexpr double far_from_prediction = 0.6;
constexpr double beyond_the_step = 1.5;
constexpr double far_behind_an_end = 0.2;
// Events that exchange their places move the parameter by no more, relative to the range, where the
// branch goes on. It jumps elsewhere, also by little, as at a late impact of a chatter.
constexpr double exchanged = 1e-9;
// A collapse lies this near to the parameter that its excursion predicts, relative to the distance.
constexpr double near_collapse = 0.3;

// Multipliers at this distance from the unit circle were seen to cross it twice in a step.
constexpr double near_the_circle = 0.2;

// Quantities that an orbit at an end may have below zero, relative to their units: the search for
// minima and the solution have more digits.
constexpr double below_zero = 1e-9;

}  // namespace vibro_impact::branches
