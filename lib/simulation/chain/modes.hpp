// The natural modes of the free masses of a chain, and its static positions.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "vibro_impact/scene.hpp"

namespace vibro_impact::detail {

// The modes of N masses of which some are held: x = shape y, y'' + lambda y = 0 without damping and
// forcing. `lambda` ascends. `shape` is N x modes, with zero rows for held masses; it is normalised
// to unit modal mass, shape^T M shape = 1, and `inverse` = shape^T M is its left inverse. Column j
// of `tension` has the tensions sqrt(k_i) (x_i - x_(i-1)) of the N links in mode j, and below them
// those of the N springs to the ground, sqrt(ground_i) x_i, where there are any. Their squares add
// up to lambda_j, and they are accurate relative to sqrt(lambda_j).
struct ModalBasis {
  Eigen::VectorXd lambda;
  Eigen::MatrixXd shape, inverse, tension;
};

// The number of springs of a scene, and rows of `tension`: 2 N with springs to the ground, else N.
Eigen::Index springs(const Scene &scene);

// True where neither the first link nor any other spring ties the chain to the ground.
bool is_untied(const Scene &scene);

// `free`: the indices of the free masses, ascending, from 0. Every mode is accurate relative to its
// own frequency, however much softer it is than others. Where the whole chain is free and not tied
// to the ground, the rigid-body mode is exact.
ModalBasis modal_basis(const Scene &scene, const std::vector<std::size_t> &free);

// Static positions x of all masses, with the held ones at their stops, of the links alone, and the
// tensions of all springs there, as in `ModalBasis`. They are linear in the compliance between two
// anchors, and written so that two equal anchors give exactly their common position: a zero hold
// force (Figure 5(c): s1 = s2) is then exactly zero.
void set_static_positions(const Scene &scene, const Held &held, Eigen::VectorXd &x,
                          Eigen::VectorXd &tension);

}  // namespace vibro_impact::detail
