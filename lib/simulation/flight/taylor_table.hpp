// The Taylor table of a step: the coefficients of all displacements about its start. Gaps and hold
// forces are read from it, and it moves the motion ((1) to (3) of lib/README.md).
#pragma once

#include <vector>

#include "polynomial.hpp"
#include "simulation/chain/motion.hpp"

namespace vibro_impact::detail {

// One step of a flight, in u = tau / unit from 0 to u_max = length / unit. The unit of time is a
// power of two, so that no scaling of a coefficient is rounded: such roundings are the same in
// every step of a length, and the energy of an elastic chain would drift.
struct Step {
  double length = 0.0;
  double unit = 1.0;
  double u_max = 1.0;  // between 1/2 and 1
  int order = 0;
};

// The order of a step of this many radians: the smallest p = 2 k + 3 with the remainder
// 2 x^(p-1) / (p+1)! <= tolerance, at most `max_order`. The remainder is its first term, relative
// to the second-order term: small gaps stay accurate.
int order_of(double radians, double tolerance);

struct TaylorTable {
  Step step;
  std::size_t stride = 0;
  std::vector<double> coefficients = {};  // order by order, one for each mass, from order 1 on
  std::vector<double> travel = {};        // of masses with stops: the sum of moduli from order 2 on
  // The forcing of three or more masses: the parts of even and of odd orders.
  std::vector<double> even = {}, odd = {};

  double *of_order(int n) {
    return coefficients.data() + static_cast<std::size_t>(n) * stride;
  }
  const double *of_order(int n) const {
    return coefficients.data() + static_cast<std::size_t>(n) * stride;
  }
};

// Makes the table of the motion over a step, whose acceleration is known.
void expand(const Chain &chain, const Motion &motion, const Step &step, TaylorTable &table);

// The coefficients from the second order on of the gap or pressing force of a contact.
void read(const Chain &chain, const Motion &start, const TaylorTable &table, const Contact &contact,
          Polynomial &p);

// The time at which a gap that closes is zero, by a step of Newton's from the time tau, which a
// double has rounded. At tau a gap of a rounding is left. To put the mass hit onto its stop would
// move it in the field of its springs: the gap has a preferred sign, and the energy of an elastic
// chain would drift.
Real exact_root(const TaylorTable &table, const Contact &closing, const Motion &motion, double tau);

// Moves motion and clock to the time tau of the step. The first-order change is exact, so that only
// what is of second order has the rounding of a double.
void move_along(const Chain &chain, const TaylorTable &table, const Real &tau, Motion &motion);

}  // namespace vibro_impact::detail
