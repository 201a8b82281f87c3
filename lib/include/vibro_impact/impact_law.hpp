/// \file
/// The impact law (Eqs. 8-11). This file alone says with which speed a mass leaves its stop. All
/// speeds are non-dimensional.
///
/// The rest of the library calls only the functions below. So another law r(v) is a change of this
/// file alone, unless it needs more numbers per stop than r. The law must have two properties. A
/// mass leaves no faster than it came. The ratio after(v) / v is smooth down to v = 0, so that the
/// impacts of a chatter form a smooth sequence. Tests that contain numbers of Newton's law fail
/// with another law. `Tangents.*`, `RandomBranches.*` and `random_scenes_test` but its elastic
/// chains must pass.
#pragma once

namespace vibro_impact {

struct ImpactLaw {
  double restitution;  ///< Newton's coefficient r in [0, 1]

  /// The gap speed after an impact at the closing speed `speed` >= 0.
  constexpr double after(double speed) const {
    return restitution * speed;
  }
  /// The derivative of `after` by the closing speed.
  constexpr double slope(double) const {
    return restitution;
  }
  /// The limit of after(v) / v as v -> 0, which is the speed ratio of the late impacts of a
  /// chatter.
  constexpr double at_rest() const {
    return restitution;
  }
};

}  // namespace vibro_impact
