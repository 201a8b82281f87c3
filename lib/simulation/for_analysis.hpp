// The internal interface of the simulation for the analysis. Everything else that the analysis
// needs stands in the public headers.
#pragma once

#include "chain/require.hpp"     // the refusal of bad input
#include "chain/scene.hpp"       // the check of a start, a bound of every rate
#include "modal/modes.hpp"       // the natural modes of a block of free masses
#include "modal/oscillator.hpp"  // the free motion of one mode in closed form

namespace vibro_impact {

using detail::BlockModes;
using detail::Chain;
using detail::check_place;
using detail::entry_of;
using detail::impulse_response;
using detail::line;
using detail::modes_of_block;
using detail::Oscillator;
using detail::rate_bound;
using detail::require;
using detail::require_mass;
using detail::rounded;

}  // namespace vibro_impact
