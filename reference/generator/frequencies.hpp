// Frequencies at which a settled motion changes, by bisection on what is counted in it.
#pragma once

#include "event_driven.hpp"
#include "turning_points.hpp"

#include <cstddef>
#include <functional>

namespace vibro_impact_reference {

/// A whole number read off a run, such as the number of its sticking phases.
using Count = std::function<std::size_t(const Run &)>;

/// Two frequencies at which a count differs.
struct Bracket {
  Real near, far;
};

/// Forcing periods: for the motion from rest to settle, for the motion to settle that begins near
/// the settled one, and counted over. The slowest motion to settle is that at border_mass_2_3.
constexpr int settling_from_rest = 300, settling_from_near = 10, counted = 4;

/// Both motions at the jump are reached within 60 periods from rest, to the same frequency in
/// double precision as after 800.
constexpr int settling_of_a_jump = 100;

/// A chatter followed down to a speed v tells whether it is complete where the frequency is farther
/// from the change than some 500 v (measured at border_mass_2_4).
inline const Real chatter_floor = Real("1e-22");

/// A bracket is bisected until it is narrower than this. A double has 17 digits.
inline const Real bracket_width = Real("1e-18");

/// A settled motion at phase zero of the forcing.
struct Settled {
  Real frequency;
  State state;
};

/// The frequency between the ends of the bracket at which the count changes. The settled motion is
/// followed from `near`: every trial begins at the state extrapolated from the last two frequencies
/// known to have the same count as `near`, so that the unsettled part of a trial is small beside
/// the bracket. Throws std::logic_error if the counts at the ends agree.
Real changing_frequency(Scene scene, Bracket bracket, const Count &count);

/// The frequency between the ends of the bracket at which the count of the motion from rest jumps.
/// Every trial starts at rest and settles for `settling` periods.
Real jumping_frequency(Scene scene, Bracket bracket, int settling, const Count &count);

/// The number of sticking phases of a mass (from 0) that begin in a run.
Count sticks_of(std::size_t mass);

}  // namespace vibro_impact_reference
