/// \file
/// A scene is a chain of masses with its forcing, its stops and its initial state. A motion state
/// is its motion at one instant.
///
/// M x'' + C x' + K x = A cos(Omega t) + B sin(Omega t) + P with C = beta K. This is Wagg (2006),
/// Eqs. 1-4, where B = P = 0. Mass i is tied to mass i - 1 by link i (mass 1 to the ground), and to
/// the ground by a spring of its own where `ground` has one; the last mass is free at its far end.
/// Everything is non-dimensional, as in the paper. Masses are counted from 1.
#pragma once

#include <optional>
#include <vector>

#include "impact_law.hpp"
#include "instant.hpp"

namespace vibro_impact {

/// The side of a mass on which a stop stands. The paper reads it from the sign of s_p (Eq. 3); it
/// is carried explicitly so that s_p = 0 and a stop across the origin work.
enum class Side : signed char { lower = -1, upper = +1 };

/// +1 for an upper stop, -1 for a lower one.
constexpr double sign(Side side) {
  return side == Side::upper ? 1.0 : -1.0;
}

/// Returns "upper" or "lower".
const char *name(Side side);

/// A rigid stop: mass `mass` (from 1) satisfies x <= position (upper) or x >= position (lower).
struct Stop {
  int mass = 1;
  Side side = Side::upper;
  double position = 0.0;
  std::optional<double> restitution = {};  ///< r in [0, 1]; if empty, that of the scene

  bool operator==(const Stop &) const = default;
};

/// The contact mode, per mass: 0 free, +1 held at its upper stop, -1 held at its lower stop.
using Held = std::vector<signed char>;

/// A scene in one aggregate. Vectors hold one entry per mass; `displacement` and `velocity` may be
/// left empty (rest at zero), as may `amplitude`, `sine`, `constant` and `ground` (nothing of it).
struct Scene {
  std::vector<double> mass = {};          ///< m_i > 0
  std::vector<double> stiffness = {};     ///< k_i > 0, link between mass i - 1 and mass i; k_1 = 0:
                                          ///< a free chain, not tied to the ground
  double beta = 0.0;                      ///< C = beta K, beta >= 0; the paper's c / k
  std::vector<double> amplitude = {};     ///< A_i
  std::vector<double> sine = {};          ///< B_i
  std::vector<double> constant = {};      ///< P_i, as a weight or a preload
  std::vector<double> ground = {};        ///< stiffness >= 0 of a spring from mass i to the ground
  double omega = 1.0;                     ///< Omega >= 0
  double restitution = 1.0;               ///< r in [0, 1] of the stops that have none of their own
  std::vector<Stop> stops = {};           ///< at most one lower and one upper stop per mass
  std::vector<double> displacement = {};  ///< x_i at t = 0
  std::vector<double> velocity = {};      ///< x_i' at t = 0

  bool operator==(const Scene &) const = default;

  int masses() const {
    return static_cast<int>(mass.size());
  }
  /// True when A or B of mass i, from 1 to N, is not zero.
  bool forced(int i) const {
    const auto k = static_cast<std::size_t>(i - 1);
    return (k < amplitude.size() && amplitude[k] != 0.0) || (k < sine.size() && sine[k] != 0.0);
  }
  /// True when some mass is forced: without forcing no forcing terms are carried.
  bool forced() const {
    for (int i = 1; i <= masses(); ++i)
      if (forced(i)) return true;
    return false;
  }
};

/// The sum of the stiffnesses of the springs of mass i, from 0: K_ii of Eq. 4.
double stiffness_at(const Scene &scene, std::size_t i);

/// The force of the springs on mass i, from 0, for the displacements x of all masses: row i of -K
/// x. Differences come first: a neighbour at the same place exerts no force at all, not a rounded
/// one.
double spring_force(const Scene &scene, std::size_t i, const std::vector<double> &x);

/// The impact law at a stop of the scene.
inline ImpactLaw law_of(const Scene &scene, const Stop &stop) {
  return {stop.restitution.value_or(scene.restitution)};
}

/// Throws std::invalid_argument with one line naming the value and the rule it breaks.
void check(const Scene &scene);

/// Time, displacement and velocity of every mass, and the contact mode. Non-dimensional.
struct MotionState {
  Instant instant = {};
  std::vector<double> displacement = {}, velocity = {};  ///< N
  Held held = {};                                        ///< N

  bool operator==(const MotionState &) const = default;
};

/// Throws std::invalid_argument with one line unless a run of this scene can start from this
/// motion: no mass is beyond a stop, and held masses are at rest at their stops. The scene itself
/// is not checked.
void check(const Scene &scene, const MotionState &start);

/// The initial state of a scene at t = 0, with no mass held yet. Throws as `check` does.
MotionState start_of(const Scene &scene);

}  // namespace vibro_impact
