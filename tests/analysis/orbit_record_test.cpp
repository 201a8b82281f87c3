// What is recorded of a motion: counts of events, and only what is asked for.
#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "reference/scenes/paper_scenes.hpp"
#include "vibro_impact/analysis/analysis.hpp"
#include "vibro_impact/vibro_impact.hpp"

namespace {

using namespace vibro_impact;

EventMark impact(std::size_t stop, int falling) {
  return {EventKind::impact, stop, falling, false};
}

TEST(EventCounts, ACompleteChatterGoesOnOverTheEndOfThePeriods) {
  const Scene scene = paper::figure2();
  const EventMark stick{EventKind::stick, 0, 0, false}, release{EventKind::release, 0, 0, false};
  // At stop 1 a chatter that begins near the end and completes near the beginning; at stop 2 one
  // that falls, and ends in flight.
  const std::vector<EventMark> marks = {impact(0, 2), stick,        impact(1, 0),
                                        impact(1, 1), release,      impact(1, 2),
                                        impact(0, 0), impact(0, 0), impact(0, 1)};
  const EventCounts counts = counts_of(scene, marks, 1, false);
  EXPECT_EQ(counts.impacts, (std::vector{1, 3}));
  EXPECT_EQ(counts.sticks, (std::vector{1, 0}));
  EXPECT_EQ(counts.chatters, (std::vector{1, 0}));
  EXPECT_FALSE(counts.dual_sticking);
  EXPECT_TRUE(counts_of(scene, marks, 1, true).dual_sticking);
}

TEST(Record, OnlyWhatIsAskedForIsComputed) {
  const Scene settling = paper::figure3(0.55), chaotic = paper::figure3(0.69);
  RecordOptions plain;
  const OrbitRecord bare = record_of(settling, plain), none = record_of(chaotic, plain);
  EXPECT_EQ(bare.work.recorded, 0);
  EXPECT_EQ(bare.work.with_tangents, 0);
  EXPECT_FALSE(bare.lyapunov.has_value());
  EXPECT_TRUE(bare.impact_velocities.empty());
  EXPECT_EQ(bare.counters.modal_evaluations, bare.work.settling) << "one look at every section";
  EXPECT_EQ(none.period, 0);
  EXPECT_EQ(none.work.recorded, plain.counted);
  EXPECT_EQ(none.work.with_tangents, 0);

  RecordOptions asked = plain;
  asked.lyapunov = true;
  EXPECT_EQ(record_of(settling, asked).work.with_tangents, bare.period);
  EXPECT_EQ(record_of(settling, asked).work.recorded, 0);
  EXPECT_EQ(record_of(chaotic, asked).work.with_tangents, 160) << "until the sign is certain";
  asked = plain;
  asked.impact_velocities = true;
  const OrbitRecord speeds = record_of(settling, asked);
  EXPECT_EQ(speeds.work.recorded, bare.period);
  EXPECT_TRUE(bare.pairs.empty());
  asked = plain;
  asked.pairs = true;
  EXPECT_EQ(record_of(settling, asked).work.recorded, 2 * bare.period);
  EXPECT_EQ(speeds.impact_velocities[0].size(), static_cast<std::size_t>(bare.counts.impacts[0]));
}

// Figure 5, Section 3.3: mass 2 hits while mass 1 sticks in (a) and (c), in which nothing else of
// Table I occurs; in (b) nothing does, mass 2 turning short of its stop. Both are held at once with
// the stop of mass 2 below that of mass 1.
TEST(Record, ThePairsOfTableIThatOccur) {
  RecordOptions options;
  options.pairs = true;
  const auto pairs_of = [&](const Scene &scene) { return record_of(scene, options).pairs; };
  EXPECT_EQ(pairs_of(paper::figure5a()), std::vector{EventPair::sticking_impact});
  EXPECT_EQ(pairs_of(paper::figure5b()), std::vector<EventPair>{});
  Scene lower = paper::figure5a();
  lower.stops[1].position = 0.2;
  const std::vector<EventPair> both = pairs_of(lower);
  EXPECT_EQ(std::count(both.begin(), both.end(), EventPair::dual_sticking), 1);
}

}  // namespace
