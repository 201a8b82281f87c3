// The one door through which the analysis uses the inside of the simulation: everything else that
// it needs stands in the public headers.
#pragma once

#include "chain/contact_mode.hpp"  // the modes of a contact mode, for changes of a motion
#include "chain/forces.hpp"        // the forces of Eq. 4, and a bound of every rate
#include "chain/motion.hpp"        // the closed form of the lanes
#include "chain/require.hpp"       // the refusal of bad input
