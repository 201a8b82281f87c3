// Motions that are slow or small relative to what could move: digits that a steady response, a long
// clock, the rounding of steps or of stiff coordinates would take. Each has its motion in closed
// form.
#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <limits>
#include <vector>

#include "reference/scenes/paper_scenes.hpp"
#include "vibro_impact/vibro_impact.hpp"

namespace {

using namespace vibro_impact;

constexpr double far = 1e300;  // a stop that nothing reaches

struct Ball {
  double mass = 1.0, stiffness = 0.0, amplitude = 0.0, omega = 1.0, restitution = 1.0;
  double stop = far, displacement = 0.0, velocity = 0.0;
};

Scene scene_of(const Ball &ball) {
  Scene scene;
  scene.mass = {ball.mass};
  scene.stiffness = {ball.stiffness};
  scene.amplitude = {ball.amplitude};
  scene.omega = ball.omega;
  scene.restitution = ball.restitution;
  scene.stops = {{1, Side::upper, ball.stop}};
  scene.displacement = {ball.displacement};
  scene.velocity = {ball.velocity};
  return scene;
}

double displacement_at(const Scene &scene, double time) {
  return simulate(scene, time).state.displacement[0];
}

// The steady response f / Omega^2 of a free mass is up to 1e15 times its motion. 1e-14 of the
// motion: some fifty roundings.
TEST(SlowForcing, OfAFreeMassCancelsNoDigits) {
  for (const double omega : {1.0, 3e-3, 3e-5, 3e-7, 1e-8, 0.0}) {
    const Scene scene = scene_of({1.3, 0.0, 0.37, omega, 1.0, far, 0.1, 0.2});
    for (const double t : {0.1, 0.6, 1.3, 2.2, 3.7}) {
      // 2 sin^2(Omega t / 2) is 1 - cos(Omega t) without cancellation.
      const double half = omega * t / 2.0, sinc = half > 0.0 ? std::sin(half) / half : 1.0;
      const double exact = 0.1 + 0.2 * t + 0.37 / 1.3 * t * t / 2.0 * sinc * sinc;
      EXPECT_NEAR(displacement_at(scene, t), exact, 1e-14 * exact) << omega << " " << t;
    }
  }
}

// Under a constant force a soft spring has moved by a 1e-11th of its static deflection.
TEST(SlowForcing, OfASoftSpringCancelsNoDigits) {
  for (const double stiffness : {1e-3, 1e-7, 1e-9, 1e-11}) {
    const Scene scene = scene_of({1.0, stiffness, 1.0, 0.0});
    for (const double t : {0.0, 1e-5, 0.6, 3.7}) {
      const double half = std::sin(std::sqrt(stiffness) * t / 2.0);
      const double exact = 2.0 * half * half / stiffness;
      EXPECT_NEAR(displacement_at(scene, t), exact, 1e-14 * exact) << stiffness << " " << t;
    }
  }
}

// The centre of mass, in 1e5 forcing periods beside a stop that lies 0.001 beyond its amplitude:
// 1e-12 of its motion, in steps of two radians of the fastest mode.
TEST(RigidBodyMode, IsExactInStepsBesideAStop) {
  Scene scene = paper::figure2();
  scene.stiffness = {0.0, 0.35};
  scene.amplitude = {0.5, 0.0};
  scene.omega = 0.5;
  scene.beta = 0.0;
  scene.stops = {{1, Side::upper, 2.001}};
  const double until = time_of({100'000, 3.0}, Clock(scene.omega));
  const Outcome outcome = require_complete(simulate(scene, until));
  EXPECT_GT(outcome.counters.expansions, 100'000);
  EXPECT_EQ(outcome.counters.impacts, 0);
  const double x = (outcome.state.displacement[0] + outcome.state.displacement[1]) / 2.0;
  EXPECT_NEAR(x, 1.0 - std::cos(0.5 * outcome.state.instant.phase), 1e-12);
}

// A strongly damped mode of which both decays are 1e4 times slower than the forcing, which is 1e10
// times the spring force. The times differ by 1e-14, some fifty roundings.
TEST(StrongDamping, SlowerThanTheForcingCancelsNoDigits) {
  Scene scene = scene_of({1.0, 1.0, 1e10, 1e5});
  scene.beta = 4.0;
  const long double omega = 1e5L, slow = 2.0L - std::sqrt(3.0L), fast = 2.0L + std::sqrt(3.0L);
  const std::complex<long double> steady =
      1e10L / std::complex<long double>(1.0L - omega * omega, 4.0L * omega);
  const std::complex<long double> speed = steady * std::complex<long double>(0.0L, omega);
  for (const double hit : {1.5e-7, 2e-6, 1e-5}) {
    // From rest, x = S + a e^(-slow t) + b e^(-fast t).
    const long double a = (-speed.real() - fast * steady.real()) / (fast - slow),
                      b = (speed.real() + slow * steady.real()) / (fast - slow);
    const long double x = (steady * (std::polar(1.0L, omega * hit) - 1.0L)).real() +
                          a * std::expm1(-slow * static_cast<long double>(hit)) +
                          b * std::expm1(-fast * static_cast<long double>(hit));
    scene.stops[0].position = static_cast<double>(x);
    EventRecorder events;
    require_complete(simulate(scene, 1.1 * hit, events));
    ASSERT_FALSE(events.events.empty()) << hit;
    EXPECT_NEAR(events.events[0].time, hit, 1e-14 * hit);
  }
}

// A mode far slower than its forcing, in 1e4 forcing periods of steps beside a stop. Sums over
// steps would be off by 3e-11 of the motion. 1e-14: some fifty roundings.
TEST(SoftSpring, IsExactInStepsBesideAStop) {
  Scene scene = scene_of({1.0, 1e-8, 10.0, 2.5, 0.7, far, 1.0, 0.01});
  scene.stops = {{1, Side::lower, -0.7}};
  const Outcome outcome = require_complete(simulate(scene, 29'000.0));
  EXPECT_GT(outcome.counters.expansions, 10'000);
  EXPECT_EQ(outcome.counters.impacts, 0);
  const long double k = 1e-8L, root = std::sqrt(k), omega = 2.5L, t = 29'000.0L,
                    steady = 10.0L / (k - omega * omega);
  const long double exact = steady * std::cos(omega * t) + (1.0L - steady) * std::cos(root * t) +
                            0.01L / root * std::sin(root * t);
  EXPECT_NEAR(outcome.state.displacement[0], static_cast<double>(exact), 1e-14 * 120.0);
}

// At a natural frequency of 1 and Omega = 1, whole periods bring the free motion back.
TEST(Clock, TurnsAFreeMotionByWholePeriodsExactly) {
  const Scene scene = scene_of({1.0, 1.0});
  for (const long long cycles : {1'000LL, 1'000'000LL, 1'000'000'000LL}) {
    const MotionState start{{1, 1.0}, {0.1}, {0.0}, {0}};
    const Outcome end = Simulation(scene, start).advance(time_of({1 + cycles, 2.0}, Clock(1.0)));
    EXPECT_NEAR(end.state.displacement[0], 0.1 * std::cos(end.state.instant.phase - 1.0), 4e-16);
  }
}

// From any start: the time is a whole number of periods and a phase.
TEST(Clock, OfALongQuietMotionIsNotRounded) {
  Scene scene = scene_of({1.0, 1.0, 0.5, 0.28, 0.7, 200.0});
  scene.beta = 0.1;
  const double stiff = 1.0 - 0.28 * 0.28, drag = 0.1 * 0.28;
  for (const long long cycle : {0LL, 1LL, 1'000'000LL, 10'000'000'000LL}) {
    const MotionState start{{cycle, 1.0}, {0.1}, {0.0}, {0}};
    const Outcome outcome =
        Simulation(scene, start).advance(time_of({cycle + 1'000'000, 2.0}, Clock(0.28)));
    const double angle = 0.28 * outcome.state.instant.phase;
    EXPECT_NEAR(
        outcome.state.displacement[0],
        0.5 * (stiff * std::cos(angle) + drag * std::sin(angle)) / (stiff * stiff + drag * drag),
        8e-16)
        << cycle;
  }
}

// A ball that falls from 1 at unit weight rests after sqrt(2) (1 + 2 r / (1 - r)). The tolerance of
// the time is that of the limit, 1e-13, and what some thousand impacts round.
TEST(SlowChatter, EndsInItsLimit) {
  constexpr double r = 0.99999;
  const Scene scene = scene_of({1.0, 0.0, 1.0, 0.0, r, 0.0, -1.0});
  const double rest = std::sqrt(2.0) * (1.0 + 2.0 * r / (1.0 - r));
  EventRecorder events;
  const Outcome outcome = require_complete(simulate(scene, 2.0 * rest, events));
  EXPECT_EQ(outcome.counters.sticks, 1);
  EXPECT_LT(outcome.counters.impacts, 1'000'000);
  EXPECT_NEAR(events.events.back().time, rest, 1e-12 * rest);
}

// A free mass that drifts to its stop, and away from it: steps as long as the motion is slow.
TEST(Drift, TakesFewSteps) {
  for (const double speed : {1e-2, 1e-6, 1e-12}) {
    EventRecorder events;
    const Scene scene = scene_of({1.0, 0.0, 0.0, 1.0, 0.5, 1.0, 0.1, speed});
    const Outcome outcome = simulate(scene, 1.8 / speed, events);
    ASSERT_EQ(events.events.size(), 1u) << speed;
    EXPECT_NEAR(events.events[0].time * speed, 0.9, 1e-15) << speed;
    EXPECT_NEAR(outcome.state.displacement[0], 1.0 - 0.45, 1e-15) << speed;
    EXPECT_LE(outcome.counters.expansions, 50) << speed;
  }
}

// A sample at the start of a long flight.
TEST(SmallMotion, IsFiniteInNoTime) {
  const MotionState start = simulate(scene_of({1.0, 1.0, 0.0, 1.0, 1.0, far, 0.1, 0.2}), 0.0).state;
  EXPECT_EQ(start.displacement[0], 0.1);
  EXPECT_EQ(start.velocity[0], 0.2);
}

// A motion of 1e-170, of which the squares underflow.
TEST(SmallMotion, MissesNoImpact) {
  const Scene scene = scene_of({1.0, 1.0, 0.0, 1.0, 0.5, 0.5e-170, -1e-170});
  EXPECT_EQ(simulate(scene, 10.0).counters.impacts, 2);
}

// Gaps of 1e-20 beside a mass that is displaced by one: the rounding of a common displacement would
// close or widen either by 1e-17. Twice the precision of the displacement leaves 1e-32.
TEST(SmallMotion, KeepsTwoSmallGaps) {
  Scene scene;
  scene.mass = {1.0, 1.3, 0.7};
  scene.stiffness = {1.0, 0.3, 2.1};
  scene.restitution = 0.5;
  scene.stops = {{2, Side::upper, 1e-20}, {3, Side::upper, 3e-20}};
  scene.displacement = {1.0, 0.0, 0.0};
  scene.velocity = {0.0, 1.0, 0.7};
  EventRecorder events;
  require_complete(simulate(scene, 1e-19, events));
  ASSERT_EQ(events.events.size(), 2u);
  EXPECT_NEAR(events.events[0].time, 1e-20, 1e-31);
  EXPECT_NEAR(events.events[1].time, 3e-20 / 0.7, 4e-31);
}

// An undamped stiff mode takes two radians a step at most. A damped one dies out.
TEST(Work, OfARunIsBounded) {
  Scene scene;
  scene.mass = {1.0, 1.0};
  scene.stiffness = {1.0, 1e14};
  scene.amplitude = {0.5, 0.0};
  scene.restitution = 0.7;
  scene.stops = {{1, Side::upper, 0.1}};
  RunOptions options;
  options.max_steps = 10'000;
  const Outcome outcome = simulate(scene, 100.0, options);
  EXPECT_EQ(outcome.ending, Ending::given_up);
  EXPECT_NE(outcome.reason.find("more than 10000 steps, given up at t = "), std::string::npos);
  EXPECT_LE(outcome.counters.expansions, 10'000);
  scene.beta = 0.1;
  EXPECT_EQ(simulate(scene, 100.0).ending, Ending::reached);
  scene.beta = 0.0;
  scene.stiffness[1] = 1e30;
  EXPECT_THROW(static_cast<void>(simulate(scene, 100.0, options)), std::invalid_argument);
  EXPECT_EQ(simulate(scene, 1e-12, options).ending, Ending::reached);
}

// A fast decay that wakes up late in a run, where its steps lie below the rounding of the phase.
TEST(Clock, ResolvesAFastDecayLateInARun) {
  Scene scene;
  scene.mass = {1.0, 1.0};
  scene.stiffness = {1.0, 1e9};
  scene.beta = 1e4;
  scene.amplitude = {1.0, 0.0};
  scene.omega = 1e-4;
  scene.restitution = 0.5;
  scene.stops = {{2, Side::upper, 0.05}};
  const Outcome outcome = simulate(scene, 4e4);
  EXPECT_EQ(outcome.ending, Ending::reached);
  EXPECT_GT(outcome.counters.impacts, 0);
}

}  // namespace
