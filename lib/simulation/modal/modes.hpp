// The natural modes of the free masses of a chain. In x = shape y, shape^T M shape = 1, the motion
// falls apart into oscillators: Eqs. 6 and 7. Two equal masses have lambda = 0.382 and 2.618.
#pragma once

#include <Eigen/Core>
#include <cstddef>

#include "simulation/chain/chain.hpp"
#include "twofold_matrix.hpp"

namespace vibro_impact::detail {

// The modes of a block of neighbouring free masses, tied to each other, between masses held fixed.
struct BlockModes {
  RealMatrix shape;   // of the mass i of the block in mode j
  RealVector lambda;  // squares of the natural frequencies
};

// The modes of the masses first to last, each relative to its own frequency accurate to 1e-25 and
// better, however much softer it is than others. A block that is not tied to anything moves as one
// body in an exact mode.
BlockModes modes_of_block(const Chain &chain, std::size_t first, std::size_t last);

}  // namespace vibro_impact::detail
