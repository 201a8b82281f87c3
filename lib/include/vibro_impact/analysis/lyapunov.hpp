// The greatest Lyapunov exponent of a motion: the rate, per unit of (non-dimensional) time, at
// which a small perturbation of its state grows in the long run. It is negative infinity where
// every perturbation dies out in finite time, as it does where all masses stick at once. That of a
// periodic motion is ln|mu| / (p T), mu its largest Floquet multiplier over its period of p forcing
// periods T.
#pragma once

#include "vibro_impact/simulate.hpp"

namespace vibro_impact {

struct Growth {
  double exponent = 0.0;  // ln of the growth over the time followed
  bool sign_is_certain = false;
};

// The mean growth of one perturbation of the state over whole forcing periods, by the derivative of
// the stroboscopic map. The perturbation is brought back to length 1 every eight periods; there is
// only one, so that orthonormalising is scaling.
//
// In chaos the growth varies from period to period, so that the sign of a short mean may be chance.
// It counts as certain when the mean over at least 4 blocks of 40 forcing periods is larger than 4
// times its standard error (the deviation of the blocks over the root of their number). The motion
// is followed until the sign is certain, or for `longest` forcing periods. A motion whose transient
// is chaotic for much longer counts as chaos.
//
// `start` should lie away from events (`at_quiet_phase`). Throws std::invalid_argument for a start
// that does not fit the scene, for a scene without a forcing period and for longest < 1, and
// std::runtime_error when the run is given up.
Growth mean_growth(const Scene &scene, const MotionState &start, int longest,
                   const RunOptions &options = {});

}  // namespace vibro_impact
