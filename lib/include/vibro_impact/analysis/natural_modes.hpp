/// \file
/// The natural modes of a contact mode (Eqs. 6-7).
#pragma once

#include <vector>

#include "matrix.hpp"
#include "vibro_impact/scene.hpp"

namespace vibro_impact {

/// The modes of the free masses, by ascending frequency. `shape` is N x modes, normalised to unit
/// modal mass; its rows of held masses are zero. The last mass of a mode moves to the positive
/// side, as in the paper.
struct NaturalModes {
  std::vector<double> lambda;  ///< squares of the natural frequencies
  Matrix shape;
};

/// The modes with some masses held, which need not have stops. Throws std::invalid_argument for a
/// bad scene and for a contact mode of another number of masses.
NaturalModes natural_modes(const Scene &scene, const Held &held);

}  // namespace vibro_impact
