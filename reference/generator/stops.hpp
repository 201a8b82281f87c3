// The signals whose zeros are events: the gap of a free mass before each stop, and the hold force
// of a mass that rests on a stop. Where the hold force is zero, who is held is found by trial.
#pragma once

#include "closed_form.hpp"
#include "roots.hpp"

#include <cstddef>
#include <optional>
#include <vector>

namespace vibro_impact_reference {

/// How hard the springs, dampers and the forcing push a mass that rests on its stop into it: F_p of
/// Eqs. 12 (rebuilt) and 13 times the sign of the side, for a general chain, and its derivatives.
/// The mass's own motion does not enter.
Signal pressing_signal(const Scene &scene, const Stop &stop, const Motion &motion);

/// The numbers known exactly at the start of a piece of motion. Evaluated, they would be noise.
enum class Start {
  apart,     // the mass is away from its stop
  touching,  // it has just hit: the gap is zero
  pulled,    // it rests on the stop and is pulled away, at the start or by a jump of the force: gap
             // and speed are zero
  let_go,  // the hold force has just fallen through zero: gap, speed and acceleration are zero, the
           // gap opens
};

/// The state between two pieces of motion.
struct State {
  Real time;
  Vector x, v;
  std::vector<std::optional<std::size_t>> stuck_on;  // per mass: the stop (index) it rests on
  std::vector<Start> stop_start;                     // per stop
  // The masses that decide_at_rest has decided, which keep this state for the time `decided_for`.
  std::vector<std::size_t> decided = {};  // stops
  Real decided_for = 0;
};

std::vector<bool> stuck_masses(const State &state);

/// The signal of a stop: the gap, side (s - x), if its mass is free, the hold force if it rests on
/// this very stop, none otherwise.
std::optional<Signal> stop_signal(const Scene &scene, const State &state, std::size_t index,
                                  const Motion &motion);

/// How hard a mass that rests on a stop is pressed into it at the present instant.
Real pressing_now(const Scene &scene, const State &state, std::size_t stop);

/// Signals of all stops at the very start of a piece, with the exact zeros put in.
std::vector<std::optional<Signal>> starting_signals(const Scene &scene, const State &state,
                                                    const Motion &motion);

// --- Masses at rest on their stops where the hold force is zero ------------------------------
//
// The force on such a mass says nothing at that instant. What it becomes depends on which of its
// neighbours move, and that on the forces on them. So every assignment of held and free to the
// masses in question is tried: its closed form is followed for a short time, and it stands if every
// held mass is pressed into its stop and every free one is off it all that time. Such a motion
// obeys every rule of the model for that time, and the model has one motion only; exactly one
// assignment may stand.

/// Decides who of the masses at the stops `in_question`, all at rest there, is held, and writes it
/// into the state: stuck_on, stop_start, and how long that stands. Throws std::runtime_error if no
/// assignment stands for any of the times tried, or more than one.
void decide_at_rest(const Scene &scene, State &state, const std::vector<std::size_t> &in_question,
                    Eigensystems &known);

}  // namespace vibro_impact_reference
