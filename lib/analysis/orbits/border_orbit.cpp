#include "vibro_impact/analysis/border_orbit.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "fits.hpp"

namespace vibro_impact {

namespace {

// A sequence and the stop (index in Scene::stops) that it is at.
struct SequenceAtStop {
  std::size_t stop;
  FallingSequence sequence;
};

std::vector<SequenceAtStop> sequences_of(const Scene &scene, const MotionState &start, int mass,
                                         int periods) {
  check(scene);
  require_mass(scene, mass);
  EventRecorder recorder;
  recorder.from = -std::numeric_limits<double>::infinity();
  stroboscopic_map(scene, start, periods, every_impact(), recorder);
  const Clock clock(scene.omega);
  std::vector<SequenceAtStop> sequences;
  bool open = false;
  for (const Event &event : recorder.events) {
    if (event.mass != mass) continue;
    if (event.kind != EventKind::impact) {
      if (event.kind == EventKind::stick && open) sequences.back().sequence.complete = true;
      open = false;
      continue;
    }
    if (!open || event.falling == 0 || event.stop != sequences.back().stop)
      sequences.push_back({event.stop, {elapsed(start.instant, event.instant, clock), {}, false}});
    sequences.back().sequence.speeds.push_back(std::abs(event.velocity_before));
    open = true;
  }
  return sequences;
}

// The chatter whose border orbit is looked for: where it begins on the orbit, and at which stop.
struct FollowedChatter {
  const std::function<Scene(double)> &scene_at;
  int mass;
  const MotionState &seed;
  double begin;
  int periods;
  std::optional<std::size_t> stop = {};  // any, as long as it is not known
};

// The chatter on the orbit of `scene`: the sequence that begins nearest. Nothing when there is
// none.
std::optional<SequenceAtStop> chatter_of(const Scene &scene, const FollowedChatter &followed) {
  const MotionState at = orbit_near(scene, followed.seed, followed.periods, every_impact());
  std::optional<SequenceAtStop> nearest;
  const auto distance = [&followed](const SequenceAtStop &found) {
    return std::abs(found.sequence.begin - followed.begin);
  };
  for (const SequenceAtStop &found : sequences_of(scene, at, followed.mass, followed.periods)) {
    if (followed.stop && found.stop != *followed.stop) continue;
    if (!nearest || distance(found) < distance(*nearest)) nearest = found;
  }
  return nearest;
}

// By how much the ratio of the speeds of impacts n and n + 1 exceeds that on the border orbit.
struct Excess {
  double ratio = 0.0;
  double speed = 0.0;  // of impact n + 1; 0 when the sequence is over by then
};

Excess excess_at(const FollowedChatter &followed, double speed_ratio, double parameter,
                 std::size_t n) {
  const Scene scene = followed.scene_at(parameter);
  const auto chatter = chatter_of(scene, followed);
  if (!chatter) return {-speed_ratio};
  const auto &[begin, speeds, complete] = chatter->sequence;
  if (n + 1 < speeds.size()) return {speeds[n + 1] / speeds[n] - speed_ratio, speeds[n + 1]};
  const double r = law_of(scene, scene.stops[chatter->stop]).at_rest();
  return {complete ? r - speed_ratio : -speed_ratio};
}

}  // namespace

BorderChatter border_chatter(double r) {
  require(r > 0.0 && r < 1.0, "restitution = ", r, ": a border chatter needs 0 < r < 1");
  const auto balance = [r](double s) { return (3 - s) * (1 - s) * (1 - s) - r * (3 - 2 * s); };
  const double s = zero(balance, 0.0, 1.0).value, q = 1 - s;
  const double by_flight =
      r * ((0.5 - 2 * s / 3) / (q * q) + 2 * (s / 2 - s * s / 3) / (q * q * q));
  return {s, q, q * q, by_flight / (0.5 - s / 3)};
}

std::vector<FallingSequence> falling_sequences(const Scene &scene, const MotionState &start,
                                               int mass, int periods) {
  std::vector<FallingSequence> sequences;
  for (SequenceAtStop &found : sequences_of(scene, start, mass, periods))
    sequences.push_back(std::move(found.sequence));
  return sequences;
}

std::optional<BorderOrbit> find_border_orbit(const std::function<Scene(double)> &scene_at, int mass,
                                             const MotionState &seed, double chatter, int periods,
                                             double complete, double incomplete) {
  FollowedChatter followed{scene_at, mass, seed, chatter, periods};
  const Scene scene = scene_at(complete);
  const auto completing = chatter_of(scene, followed);
  if (!completing) return std::nullopt;
  followed.stop = completing->stop;
  const double ratio =
      border_chatter(law_of(scene, scene.stops[completing->stop]).at_rest()).speed_ratio;
  const double below = std::min(complete, incomplete), above = std::max(complete, incomplete);
  BorderOrbit result;
  double last = std::numeric_limits<double>::quiet_NaN(), last_step = last;
  constexpr int stride = 6;
  for (int n = 12; n <= 60; n += stride) {
    double speed = 0.0;
    const auto excess = [&](double parameter) {
      const Excess found = excess_at(followed, ratio, parameter, static_cast<std::size_t>(n));
      if (found.speed > 0.0) speed = found.speed;
      return found.ratio;
    };
    // Early in the chatter the zero may still lie outside.
    if (!(excess(complete) > 0.0 && excess(incomplete) < 0.0)) continue;
    const double root = zero(excess, below, above).value;
    excess(root);  // for the speed there
    const double step = std::abs(root - last), noise = 4e-16 * std::abs(root);
    result = {{root, std::max(step, noise)}, n, std::pow(step / last_step, 1.0 / stride), speed};
    if (step <= 8.0 * noise) break;
    last = root;
    last_step = step;
  }
  if (result.depth == 0 || !std::isfinite(result.parameter.error)) return std::nullopt;
  return result;
}

}  // namespace vibro_impact
