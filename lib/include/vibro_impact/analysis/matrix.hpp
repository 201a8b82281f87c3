/// \file
/// A dense matrix by rows, for what the analysis hands out.
#pragma once

#include <cstddef>
#include <vector>

namespace vibro_impact {

struct Matrix {
  std::size_t rows = 0, columns = 0;
  std::vector<double> values = {};  ///< rows x columns, row by row

  double &operator()(std::size_t row, std::size_t column) {
    return values[row * columns + column];
  }
  double operator()(std::size_t row, std::size_t column) const {
    return values[row * columns + column];
  }
};

}  // namespace vibro_impact
