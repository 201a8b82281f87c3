// The number type of the whole generator, and thresholds that follow its digits.
//
// The same source makes two programs: the folder on the include path, digits_50 or digits_100, says
// which type Real is.
#pragma once

#include "number.hpp"

#include <limits>
#include <string>

namespace vibro_impact_reference {

/// 10^-exponent with 50 digits; the same part of all digits with more.
inline Real small(int exponent) {
  return Real("1e-" + std::to_string(exponent * std::numeric_limits<Real>::digits10 / 50));
}

}  // namespace vibro_impact_reference
