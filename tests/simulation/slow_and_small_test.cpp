// Motions that are slow or small relative to what could move: digits that a steady response, a long
// clock, the rounding of steps or of stiff coordinates would take. Each is compared with its closed
// form. The motion itself is the measure of them, and not the frequencies of a chain that hardly
// feels its springs.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "reference/scenes/extreme_scenes.hpp"
#include "reference/scenes/paper_scenes.hpp"
#include "tests/support/events.hpp"
#include "tests/support/mode_motion.hpp"
#include "tests/support/random_scenes.hpp"
#include "vibro_impact/vibro_impact.hpp"

namespace {

using namespace vibro_impact;
using namespace vibro_impact::testing;

// One mass on a spring, with a stop that nothing reaches.
Scene mass_on_spring(double stiffness, double amplitude, double omega) {
  Scene scene = extremes::one_mass(0.0, amplitude, omega, 0.7, 1e300);
  scene.stiffness = {stiffness};
  return scene;
}

// The motion of a chain of one mass at time t, as if there were no stops.
Place motion_of_one_mass(const Scene &scene, Real t) {
  const FreeModes basis = free_modes(scene, {0});
  const MotionState start = start_of(scene);
  const Real shape = basis.shape(0, 0);
  const ModeMotion mode(scene, basis.lambda(0), Complex(basis.cosine(0), -basis.sine(0)),
                        basis.pull(0), 0,
                        {start.displacement[0] / shape, start.velocity[0] / shape});
  const Place place = mode.after(t);
  return {shape * place.at, shape * place.speed};
}

// The displacement is that of the closed form, as exact as the motion itself. 1e-14 of the motion:
// some fifty roundings.
void expect_exact(const Scene &scene, double time) {
  const auto exact = static_cast<double>(motion_of_one_mass(scene, time).at);
  EXPECT_NEAR(simulate(scene, time).state.displacement[0], exact, 1e-14 * std::abs(exact))
      << "stiffness " << scene.stiffness[0] << ", omega " << scene.omega << ", time " << time;
}

// The steady response f / Omega^2 of a free mass is up to 1e15 times its motion. Under a constant
// force a soft spring has moved by a 1e-11th of its static deflection.
TEST(SlowForcing, CancelsNoDigits) {
  for (const double omega : {1.0, 3e-3, 3e-5, 3e-7, 1e-8, 0.0}) {
    Scene scene = mass_on_spring(0.0, 0.37, omega);
    scene.mass = {1.3};
    scene.displacement = {0.1};
    scene.velocity = {0.2};
    for (const double t : {0.1, 0.6, 1.3, 2.2, 3.7}) expect_exact(scene, t);
  }
  for (const double stiffness : {1e-3, 1e-7, 1e-9, 1e-11})
    for (const double t : {0.0, 1e-5, 0.6, 3.7})
      expect_exact(mass_on_spring(stiffness, 1.0, 0.0), t);
}

// The centre of mass of a free chain moves as f (1 - cos(Omega t)) / Omega^2. First a stop is far
// away. Then it lies 0.001 beyond the amplitude. 1e-12 of the motion.
TEST(RigidBodyMode, IsExactForAHundredThousandPeriods) {
  for (const auto &[omega, stop] : {std::pair{0.05, 1e4}, {0.5, 2.001}}) {
    Scene scene = paper::figure2();
    scene.stiffness = {0.0, 0.35};
    scene.amplitude = {0.5, 0.0};
    scene.omega = omega;
    scene.beta = 0.0;
    scene.stops = {{1, Side::upper, stop}};
    const double until = time_of({100'000, 3.0}, Clock(omega));
    const Outcome outcome = require_complete(simulate(scene, until));
    EXPECT_EQ(outcome.counters.impacts, 0);
    const double x = (outcome.state.displacement[0] + outcome.state.displacement[1]) / 2.0,
                 amplitude = 0.25 / (omega * omega);
    EXPECT_NEAR(x, amplitude * (1.0 - std::cos(omega * outcome.state.instant.phase)),
                1e-12 * amplitude);
  }
}

// A strongly damped mode of which both decays are 1e4 times slower than the forcing, which is 1e10
// times the spring force. The times differ by 1e-14, some fifty roundings.
TEST(StrongDamping, SlowerThanTheForcingCancelsNoDigits) {
  Scene scene = mass_on_spring(1.0, 1e10, 1e5);
  scene.beta = 4.0;
  for (const double hit : {1.5e-7, 2e-6, 1e-5}) {
    const auto x = motion_of_one_mass(scene, hit).at;
    scene.stops[0].position = static_cast<double>(x);
    const std::vector<Event> events = events_of(scene, 0.0, 1.1 * hit);
    ASSERT_FALSE(events.empty()) << hit;
    EXPECT_NEAR(events[0].time, hit, 1e-14 * hit);
  }
}

// A mode far slower than its forcing, in 1e4 forcing periods beside a stop. Sums over steps would
// be off by 3e-11 of the motion.
TEST(SoftSpring, IsExactBesideAStop) {
  Scene scene = mass_on_spring(1e-8, 10.0, 2.5);
  scene.stops = {{1, Side::lower, -0.7}};
  scene.displacement = {1.0};
  scene.velocity = {0.01};
  EXPECT_EQ(simulate(scene, 29'000.0).counters.impacts, 0);
  expect_exact(scene, 29'000.0);
}

// At a natural frequency of 1 and Omega = 1, whole periods bring the free motion back.
TEST(Clock, TurnsAFreeMotionByWholePeriodsExactly) {
  const Scene scene = mass_on_spring(1.0, 0.0, 1.0);
  for (const long long cycles : {1'000LL, 1'000'000LL, 1'000'000'000LL}) {
    const MotionState start{{1, 1.0}, {0.1}, {0.0}, {0}};
    const Outcome end = Simulation(scene, start).advance(time_of({1 + cycles, 2.0}, Clock(1.0)));
    EXPECT_NEAR(end.state.displacement[0], 0.1 * std::cos(end.state.instant.phase - 1.0), 4e-16);
  }
}

// A sample at the end of a call, and one where the next call begins, lie in it by this.
TEST(Clock, GivesTheInstantAtATimeThisTimeExactly) {
  Draw draw{std::mt19937(1)};
  for (int k = 0; k < 100'000; ++k) {
    const Clock clock(draw.spread(1e-3, 1e3));
    const double time = clock.period * draw.spread(1e-6, 1e12);
    ASSERT_EQ(time_of(instant_at(time, clock), clock), time) << clock.period;
    const double periods = k % 200 * clock.period;
    const Instant instant = instant_at(periods, clock);
    ASSERT_EQ(time_of(instant, clock), periods) << clock.period;
    ASSERT_LT(instant.phase, clock.period);
  }
}

// A motion of 1e-170, of which the squares underflow.
TEST(SmallMotion, MissesNoImpact) {
  const Scene scene = extremes::one_mass(0.0, 0.0, 1.0, 0.5, 0.5e-170, -1e-170);
  EXPECT_EQ(simulate(scene, 10.0).counters.impacts, 2);
}

// Masses without a spring to the ground leave the stop of the first with the speed v against a
// force that brings them back with the acceleration a, after 2 v / a. The gap, v^2 / (2 a) at most,
// is hidden beside the place of the stop at first, and again before the impact. It has the digits
// of that place, 1e-32 of it, and is at least 1e-24 of it here: 1e-7. The links swing by this
// rounding.
TEST(SmallMotion, OfFreeMassesComesBackToItsStop) {
  for (unsigned seed = 1; seed <= 60; ++seed) {
    SCOPED_TRACE(seed);
    Draw draw{std::mt19937(seed)};
    const auto masses = static_cast<std::size_t>(draw.between(1, 3));
    const double place = draw.spread(0.1, 10.0), height = place * draw.spread(1e-24, 1e-12),
                 back = draw.spread(1e2, masses == 1 ? 1e14 : 1e11), speed = 4.0 * height / back;
    std::vector<double> stiffness(masses, 1.0);
    stiffness[0] = 0.0;
    const Scene scene{.mass = std::vector(masses, 1.0),
                      .stiffness = stiffness,
                      .constant = std::vector(masses, 2.0 * speed / back),
                      .omega = 0.0,
                      .restitution = 0.5,
                      .stops = {{1, Side::upper, place}},
                      .displacement = std::vector(masses, place),
                      .velocity = std::vector(masses, -speed)};
    const std::vector<Event> events = events_of(scene, 0.0, 1.1 * back, {.max_steps = 10'000});
    ASSERT_GE(events.size(), 1u);
    EXPECT_NEAR(events[0].time, back, 1e-7 * back);
    EXPECT_NEAR(events[0].velocity_before, speed, 1e-7 * speed + 1e-30 * place);
  }
}

// A force cos t - 1 + d holds a mass but for a time sqrt(2 d) about each odd multiple of pi. A
// touch reaches to d = 1.8e-15, eight roundings of both forces: deeper dips release the mass.
TEST(SmallMotion, FollowsADipOfAForceBelowItsTouch) {
  for (const auto &[depth, releases] : {std::pair{0x1p-45, 10}, {0x1p-48, 10}, {0x1p-50, 0}}) {
    Scene scene = extremes::one_mass(0.1, 1.0, 1.0, 0.0, 0.0);
    scene.constant = {1.0 - depth};
    const Outcome outcome = simulate(scene, 60.0);
    EXPECT_EQ(outcome.counters.releases, releases) << depth;
  }
}

// A stiff mode, damped or not, needs few steps. A mode that swings on is not followed for longer
// than its phase has digits.
TEST(Work, OfAStiffChainIsBounded) {
  Scene scene = extremes::chain(2, 0.0);
  scene.stiffness = {1.0, 1e14};
  scene.amplitude = {0.5, 0.0};
  scene.restitution = 0.7;
  scene.stops = {{1, Side::upper, 0.1}};
  const RunOptions options{.max_steps = 10'000};
  for (const double beta : {0.1, 0.0}) {
    scene.beta = beta;
    EXPECT_EQ(simulate(scene, 100.0, options).ending, Ending::reached) << beta;
  }
  scene.stiffness[1] = 1e30;
  EXPECT_THROW(static_cast<void>(simulate(scene, 100.0, options)), std::invalid_argument);
  EXPECT_EQ(simulate(scene, 1e-12, options).ending, Ending::reached);
}

// A force presses a mass onto its stop with r = 1: its flights shorten without limit, each as fast
// as the one before. The run ends at the stated number of steps, and its outcome is the state at
// its latest event.
TEST(Work, OfEndlessImpactsEndsWithTheLatestEvent) {
  const Scene scene = extremes::one_mass(0.0, 1.0, 0.0, 1.0, -1.0, -1.0 - 1e-9);
  EventRecorder recorder;
  const Outcome outcome = simulate(scene, 1e3, {.max_steps = 5000}, recorder);
  EXPECT_EQ(outcome.ending, Ending::given_up);
  EXPECT_TRUE(outcome.reason.starts_with("at least 5000 steps, given up at t = "));
  EXPECT_EQ(outcome.reason.find('\n'), std::string::npos) << outcome.reason;
  EXPECT_EQ(outcome.counters.expansions, 5000);
  ASSERT_GT(recorder.events.size(), 4990u);
  EXPECT_EQ(outcome.time, recorder.events.back().time);
  EXPECT_EQ(outcome.state.displacement[0], -1.0);
  EXPECT_EQ(outcome.state.velocity[0], recorder.events.back().velocity_after);
  EXPECT_THROW(require_complete(outcome), std::runtime_error);
}

struct Ball {
  double mass, stiffness, force, omega, restitution, height;
};

// A ball of constant weight rests after (1 + 2 r / (1 - r)) times its first fall, whatever the
// rates of its spring and of a forcing that hardly turns. 1e-12: the tolerance of a limit and what
// the forcing and the spring change.
TEST(Chatter, OfAFallingMassEndsWhereItsImpactsDo) {
  for (const auto &[mass, stiffness, force, omega, r, height] :
       {Ball{1e8, 1e-12, 1e8, 0.0, 3e-5, 1.0},
        {1.0, 0.0, 1.0, 1e-8, 1e-7, 1.0},
        {1.0, 0.0, 1e8, 0.0, 1e-7, 1e-8},
        {1.0, 0.0, 1.0, 1e-14, 0.5, 1.0},
        {1.0, 0.0, 1.0, 1e-14, 0.9, 1.0},
        {1.0, 1e-24, 1.0, 0.0, 0.7, 1.0},
        {1.0, 0.0, 1.0, 0.0, 0.99999, 1.0}}) {
    const Scene scene{.mass = {mass},
                      .stiffness = {stiffness},
                      .amplitude = {-force},
                      .omega = omega,
                      .restitution = r,
                      .stops = {{1, Side::lower, 0.0}},
                      .displacement = {height}};
    const double fall = std::sqrt(2.0 * height * mass / force),
                 rest = fall * (1.0 + 2.0 * r / (1.0 - r));
    for (const RunOptions &options : {RunOptions{}, all_impacts}) {
      if (r > 0.99 && options.limit_below_speed == 0.0) continue;  // some millions of impacts
      const std::vector<Event> events = events_of(scene, 0.0, 1.5 * rest, options);
      ASSERT_FALSE(events.empty());
      EXPECT_LT(events.size(), 1'000'000u);
      EXPECT_EQ(events.back().kind, EventKind::stick) << omega << " " << r;
      EXPECT_NEAR(events.back().time, rest, 1e-12 * rest) << omega << " " << r;
    }
  }
}

// A spring so soft that a step of two radians has an infinite square.
TEST(Modes, OfASpringNearTheLeastNumberStayInRange) {
  Scene scene = extremes::one_mass(0.0, 0.0, 0.0, 0.5, 1.0, 0.0, 0.5);
  scene.stiffness = {1e-310};
  const Outcome outcome = require_complete(simulate(scene, 4.0));
  EXPECT_EQ(outcome.counters.impacts, 1);
  EXPECT_NEAR(outcome.state.displacement[0], 0.5, 1e-15);
}

}  // namespace
