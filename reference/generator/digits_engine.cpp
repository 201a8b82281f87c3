#include "digits_engine.hpp"

#include <algorithm>
#include <functional>
#include <optional>
#include <stdexcept>

namespace vibro_impact_reference {

namespace {

std::size_t index(int mass) {
  return static_cast<std::size_t>(mass - 1);
}

// --- Turning points ---------------------------------------------------------------------------

bool moves(std::size_t mass, const Flow &flow) {
  return std::find(flow.free.begin(), flow.free.end(), mass) != flow.free.end();
}

/// Calls found(tau) where `rate_at`, sampled along the flow, changes its sign in [begin, end].
template <class RateAt, class Found>
void each_turn(const Flow &flow, const Real &begin, const Real &end, const RateAt &rate_at,
               const Found &found) {
  const Real step = sampling_step(flow, Real(0));
  bool rising = rate_at(begin) > 0;
  for (Real a = begin; a < end; a += step) {
    const Real b = std::min<Real>(a + step, end);
    if (rising == (rate_at(b) > 0)) continue;
    found(bisect([&](const Real &tau) { return (rate_at(tau) > 0) == rising; }, a, b,
                 Real("1e-36") * b));
    rising = !rising;
  }
}

// --- Frequencies --------------------------------------------------------------------------------

/// Forcing periods: for the motion to settle that begins near the settled one, and counted over.
constexpr int settling_from_near = 10, counted = 4;

/// Both motions at the jump are reached within 60 periods from rest, to the same frequency in
/// double precision as after 800.
constexpr int settling_of_a_jump = 100;

/// A chatter followed down to a speed v tells whether it is complete where the frequency is farther
/// from the change than some 500 v (measured at border_mass_2_4).
const Resolution resolution_of_frequencies = resolution_down_to(Real("1e-22"));

/// A bracket is bisected until it is narrower than this. A double has 17 digits.
const Real bracket_width = Real("1e-18");

/// A whole number read off a run, such as the number of its sticking phases.
using Count = std::function<std::ptrdiff_t(const Run &)>;

/// A motion at phase zero of the forcing.
struct MotionAt {
  Real frequency;
  State state;
};

/// The run of some forcing periods from `motion`, which it brings to their end, where the phase is
/// zero again and the time is counted anew.
Run carry_on(Scene scene, MotionAt &motion, int periods) {
  Run run;
  scene.omega = motion.frequency;
  scene.end_time = periods * 2 * acos(Real(-1)) / motion.frequency;
  advance(scene, motion.state, run, resolution_of_frequencies);
  motion.state.time = 0;
  return run;
}

/// The motion from rest after some forcing periods.
MotionAt from_rest(Scene scene, const Real &frequency, int periods) {
  Run run;
  scene.omega = frequency;
  MotionAt motion{frequency, initial_state(scene, resolution_of_frequencies, run)};
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

/// Throws std::logic_error, naming the two frequencies, unless `holds` is true.
void require(bool holds, const Real &one, const Real &other, const char *fault) {
  if (!holds)
    throw std::logic_error("the counts at " + one.str(10) + " and " + other.str(10) + ' ' + fault);
}

/// The extremes of the motion of a mass over [from, to]: at zeros of the velocity (sampled, then
/// bisected) or where one piece of motion meets the next. Throws std::runtime_error if the run has
/// no motion there.
Extremes extremes(const Run &run, std::size_t mass, const Real &from, const Real &to) {
  std::optional<Extremes> found;
  for (const Piece &piece : run.pieces) {
    const Flow &flow = piece.flow;
    const Real begin = std::max<Real>(Real(0), from - flow.start_time);
    const Real end = std::min<Real>(piece.duration, to - flow.start_time);
    if (begin >= end) continue;
    const auto include = [&](const Real &tau) {
      const Real x = motion_at(flow, tau).x[mass], time = flow.start_time + tau;
      if (!found) found = {x, x, time};
      found->lowest = std::min(found->lowest, x);
      if (x <= found->highest) return;
      found->highest = x;
      found->highest_at = time;
    };
    include(begin);
    if (moves(mass, flow))
      each_turn(
          flow, begin, end, [&](const Real &tau) { return motion_at(flow, tau).v[mass]; }, include);
    include(end);
  }
  if (!found) throw std::runtime_error("the run has no motion in that interval");
  return *found;
}

/// The frequency between `near` and `far` at which the count changes. The settled motion is
/// followed from `near`: every trial begins at the state extrapolated from the last two frequencies
/// known to have the same count as `near`, so that the unsettled part of a trial is small beside
/// the bracket. Throws std::logic_error if the counts at the ends agree, or if the motion of `near`
/// does not reach to 2 near - far, where the first extrapolation begins.
Real changing_frequency(const Scene &scene, const Real &near, const Real &far, const Count &count,
                        int settling_from_rest) {
  const auto settled_count = [&](MotionAt &motion) {
    carry_on(scene, motion, settling_from_near);
    return count(carry_on(scene, motion, counted));
  };
  const Real first = 2 * near - far;
  MotionAt before = from_rest(scene, first, settling_from_rest), tried = before,
           last = from_rest(scene, near, settling_from_rest),
           beyond = from_rest(scene, far, settling_from_rest);
  const std::ptrdiff_t count_near = settled_count(last);
  require(settled_count(beyond) != count_near, near, far, "agree");
  require(settled_count(tried) == count_near, first, near, "differ");
  const auto as_near = [&](const Real &frequency) {
    MotionAt trial = extrapolated(before, last, frequency);
    if (settled_count(trial) != count_near) return false;
    before = last;
    last = trial;
    return true;
  };
  return bisect(as_near, near, far, bracket_width);
}

/// The frequency between `near` and `far` at which the count of the motion from rest jumps. Every
/// trial starts at rest. Throws as `changing_frequency` does.
Real jumping_frequency(const Scene &scene, const Real &near, const Real &far, const Count &count) {
  const auto count_at = [&](const Real &frequency) {
    MotionAt motion = from_rest(scene, frequency, settling_of_a_jump);
    return count(carry_on(scene, motion, counted));
  };
  const std::ptrdiff_t count_near = count_at(near);
  require(count_at(far) != count_near, near, far, "agree");
  return bisect([&](const Real &frequency) { return count_at(frequency) == count_near; }, near, far,
                bracket_width);
}

}  // namespace

const Run &DigitsEngine::run(const NamedScene &asked) {
  for (const auto &[known, run] : runs_)
    if (known.scene == asked.scene && known.until == asked.until) return run;
  const Scene scene = in_digits(asked.scene, asked.until);
  runs_.emplace_back(asked, simulate(scene, resolution_down_to(Real("1e-20"))));
  return runs_.back().second;
}

std::vector<numbers::TimedEvent<Real>> DigitsEngine::events(const NamedScene &asked) {
  std::vector<numbers::TimedEvent<Real>> events;
  for (const Event &event : run(asked).events)
    events.push_back({event.time + event.left_out, event.kind, static_cast<int>(event.mass) + 1,
                      contact_mode(event.stuck)});
  return events;
}

Real DigitsEngine::period(const vibro_impact::Scene &scene) {
  return 2 * acos(Real(-1)) / Real(scene.omega);
}

Extremes DigitsEngine::range(const NamedScene &asked, int mass,
                             const numbers::Interval<double> &window) {
  return extremes(run(asked), index(mass), Real(window.from), Real(window.to));
}

numbers::TurningPoint<Real> DigitsEngine::turning_point(const NamedScene &asked, int mass,
                                                        const numbers::Interval<double> &window) {
  const Extremes found = range(asked, mass, window);
  return {found.highest_at, found.highest};
}

Real DigitsEngine::least_pressing(const NamedScene &asked, std::size_t stop) {
  const Scene scene = in_digits(asked.scene, asked.until);
  const Real from = scene.end_time - 2 * period(asked.scene);
  std::optional<Real> least;
  for (const Piece &piece : run(asked).pieces) {
    const Flow &flow = piece.flow;
    if (moves(scene.stops[stop].mass, flow) || flow.start_time < from) continue;
    const auto pressing = [&](const Real &tau) {
      return pressing_signal(scene, scene.stops[stop], motion_at(flow, tau));
    };
    each_turn(
        flow, Real(0), piece.duration, [&](const Real &tau) { return pressing(tau).rate; },
        [&](const Real &tau) {
          const Signal at_turn = pressing(tau);
          if (at_turn.curvature > 0 && (!least || abs(at_turn.value) < abs(*least)))
            least = at_turn.value;
        });
  }
  if (!least) throw std::runtime_error("no least force in a sticking phase");
  return *least;
}

Real DigitsEngine::changing_frequency(const vibro_impact::Scene &scene, int mass, double near,
                                      double far, numbers::Change motion) {
  const Count sticks = [mass](const Run &run) {
    return std::count_if(run.events.begin(), run.events.end(), [mass](const Event &event) {
      return event.kind == EventKind::stick && event.mass == index(mass);
    });
  };
  const Scene asked = in_digits(scene, 0.0);
  if (motion == numbers::Change::from_rest)
    return jumping_frequency(asked, Real(near), Real(far), sticks);
  return vibro_impact_reference::changing_frequency(asked, Real(near), Real(far), sticks,
                                                    settling_from_rest);
}

Real DigitsEngine::grazing_frequency(vibro_impact::Scene scene, int mass, double near, double far) {
  const auto stop = scene.stops.begin() +
                    static_cast<std::ptrdiff_t>(vibro_impact::numbers::stop_of(scene, mass));
  const Real place = Real(stop->position);
  scene.stops.erase(stop);
  const Count reaches = [&](const Run &run) {
    return extremes(run, index(mass), Real(0), Real("1e9")).highest >= place;
  };
  return vibro_impact_reference::changing_frequency(in_digits(scene, 0.0), Real(near), Real(far),
                                                    reaches, settling_from_rest);
}

}  // namespace vibro_impact_reference
