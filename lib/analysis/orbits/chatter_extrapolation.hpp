// What consecutive impacts of a chatter tell of its end, extrapolated.
#pragma once

#include <Eigen/Core>
#include <vector>

namespace vibro_impact {

// The extrapolated values, and their estimated error relative to the largest.
struct Limit {
  Eigen::MatrixXd values;
  double error;
};

// Of values at consecutive impacts, a time x before the limit each, that differ from those at the
// limit by x^3 times a smooth function of x. `error` is that of the last of them alone.
Limit limit_in_time(const std::vector<Eigen::MatrixXd> &values, const std::vector<double> &x,
                    double error);

// Of values that differ from those at the limit by a sum of a_k ratio^(k n), k >= first_power, n
// the number of the value; with `derivative`, of (a_k + n b_k) ratio^(k n): what becomes of such a
// sum when it is differentiated by the ratio.
Limit limit_in_number(const std::vector<Eigen::MatrixXd> &values, double ratio, int first_power,
                      bool derivative, double error);

}  // namespace vibro_impact
