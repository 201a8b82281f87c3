// The record of a motion: counts of its events, and only what is asked for.
#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "reference/paper_scenes.hpp"
#include "vibro_impact/analysis/analysis.hpp"
#include "vibro_impact/vibro_impact.hpp"

namespace {

using namespace vibro_impact;

TEST(Record, OnlyWhatIsAskedForIsComputed) {
  const Scene settling = paper::figure3(0.55), chaotic = paper::figure3(0.69);
  RecordOptions plain;
  const OrbitRecord bare = record_of(settling, plain), none = record_of(chaotic, plain);
  EXPECT_EQ(bare.work.recorded, 0);
  EXPECT_EQ(bare.work.with_tangents, 0);
  EXPECT_FALSE(bare.lyapunov.has_value());
  EXPECT_TRUE(bare.impact_velocities.empty());
  const SettledMotion motion = settle(settling, start_of(settling));
  EXPECT_EQ(motion.counters.modal_evaluations, motion.periods_run) << "one look at every section";
  EXPECT_EQ(none.period, 0);
  EXPECT_EQ(none.work.recorded, plain.counted);
  EXPECT_EQ(none.work.with_tangents, 0);

  RecordOptions asked = plain;
  asked.lyapunov = true;
  EXPECT_EQ(record_of(settling, asked).work.with_tangents, bare.period);
  EXPECT_EQ(record_of(settling, asked).work.recorded, 0);
  // At least four blocks of 40 periods; a strong growth is certain long before the 1,000 allowed.
  const long long followed = record_of(chaotic, asked).work.with_tangents;
  EXPECT_EQ(followed % 40, 0);
  EXPECT_GE(followed, 160);
  EXPECT_LT(followed, 1000);
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

// Pressed onto their stops for ever: no event says so.
TEST(Record, MassesThatAreHeldFromTheBeginningStickAtOnce) {
  Scene scene = paper::two_masses({1, Side::lower, 0.1}, {2, Side::lower, 0.15}, 0.7, 0.3);
  scene.amplitude = {0.01, 0.0};
  scene.displacement = {0.1, 0.15};
  const EventCounts counts = record_of(scene).counts;
  EXPECT_TRUE(counts.dual_sticking);
  EXPECT_EQ(counts.sticks, (std::vector{0, 0}));
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
