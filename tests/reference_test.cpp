// Every event of the scenes of Figures 2, 4 and 5 against the 50-digit event tables.
#include <gtest/gtest.h>

#include <ostream>

#include "event_tables.hpp"
#include "paper_scenes.hpp"

namespace {

using namespace vibro_impact;
using namespace vibro_impact::testing;

struct PaperRun {
  const char *name;
  Scene scene;
  double until;
};

// What the test's name shows of a parameter.
void PrintTo(const PaperRun &run, std::ostream *out) {
  *out << run.name;
}

// 1e-10 in time: what the suite promises. Measured: below 6e-12 (Figure 4, where the distance to
// the multi-sliding point is 4e-5 in force and the motion is that much more sensitive), 3e-13
// elsewhere, which is a unit or two in the last place of t.
constexpr double time_tolerance = 1e-10;

void expect_agreement(const PaperRun &run, const RunOptions &options) {
  EventRecorder recorder;
  simulate(run.scene, run.until, options, recorder);
  const auto reference =
      read_event_table(std::string(REFERENCE_DIR "/") + run.name + "_events.csv");
  ASSERT_GT(reference.size(), 100u);
  const Comparison result = compare(recorder.events, reference);
  EXPECT_EQ(result.difference, "") << run.name;
  EXPECT_LT(result.worst_time, time_tolerance) << run.name;
  EXPECT_LT(result.worst_velocity, time_tolerance) << run.name;
  fmt::print(
      "{}: {} events, largest error {:.2g} in time, {:.2g} in velocity; {} impacts beyond "
      "the chatter limits\n",
      run.name, result.matched, result.worst_time, result.worst_velocity, result.beyond_the_limit);
}

class PaperScenes : public ::testing::TestWithParam<PaperRun> {};

TEST_P(PaperScenes, AgreeEventForEventWithChatterLimits) {
  expect_agreement(GetParam(), {});
}

TEST_P(PaperScenes, AgreeEventForEventWithChatterResolvedDownTo1e6) {
  RunOptions options;
  options.resolve_chatter = 1e-6;
  expect_agreement(GetParam(), options);
}

TEST_P(PaperScenes, AgreeEventForEventWithChatterResolvedToRounding) {
  RunOptions options;
  options.resolve_chatter = 0.0;
  expect_agreement(GetParam(), options);
}

INSTANTIATE_TEST_SUITE_P(Figures, PaperScenes,
                         ::testing::Values(PaperRun{"figure2", paper::figure2(), 750.0},
                                           PaperRun{"figure4a", paper::figure4a(), 750.0},
                                           PaperRun{"figure4b", paper::figure4b(), 750.0},
                                           PaperRun{"figure5a", paper::figure5a(), 964.0},
                                           PaperRun{"figure5b", paper::figure5b(), 930.0},
                                           PaperRun{"figure5c", paper::figure5c(), 1000.0}),
                         [](const auto &run) { return std::string(run.param.name); });

TEST(EventTables, AMissingOrSpuriousEventIsFound) {
  EventRecorder recorder;
  simulate(paper::figure2(), 750.0, {}, recorder);
  const auto reference = read_event_table(REFERENCE_DIR "/figure2_events.csv");
  auto missing = recorder.events, spurious = recorder.events;
  missing.erase(missing.begin() + 40);
  spurious.insert(spurious.begin() + 40, spurious[39]);
  EXPECT_NE(compare(missing, reference).difference, "");
  EXPECT_NE(compare(spurious, reference).difference, "");
}

}  // namespace
