// Border orbits: where a chatter just fails to complete. The accumulation point of its impacts is
// then also the zero of the pressing force.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <stdexcept>
#include <vector>

#include "locate.hpp"
#include "periodic_orbit.hpp"

namespace vibro_impact {

// The periodic orbit of `scene` near `seed`: by Newton's method, or where that fails (a border in
// between) by following the motion for `settling` periods.
inline MotionState orbit_near(const Scene &scene, const MotionState &seed, int periods,
                              const RunOptions &options, int settling = 200) {
  NewtonOptions newton;
  newton.run = options;
  const PeriodicOrbit orbit = find_periodic_orbit(scene, seed, periods, newton);
  if (orbit.converged) return orbit.state;
  return stroboscopic_map(scene, seed, settling - settling % periods, options).state;
}

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
inline BorderChatter border_chatter(double r) {
  if (!(r > 0.0 && r < 1.0))
    throw std::invalid_argument(
        fmt::format("restitution = {}: a border chatter needs 0 < r < 1", r));
  const auto balance = [r](double s) { return (3 - s) * (1 - s) * (1 - s) - r * (3 - 2 * s); };
  const double s = zero(balance, 0.0, 1.0).value, q = 1 - s;
  const double by_flight =
      r * ((0.5 - 2 * s / 3) / (q * q) + 2 * (s / 2 - s * s / 3) / (q * q * q));
  return {s, q, q * q, by_flight / (0.5 - s / 3)};
}

// One sequence of impacts of one mass on a followed orbit, each slower than the one before.
struct FallingSequence {
  double begin = 0.0;          // time of the first impact since the start of the run
  std::vector<double> speeds;  // just before the impacts
  bool complete = false;       // it ended in sticking
};

// All of them in `periods` forcing periods from `start`; chatter is resolved impact by impact down
// to rounding.
inline std::vector<FallingSequence> falling_sequences(const Scene &scene, const MotionState &start,
                                                      int mass, int periods) {
  const Clock clock(scene.omega);
  RunOptions every_impact;
  every_impact.resolve_chatter = 0.0;
  EventRecorder recorder;
  recorder.from = -std::numeric_limits<double>::infinity();
  stroboscopic_map(scene, start, periods, every_impact, recorder);
  std::vector<FallingSequence> sequences;
  bool open = false;
  for (const Event &event : recorder.events) {
    if (event.mass != mass) continue;
    if (event.kind != EventKind::impact) {
      if (event.kind == EventKind::stick && open) sequences.back().complete = true;
      open = false;
      continue;
    }
    const double speed = std::abs(event.velocity_before);
    if (!open || !(speed < sequences.back().speeds.back()))
      sequences.push_back({elapsed(start.instant, event.instant, clock), {}, false});
    sequences.back().speeds.push_back(speed);
    open = true;
  }
  return sequences;
}

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
template <class SceneAt>
std::optional<BorderOrbit> find_border_orbit(SceneAt &&scene_at, int mass, const MotionState &seed,
                                             double chatter, int periods, double complete,
                                             double incomplete) {
  const BorderChatter border = border_chatter(scene_at(complete).restitution);
  RunOptions every_impact;
  every_impact.resolve_chatter = 0.0;
  double slowest = 0.0;
  const auto excess = [&](double parameter, std::size_t n) {
    const Scene scene = scene_at(parameter);
    const MotionState at = orbit_near(scene, seed, periods, every_impact);
    const auto sequences = falling_sequences(scene, at, mass, periods);
    const auto found =
        std::min_element(sequences.begin(), sequences.end(), [&](const auto &a, const auto &b) {
          return std::abs(a.begin - chatter) < std::abs(b.begin - chatter);
        });
    if (found == sequences.end()) return -border.speed_ratio;
    if (found->speeds.size() < n + 2)
      return found->complete ? scene.restitution - border.speed_ratio : -border.speed_ratio;
    slowest = found->speeds[n + 1];
    return found->speeds[n + 1] / found->speeds[n] - border.speed_ratio;
  };
  BorderOrbit result;
  const double below = std::min(complete, incomplete), above = std::max(complete, incomplete);
  double last = std::numeric_limits<double>::quiet_NaN(), last_step = last;
  constexpr int stride = 6;
  for (int n = 12; n <= 60; n += stride) {
    const auto f = [&](double parameter) { return excess(parameter, static_cast<std::size_t>(n)); };
    // Early in the chatter the zero may still lie outside.
    if (!(f(complete) > 0.0 && f(incomplete) < 0.0)) continue;
    const Located root = zero(f, below, above);
    f(root.value);
    const double step = std::abs(root.value - last), noise = 4e-16 * std::abs(root.value);
    result = {
        {root.value, std::max(step, noise)}, n, std::pow(step / last_step, 1.0 / stride), slowest};
    if (step <= 8.0 * noise) break;
    last = root.value;
    last_step = step;
  }
  if (result.depth == 0 || !std::isfinite(result.parameter.error)) return std::nullopt;
  return result;
}

}  // namespace vibro_impact
