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

// sum_j row_j y_j[n] of the orders n = 0, ..., last.
void sum_row(const TaylorTable &table, const PerCoordinate &row, int last, Terms &sums);

// (3) of a contact along the step, by (5).
void read_along(const TaylorTable &table, const Contact &contact, Polynomial &polynomial);

// Moves motion and clock to u of the step by (6). The first-order change tau y' is added exactly,
// in twice the precision, so that a gap errs by the rounding of its second-order change only.
void move_coordinates(const TaylorTable &table, double u, const Clock &clock, Motion &motion);

}  // namespace vibro_impact::detail
