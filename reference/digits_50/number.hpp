// The number type of reference-generate.
#pragma once

#include <boost/multiprecision/cpp_bin_float.hpp>

namespace vibro_impact_reference {

using Real = boost::multiprecision::cpp_bin_float_50;

}  // namespace vibro_impact_reference
