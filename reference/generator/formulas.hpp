// Key numbers that have a formula. Their parameters are decimal numbers as the paper prints them,
// not the doubles nearest to these.
#pragma once

#include "in_digits.hpp"
#include "reference/numbers/quantities.hpp"

namespace vibro_impact_reference {

using vibro_impact::numbers::Arguments;

/// Eigenvalue of E, in the paper's order.
Real eigenvalue(const Arguments &given);

/// Component of the normalized eigenvector whose last component is positive.
Real mode_shape(const Arguments &given);

/// The line x1' = (k/c)(s2 - x1) of Eq. 23.
Real exit_slope(const Arguments &given);
Real exit_intercept(const Arguments &given);

/// A mass that bounces at its equilibrium, with the damping ratio zeta = c/(2 sqrt(k m)), hits its
/// stop at half periods of its damped motion.
Real bounce_interval(const Arguments &given);

}  // namespace vibro_impact_reference
