// Table I: the classifier of pairs of events, and the six scenes.
#include <gtest/gtest.h>

#include <algorithm>

#include "reference/scenes/paper_scenes.hpp"
#include "reference/scenes/table1_scenes.hpp"
#include "reference/truth/case.hpp"
#include "vibro_impact/analysis/analysis.hpp"
#include "vibro_impact/vibro_impact.hpp"

namespace {

using namespace vibro_impact;

std::vector<PairedEvents> pairs_of(const Scene &scene, double until, double from = 0.0) {
  PressedEventRecorder recorder(scene, from);
  require_complete(simulate(scene, until, recorder));
  return event_pairs(recorder.events);
}

int count(const std::vector<PairedEvents> &pairs, EventPair kind) {
  return static_cast<int>(std::count_if(
      pairs.begin(), pairs.end(), [kind](const PairedEvents &pair) { return pair.kind == kind; }));
}

// Each scene shows its pair. It shows no pair of another row of Table I, except the
// sticking-impacts of a chatter next to a sticking mass. The pairs are of codimension one to three:
// a stop moved by 1e-4 undoes those with a condition.
TEST(TableI, EachSceneShowsItsPairAndNoOther) {
  const std::vector<paper::PairScene> scenes = paper::table1_scenes();
  ASSERT_EQ(scenes.size(), all_event_pairs.size());
  for (std::size_t row = 0; row < scenes.size(); ++row) {
    const paper::PairScene &shown = scenes[row];
    const EventPair kind = all_event_pairs[row];
    EXPECT_EQ(shown.pair, abbreviation(kind));
    const auto pairs = pairs_of(shown.scene, shown.to, shown.from);
    EXPECT_GT(count(pairs, kind), 0) << shown.pair;
    for (EventPair other : all_event_pairs)
      if (other != kind && other != EventPair::sticking_impact) {
        EXPECT_EQ(count(pairs, other), 0) << shown.pair << abbreviation(other);
      }
    Scene moved = shown.scene;
    moved.stops[1].position -= 1e-4;
    EXPECT_EQ(count(pairs_of(moved, shown.to, shown.from), kind) > 0,
              kind == EventPair::dual_sticking || kind == EventPair::sticking_impact)
        << shown.pair;
  }
}

using enum EventKind;

PressedEvent event_at(EventKind kind, int mass, double time, Held held, double speed = 0.1,
                      double press = 0.0) {
  PressedEvent pressed{truth::event_at(time, mass, kind, kind == impact ? speed : 0.0), press};
  pressed.event.held = std::move(held);
  return pressed;
}

// The recorders of events take those from their time on, the first of which is at this time.
TEST(EventPairs, ARecorderTakesTheEventAtItsTime) {
  const Scene scene = paper::figure2();
  EventRecorder all;
  require_complete(simulate(scene, 30.0, all));
  ASSERT_GE(all.events.size(), 3u);
  const double from = all.events[2].time;
  PressedEventRecorder pressed(scene, from);
  EventRecorder events(from);
  require_complete(simulate(scene, 30.0, pressed, events));
  ASSERT_FALSE(pressed.events.empty() || events.events.empty());
  EXPECT_EQ(pressed.events.front().event.time, from);
  EXPECT_EQ(events.events.front().time, from);
}

// Within the tolerance of the end of a chatter both readings apply; sticking takes precedence. Two
// impacts pair from the earlier to the later one.
TEST(EventPairs, AnImpactAtTheEndOfAChatterIsAStickingImpact) {
  const auto pairs =
      event_pairs({event_at(impact, 1, 1.0, {0, 0}), event_at(stick, 1, 1.0 + 1e-7, {1, 0}),
                   event_at(impact, 2, 1.0 + 2e-7, {1, 0}), event_at(release, 1, 2.0, {0, 0})});
  EXPECT_EQ(
      pairs,
      (std::vector<PairedEvents>{{1.0 + 2e-7, 1.0 + 2e-7, EventPair::sticking_impact, 1, 2}}));
  EXPECT_EQ(
      event_pairs({event_at(impact, 2, 1.0, {0, 0}), event_at(impact, 1, 1.0 + 2e-7, {0, 0})}),
      (std::vector<PairedEvents>{{1.0, 1.0 + 2e-7, EventPair::double_impact, 1, 2}}));
}

// The force decides about a contact at a speed of 1e-7. A mass that is pulled off grazes. A mass
// that is pressed into its stop, as late in a chatter, hits. So does one whose force is zero within
// 1e-9.
TEST(EventPairs, ASlowContactGrazesOnlyIfTheMassIsPulledOff) {
  for (const double press : {-0.1, -2e-9, -5e-10, 0.0, 0.1}) {
    const auto pairs = event_pairs(
        {event_at(stick, 1, 1.0, {1, 0}), event_at(impact, 2, 1.5, {1, 0}, 1e-7, press)});
    EXPECT_EQ(count(pairs, EventPair::grazing_sticking), press < -1e-9) << press;
    EXPECT_EQ(count(pairs, EventPair::sticking_impact), press > -1e-9) << press;
  }
}

// Phases that follow each other do not pair, nor do those that meet at an instant. Phases that are
// under way as the record begins do, also where both masses are released at the first instant of
// the record.
TEST(EventPairs, DualStickingIsTheCommonPartOfTwoPhases) {
  EXPECT_TRUE(event_pairs({event_at(stick, 1, 1.0, {1, 0}), event_at(release, 1, 2.0, {0, 0}),
                           event_at(stick, 2, 2.5, {0, 1}), event_at(release, 2, 3.0, {0, 0})})
                  .empty());
  for (const double overlap : {0.0, 5e-7})  // within the tolerance of 1e-6
    EXPECT_TRUE(event_pairs({event_at(stick, 1, 1.0, {1, 0}), event_at(stick, 2, 2.0, {1, 1}),
                             event_at(release, 1, 2.0 + overlap, {0, 1}),
                             event_at(release, 2, 3.0, {0, 0})})
                    .empty());
  const std::vector<PairedEvents> expected{{-INFINITY, 1.0, EventPair::dual_sticking, 1, 2}};
  EXPECT_EQ(event_pairs({event_at(release, 1, 1.0, {0, 0}), event_at(release, 2, 1.0, {0, 0})}),
            expected);
  EXPECT_EQ(event_pairs({event_at(release, 1, 1.0, {0, 1}), event_at(release, 2, 1.5, {0, 0})}),
            expected);
}

// Two masses with x2 = 2 x1 hit their stops once in each period, mass 2 later by some 6e-9, which
// is within the tolerance of 1e-6. The section of the record lies between the two impacts.
TEST(EventPairs, APairAcrossTheBeginningOfAPeriodIsFound) {
  const Scene scene{.mass = {1.0, 1.0},
                    .stiffness = {3.0, 2.0},
                    .beta = 0.1,
                    .amplitude = {0.5, 1.0},
                    .omega = 1.0,
                    .restitution = 0.7,
                    .stops = {{1, Side::upper, 0.25}, {2, Side::upper, 0.5 + 1e-8}}};
  const OrbitRecord settled = record_of(scene, {.impacts = true});
  ASSERT_EQ(settled.period, 1);
  const double first = settled.impacts[0].at(0).instant.phase,
               second = settled.impacts[1].at(0).instant.phase;
  ASSERT_LT(first, second);
  const double between = 0.5 * (first + second);
  const MotionState start = Simulation(scene, settled.state).advance(between).state;
  EXPECT_EQ(record_of(scene, start, {.pairs = true}).pairs, std::vector{EventPair::double_impact});
}

}  // namespace
