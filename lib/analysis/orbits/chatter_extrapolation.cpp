#include "chatter_extrapolation.hpp"

#include <algorithm>
#include <utility>

namespace vibro_impact {

namespace {

double largest(const Eigen::MatrixXd &matrix) {
  return matrix.size() == 0 ? 0.0 : matrix.cwiseAbs().maxCoeff();
}

// The value at x = 0 of the polynomial without x and x^2 through the values from `first` on. Its
// weights are those of Lagrange for 1/x^2 times the polynomial, divided by their sum.
Eigen::MatrixXd polynomial_at_zero(const std::vector<Eigen::MatrixXd> &values,
                                   const std::vector<double> &x, std::size_t first) {
  Eigen::MatrixXd weighted = 0.0 * values.back();
  double sum = 0.0;
  for (std::size_t i = first; i < values.size(); ++i) {
    double product = x[i] * x[i];
    for (std::size_t j = first; j < values.size(); ++j)
      if (j != i) product *= 1.0 - x[i] / x[j];
    weighted += (1.0 / product) * values[i];
    sum += 1.0 / product;
  }
  return weighted / sum;
}

}  // namespace

// More values approach the limit faster, but amplify rounding. So of the limits extrapolated from
// the last 1, 2, ... values the one is taken that differs least from the one before.
ExtrapolatedLimit extrapolate_chatter(const std::vector<Eigen::MatrixXd> &values,
                                      const std::vector<double> &x, double error) {
  ExtrapolatedLimit best{values.back(), error};
  const double size = std::max(largest(values.back()), 1e-300);
  Eigen::MatrixXd previous = values.back();
  for (std::size_t first = values.size() - 1; first-- > 0;) {
    Eigen::MatrixXd limit = polynomial_at_zero(values, x, first);
    const double difference = largest(limit - previous) / size;
    if (difference < best.error) best = {limit, difference};
    previous = std::move(limit);
  }
  return best;
}

}  // namespace vibro_impact
