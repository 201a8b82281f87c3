// The records of settled motions.
#include <gtest/gtest.h>

#include <vector>

#include "reference/scenes/paper_scenes.hpp"
#include "vibro_impact/analysis/analysis.hpp"
#include "vibro_impact/vibro_impact.hpp"

namespace {

using namespace vibro_impact;

// The record of a motion has counts of its events, and only what is asked for.
TEST(Record, HasOnlyWhatIsAskedFor) {
  const Scene settling = paper::figure3(0.55);
  const OrbitRecord bare = record_of(settling);
  EXPECT_GT(bare.period, 0);
  EXPECT_FALSE(bare.lyapunov.has_value());
  EXPECT_TRUE(bare.impacts.empty());
  EXPECT_TRUE(bare.pairs.empty());
  RecordOptions asked;
  asked.impacts = true;
  const OrbitRecord speeds = record_of(settling, asked);
  EXPECT_EQ(speeds.counts.impacts, bare.counts.impacts);
  EXPECT_EQ(speeds.impacts[0].size(), static_cast<std::size_t>(bare.counts.impacts[0]));
  EXPECT_LT(speeds.impacts[0].front().velocity_before, 0.0) << "mass 1 hits a lower stop";
  EXPECT_GT(speeds.impacts[1].front().velocity_before, 0.0) << "mass 2 hits an upper stop";
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

// A chatter goes on over the section. The events of one period from there on begin with impacts of
// this chatter, which are not counted either.
TEST(Record, ACompleteChatterAtTheSectionIsNotCounted) {
  const Scene scene = paper::figure3(0.3);
  const OrbitRecord record = record_of(scene);
  ASSERT_EQ(record.period, 1);
  EventRecorder recorder(-infinity);
  stroboscopic_map(scene, record.state, 1, {}, recorder);
  const EventCounts counts = counts_of(scene, recorder.events, 1, record.state.held);
  EXPECT_EQ(counts.impacts, record.counts.impacts);
  EXPECT_EQ(counts.sticks, record.counts.sticks);
}

// The pairs themselves are those of event_pairs_test; Figure 5(b) has none.
TEST(Record, ThePairsOfTableIThatOccur) {
  const RecordOptions options{.settle = {}, .pairs = true};
  EXPECT_EQ(record_of(paper::figure5a(), options).pairs, std::vector{EventPair::sticking_impact});
  EXPECT_TRUE(record_of(paper::figure5b(), options).pairs.empty());
}

// A state of a neighbouring scene is a start: a mass that is held moves with its stop, a mass
// beyond a stop moves to it, and the phase stays within the period.
TEST(StartNear, BringsAStateIntoTheScene) {
  Scene scene = paper::figure2();
  MotionState state = start_of(scene);
  state.displacement = {-0.3, 0.05};
  state.velocity = {0.0, 0.2};
  state.held = {-1, 0};
  state.instant.phase = 0.9 * Clock(scene.omega).period;
  scene.omega *= 1.5;
  scene.stops[0].position = -0.25;
  scene.stops[1].position = 0.04;
  const MotionState start = start_near(scene, state);
  EXPECT_EQ(start.displacement, (std::vector<double>{-0.25, 0.04}));
  EXPECT_EQ(start.velocity, state.velocity);
  EXPECT_EQ(start.held, state.held);
  EXPECT_LT(start.instant.phase, Clock(scene.omega).period);
  EXPECT_NO_THROW(require_complete(Simulation(scene, start).advance(time_after(scene, start, 1))));
}

}  // namespace
