// Masses that are let go together: chains of equal masses and links on equal stops, where the hold
// forces of all are zero at one instant, or from the start on.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "energy_balance.hpp"
#include "event_rules.hpp"
#include "reference/scenes/degenerate_cases.hpp"
#include "work_bounds.hpp"

namespace {

using namespace vibro_impact;
using namespace vibro_impact::testing;

using extremes::on_equal_stops;

std::vector<Scene> uniform_chains(Side side) {
  std::vector<Scene> scenes;
  for (const int masses : {2, 3, 4, 5, 6, 8})
    for (const double beta : {0.0, 0.5})
      for (const double r : {0.0, 0.3, 0.7})
        for (const double omega : {0.3, 0.7})
          scenes.push_back(on_equal_stops(masses, side, beta, r, omega));
  return scenes;
}

// What holds of a run of any of them: it comes to its end by events that obey the rules, none of
// which lasts no time, with the work that these take, 20 impacts a mass and period at most; and its
// energy is accounted for.
void expect_orderly(const Scene &scene, const EventRules &rules, const Outcome &outcome,
                    double until) {
  SCOPED_TRACE(command_of(scene, until));
  EXPECT_EQ(outcome.ending, Ending::reached) << outcome.reason;
  EXPECT_EQ(rules.broken, "");
  EXPECT_EQ(excessive_work(scene, until, outcome.counters), "");
  const double periods = until / Clock(scene.omega).period;
  EXPECT_LT(static_cast<double>(outcome.counters.impacts), 20.0 * periods * scene.masses());
  RunOptions all;
  all.resolve_chatter = 0.0;
  EnergyAudit audit{scene};
  audit.close(require_complete(simulate(scene, until, all, audit)).state);
  EXPECT_LT(std::abs(audit.imbalance()), 1e-13 * audit.scale());
}

// The forcing pulls every mass off at once, with the same force: the links come into play later.
TEST(TiedReleases, ChainsPulledOffAtTheStart) {
  for (const Scene &scene : uniform_chains(Side::lower)) {
    EventRules rules{scene};
    const Outcome outcome = simulate(scene, 30.0, {}, rules);
    expect_orderly(scene, rules, outcome, 30.0);
    // Mass 1, tied to the ground, is the first to come back.
    ASSERT_FALSE(rules.events.empty());
    const Event &first = rules.events.front();
    EXPECT_EQ(first.kind, EventKind::impact);
    EXPECT_EQ(first.mass, 1);
    EXPECT_GT(first.time, 1.0);
  }
}

// Pressed in at first, all are let go where cos(Omega t) = 0: one instant, to a rounding or two.
TEST(TiedReleases, ChainsLetGoAtOneInstant) {
  for (const Scene &scene : uniform_chains(Side::upper)) {
    EventRules rules{scene};
    const Outcome outcome = simulate(scene, 30.0, {}, rules);
    expect_orderly(scene, rules, outcome, 30.0);
    const auto n = scene.mass.size();
    const double let_go = std::acos(-1.0) / 2.0 / scene.omega;
    ASSERT_GE(rules.events.size(), 2 * n);
    for (std::size_t i = 0; i < n; ++i) {
      const Event &stick = rules.events[i], &release = rules.events[n + i];
      EXPECT_EQ(stick.kind, EventKind::stick);
      EXPECT_EQ(stick.time, 0.0);
      EXPECT_EQ(release.kind, EventKind::release);
      EXPECT_NEAR(release.time, let_go, 4e-16 * let_go);
      EXPECT_EQ(release.time, rules.events[n].time);
      EXPECT_FALSE(release.by_a_jump);
    }
  }
}

// What the limit of chatter says of who is held, and when, against all impacts resolved. 1e-11:
// what rounding grows to over some thirty impacts.
TEST(TiedReleases, ThreeMassesWithAndWithoutChatterLimits) {
  const Scene scene = on_equal_stops(3, Side::lower, 0.5, 0.3, 0.3);
  const auto holds = [&scene](const RunOptions &options) {
    EventRecorder recorder;
    require_complete(simulate(scene, 30.0, options, recorder));
    std::erase_if(recorder.events,
                  [](const Event &event) { return event.kind == EventKind::impact; });
    return recorder.events;
  };
  RunOptions all;
  all.resolve_chatter = 0.0;
  const std::vector<Event> events = holds({}), truth = holds(all);
  ASSERT_EQ(events.size(), truth.size());
  EXPECT_GE(events.size(), 6u);
  for (std::size_t i = 0; i < events.size(); ++i) {
    EXPECT_EQ(events[i].kind, truth[i].kind);
    EXPECT_EQ(events[i].mass, truth[i].mass);
    EXPECT_EQ(events[i].held, truth[i].held);
    EXPECT_NEAR(events[i].time, truth[i].time, 1e-11);
  }
}

// Only the first mass is forced, and has no stop: x_1'' = 1/2 at first, and mass j follows its
// neighbour, x_j = t^2j / (2 (2j)!) to leading order. That is far below rounding for a while, but
// no mass is held: all move as in the chain without stops until one of them comes back.
TEST(TiedReleases, TenMassesThatFollowTheFirst) {
  const Scene scene = extremes::following_the_first(0.7, 0.7);
  Scene free = scene;
  free.stops.clear();
  EventRules rules{scene};
  const Outcome outcome = simulate(scene, 30.0, {}, rules);
  expect_orderly(scene, rules, outcome, 30.0);
  ASSERT_FALSE(rules.events.empty());

  const double first = rules.events.front().time;
  EXPECT_GT(first, 0.5);
  EXPECT_EQ(rules.events.front().kind, EventKind::impact);
  const MotionState at_impact = simulate(free, first).state;
  const auto hit = static_cast<std::size_t>(rules.events.front().mass - 1);
  EXPECT_NEAR(at_impact.displacement[hit], 0.0, 1e-14);  // rounding of motion of order one
  EXPECT_NEAR(at_impact.velocity[hit], rules.events.front().velocity_before, 1e-14);
  for (double time = first / 64.0; time < first; time += first / 64.0) {
    const MotionState state = simulate(scene, time).state, truth = simulate(free, time).state;
    for (std::size_t i = 0; i < 10; ++i) {
      EXPECT_NEAR(state.displacement[i], truth.displacement[i], 1e-14) << i << " at " << time;
      EXPECT_NEAR(state.velocity[i], truth.velocity[i], 1e-14) << i << " at " << time;
      // Mass 1 has no stop.
      EXPECT_TRUE(i == 0 || state.displacement[i] >= 0.0) << i << " at " << time;
    }
  }
  // The first ones by themselves: the next term is (2j + 2)(2j + 1) / t^2 times smaller, or that of
  // the forcing, and less.
  const MotionState early = simulate(scene, 0.01).state;
  double leading = scene.amplitude[0];
  for (int j = 1; j <= 4; ++j) {
    leading *= 0.01 * 0.01 / (2.0 * j * (2.0 * j - 1.0));
    EXPECT_NEAR(early.displacement[static_cast<std::size_t>(j - 1)], leading, 1e-4 * leading) << j;
  }
}

}  // namespace
