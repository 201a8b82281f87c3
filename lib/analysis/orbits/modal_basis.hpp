// The natural modes of a contact mode in double precision.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "vibro_impact/scene.hpp"

namespace vibro_impact {

// The modes of N masses of which some are held. `lambda` ascends. `shape` is N x modes, with zero
// rows for held masses; the last mass of a block moves to the positive side, as in the paper.
// `inverse` = shape^T M is its left inverse.
struct ModalBasis {
  Eigen::VectorXd lambda;
  Eigen::MatrixXd shape, inverse;
};

// `free`: the indices of the free masses, ascending, from 0.
ModalBasis modal_basis(const Scene &scene, const std::vector<std::size_t> &free);

}  // namespace vibro_impact
