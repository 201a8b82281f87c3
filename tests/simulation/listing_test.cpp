// The impacts of a chatter that are listed before its limit do not move it, and do not depend on
// the times at which calls end.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include "reference/scenes/paper_scenes.hpp"
#include "simulation/run/chatter_limit.hpp"
#include "simulation/run/events_at_an_instant.hpp"
#include "tests/support/windows.hpp"
#include "vibro_impact/analysis/totals.hpp"

namespace {

using namespace vibro_impact;
using namespace vibro_impact::testing;

// Impacts are listed down to a share of the first, or to a speed, and the counts are those of all
// impacts at this speed or faster. The motion and its work are the same.
TEST(Listing, DoesNotMoveTheRun) {
  const Scene scene = paper::figure2();
  const Outcome alone = simulate(scene, 100.0);
  const std::vector<Event> all =
      select(events_of(scene, 0.0, 100.0, all_impacts), EventKind::impact);
  for (const double slowest : {1e-3, 1e-5, 1e-9, 0.0}) {
    EventRecorder events(0.0, slowest);
    TotalsRecorder totals(scene, 0.0, 100.0, slowest);
    const Outcome outcome = simulate(scene, 100.0, events, totals);
    EXPECT_EQ(outcome.state, alone.state);
    EXPECT_EQ(outcome.counters.expansions, alone.counters.expansions);
    EXPECT_EQ(outcome.counters.impacts, alone.counters.impacts);
    EXPECT_EQ(std::ranges::count(events.events, EventKind::stick, &Event::kind),
              alone.counters.sticks);
    EXPECT_NEAR(sum_of(events.events).impulse, sum_of(all).impulse, 1e-12) << slowest;
    for (const Event &event : events.events) {
      EXPECT_GE(event.taken.impulse, 0.0) << slowest << ' ' << event.time;
      EXPECT_GE(event.taken.energy, 0.0) << slowest << ' ' << event.time;
    }
    const auto as_fast = [slowest](const Event &event) {
      return event.kind == EventKind::impact && std::abs(event.velocity_before) >= slowest;
    };
    if (slowest == 0.0) continue;
    EXPECT_EQ(std::ranges::count_if(events.events, as_fast), std::ranges::count_if(all, as_fast));
    EXPECT_EQ(totals.stops[0].impacts + totals.stops[1].impacts,
              std::ranges::count_if(all, as_fast));
  }
}

// The calls end anywhere, also between impacts that are resolved before a limit.
TEST(Listing, IsTheSameInAnyCalls) {
  for (unsigned seed = 1; seed <= 100; ++seed) {
    Draw draw{std::mt19937(seed)};
    const Scene scene = seed % 2 == 0 ? chattering_scene(seed) : paper::figure2();
    const double until = seed % 2 == 0 ? 15.0 : 60.0;
    const std::vector<Event> whole = events_of(scene, 0.0, until);
    std::vector<double> ends = {until};
    for (int k = 0; k < 8; ++k) ends.push_back(std::clamp(edge(whole, until, draw), 0.0, until));
    std::ranges::sort(ends);
    Simulation simulation(scene);
    EventRecorder parts(-infinity);
    for (const double end : ends) require_complete(simulation.advance(end, parts));
    EXPECT_TRUE(parts.events == whole) << seed;
  }
}

// Nobody lists impacts in the first call, which ends inside a chatter. The stick has those, too.
TEST(Listing, BeginsInsideAChatterOfWhichNobodyHasHeard) {
  const Scene scene = paper::figure2();
  const std::vector<Event> whole = events_of(scene, 0.0, 20.0);
  const Event &stick = *std::ranges::find(whole, EventKind::stick, &Event::kind);
  for (const double before : {3e-3, 1e-4, 1e-6}) {
    struct Quiet : Recorder {
      ImpactSum sum = {};
      void event(const Event &event, const Moment &) override {
        sum += event.taken;
      }
    } quiet;
    Simulation simulation(scene);
    require_complete(simulation.advance(stick.time - before, quiet));
    EventRecorder rest(-infinity);
    require_complete(simulation.advance(20.0, rest));
    quiet.sum += sum_of(rest.events);
    EXPECT_NEAR(quiet.sum.impulse, sum_of(whole).impulse, 1e-14) << before;
    EXPECT_GE(rest.events.front().time, stick.time - before);
  }
}

// A mass is released at the limit of its chatter, by the spring. No scene is known in which this
// happens: the run is put there. The impacts beyond the latest node take an impulse of 2 and an
// energy of 3.
TEST(Listing, EndsAChatterThatIsReleasedAtOnceWithAnImpactWithoutSpeed) {
  const Scene scene{.mass = {1.0},
                    .stiffness = {1.0},
                    .restitution = 0.5,
                    .stops = {{1, Side::upper, 0.1}},
                    .displacement = {0.1}};
  EventRecorder events;
  Recorder *const recorders[] = {&events};
  detail::Run run{.problem = {std::make_shared<const Scene>(scene), {}}, .start = start_of(scene)};
  detail::put_at_start(run);
  detail::handle_instant(run, {});
  run.limit.motion = run.motion;
  run.limit.stops = run.stops;
  run.limit.unreported = {2.0, 3.0};
  detail::enter_limit(run, recorders);
  ASSERT_EQ(events.events.size(), 1u);
  const Event &event = events.events[0];
  EXPECT_EQ(event.kind, EventKind::impact);
  EXPECT_EQ(event.velocity_before, 0.0);
  EXPECT_EQ(event.taken, (ImpactSum{2.0, 3.0}));
}

}  // namespace
