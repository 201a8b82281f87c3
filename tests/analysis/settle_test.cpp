// Motions followed until they have settled, compared with motions run to the full length and
// counted by another rule, and their records.
#include <gtest/gtest.h>

#include <complex>
#include <random>
#include <utility>
#include <vector>

#include "reference/scenes/extreme_scenes.hpp"
#include "reference/scenes/paper_scenes.hpp"
#include "tests/support/events.hpp"
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

// The events of whole periods after many periods, counted forwards. The impacts of a chatter are
// pending until a stick, or a faster impact, shows whether it is complete.
EventCounts counted_after(const Scene &scene, int periods, int after) {
  const Clock clock(scene.omega);
  EventRecorder recorder{(after - 1) * clock.period};
  require_complete(simulate(scene, (after + periods + 1) * clock.period, recorder));
  const std::vector<int> none(scene.mass.size(), 0);
  EventCounts counts{periods, none, none, false};
  std::vector<int> pending(scene.stops.size(), 0);
  const auto inside = [&](const Event &event) {
    return event.instant.cycle >= after && event.instant.cycle < after + periods;
  };
  for (const Event &event : recorder.events) {
    const auto mass = static_cast<std::size_t>(event.mass - 1);
    if (event.kind == EventKind::impact) {
      if (event.falling == 0)
        counts.impacts[mass] += std::exchange(pending[static_cast<std::size_t>(event.stop - 1)], 0);
      if (inside(event)) ++pending[static_cast<std::size_t>(event.stop - 1)];
    }
    if (event.kind == EventKind::stick) {
      if (law_of(scene, stop_of(scene, event)).restitution == 0.0)
        counts.impacts[mass] += pending[static_cast<std::size_t>(event.stop - 1)];
      pending[static_cast<std::size_t>(event.stop - 1)] = 0;
      if (inside(event)) ++counts.sticks[mass];
    }
    if (inside(event) && std::ranges::count(event.held, 0) + 1 < std::ssize(event.held))
      counts.dual_sticking = true;
  }
  for (std::size_t stop = 0; stop < pending.size(); ++stop)
    counts.impacts[static_cast<std::size_t>(scene.stops[stop].mass - 1)] += pending[stop];
  return counts;
}

// A motion that is given at most so many periods to settle, and decided after others.
struct Followed {
  Scene scene;
  int longest = 2000, far_out = 2000;
};

// The motions are those of fifty points of the (Omega, r) atlas, a scene without rebound, of which
// all impacts count, and a chain of ten masses, of which several stick at once. Others come near
// their orbit slowly, turning: with some number of periods in between, the states are close long
// before those of one period are. The last is a ball on no spring, thrown between two stops by the
// force on it: nothing makes it turn.
std::vector<Followed> motions_of_many_kinds() {
  Scene ball{.mass = {1.0}, .stiffness = {0.0}, .amplitude = {1.0}, .restitution = 0.5};
  ball.stops = {{1, Side::lower, -1.0}, {1, Side::upper, 1.0}};
  std::vector<Followed> motions{{with(paper::figure2(), "restitution", 0.0)}, {ball, 200, 4000}};
  const auto add = [&motions](Followed motion, double omega, double restitution) {
    motion.scene.omega = omega;
    motion.scene.restitution = restitution;
    motions.push_back(motion);
  };
  for (const auto &[omega, restitution] : {std::pair{0.25, 0.7}, {0.3, 0.2}, {0.72, 0.6}})
    add({extremes::long_chain()}, omega, restitution);
  for (const auto &[omega, restitution] : {std::pair{0.39849624060150379, 0.82595317725752504},
                                           {0.61804511278195495, 0.74401337792642142},
                                           {0.67218045112781954, 0.72434782608695647},
                                           {0.68571428571428572, 0.58668896321070241},
                                           {0.69172932330827075, 0.62602006688963208}})
    add({paper::figure2(), 200, 4000}, omega, restitution);
  std::mt19937 random(20060401);
  std::uniform_real_distribution<double> any_omega(0.2, 0.8), any_restitution(0.0, 0.98);
  for (int k = 0; k < 50; ++k) {
    const double omega = any_omega(random);
    add({paper::figure2()}, omega, any_restitution(random));
  }
  return motions;
}

// Whether a motion repeats is decided after many periods, by its states alone.
TEST(Settle, PeriodsAndCountsAreThoseOfThousandsOfPeriods) {
  int settled = 0;
  for (const auto &[scene, longest, after] : motions_of_many_kinds()) {
    SCOPED_TRACE(::testing::Message() << scene.omega << " " << scene.restitution);
    const OrbitRecord found = record_of(scene, {.settle = {.longest = longest}});
    const MotionState far_out = state_after_periods(scene, after);
    ASSERT_EQ(found.period, period_of_states(scene, far_out));
    if (found.period == 0) continue;
    ++settled;
    const EventCounts expected = counted_after(scene, found.period, after);
    EXPECT_EQ(found.counts.periods, expected.periods);
    EXPECT_EQ(found.counts.impacts, expected.impacts);
    EXPECT_EQ(found.counts.sticks, expected.sticks);
    EXPECT_EQ(found.counts.dual_sticking, expected.dual_sticking);
  }
  EXPECT_GT(settled, 52);
}

// Period 2 after period 1 in the region of sticking, and what a short wait leaves undecided. At
// Omega = 1.9 the free motion turns ten times in 19 forcing periods; periods are looked for up to
// the largest one. A motion whose damping has not died out yet is on its way to its period, a
// chaotic one to none. A motion without forcing comes to rest at a distance from its stop: its
// tolerance is relative to its amplitude over the later half, so that it settles. The three motions
// that are given 14, 42 and 60 periods settle after 12, 37 and 52.
TEST(Settle, SaysThePeriodOrTheOneThatTheMotionApproaches) {
  const Scene turning{.mass = {1.0}, .stiffness = {1.0}, .amplitude = {0.1}, .omega = 1.9},
      resting{.mass = {1.0}, .stiffness = {1.0}, .beta = 0.2, .velocity = {1.0}};
  const struct {
    const char *name;
    Scene scene;
    SettleOptions options;
    int period, approached = 0;
  } cases[] = {{"sticking", paper::figure3(0.28), {.longest = 14}, 1},
               {"period 4", paper::figure3(0.65), {}, 4},
               {"period 2", paper::figure3(0.61), {.longest = 42}, 2},
               {"chaotic", paper::figure3(0.69), {}, 0},
               {"after 5 periods", paper::figure3(0.28), {.longest = 5}, 1},
               {"after 1 period", paper::figure3(0.28), {.longest = 1}, 0},
               {"period 19", turning, {}, 19},
               {"up to period 18", turning, {.largest_period = 18}, 0},
               {"damped slowly", with(turning, "beta", 0.02), {.longest = 300}, 1},
               {"at rest", resting, {.longest = 60}, 1}};
  for (const auto &[name, scene, options, period, approached] : cases) {
    const SettledMotion motion = settle(scene, options);
    EXPECT_EQ(motion.period, period) << name;
    EXPECT_EQ(motion.approached, approached) << name;
    EXPECT_LE(motion.periods_run, options.longest) << name;
    EXPECT_TRUE(period > 0 || motion.periods_run == options.longest) << name;
  }
}

// The state of a stiff oscillator, no stop in its way, turns around the orbit as it comes nearer,
// in a thin ellipse: any one component is small twice a turn. The orbit itself in closed form.
// Twice the tolerance, relative to its amplitude: the decay within a turn is not even.
TEST(Settle, WhatIsStillToComeIsKnownOfAMotionThatTurns) {
  Scene scene = extremes::one_mass(5e-4, 1e4, 0.0, 1.0, 1000.0);
  scene.stiffness = {1e4};
  const double tolerance = 1e-10;
  for (int k = 0; k <= 400; ++k) {
    scene.omega = 20.0 + 0.45 * k;
    SCOPED_TRACE(scene.omega);
    const SettledMotion motion = settle(scene);
    ASSERT_EQ(motion.period, 1);
    const std::complex<double> turn(0.0, scene.omega),
        x = 1e4 / (1e4 + turn * (turn + scene.beta * 1e4));
    const double v = (turn * x).real(), w = 100.0;
    EXPECT_LE(
        std::hypot(motion.state.displacement[0] - x.real(), (motion.state.velocity[0] - v) / w),
        2.0 * tolerance * std::hypot(x.real(), v / w));
  }
}

// Two masses that hit at the same instants, x_2 = 2 x_1, settle alike in whatever order their stops
// are listed.
TEST(Settle, DoesNotDependOnTheOrderOfTheStops) {
  for (const double r : {0.5, 0.7})
    for (const double omega : {0.6, 0.9, 1.1}) {
      Scene scene{.mass = {1.0, 1.0},
                  .stiffness = {3.0, 2.0},
                  .beta = 0.1,
                  .amplitude = {0.5, 1.0},
                  .omega = omega,
                  .restitution = r,
                  .stops = {{1, Side::upper, 0.25}, {2, Side::upper, 0.5}}};
      const OrbitRecord record = record_of(scene);
      std::swap(scene.stops[0], scene.stops[1]);
      const OrbitRecord swapped = record_of(scene);
      SCOPED_TRACE(::testing::Message() << r << " " << omega);
      EXPECT_GT(record.period, 0);
      EXPECT_EQ(swapped.period, record.period);
      EXPECT_EQ(swapped.counts.impacts, record.counts.impacts);
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

// The record of a motion has counts of its events, and only what is asked for.
TEST(Record, HasOnlyWhatIsAskedFor) {
  const Scene settling = paper::figure3(0.55);
  const OrbitRecord bare = record_of(settling);
  EXPECT_GT(bare.period, 0);
  EXPECT_FALSE(bare.lyapunov.exists());
  EXPECT_TRUE(bare.impacts.empty());
  EXPECT_TRUE(bare.pairs.empty());
  RecordOptions asked;
  asked.impacts = true;
  const OrbitRecord speeds = record_of(settling, asked);
  EXPECT_EQ(speeds.counts.impacts, bare.counts.impacts);
  EXPECT_EQ(speeds.impacts[0].size(), static_cast<std::size_t>(bare.counts.impacts[0]));
  EventRecorder period(-infinity);
  stroboscopic_map(settling, speeds.state, speeds.period, {}, period);
  for (const int mass : {1, 2}) {
    const auto &recorded = speeds.impacts[static_cast<std::size_t>(mass - 1)];
    const auto expected = vibro_impact::testing::select(period.events, EventKind::impact, mass);
    ASSERT_EQ(recorded.size(), expected.size());
    for (std::size_t k = 0; k < expected.size(); ++k)  // the motion has settled to 1e-10
      EXPECT_NEAR(recorded[k].velocity_before, expected[k].velocity_before, 1e-9) << mass;
  }
}

// Pressed onto their stops for ever: no event says so.
TEST(Record, MassesThatAreHeldFromTheBeginningStickAtOnce) {
  Scene scene = paper::two_masses({1, Side::lower, 0.1}, {2, Side::lower, 0.15}, 0.7, 0.3);
  scene.amplitude = {0.01, 0.0};
  scene.displacement = {0.1, 0.15};
  const EventCounts counts = record_of(scene).counts;
  EXPECT_TRUE(counts.dual_sticking);
  EXPECT_EQ(counts.sticks, (std::vector{0, 0}));
}

// The pairs themselves are those of event_pairs_test; Figure 5(b) has none.
TEST(Record, ThePairsOfTableIThatOccur) {
  const RecordOptions options{.settle = {}, .pairs = true};
  EXPECT_EQ(record_of(paper::figure5a(), options).pairs, std::vector{EventPair::sticking_impact});
  EXPECT_TRUE(record_of(paper::figure5b(), options).pairs.empty());
}

// A state of a neighbouring scene is a start: a mass that is held moves with its stop, a mass
// beyond a stop moves to it, and the phase stays within the period.
TEST(StartNear, BringsAStateIntoTheScene) {
  Scene scene = paper::figure2();
  MotionState state = start_of(scene);
  state.displacement = {-0.3, 0.05};
  state.velocity = {0.0, 0.2};
  state.held = {-1, 0};
  state.instant.phase = 0.9 * Clock(scene.omega).period;
  scene.omega *= 1.5;
  scene.stops[0].position = -0.25;
  scene.stops[1].position = 0.04;
  const MotionState start = start_near(scene, state);
  EXPECT_EQ(start.displacement, (std::vector<double>{-0.25, 0.04}));
  EXPECT_EQ(start.velocity, state.velocity);
  EXPECT_EQ(start.held, state.held);
  EXPECT_LT(start.instant.phase, Clock(scene.omega).period);
  EXPECT_NO_THROW(require_complete(Simulation(scene, start).advance(time_after(scene, start, 1))));
}

}  // namespace
