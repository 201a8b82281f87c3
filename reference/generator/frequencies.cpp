#include "frequencies.hpp"

#include <stdexcept>

namespace vibro_impact_reference {

namespace {

/// Forcing periods: for the motion from rest to settle, for the motion to settle that begins near
/// the settled one, and counted over. The slowest motion to settle is that at border_mass_2_3.
constexpr int settling_from_rest = 300, settling_from_near = 10, counted = 4;

/// Both motions at the jump are reached within 60 periods from rest, to the same frequency in
/// double precision as after 800.
constexpr int settling_of_a_jump = 100;

/// A chatter followed down to a speed v tells whether it is complete where the frequency is farther
/// from the change than some 500 v (measured at border_mass_2_4).
const Resolution resolution = resolution_down_to(Real("1e-22"));

/// A bracket is bisected until it is narrower than this. A double has 17 digits.
const Real bracket_width = Real("1e-18");

/// A motion at phase zero of the forcing.
struct MotionAt {
  Real frequency;
  State state;
};

/// The run of some forcing periods from `motion`, which it brings to their end, where the phase is
/// zero again and the time is counted anew.
Run carry_on(Scene scene, MotionAt &motion, int periods) {
  Run run;
  scene[&Field::omega] = motion.frequency;
  scene.end_time = periods * 2 * acos(Real(-1)) / motion.frequency;
  advance(scene, motion.state, run, resolution);
  motion.state.time = 0;
  return run;
}

/// The motion from rest after some forcing periods.
MotionAt from_rest(Scene scene, const Real &frequency, int periods) {
  Run run;
  scene[&Field::omega] = frequency;
  MotionAt motion{frequency, initial_state(scene, resolution, run)};
  carry_on(scene, motion, periods);
  return motion;
}

/// The motion at another frequency on the line through two settled motions, up to the square of the
/// distance.
MotionAt extrapolated(const MotionAt &one, const MotionAt &other, const Real &frequency) {
  const Real part = (frequency - one.frequency) / (other.frequency - one.frequency);
  MotionAt motion{frequency, one.state};
  for (std::size_t i = 0; i < motion.state.x.size(); ++i) {
    motion.state.x[i] += part * (other.state.x[i] - one.state.x[i]);
    motion.state.v[i] += part * (other.state.v[i] - one.state.v[i]);
  }
  return motion;
}

/// Throws std::logic_error if the counts at the two frequencies agree.
void require_change(const Real &near, const Real &far, std::ptrdiff_t count_near,
                    std::ptrdiff_t count_far) {
  if (count_near == count_far)
    throw std::logic_error("the counts at " + near.str(10) + " and " + far.str(10) + " agree");
}

}  // namespace

Real changing_frequency(const Scene &scene, const Real &near, const Real &far, const Count &count) {
  const auto settled_count = [&](MotionAt &motion) {
    carry_on(scene, motion, settling_from_near);
    return count(carry_on(scene, motion, counted));
  };
  MotionAt before = from_rest(scene, 2 * near - far, settling_from_rest),
           last = from_rest(scene, near, settling_from_rest),
           beyond = from_rest(scene, far, settling_from_rest);
  const std::ptrdiff_t count_near = settled_count(last);
  require_change(near, far, count_near, settled_count(beyond));
  const auto as_near = [&](const Real &frequency) {
    MotionAt trial = extrapolated(before, last, frequency);
    if (settled_count(trial) != count_near) return false;
    before = last;
    last = trial;
    return true;
  };
  return bisect(as_near, near, far, bracket_width / far);
}

Real jumping_frequency(const Scene &scene, const Real &near, const Real &far, const Count &count) {
  const auto count_at = [&](const Real &frequency) {
    MotionAt motion = from_rest(scene, frequency, settling_of_a_jump);
    return count(carry_on(scene, motion, counted));
  };
  const std::ptrdiff_t count_near = count_at(near);
  require_change(near, far, count_near, count_at(far));
  return bisect([&](const Real &frequency) { return count_at(frequency) == count_near; }, near, far,
                bracket_width / far);
}

}  // namespace vibro_impact_reference
