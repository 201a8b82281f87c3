// The vectors and matrices of the public headers as Eigen sees them, without a copy.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "vibro_impact/analysis/matrix.hpp"

namespace vibro_impact {

using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

inline Eigen::Map<const Eigen::VectorXd> view(const std::vector<double> &values) {
  return {values.data(), static_cast<Eigen::Index>(values.size())};
}

inline Eigen::Map<const RowMajor> view(const Matrix &matrix) {
  return {matrix.values.data(), static_cast<Eigen::Index>(matrix.rows),
          static_cast<Eigen::Index>(matrix.columns)};
}

inline Matrix matrix_of(const Eigen::MatrixXd &from) {
  Matrix matrix(static_cast<std::size_t>(from.rows()), static_cast<std::size_t>(from.cols()));
  Eigen::Map<RowMajor>(matrix.values.data(), from.rows(), from.cols()) = from;
  return matrix;
}

}  // namespace vibro_impact
