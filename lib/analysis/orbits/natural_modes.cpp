#include "vibro_impact/analysis/natural_modes.hpp"

#include <algorithm>
#include <numeric>

#include "motion_state.hpp"

namespace vibro_impact {

NaturalModes natural_modes(const Scene &scene, const Held &held) {
  check(scene);
  require_held(scene, held);
  // Stops only shift the static positions. Without damping and forcing every lane of the contact
  // mode is one mode.
  Scene bare = scene;
  bare.beta = 0.0;
  bare.stops.clear();
  bare.amplitude.clear();
  const auto mode = build_contact_mode<Eigen::Dynamic>(bare, held);
  std::vector<Eigen::Index> order(static_cast<std::size_t>(mode.lanes()));
  std::iota(order.begin(), order.end(), Eigen::Index{0});
  std::stable_sort(order.begin(), order.end(), [&mode](Eigen::Index a, Eigen::Index b) {
    return mode.lambda(a) < mode.lambda(b);
  });
  NaturalModes modes{{}, matrix_of(mode.shape(Eigen::all, order))};
  for (const Eigen::Index lane : order) modes.lambda.push_back(mode.lambda(lane));
  return modes;
}

}  // namespace vibro_impact
