// Border orbits: where a chatter just fails to complete. The accumulation point of its impacts is
// then also the zero of the pressing force.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "locate.hpp"
#include "periodic_orbit.hpp"

namespace vibro_impact {

// On a border orbit the accumulation point of the chatter is also the zero of the pressing force.
// With v the speed after an impact, a the pressing acceleration there and b = -a' > 0, the flight s
// (in units of a / b) that follows obeys v b / a^2 = s/2 - s^2/6, and the chatter is self-similar
// where the next impact has the same v b / a^2:
//   (3 - s) (1 - s)^2 = r (3 - 2 s).
// Pressing force and speed then fall by the factors below; the fixed point repels the neighbouring
// orbits by `escape` per impact: a chatter that completes turns towards speed ratio r, one that
// does not falls below the ratio of the border orbit, and its mass is let go.
struct BorderChatter {
  double flight = 0.0;       // s
  double press_ratio = 0.0;  // 1 - s
  double speed_ratio = 0.0;  // (1 - s)^2
  double escape = 0.0;
};

// Throws std::invalid_argument unless 0 < r < 1.
BorderChatter border_chatter(double r);

// One sequence of impacts of one mass on a followed orbit, each slower than the one before.
struct FallingSequence {
  double begin = 0.0;          // time of the first impact since the start of the run
  std::vector<double> speeds;  // just before the impacts
  bool complete = false;       // it ended in sticking
};

// All of them in `periods` forcing periods from `start`; chatter is resolved impact by impact down
// to rounding.
std::vector<FallingSequence> falling_sequences(const Scene &scene, const MotionState &start,
                                               int mass, int periods);

struct BorderOrbit {
  Located parameter;
  int depth = 0;                // impacts resolved before the accumulation point
  double convergence = 0.0;     // observed factor per impact; press_ratio / escape is expected
  double speed_at_depth = 0.0;  // the slowest impact used
};

// The border orbit of `mass` between two parameter values: the chatter that sticks at `complete`
// and does not at `incomplete`. `scene_at(parameter)` gives the scene; `seed` lies on the orbit at
// `complete`, of `periods` forcing periods, away from events (`at_quiet_phase`), and `chatter` is
// the time from there to the first impact of the sequence.
//
// The zero in the parameter of (ratio of the speeds of impacts n and n + 1) - speed_ratio converges
// with n by press_ratio / escape per impact; no sticking is decided on the way. Nothing when the
// ratio does not change sign: the sequence completes, or fails to, at both values.
std::optional<BorderOrbit> find_border_orbit(const std::function<Scene(double)> &scene_at, int mass,
                                             const MotionState &seed, double chatter, int periods,
                                             double complete, double incomplete);

}  // namespace vibro_impact
