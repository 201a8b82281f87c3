// The scene: a chain of masses, its forcing, its stops and its initial state.
//
// M x'' + C x' + K x = A cos(Omega t) with C = beta K (Wagg 2006, Eqs. 1-4): mass i is tied to mass
// i - 1 by link i (mass 1 to the ground), the last mass is free at its far end. Everything is
// non-dimensional, as in the paper. Masses are counted from 1.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

namespace vibro_impact {

// The side of a mass on which a stop stands. The paper reads it from the sign of s_p (Eq. 3); it is
// carried explicitly here so that s_p = 0 and a stop across the origin work.
enum class Side : signed char { lower = -1, upper = +1 };

// +1 for an upper stop, -1 for a lower one.
constexpr double sign(Side side) {
  return side == Side::upper ? 1.0 : -1.0;
}

// A rigid stop: mass `mass` (from 1) satisfies x <= position (upper) or x >= position (lower).
struct Stop {
  int mass = 1;
  Side side = Side::upper;
  double position = 0.0;
};

// A scene in one aggregate. Vectors hold one entry per mass; `displacement` and `velocity` may be
// left empty (rest at zero), as may `amplitude` (unforced).
struct Scene {
  std::vector<double> mass = {};          // m_i > 0
  std::vector<double> stiffness = {};     // k_i > 0, link between mass i - 1 and mass i
  double beta = 0.0;                      // C = beta K, beta >= 0; the paper's c / k
  std::vector<double> amplitude = {};     // A_i
  double omega = 1.0;                     // Omega >= 0
  double restitution = 1.0;               // r in [0, 1]
  std::vector<Stop> stops = {};           // at most one lower and one upper stop per mass
  std::vector<double> displacement = {};  // x_i at t = 0
  std::vector<double> velocity = {};      // x_i' at t = 0

  int masses() const {
    return static_cast<int>(mass.size());
  }
  // True when some A_i is not zero: without forcing no forcing terms are carried.
  bool forced() const;
};

namespace detail {

// The message is made only where the rule is broken: scenes are checked before every run.
template <class... Values>
void require(bool holds, fmt::format_string<const Values &...> rule, const Values &...values) {
  if (!holds) throw std::invalid_argument(fmt::format(rule, values...));
}

inline void require_length(const std::vector<double> &values, std::size_t masses,
                           const std::string &name) {
  require(values.empty() || values.size() == masses, "{}: {} values given, the chain has {} masses",
          name, values.size(), masses);
  for (double value : values) require(std::isfinite(value), "{} = {}: must be finite", name, value);
}

inline void check_stop(const Stop &stop, const Scene &scene) {
  require(stop.mass >= 1 && stop.mass <= scene.masses(),
          "stop on mass {}: the chain has masses 1 to {}", stop.mass, scene.masses());
  require(std::isfinite(stop.position), "stop on mass {} at {}: must be finite", stop.mass,
          stop.position);
  const auto i = static_cast<std::size_t>(stop.mass - 1);
  const double start = scene.displacement.empty() ? 0.0 : scene.displacement[i];
  require(sign(stop.side) * (stop.position - start) >= 0.0,
          "mass {} starts at {}, beyond its {} stop at {}", stop.mass, start,
          stop.side == Side::upper ? "upper" : "lower", stop.position);
  for (const Stop &other : scene.stops) {
    if (&other == &stop || other.mass != stop.mass) continue;
    require(other.side != stop.side, "stop on mass {}: two stops on the same side", stop.mass);
    require(sign(stop.side) * (stop.position - other.position) > 0.0,
            "stops on mass {} at {} and {}: the lower must lie below the upper", stop.mass,
            other.position, stop.position);
  }
}

}  // namespace detail

inline bool Scene::forced() const {
  for (double a : amplitude)
    if (a != 0.0) return true;
  return false;
}

// Gershgorin's bound of the eigenvalues of the chain (squares of its natural frequencies). It holds
// for every contact mode: holding masses keeps the eigenvalues between those of the free chain.
inline double largest_eigenvalue_bound(const Scene &scene) {
  double bound = 0.0;
  for (std::size_t i = 0; i < scene.mass.size(); ++i) {
    const double right = i + 1 < scene.mass.size() ? scene.stiffness[i + 1] : 0.0;
    bound = std::max(bound, 2.0 * (scene.stiffness[i] + right) / scene.mass[i]);
  }
  return bound;
}

// Throws std::invalid_argument with one line naming the value and the rule it breaks.
inline void check(const Scene &scene) {
  using detail::require;
  const std::size_t n = scene.mass.size();
  require(n > 0, "masses = 0: a chain has at least one mass");
  require(scene.stiffness.size() == n, "stiffness: {} values given, the chain has {} masses",
          scene.stiffness.size(), n);
  for (double m : scene.mass)
    require(std::isfinite(m) && m > 0.0, "mass = {}: must be positive and finite", m);
  for (double k : scene.stiffness)
    require(std::isfinite(k) && k > 0.0, "stiffness = {}: must be positive and finite", k);
  require(std::isfinite(scene.beta) && scene.beta >= 0.0,
          "beta = {}: must be non-negative and finite", scene.beta);
  require(std::isfinite(scene.omega) && scene.omega >= 0.0,
          "omega = {}: must be non-negative and finite", scene.omega);
  require(scene.restitution >= 0.0 && scene.restitution <= 1.0,
          "restitution = {}: must lie in [0, 1]", scene.restitution);
  detail::require_length(scene.amplitude, n, "amplitude");
  detail::require_length(scene.displacement, n, "initial displacement");
  detail::require_length(scene.velocity, n, "initial velocity");
  for (const Stop &stop : scene.stops) detail::check_stop(stop, scene);
}

}  // namespace vibro_impact
