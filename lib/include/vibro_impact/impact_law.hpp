// The impact law (Eqs. 8-11): the one place that says with which speed a mass leaves its stop.
//
// The rest of the library asks for nothing but the functions below, so that a law r(v) is a
// change of this file alone, as long as it needs no numbers per stop but r. What is taken for
// granted: a mass leaves no faster than it came, and after(v) / v is smooth down to v = 0 (that
// makes the impacts of a chatter a smooth sequence). Tests with Newton's numbers then fail.
#pragma once

namespace vibro_impact {

struct ImpactLaw {
  double restitution;  // Newton's coefficient r in [0, 1]

  // The gap speed after an impact at the closing speed `speed` >= 0.
  constexpr double after(double speed) const {
    return restitution * speed;
  }
  // Its derivative by the closing speed.
  constexpr double slope(double) const {
    return restitution;
  }
  // And by r.
  constexpr double after_by_restitution(double speed) const {
    return speed;
  }
  // after(v) / v as v -> 0: the ratio of the late impacts of a chatter.
  constexpr double at_rest() const {
    return restitution;
  }
};

}  // namespace vibro_impact
