// The natural modes of the free masses of a chain.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "vibro_impact/scene.hpp"

namespace vibro_impact::detail {

// The modes of N masses of which some are held: x = shape y, y'' + lambda y = 0 without damping and
// forcing. `lambda` ascends. `shape` is N x modes, with zero rows for held masses; it is normalised
// to unit modal mass, shape^T M shape = 1, and `inverse` = shape^T M is its left inverse. Column j
// of `tension`, N x modes, has the tensions sqrt(k_i) (x_i - x_(i-1)) of the links in mode j. Their
// squares add up to lambda_j, and they are accurate relative to sqrt(lambda_j).
struct ModalBasis {
  Eigen::VectorXd lambda;
  Eigen::MatrixXd shape, inverse, tension;
};

// `free`: the indices of the free masses, ascending, from 0. Every mode is accurate relative to its
// own frequency, however soft it is beside others; where the whole chain is free and not tied to
// the ground, the rigid-body mode is exact.
ModalBasis modal_basis(const Scene &scene, const std::vector<std::size_t> &free);

}  // namespace vibro_impact::detail
