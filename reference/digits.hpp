// The number type of the whole generator, and thresholds that follow its digits.
//
// The same source makes two programs: REFERENCE_DIGITS is 50 or 100.
#pragma once

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <limits>
#include <string>

namespace vibro_impact_reference {

using Real = boost::multiprecision::number<boost::multiprecision::cpp_bin_float<REFERENCE_DIGITS>>;

/// 10^-exponent with 50 digits; the same part of all digits with more.
inline Real small(int exponent) {
  return Real("1e-" + std::to_string(exponent * std::numeric_limits<Real>::digits10 / 50));
}

}  // namespace vibro_impact_reference
