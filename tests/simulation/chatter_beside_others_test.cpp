// What else may happen while a mass chatters: one that is held is let go. (Others that arrive at
// their stops: random_scenes_test.) Runs that may carry the chatter to its limit against runs that
// resolve every impact, those against a motion in extended precision.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "reference/scenes/extreme_scenes.hpp"
#include "tests/events.hpp"
#include "vibro_impact/analysis/pressing_force.hpp"
#include "witness.hpp"

namespace {

using namespace vibro_impact;
using namespace vibro_impact::testing;

constexpr double begin = 0.3;

struct Pressed {
  Scene scene;
  MotionState start;
};

// Three masses of which the second has just left its stop and is pressed back by its neighbours.
// The third is held, by a force of `slack` that the forcing reduces; every impact of the second one
// takes a jump off it, which the damper between them passes on.
Pressed with_a_held_mass(double beta, double restitution, double slack) {
  constexpr double link = 0.9, omega = 1.2;
  const double speed = beta > 10.0 ? 1e-3 : 0.06;  // with which the second left
  const double pulled = std::cos(omega * begin) - beta * link * speed - slack,
               position = 0.1 + pulled / link;
  Scene scene;
  scene.mass = {1.0, 0.8, 1.3};
  scene.stiffness = {1.0, 1.2, link};
  scene.beta = beta;
  scene.amplitude = {0.3, 0.0, 1.0};
  scene.omega = omega;
  scene.restitution = restitution;
  scene.stops = {{2, Side::upper, 0.1}, {3, Side::upper, position}};
  return {scene, {{0, begin}, {0.7, 0.1, position}, {0.05, -speed, 0.0}, {0, 0, 1}}};
}

struct Told {
  std::vector<Event> events;
  Outcome outcome;
};

Told run(const Pressed &at, double until, const RunOptions &options = {}) {
  EventRecorder recorder;
  const Outcome outcome = simulate_from(at.scene, at.start, until, options, recorder);
  return {recorder.events, require_complete(outcome)};
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
