// What else may happen while a mass chatters: another mass arrives at its stop, a held one is let
// go. Runs that may carry the chatter to its limit against runs that resolve every impact, those
// against a motion in extended precision.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "reference/scenes/extreme_scenes.hpp"
#include "tests/events.hpp"
#include "vibro_impact/analysis/hold_force.hpp"
#include "witness.hpp"

namespace {

using namespace vibro_impact;
using namespace vibro_impact::testing;

constexpr double begin = 0.3;

// Three masses of which the second has just left its stop and is pressed back by its neighbours.
struct Pressed {
  Scene scene;
  MotionState start;
  double speed;  // with which it left

  Pressed(double beta, double omega, double restitution) : speed(beta > 10.0 ? 1e-3 : 0.06) {
    scene.mass = {1.0, 0.8, 1.3};
    scene.stiffness = {1.0, 1.2, 0.9};
    scene.beta = beta;
    scene.amplitude = {0.3, 0.0, 0.2};
    scene.omega = omega;
    scene.restitution = restitution;
    scene.stops = {{2, Side::upper, 0.1}, {3, Side::upper, 5.0}};
    place_third(0.6, -0.04);
  }
  // Starts with the third mass at x, held at its stop or moving at v.
  void place_third(double x, double v, signed char how = 0) {
    start = {{0, begin}, {0.7, 0.1, x}, {0.05, -speed, v}, {0, 0, how}};
  }
};

struct Told {
  std::vector<Event> events;
  Outcome outcome;
};

Told run(const Pressed &at, double until, const RunOptions &options = {}) {
  EventRecorder recorder;
  const Outcome outcome = simulate_from(at.scene, at.start, until, options, recorder);
  return {recorder.events, require_complete(outcome)};
}

// When the chatter of the second mass, left alone, is over: it sticks.
double accumulation(const Pressed &at) {
  Pressed alone = at;
  alone.scene.stops.resize(1);
  alone.start.held[2] = 0;
  const auto sticks =
      select(events_from(alone.scene, alone.start, 20.0, all_impacts), EventKind::stick, 2);
  return sticks.empty() ? INFINITY : sticks.front().time;
}

// Everything but the impacts of the second mass, of which a limit leaves some out.
std::vector<Event> beside_the_chatter(const Told &told) {
  std::vector<Event> found;
  for (const Event &event : told.events)
    if (event.mass != 2 || event.kind != EventKind::impact) found.push_back(event);
  return found;
}

// Within the error at which a limit is accepted.
void expect_the_same_beside_the_chatter(const Told &told, const Told &truth) {
  const double tolerance = RunOptions{}.chatter_tolerance;
  const std::vector<Event> events = beside_the_chatter(told), others = beside_the_chatter(truth);
  ASSERT_EQ(events.size(), others.size());
  for (std::size_t i = 0; i < events.size(); ++i) {
    EXPECT_EQ(events[i].kind, others[i].kind) << i;
    EXPECT_EQ(events[i].mass, others[i].mass) << i;
    EXPECT_EQ(events[i].held, others[i].held) << i;
    EXPECT_NEAR(events[i].time, others[i].time, tolerance) << i;
    EXPECT_NEAR(events[i].velocity_before, others[i].velocity_before, tolerance) << i;
  }
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_NEAR(told.outcome.state.displacement[i], truth.outcome.state.displacement[i], tolerance);
    EXPECT_NEAR(told.outcome.state.velocity[i], truth.outcome.state.velocity[i], tolerance);
  }
}

// The third mass is put where its free motion is at a time before, or after, the accumulation of
// the impacts, as near as one likes: there it arrives, and no sooner is the chatter over.
TEST(Chatter, GoesOnUpToWhereAMassArrives) {
  int met = 0;
  for (const double r : {0.3, 0.7, 0.9})
    for (const double speed : {0.2, 0.6}) {
      Pressed at(0.1, 0.3, r);
      at.place_third(0.6, speed);
      const double over = accumulation(at);
      if (!(over < 10.0)) continue;
      for (const double share : {0.1, 0.5, 0.9, 0.99, 0.999, 0.9999, 1.0 - 1e-6, 1.0 - 1e-8,
                                 1.0 + 1e-8, 1.0 + 1e-6, 1.0001, 1.01, 1.1}) {
        SCOPED_TRACE(::testing::Message() << r << " " << speed << " " << share);
        const double time = begin + share * (over - begin);
        Pressed before = at;
        before.scene.stops[1].position = 1e3;
        const MotionState there = run(before, time, all_impacts).outcome.state;
        if (!(there.velocity[2] > 0.05)) continue;
        Pressed meets = at;
        meets.scene.stops[1].position = there.displacement[2];
        const double until = 1.2 * over;
        const Told told = run(meets, until), truth = run(meets, until, all_impacts);
        const auto arrivals = select(told.events, EventKind::impact, 3);
        ASSERT_FALSE(arrivals.empty());
        const Event &arrival = arrivals.front();
        EXPECT_NEAR(arrival.time, time, 1e-13);
        EXPECT_NEAR(arrival.velocity_before, there.velocity[2], 1e-13);
        expect_the_same_beside_the_chatter(told, truth);
        ++met;
      }
    }
  EXPECT_GE(met, 50);
}

// The third mass held, by a force of `slack` that the forcing reduces; every impact of the second
// one takes a jump off it, which the damper between them passes on.
Pressed with_a_held_mass(double beta, double restitution, double slack) {
  Pressed at(beta, 1.2, restitution);
  at.scene.amplitude[2] = 1.0;
  const double stiffness = at.scene.stiffness[2];
  const double pulled = std::cos(1.2 * begin) - beta * stiffness * at.speed - slack;
  const double position = 0.1 + pulled / stiffness;
  at.scene.stops[1].position = position;
  at.place_third(position, 0.0, 1);
  return at;
}

struct Ends {
  int by_a_jump = 0, between = 0, held = 0;
};

// Whether the hold ends before the chatter of the second mass does. The witness sees the force fall
// to zero there and no sooner, at an impact or between two, and a run that may take limits has it
// end at the same time.
bool let_go_first(const Pressed &at, Ends &ends) {
  const auto all = events_from(at.scene, at.start, begin + 1.0, all_impacts);
  const auto releases = select(all, EventKind::release, 3),
             sticks = select(all, EventKind::stick, 2);
  const double let_go = releases.empty() ? INFINITY : releases.front().time;
  const double over = sticks.empty() ? INFINITY : sticks.front().time;
  const double until = std::min({let_go, over, begin + 1.0}) + 1e-9;
  Witness witness(at.scene, at.start);
  const Outcome outcome = simulate_from(at.scene, at.start, until, all_impacts, witness);
  witness.close(require_complete(outcome).state);
  EXPECT_LT(witness.weakest, 1e-14);
  EXPECT_LT(witness.not_zero, 1e-14);
  expect_the_same_beside_the_chatter(run(at, until), run(at, until, all_impacts));
  const bool first = let_go < over;
  ++(!first ? ends.held : releases.front().by_a_jump ? ends.by_a_jump : ends.between);
  return first;
}

TEST(Chatter, EndsWhereAHoldForceFalls) {
  Ends ends;
  for (const double beta : {0.1, 0.5, 2.0, 30.0})
    for (const double restitution : {0.3, 0.5, 0.7, 0.9}) {
      SCOPED_TRACE(::testing::Message() << beta << " " << restitution);
      double falls = 0.0, stays = 0.0;
      for (double slack = 1e-5; slack < 1.0; slack *= 1.3) {
        SCOPED_TRACE(slack);
        const Pressed at = with_a_held_mass(beta, restitution, slack);
        ASSERT_NEAR(pressing_force(at.scene, at.scene.stops[1], at.start), slack, 1e-13);
        if (let_go_first(at, ends))
          falls = slack;
        else if (stays == 0.0)
          stays = slack;
      }
      if (falls == 0.0 || stays == 0.0) continue;
      // The hold ends later and later in the chatter as the slack comes near the border.
      for (int half = 0; half < 40; ++half) {
        const double slack = (falls + stays) / 2.0;
        SCOPED_TRACE(slack);
        (let_go_first(with_a_held_mass(beta, restitution, slack), ends) ? falls : stays) = slack;
      }
    }
  EXPECT_GE(ends.by_a_jump, 100);
  EXPECT_GE(ends.between, 100);
  EXPECT_GE(ends.held, 100);
}

}  // namespace
