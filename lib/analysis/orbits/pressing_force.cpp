#include "vibro_impact/analysis/pressing_force.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "motion_state.hpp"

namespace vibro_impact {

namespace {

std::size_t index_of(const Stop &stop) {
  return static_cast<std::size_t>(stop.mass - 1);
}

// The coordinate j (from 0) that link_force asks for.
auto of(const std::vector<double> &values) {
  return [&values](std::size_t j) { return values[j]; };
}

// The motion with the mass of this stop at rest there.
MotionState resting(const Scene &scene, const Stop &stop, MotionState at) {
  require_stop(scene, stop);
  require_fits(scene, at);
  at.displacement[index_of(stop)] = stop.position;
  at.velocity[index_of(stop)] = 0.0;
  return at;
}

}  // namespace

NaturalModes natural_modes(const Scene &scene, const Held &held) {
  check(scene);
  require_held(scene, held);
  // Neither the stops, which only shift the static positions, nor damping or forcing have a part in
  // the modes; without them every lane of the contact mode is one mode.
  Scene bare = scene;
  bare.beta = 0.0;
  bare.stops.clear();
  bare.amplitude.clear();
  const auto mode = build_contact_mode<Eigen::Dynamic>(bare, held);
  std::vector<Eigen::Index> order(static_cast<std::size_t>(mode.lanes()));
  std::iota(order.begin(), order.end(), Eigen::Index{0});
  std::sort(order.begin(), order.end(), [&mode](Eigen::Index a, Eigen::Index b) {
    return std::pair(mode.lambda(a), a) < std::pair(mode.lambda(b), b);
  });
  NaturalModes modes{{}, Matrix(held.size(), order.size())};
  for (std::size_t k = 0; k < order.size(); ++k) {
    modes.lambda.push_back(mode.lambda(order[k]));
    for (std::size_t i = 0; i < held.size(); ++i)
      modes.shape(i, k) = mode.shape(static_cast<Eigen::Index>(i), order[k]);
  }
  return modes;
}

std::vector<double> acceleration(const Scene &scene, const MotionState &at) {
  check(scene);
  require_fits(scene, at);
  const double forcing = std::cos(scene.omega * at.instant.phase);
  std::vector<double> a(scene.mass.size(), 0.0);
  for (std::size_t i = 0; i < a.size(); ++i)
    if (at.held[i] == 0)
      a[i] = force_on(scene, i, of(at.displacement), of(at.velocity), forcing) / scene.mass[i];
  return a;
}

double pressing_force(const Scene &scene, const Stop &stop, const MotionState &at) {
  const auto &[instant, x, v, held] = resting(scene, stop, at);
  return sign(stop.side) *
         force_on(scene, index_of(stop), of(x), of(v), std::cos(scene.omega * instant.phase));
}

double pressing_force_rate(const Scene &scene, const Stop &stop, const MotionState &at) {
  // The neighbours are pulled by the mass as it stands at its stop.
  const MotionState with_it = resting(scene, stop, at);
  const std::size_t p = index_of(stop);
  const std::vector<double> a = acceleration(scene, with_it);
  const double links = link_force(scene, p, 0.0, of(at.velocity)),
               dampers = scene.beta * link_force(scene, p, 0.0, of(a)),
               forcing =
                   -amplitude_on(scene, p) * scene.omega * std::sin(scene.omega * at.instant.phase);
  return sign(stop.side) * (links + dampers + forcing);
}

}  // namespace vibro_impact
