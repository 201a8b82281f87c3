#include "vibro_impact/analysis/natural_modes.hpp"

#include "modal_basis.hpp"
#include "motion_state.hpp"

namespace vibro_impact {

NaturalModes natural_modes(const Scene &scene, const Held &held) {
  check(scene);
  require_held(scene, held);
  const ModalBasis basis = modal_basis(scene, free_masses(held));
  return {{basis.lambda.begin(), basis.lambda.end()}, matrix_of(basis.shape)};
}

}  // namespace vibro_impact
