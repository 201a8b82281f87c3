// The record of a motion: counts of its events, and only what is asked for.
#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "reference/paper_scenes.hpp"
#include "vibro_impact/analysis/analysis.hpp"
#include "vibro_impact/vibro_impact.hpp"

namespace {

using namespace vibro_impact;

TEST(Record, HasOnlyWhatIsAskedFor) {
  const Scene settling = paper::figure3(0.55);
  const OrbitRecord bare = record_of(settling);
  EXPECT_GT(bare.period, 0);
  EXPECT_FALSE(bare.lyapunov.has_value());
  EXPECT_TRUE(bare.impact_velocities.empty());
  EXPECT_TRUE(bare.pairs.empty());
  RecordOptions asked;
  asked.impact_velocities = true;
  const OrbitRecord speeds = record_of(settling, asked);
  EXPECT_EQ(speeds.counts.impacts, bare.counts.impacts);
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
