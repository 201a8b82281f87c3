/// \file
/// The greatest Lyapunov exponent of a motion: the rate, per unit of (non-dimensional) time, at
/// which a small perturbation of its state grows in the long run. It is negative infinity where
/// every perturbation dies out in finite time, as it does where all masses stick at once. That of a
/// periodic motion is ln|mu| / (p T), mu its largest Floquet multiplier over its period of p
/// forcing periods T.
#pragma once

#include "smooth.hpp"
#include "vibro_impact/simulate.hpp"

namespace vibro_impact {

/// An exponent with its standard error, both per unit of time.
struct Growth {
  double exponent = 0.0;    ///< ln(growth) / time
  double error = infinity;  ///< infinite: not known

  /// True if the exponent exceeds four times its error.
  bool sign_is_certain() const {
    return std::abs(exponent) > 4.0 * error;
  }
};

/// A growth is averaged over `longest` forcing periods, or until its error is at most `error`.
struct GrowthOptions {
  int longest = 1000;  ///< >= 1
  double error = 0.0;
};

/// The mean growth of one perturbation of the state over whole forcing periods, by the derivative
/// of the motion. It does not exist where the motion meets an event at which it is not
/// differentiable (periodic_orbit.hpp). The perturbation is brought back to length 1 every eight
/// periods; there is only one, so that orthonormalising is scaling.
///
/// In chaos the growth varies from period to period, so that the sign of a short mean may be
/// chance. With the mean growths of n blocks of 40 forcing periods, of standard deviation s, the
/// error of their mean is s / n^(1/2). It is infinite below n = 16, which takes 640 periods. The
/// choice of the norm changes ln of the length by about 1 in all: the error is no less than 1/4
/// over the time followed, so that rounding has no certain sign. A motion whose transient is
/// chaotic for much longer counts as chaos.
///
/// `start` should lie away from events (`at_quiet_phase`). Throws std::invalid_argument for a start
/// that does not fit the scene, for a scene without a forcing period and for options out of range,
/// and std::runtime_error when the run is given up.
Smooth<Growth> mean_growth(const Scene &scene, const MotionState &start,
                           const GrowthOptions &options = {}, const RunOptions &run = {});

}  // namespace vibro_impact
