// The limit of a complete chatter, extrapolated from its consecutive impacts.
#pragma once

#include <Eigen/Core>
#include <vector>

namespace vibro_impact {

// The extrapolated values, and their estimated error relative to the largest.
struct ExtrapolatedLimit {
  Eigen::MatrixXd values;
  double error;
};

// Extrapolates values at consecutive impacts to the limit of their chatter. Value k, a time x[k]
// before the limit, differs from the limit by x[k]^3 times a smooth function of x. `error` is the
// estimated relative error of the last value alone.
ExtrapolatedLimit extrapolate_chatter(const std::vector<Eigen::MatrixXd> &values,
                                      const std::vector<double> &x, double error);

}  // namespace vibro_impact
