#include "vibro_impact/analysis/natural_modes.hpp"

#include "motion_state.hpp"

namespace vibro_impact {

NaturalModes natural_modes(const Scene &scene, const Held &held) {
  check(scene);
  require_held(scene, held);
  std::vector<std::size_t> free;
  for (std::size_t i = 0; i < held.size(); ++i)
    if (held[i] == 0) free.push_back(i);
  const detail::ModalBasis basis = detail::modal_basis(scene, free);
  return {{basis.lambda.begin(), basis.lambda.end()}, matrix_of(basis.shape)};
}

}  // namespace vibro_impact
