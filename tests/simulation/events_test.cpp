// Complete chatter as a limit, sticking, release, and what a scene does not need.
#include <gtest/gtest.h>

#include "reference/scenes/paper_scenes.hpp"
#include "vibro_impact/vibro_impact.hpp"

namespace {

using namespace vibro_impact;

std::vector<Event> events_of(const Scene &scene, double until, const RunOptions &options = {}) {
  EventRecorder recorder;
  require_complete(simulate(scene, until, options, recorder));
  return recorder.events;
}

std::vector<Event> only(const std::vector<Event> &events, EventKind kind, int mass) {
  std::vector<Event> found;
  for (const Event &event : events)
    if (event.kind == kind && event.mass == mass) found.push_back(event);
  return found;
}

// 1e-11: the limit is accepted at an estimated relative error of 1e-13; later events repeat and
// pass on what error there is.
TEST(ChatterLimit, AgreesWithResolvingEveryImpact) {
  for (double r : {0.001, 0.05, 0.3, 0.5, 0.7, 0.8, 0.95, 0.99}) {
    Scene scene = paper::figure5c();  // slow forcing: chatter completes for every r < 1
    scene.stops.resize(1);
    scene.restitution = r;
    RunOptions resolved;
    resolved.resolve_chatter = 0.0;
    const auto with = events_of(scene, 400.0), without = events_of(scene, 400.0, resolved);
    for (EventKind kind : {EventKind::stick, EventKind::release}) {
      const auto a = only(with, kind, 1), b = only(without, kind, 1);
      ASSERT_EQ(a.size(), b.size()) << r;
      ASSERT_GE(a.size(), 1u) << r;
      for (std::size_t i = 0; i < a.size(); ++i) EXPECT_NEAR(a[i].time, b[i].time, 1e-11) << r;
    }
    EXPECT_LE(with.size(), without.size());
  }
}

TEST(ChatterLimit, NotUsedWhereNothingChatters) {
  for (double r : {0.0, 1.0}) {
    Scene scene = paper::figure2();
    scene.restitution = r;
    const Outcome outcome = simulate(scene, 200.0);
    EXPECT_GT(outcome.counters.impacts, 20);
    EXPECT_EQ(outcome.counters.chatter_nodes, 0) << r;
    EXPECT_EQ(outcome.counters.chatter_limits, 0) << r;
  }
}

TEST(Sticking, AHeldMassStaysExactlyAtItsStopWhilePressed) {
  struct Check {
    long long asked = 0, held = 0;
    double next_time() const {
      return 0.01 * static_cast<double>(asked);
    }
    void sample(const Moment &moment) {
      ++asked;
      const double f1 = moment.hold_force(1), f2 = moment.hold_force(2);
      if (!std::isnan(f1)) {
        ++held;
        EXPECT_EQ(moment.displacement(1), -0.3);
        EXPECT_LE(f1, 1e-15) << moment.time;
      }
      if (!std::isnan(f2)) {
        ++held;
        EXPECT_EQ(moment.displacement(2), 0.1);
        EXPECT_GE(f2, -1e-15) << moment.time;
      }
    }
  } recorder;
  require_complete(simulate(paper::figure2(), 200.0, {}, recorder));
  EXPECT_GT(recorder.held, 1000);
}

TEST(Sticking, ZeroHoldForceIsNeitherAStickNorAHang) {
  // Figure 5(c) while mass 1 is stuck, to t = 989. The interval is pi / omega_d
  // exactly; 1e-12 is a few units in the last place of t.
  EventRecorder recorder{920.0};
  require_complete(simulate(paper::figure5c(), 985.0, {}, recorder));
  ASSERT_GT(recorder.events.size(), 20u);
  const double zeta = 0.05, damped = std::sqrt(1.0 - zeta * zeta), pi = std::acos(-1.0);
  for (std::size_t i = 0; i + 1 < recorder.events.size(); ++i) {
    const Event &a = recorder.events[i], &b = recorder.events[i + 1];
    EXPECT_EQ(a.kind, EventKind::impact);
    EXPECT_EQ(a.mass, 2);
    EXPECT_NEAR(b.time - a.time, pi / damped, 1e-12);
    EXPECT_NEAR(b.velocity_before / a.velocity_before, 0.7 * std::exp(-zeta * pi / damped), 1e-13);
  }
}

Scene one_mass(double position, Side side, double displacement, double velocity, double force) {
  Scene scene;
  scene.mass = {1.0};
  scene.stiffness = {1.0};
  scene.beta = 0.1;
  scene.amplitude = {force};
  scene.omega = 0.3;
  scene.restitution = 0.5;
  scene.stops = {{1, side, position}};
  scene.displacement = {displacement};
  scene.velocity = {velocity};
  return scene;
}

TEST(Sticking, AStartOnTheStopIsPressedPulledOrMoving) {
  const auto first = [](const Scene &scene) { return events_of(scene, 5.0).front(); };
  // The force on the mass at rest at x = 0.1 is A - 0.1. The stop's side, not its sign, decides.
  Event event = first(one_mass(0.1, Side::upper, 0.1, 0.0, 0.5));
  EXPECT_EQ(event.kind, EventKind::stick);
  EXPECT_EQ(event.time, 0.0);
  event = first(one_mass(0.1, Side::lower, 0.1, 0.0, 0.5));
  EXPECT_GT(event.time, 1.0) << "pulled off: it flies before it comes back";
  event = first(one_mass(0.1, Side::upper, 0.1, 0.4, 0.5));
  EXPECT_EQ(event.kind, EventKind::impact);
  EXPECT_EQ(event.time, 0.0);
  EXPECT_EQ(event.velocity_before, 0.4);
  event = first(one_mass(0.1, Side::upper, 0.1, -0.4, 0.5));
  EXPECT_GT(event.time, 0.1);
  event = first(one_mass(0.0, Side::upper, 0.0, 0.0, 0.5));  // a stop at s = 0
  EXPECT_EQ(event.kind, EventKind::stick);
}

TEST(Impact, SimultaneousImpactsAreOneEvent) {
  Scene scene = paper::figure5a();
  scene.displacement = {0.3, 0.3};
  scene.velocity = {0.2, 0.1};
  const auto events = events_of(scene, 0.05);
  ASSERT_GE(events.size(), 2u);
  for (std::size_t i : {0u, 1u}) {
    EXPECT_EQ(events[i].time, 0.0);
    EXPECT_EQ(events[i].kind, EventKind::impact);
    EXPECT_EQ(events[i].velocity_after, -0.7 * events[i].velocity_before);
  }
  EXPECT_NE(events[0].mass, events[1].mass);
}

// Mass 2 hits its stop while mass 1 is held lightly: the damper pulls mass 1 off at that instant.
TEST(Sticking, ANeighboursImpactReleasesAtOnce) {
  Scene scene = paper::figure5a();
  scene.amplitude = {0.0, 0.0};
  scene.beta = 1.0;
  scene.stops = {{1, Side::upper, 0.0}, {2, Side::upper, 0.05}};
  scene.displacement = {0.0, 0.04};
  scene.velocity = {0.0, 0.5};
  const auto events = events_of(scene, 1.0);
  ASSERT_GE(events.size(), 3u);
  EXPECT_EQ(events[0].kind, EventKind::stick);
  EXPECT_EQ(events[1].kind, EventKind::impact);
  EXPECT_EQ(events[2].kind, EventKind::release);
  EXPECT_EQ(events[2].time, events[1].time);
  EXPECT_TRUE(events[2].by_a_jump);
}

TEST(Economy, NothingASceneDoesNotNeed) {
  Scene scene;
  scene.mass.assign(10, 1.0);
  scene.stiffness.assign(10, 1.0);
  scene.beta = 0.1;
  scene.velocity.assign(10, 0.05);
  scene.omega = 0.3;
  scene.restitution = 0.7;
  scene.stops = {{10, Side::upper, 0.05}};
  Outcome outcome = simulate(scene, 100.0);
  EXPECT_LE(outcome.counters.modes_built, 2) << "a contact mode is built when it is entered";
  EXPECT_EQ(outcome.counters.forcing_lanes, 0) << "no forcing terms where A = 0";
  EXPECT_EQ(outcome.counters.modal_evaluations, 0) << "no samples where none are asked for";
  EXPECT_LE(outcome.counters.stops_clear + outcome.counters.roots_dismissed +
                outcome.counters.roots_searched,
            outcome.counters.expansions)
      << "one stop, looked at no more than once per expansion";

  scene.stops.clear();
  SampleRecorder samples;
  samples.to = 100.0;
  samples.every = 0.5;
  outcome = simulate(scene, 100.0, {}, samples);
  EXPECT_EQ(samples.times.size(), 201u);
  EXPECT_EQ(outcome.counters.modal_evaluations, 202) << "one per sample, one for the end";
  EXPECT_EQ(outcome.counters.expansions, 0);
}

// 1e-11: the rounding of the state at the restart, passed on by some twenty events.
TEST(Simulate, ARunContinuesFromAnyInstantFreeOrHeld) {
  const Scene scene = paper::figure2();
  EventRecorder whole;
  require_complete(simulate(scene, 300.0, {}, whole));
  int held = 0;
  for (double t = 200.0; t < 223.0; t += 0.31) {
    const Outcome half = simulate(scene, t);
    held += half.state.held != Held{0, 0};
    EventRecorder second;
    const Outcome rest = simulate_from(scene, half.state, 300.0, {}, second);
    EXPECT_EQ(rest.time, 300.0);
    std::vector<Event> expected, found;  // sticks and releases: a restart may resolve more impacts
    for (const Event &event : whole.events)
      if (event.time > t && event.kind != EventKind::impact) expected.push_back(event);
    for (const Event &event : second.events)
      if (event.kind != EventKind::impact) found.push_back(event);
    ASSERT_EQ(found.size(), expected.size()) << t;
    for (std::size_t i = 0; i < found.size(); ++i)
      EXPECT_NEAR(found[i].time, expected[i].time, 1e-11) << t;
  }
  EXPECT_GE(held, 5);
}

}  // namespace
