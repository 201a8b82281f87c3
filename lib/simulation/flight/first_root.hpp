// The first root of a polynomial on (0, 1], with a guarantee and without sampling (lib/README.md).
#pragma once

#include <optional>

#include "polynomial.hpp"
#include "vibro_impact/counters.hpp"

namespace vibro_impact {

struct Root {
  double at = 0.0;     // u
  double slope = 0.0;  // there
};

// First root in (0, limit] of the polynomial with its leading coefficients that are exactly zero
// divided out; nothing when there is none. The first that is not zero should be positive; when it
// is negative the root returned is 0, with the slope there.
std::optional<Root> first_root(const Polynomial &p, double limit, Counters &counters);

}  // namespace vibro_impact
