// Motions followed until they have settled, compared with motions run to the full length and
// counted by another rule.
#include <gtest/gtest.h>

#include <complex>
#include <random>
#include <utility>
#include <vector>

#include "figures/frequency_diagram.hpp"
#include "reference/scenes/extreme_scenes.hpp"
#include "reference/scenes/paper_scenes.hpp"
#include "vibro_impact/analysis/analysis.hpp"
#include "vibro_impact/vibro_impact.hpp"

namespace {

using namespace vibro_impact;

// The period by comparing whole states: the least n <= 32 with the state after n forcing periods
// the same to 1e-8, or 0.
int period_of_states(const Scene &scene, const MotionState &state) {
  const std::vector<double> from = coordinates(state);
  for (int n = 1; n <= 32; ++n) {
    const MotionState end = stroboscopic_map(scene, state, n);
    const std::vector<double> to = coordinates(end);
    bool same = end.held == state.held;
    for (std::size_t i = 0; i < from.size(); ++i) same = same && std::abs(to[i] - from[i]) <= 1e-8;
    if (same) return n;
  }
  return 0;
}

// Settling saves most of the 400 periods that Figure 3 would otherwise be followed for at each
// frequency. Of 901 frequencies some 850 settled, half of them within 23 periods, after 57,000
// periods in all, of 360,400. Motions at the edge of settling depend on rounding: the bounds have a
// margin of at least one part in ten for what does.
TEST(Settle, MostOfFigure3SettlesSoon) {
  std::vector<long long> periods_run;  // of the motions that settle
  long long all = 0;
  const Grid grid = figures::grid_of_figure3(181);
  for (std::size_t k = 0; k < grid.points(); ++k) {
    const double omega = grid.values(k).front();
    const Scene scene = paper::figure3(omega);
    const SettledMotion motion = settle(scene, start_of(scene));
    all += motion.periods_run;
    if (motion.period > 0) periods_run.push_back(motion.periods_run);
  }
  EXPECT_GE(periods_run.size(), 160u);
  EXPECT_LE(all, 181 * 400 / 5);
  std::sort(periods_run.begin(), periods_run.end());
  EXPECT_LE(periods_run[periods_run.size() / 2], 30);
}

// The events of whole periods far out, counted going forward. The impacts of a chatter are
// put aside until a stick, or a faster impact, shows which kind it was.
EventCounts counted_far_out(const Scene &scene, int periods, int after) {
  const Clock clock(scene.omega);
  EventRecorder recorder{(after - 1) * clock.period};
  require_complete(simulate(scene, (after + periods + 1) * clock.period, recorder));
  const std::vector<int> none(scene.mass.size(), 0);
  EventCounts counts{periods, none, none, false};
  std::vector<int> aside(scene.stops.size(), 0);
  const auto inside = [&](const Event &event) {
    return event.instant.cycle >= after && event.instant.cycle < after + periods;
  };
  for (const Event &event : recorder.events) {
    const auto mass = static_cast<std::size_t>(event.mass - 1);
    if (event.kind == EventKind::impact) {
      if (event.falling == 0)
        counts.impacts[mass] += std::exchange(aside[static_cast<std::size_t>(event.stop - 1)], 0);
      if (inside(event)) ++aside[static_cast<std::size_t>(event.stop - 1)];
    }
    if (event.kind == EventKind::stick) {
      if (law_of(scene, stop_of(scene, event)).restitution == 0.0)
        counts.impacts[mass] += aside[static_cast<std::size_t>(event.stop - 1)];
      aside[static_cast<std::size_t>(event.stop - 1)] = 0;
      if (inside(event)) ++counts.sticks[mass];
    }
    if (inside(event) && std::ranges::count(event.held, 0) + 1 < std::ssize(event.held))
      counts.dual_sticking = true;
  }
  for (std::size_t stop = 0; stop < aside.size(); ++stop)
    counts.impacts[static_cast<std::size_t>(scene.stops[stop].mass - 1)] += aside[stop];
  return counts;
}

// Fifty points of the (Omega, r) atlas, a scene without rebound, of which all impacts count, and a
// chain of ten masses, of which several stick at once.
std::vector<Scene> scenes_of_many_kinds() {
  std::vector<Scene> scenes{with(paper::figure2(), "restitution", 0.0)};
  const auto add = [&scenes](Scene scene, double omega, double restitution) {
    scene.omega = omega;
    scene.restitution = restitution;
    scenes.push_back(scene);
  };
  for (const auto &[omega, restitution] : {std::pair{0.25, 0.7}, {0.3, 0.2}, {0.72, 0.6}})
    add(extremes::long_chain(), omega, restitution);
  std::mt19937 random(20060401);
  std::uniform_real_distribution<double> any_omega(0.2, 0.8), any_restitution(0.0, 0.98);
  for (int k = 0; k < 50; ++k) {
    const double omega = any_omega(random);
    add(paper::figure2(), omega, any_restitution(random));
  }
  return scenes;
}

// Whether a motion repeats is decided after 2,000 periods, by its states alone.
TEST(Settle, PeriodsAndCountsAreThoseOfTwoThousandPeriods) {
  int settled = 0;
  for (const Scene &scene : scenes_of_many_kinds()) {
    SCOPED_TRACE(::testing::Message() << scene.omega << " " << scene.restitution);
    const OrbitRecord found = record_of(scene, {.settle = {.longest = 2000}});
    const MotionState far_out = state_after_periods(scene, 2000);
    ASSERT_EQ(found.period, period_of_states(scene, far_out));
    if (found.period == 0) continue;
    ++settled;
    const EventCounts expected = counted_far_out(scene, found.period, 2000);
    EXPECT_EQ(found.counts.periods, expected.periods);
    EXPECT_EQ(found.counts.impacts, expected.impacts);
    EXPECT_EQ(found.counts.sticks, expected.sticks);
    EXPECT_EQ(found.counts.dual_sticking, expected.dual_sticking);
  }
  EXPECT_GT(settled, 39);
}

// Period 2 after period 1 in the region of sticking, and what a short wait leaves undecided.
TEST(Settle, SaysThePeriodOrNone) {
  const auto period_of = [](double omega, int longest) {
    const Scene scene = paper::figure3(omega);
    const SettledMotion motion = settle(scene, start_of(scene), {.longest = longest});
    EXPECT_LE(motion.periods_run, longest);
    EXPECT_TRUE(motion.period > 0 || motion.periods_run == longest);
    return motion.period;
  };
  EXPECT_EQ(period_of(0.28, 400), 1);
  EXPECT_EQ(period_of(0.65, 400), 4);
  EXPECT_EQ(period_of(0.61, 400), 2);
  EXPECT_EQ(period_of(0.69, 400), 0);  // chaotic
  EXPECT_EQ(period_of(0.28, 5), 0);    // on its way
  EXPECT_EQ(period_of(0.28, 1), 0);
}

// At Omega = 1.9 the free motion turns ten times in 19 forcing periods. Periods are looked for up
// to the largest one. A motion whose damping has not died out yet is on its way to its period, a
// chaotic one to none.
TEST(Settle, ALongPeriodAMotionOnItsWayAndAnIrregularOne) {
  Scene scene{.mass = {1.0}, .stiffness = {1.0}, .amplitude = {0.1}, .omega = 1.9};
  EXPECT_EQ(settle(scene, start_of(scene)).period, 19);
  const SettledMotion shorter = settle(scene, start_of(scene), {.largest_period = 18});
  EXPECT_EQ(shorter.period, 0);
  EXPECT_EQ(shorter.approached, 0);
  scene.beta = 0.02;
  const SettledMotion slow = settle(scene, start_of(scene), {.longest = 300});
  EXPECT_EQ(slow.period, 0);
  EXPECT_EQ(slow.approached, 1);
  const Scene irregular = paper::figure3(0.69);
  EXPECT_EQ(settle(irregular, start_of(irregular)).approached, 0);
}

// A motion without forcing comes to rest at a distance from its stop. Its tolerance is relative to
// its amplitude over the later half, so that it settles.
TEST(Settle, AMotionThatComesToRestSettles) {
  const Scene scene{.mass = {1.0}, .stiffness = {1.0}, .beta = 0.2, .velocity = {1.0}};
  EXPECT_EQ(settle(scene, start_of(scene)).period, 1);
}

// The state of a stiff oscillator, no stop in its way, turns around the orbit as it comes nearer,
// in a thin ellipse: any one component is small twice a turn. The orbit itself in closed form.
// Twice the tolerance, relative to its amplitude: the decay within a turn is not even.
TEST(Settle, WhatIsStillToComeIsKnownOfAMotionThatTurns) {
  Scene scene;
  scene.mass = {1.0};
  scene.stiffness = scene.amplitude = {1e4};
  scene.beta = 5e-4;
  scene.stops = {{1, Side::upper, 1000.0}};
  const double tolerance = 1e-10;
  for (int k = 0; k <= 400; ++k) {
    scene.omega = 20.0 + 0.45 * k;
    SCOPED_TRACE(scene.omega);
    const SettledMotion motion = settle(scene, start_of(scene));
    ASSERT_EQ(motion.period, 1);
    const std::complex<double> turn(0.0, scene.omega),
        x = 1e4 / (1e4 + turn * (turn + scene.beta * 1e4));
    const double v = (turn * x).real(), w = 100.0;
    EXPECT_LE(
        std::hypot(motion.state.displacement[0] - x.real(), (motion.state.velocity[0] - v) / w),
        2.0 * tolerance * std::hypot(x.real(), v / w));
  }
}

// Motions that come near their orbit slowly, turning: with some number of periods in between, the
// states are close long before those of one period are. After 4,000 periods it is decided. And a
// ball on no spring, thrown between two stops by the force on it: nothing makes it turn.
TEST(Settle, OfSlowAndOfFreeMotionsThePeriodIsThatOfFourThousandPeriods) {
  Scene ball{.mass = {1.0}, .stiffness = {0.0}, .amplitude = {1.0}, .restitution = 0.5};
  ball.stops = {{1, Side::lower, -1.0}, {1, Side::upper, 1.0}};
  std::vector<Scene> scenes{ball};
  for (const auto &[omega, restitution] : {std::pair{0.39849624060150379, 0.82595317725752504},
                                           {0.61804511278195495, 0.74401337792642142},
                                           {0.67218045112781954, 0.72434782608695647},
                                           {0.68571428571428572, 0.58668896321070241},
                                           {0.69172932330827075, 0.62602006688963208}})
    scenes.push_back(with(paper::figure3(omega), "restitution", restitution));
  for (const Scene &scene : scenes) {
    const SettledMotion motion = settle(scene, start_of(scene), {.longest = 200});
    EXPECT_EQ(motion.period, period_of_states(scene, state_after_periods(scene, 4000)))
        << scene.omega;
  }
}

// The section is the phase of the start.
TEST(Settle, AnyPhaseMayBeTheSection) {
  const Scene scene = paper::figure2();
  const MotionState begin = at_quiet_phase(scene, state_after_periods(scene, 3));
  ASSERT_GT(begin.instant.phase, 0.0);
  EXPECT_EQ(begin.instant.cycle, 0);
  const SettledMotion motion = settle(scene, begin);
  EXPECT_EQ(motion.period, 1);
  EXPECT_EQ(motion.state.instant.phase, begin.instant.phase);
  EXPECT_EQ(motion.state.held, begin.held);
  EXPECT_EQ(period_of_states(scene, motion.state), 1);
}

}  // namespace
