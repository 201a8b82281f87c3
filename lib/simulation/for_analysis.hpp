// The one door through which the analysis uses the inside of the simulation: everything else that
// it needs stands in the public headers.
#pragma once

#include "chain/contact_mode.hpp"  // the natural modes of a contact mode
#include "chain/forces.hpp"        // the forces of Eq. 4, and a bound of every rate
#include "chain/oscillator.hpp"    // the free motion of one mode in closed form
#include "chain/require.hpp"       // the refusal of bad input
