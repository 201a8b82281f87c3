#include "modal_basis.hpp"

#include <algorithm>
#include <numeric>

#include "simulation/for_analysis.hpp"

namespace vibro_impact {

ModalBasis modal_basis(const Scene &scene, const std::vector<std::size_t> &free) {
  using Eigen::Index;
  const Chain chain(scene);
  const auto size = static_cast<Index>(free.size());
  Eigen::VectorXd lambda(size);
  Eigen::MatrixXd shape = Eigen::MatrixXd::Zero(static_cast<Index>(chain.masses), size);
  Index done = 0;
  for (std::size_t k = 0; k < free.size();) {
    std::size_t end = k + 1;
    while (end < free.size() && free[end] == free[end - 1] + 1) ++end;
    const BlockModes block = modes_of_block(chain, free[k], free[end - 1]);
    const auto n = static_cast<Index>(end - k);
    for (Index j = 0; j < n; ++j, ++done) {
      lambda(done) = rounded(block.lambda(j));
      const double sign = block.shape(n - 1, j).hi < 0.0 ? -1.0 : 1.0;
      for (Index i = 0; i < n; ++i)
        shape(static_cast<Index>(free[k]) + i, done) = sign * rounded(block.shape(i, j));
    }
    k = end;
  }
  std::vector<Index> order(free.size());
  std::iota(order.begin(), order.end(), Index{0});
  std::stable_sort(order.begin(), order.end(),
                   [&lambda](Index i, Index j) { return lambda(i) < lambda(j); });
  ModalBasis basis{Eigen::VectorXd(size), Eigen::MatrixXd(shape.rows(), size), {}};
  for (Index j = 0; j < size; ++j) {
    basis.lambda(j) = lambda(order[static_cast<std::size_t>(j)]);
    basis.shape.col(j) = shape.col(order[static_cast<std::size_t>(j)]);
  }
  const Eigen::VectorXd mass = Eigen::Map<const Eigen::VectorXd>(scene.mass.data(), shape.rows());
  basis.inverse = basis.shape.transpose() * mass.asDiagonal();
  return basis;
}

}  // namespace vibro_impact
