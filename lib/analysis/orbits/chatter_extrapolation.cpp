#include "tangent_limit.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

namespace vibro_impact {

namespace {

double largest(const Eigen::MatrixXd &matrix) {
  return matrix.size() == 0 ? 0.0 : matrix.cwiseAbs().maxCoeff();
}

// Of the values extrapolated from the last 1, 2, ... nodes, those that differ least from the ones
// before. `extrapolated(first)` is from all nodes from `first` on; `error` that of the last alone.
Limit steadiest(const std::vector<Eigen::MatrixXd> &values, double error,
                const std::function<Eigen::MatrixXd(std::size_t)> &extrapolated) {
  Limit best{values.back(), error};
  const double size = std::max(largest(best.values), 1e-300);
  Eigen::MatrixXd previous = best.values;
  for (std::size_t first = values.size() - 1; first-- > 0;) {
    Eigen::MatrixXd limit = extrapolated(first);
    const double difference = largest(limit - previous) / size;
    if (difference < best.error) best = {limit, difference};
    previous = std::move(limit);
  }
  return best;
}

}  // namespace

Limit limit_in_time(const std::vector<Eigen::MatrixXd> &values, const std::vector<double> &x,
                    double error) {
  // The value at x = 0 of the polynomial without x and x^2 through the nodes from `first` on.
  const auto extrapolated = [&](std::size_t first) {
    Eigen::MatrixXd limit = 0.0 * values.back();
    double sum = 0.0;
    for (std::size_t i = first; i < values.size(); ++i) {
      double product = x[i] * x[i];
      for (std::size_t j = first; j < values.size(); ++j)
        if (j != i) product *= 1.0 - x[i] / x[j];
      limit += (1.0 / product) * values[i];
      sum += 1.0 / product;
    }
    return Eigen::MatrixXd(limit / sum);
  };
  return steadiest(values, error, extrapolated);
}

Limit limit_in_number(const std::vector<Eigen::MatrixXd> &values, double ratio, int first_power,
                      bool derivative, double error) {
  // Richardson's table, each factor ratio^k in it twice where the sum has been differentiated.
  const auto extrapolated = [&](std::size_t first) {
    std::vector<Eigen::MatrixXd> row(values.begin() + static_cast<std::ptrdiff_t>(first),
                                     values.end());
    for (int taken = 0; row.size() > 1; ++taken) {
      const double factor = std::pow(ratio, first_power + (derivative ? taken / 2 : taken));
      for (std::size_t i = 0; i + 1 < row.size(); ++i)
        row[i] = (row[i + 1] - factor * row[i]) / (1.0 - factor);
      row.pop_back();
    }
    return row.front();
  };
  return steadiest(values, error, extrapolated);
}

}  // namespace vibro_impact
