// The Taylor table of a step: the coefficients of all modal coordinates about its start. Gaps and
// hold forces are read from it, and it moves the motion ((4) to (6) of lib/README.md).
#pragma once

#include <array>
#include <vector>

#include "polynomial.hpp"
#include "simulation/chain/motion.hpp"

namespace vibro_impact::detail {

// One step of a flight, in u = tau / length from 0 to 1. The polynomials of gaps and hold forces
// have the order of the step.
struct Step {
  double length = 0.0;
  double rate = 0.0;  // largest rate in motion
  int order = 0;
};

// The order of a step of x = rate * length radians: the smallest p = 4 k + 3 with the remainder
// 2 x^(p-1) / (p+1)! <= tolerance. The remainder is its first term, relative to the second-order
// term: small gaps stay accurate.
class OrderTable {
 public:
  explicit OrderTable(double tolerance);
  int order_of(double radians) const;

 private:
  std::array<double, max_order / 4> longest_;  // in radians, of order 4 k + 3
};

struct TaylorTable {
  double length = 0.0;  // of the step
  int order = 0;        // of the polynomials; a hold force needs one order more of the coordinates
  Eigen::Index coordinates = 0;
  std::vector<double> coefficients = {};  // order by order, one for each coordinate
  Terms cosine{}, sine{};                 // of the forcing; zero where there is none

  double *of_order(int n) {
    return coefficients.data() + n * coordinates;
  }
  const double *of_order(int n) const {
    return coefficients.data() + n * coordinates;
  }
};

// The table of the motion over a step, by the recurrence (4).
void expand(const Motion &motion, const Step &step, double omega, bool forced, TaylorTable &table);

// The table of the response to a unit jump of the gap speed at a contact.
void expand_impulse(const ContactMode &mode, const Contact &contact, const Step &step,
                    TaylorTable &table);

// sum_j row_j y_j[n] of the orders n = 0, ..., last.
void sum_row(const TaylorTable &table, const PerCoordinate &row, int last, Terms &sums);

// (3) of a contact along the step, by (5).
void read_along(const TaylorTable &table, const Contact &contact, Polynomial &polynomial);

// Sets the coefficients of (3) below the rounding of the modal coordinates to zero. The true motion
// of a mass is smaller than this rounding while motion has yet to pass along the chain to the mass.
// `moduli` is scratch.
void drop_rounding(const Motion &motion, double omega, const TaylorTable &table,
                   const Contact &contact, TaylorTable &moduli, Polynomial &polynomial);

// Moves the coordinates to u of the step by (6): changes are added up, because the coordinates
// themselves would be rounded alike in each of many steps of one length. The clock is left to the
// caller.
void move_coordinates(const TaylorTable &table, double u, Motion &motion);

}  // namespace vibro_impact::detail
