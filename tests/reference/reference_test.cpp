// Every event of the scenes of Figures 2, 4 and 5 against the 50-digit event tables.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <ostream>

#include "figures/event_tables.hpp"
#include "figures/methods/event_comparison.hpp"
#include "reference/scenes/paper_scenes.hpp"
#include "vibro_impact/vibro_impact.hpp"

namespace {

using namespace vibro_impact;

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

// The tables end a chatter at a speed of 1e-6; the fastest impact of a mass that chatters lies
// between 0.1 and 1.
figures::Differences differences(const PaperRun &run, const std::vector<Event> &events) {
  const auto reference =
      figures::read_event_table(std::string(REFERENCE_DIR "/") + run.name + "_events.csv");
  EXPECT_GT(reference.size(), 100u);
  return compare(
      figures::as_truth(events), reference, run.scene,
      {.period = Clock(run.scene.omega).period, .slow_impact = 1e-5, .contact_modes = true});
}

void expect_agreement(const PaperRun &run, const RunOptions &options) {
  EventRecorder recorder;
  require_complete(simulate(run.scene, run.until, options, recorder));
  const figures::Differences result = differences(run, recorder.events);
  EXPECT_EQ(result.first, "") << run.name;
  EXPECT_LT(result.time, time_tolerance) << run.name;
  EXPECT_LT(result.velocity, time_tolerance) << run.name;
  fmt::print("{}: {} events, largest error {:.2g} in time, {:.2g} in velocity\n", run.name,
             result.matched, result.time, result.velocity);
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

TEST(EventTables, AMissingASpuriousAndAnEventInAnotherModeAreFound) {
  const PaperRun run{"figure2", paper::figure2(), 750.0};
  EventRecorder recorder;
  require_complete(simulate(run.scene, run.until, {}, recorder));
  auto missing = recorder.events, spurious = recorder.events, in_another_mode = recorder.events;
  // A release: an impact late in a chatter may lie beyond a limit, and so be missing rightly.
  const auto k = std::find_if(missing.begin() + 100, missing.end(),
                              [](const Event &event) { return event.kind == EventKind::release; }) -
                 missing.begin();
  missing.erase(missing.begin() + k);
  spurious.insert(spurious.begin() + k, *(spurious.begin() + k));
  auto &held = (in_another_mode.begin() + k)->held;
  held = {1, 1};
  ASSERT_NE(held, (recorder.events.begin() + k)->held);
  EXPECT_EQ(differences(run, recorder.events).first, "");
  for (const auto &events : {missing, spurious, in_another_mode})
    EXPECT_NE(differences(run, events).first, "");
}

}  // namespace
