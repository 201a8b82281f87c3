// The numbers behind Figures 2 to 4: what the paper's text says of each, and what its axes show.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>
#include <string>
#include <vector>

#include "figures/beyond/reconstruction.hpp"
#include "figures/figure3.hpp"
#include "paper_runs.hpp"

namespace {

using namespace vibro_impact;
using namespace vibro_impact::testing;

TEST(Figure2, ExtremesAndAxisBox) {
  const auto samples = sampled(paper::figure2(), paper::figure2a_box);
  ASSERT_EQ(samples.times.size(), 10001u);
  double lowest[2] = {0.0, 0.0}, highest[2] = {0.0, 0.0};
  for (std::size_t i = 0; i < samples.displacements.size(); ++i) {
    lowest[i % 2] = std::min(lowest[i % 2], samples.displacements[i]);
    highest[i % 2] = std::max(highest[i % 2], samples.displacements[i]);
  }
  EXPECT_NEAR(lowest[1], -0.48450590646629980362, sampled_extreme);  // computed
  EXPECT_NEAR(highest[0], 0.35273193914599022422, sampled_extreme);  // computed
  // The stops themselves are reached while the masses stick; a sample is read off the modal sum, a
  // few roundings from the stop.
  EXPECT_NEAR(lowest[0], -0.3, 1e-15);
  EXPECT_NEAR(highest[1], 0.1, 1e-15);
}

// Every axis ends at the first tick beyond the data.
TEST(Figure2, CurvesFillTheAxisBoxes) {
  const paper::AxisBox &a = paper::figure2a_box, &b = paper::figure2b_box;
  const figures::Range both = figures::range_of(sampled(paper::figure2(), a)),
                       second = figures::range_of(sampled(paper::figure2(), b), 2);
  EXPECT_TRUE(figures::fills(both, figures::ordinate(a), a.tick));
  EXPECT_TRUE(figures::fills(second, figures::ordinate(b), b.tick));
  EXPECT_NEAR(second.lowest, -0.046371146410932786357, sampled_extreme);  // computed
}

TEST(Figure2, BothMassesChatterAndStickOncePerForcingPeriod) {
  const Scene scene = paper::figure2();
  EventRecorder recorder;
  const Outcome outcome = simulate(scene, 750.0, {}, recorder);
  EXPECT_EQ(outcome.counters.sticks, 66);    // computed
  EXPECT_EQ(outcome.counters.releases, 66);  // computed
  // Some 1,200 impacts are resolved before the limit is taken; 8,287 are computed down to 1e-20.
  EXPECT_LT(outcome.counters.impacts, 2500);
  const long long last = instant_at(750.0, Clock(scene.omega)).cycle;
  ASSERT_EQ(last, 33);
  for (long long cycle = 5; cycle < last; ++cycle) {
    for (int mass : {1, 2}) {
      int sticks = 0, releases = 0, falling = 0;
      double slower = std::numeric_limits<double>::infinity();
      for (const Event &event : recorder.events) {
        if (event.instant.cycle != cycle || event.mass != mass) continue;
        if (event.kind == EventKind::release) ++releases;
        if (event.kind == EventKind::impact) {
          falling = std::abs(event.velocity_before) < slower ? falling + 1 : 0;
          slower = std::abs(event.velocity_before);
        }
        if (event.kind != EventKind::stick) continue;
        ++sticks;
        EXPECT_GE(falling, 5) << "a stick follows a chatter: cycle " << cycle << " mass " << mass;
      }
      EXPECT_EQ(sticks, 1) << "cycle " << cycle << " mass " << mass;
      EXPECT_EQ(releases, 1) << "cycle " << cycle << " mass " << mass;
    }
  }
}

TEST(Figure2, ChatterOfMassTwoIsCompleteInTheWindowOfTheCloseUp) {
  const paper::AxisBox &box = paper::figure2b_box;
  for (double resolve : {std::numeric_limits<double>::infinity(), paper::slowest_impact_shown}) {
    const auto events = events_of(paper::figure2(), box.from, box.to, resolve);
    const auto impacts = select(events, EventKind::impact, 2);
    ASSERT_FALSE(impacts.empty());
    EXPECT_NEAR(impacts[0].time, 715.56156451066145933, same_time);  // computed
    const auto sticks = select(events, EventKind::stick, 2);
    ASSERT_EQ(sticks.size(), 1u);
    EXPECT_NEAR(sticks[0].time, 721.54276485739570569, same_time);  // computed
    EXPECT_TRUE(select(events, EventKind::release, 2).empty()) << "it sticks to the end";
    EXPECT_TRUE(select(events, EventKind::impact, 2, sticks[0].time).empty());
  }
}

struct Frequency {
  double omega;
  bool first_sticks, second_sticks;
};

// Sticking of the settled motion from rest. Where mass 1 does not stick between two regions where
// it does, its chatter is incomplete: the paper prints Omega of about 0.3 to 0.35 and 0.37 to 0.4,
// the simulation gives 0.297 to 0.331 and 0.368 to 0.404 (on a grid of 0.00025); both edges of each
// are taken in.
constexpr Frequency sticking_at[] = {
    {0.27, true, true},   {0.2955, true, true},  {0.2985, false, true}, {0.31, false, true},
    {0.32, false, true},  {0.33, false, true},   {0.332, true, true},   {0.35, true, true},
    {0.3665, true, true}, {0.369, false, false}, {0.385, false, false}, {0.403, false, false},
    {0.405, true, true},  {0.45, true, true},    {0.468, false, true},  {0.478, false, false},
    {0.5, false, false},  {0.55, false, false},  {0.6, false, false}};

TEST(Figure3, StickingAndSignsOfTheImpactVelocities) {
  for (const Frequency &at : sticking_at) {
    const double period = Clock(at.omega).period, from = 150 * period;
    const auto events = events_of(paper::figure3(at.omega), from, from + 10 * period, 1e-4);
    EXPECT_EQ(!select(events, EventKind::stick, 1).empty(), at.first_sticks) << at.omega;
    EXPECT_EQ(!select(events, EventKind::stick, 2).empty(), at.second_sticks) << at.omega;
    ASSERT_FALSE(select(events, EventKind::impact, 1).empty()) << at.omega;
    ASSERT_FALSE(select(events, EventKind::impact, 2).empty()) << at.omega;
    for (const Event &event : events) {
      if (event.kind != EventKind::impact) continue;
      const double speed = event.mass == 1 ? -event.velocity_before : event.velocity_before;
      EXPECT_GT(speed, 0.0) << at.omega;                          // printed: v1 < 0, v2 > 0
      EXPECT_LT(speed, paper::figure3b_box.highest) << at.omega;  // and the axis boxes to 0.4
    }
  }
}

TEST(Figure3, IncompleteChatterFallsButNotToZero) {
  for (double omega : {0.31, 0.385}) {
    const double period = Clock(omega).period, from = 150 * period;
    const auto impacts =
        select(events_of(paper::figure3(omega), from, from + period, 1e-4), EventKind::impact, 1);
    ASSERT_GE(impacts.size(), 5u) << omega;
    double slowest = 1.0;
    for (const Event &impact : impacts) slowest = std::min(slowest, -impact.velocity_before);
    EXPECT_LT(slowest, 0.01) << omega;
    EXPECT_GT(slowest, paper::slowest_impact_shown) << omega;
  }
}

// Beyond what the paper says ("sticking motions all exist at Omega < 0.5"): from rest, mass 1 comes
// to stick again above 0.632, every second forcing period at 0.65. Confirmed by the 50-digit
// generator, whose stick in period 59 is compared with here. Mass 2 does not stick there.
TEST(Figure3, MassOneSticksAgainNearTheUpperEnd) {
  const double period = Clock(0.65).period;
  const auto events = events_of(paper::figure3(0.65), 58 * period, 60 * period, 1e-4);
  const auto sticks = select(events, EventKind::stick, 1);
  ASSERT_EQ(sticks.size(), 1u);
  EXPECT_NEAR(sticks[0].time, 565.91437636579, same_time);
  EXPECT_TRUE(select(events, EventKind::stick, 2).empty());
}

TEST(Figure3, TablesDoNotDependOnTheNumberOfThreads) {
  std::vector<double> omegas;
  for (int i = 0; i < 12; ++i) omegas.push_back(0.7 - 0.03 * i);  // chaotic ones first
  const auto tables = [&](int threads) {
    SweepOptions sweeping;
    sweeping.threads = threads;
    sweeping.block = 1;
    return figures::diagram_from_rest(omegas, figures::recorded_in_figure3(5), sweeping);
  };
  const auto one = tables(1), two = tables(2), four = tables(4);
  for (std::size_t mass : {0u, 1u}) {
    const std::string &text = one.velocities[mass].text;
    EXPECT_GT(std::count(text.begin(), text.end(), '\n'), 50);
    EXPECT_EQ(text, two.velocities[mass].text);
    EXPECT_EQ(text, four.velocities[mass].text);
  }
  EXPECT_EQ(std::count(one.orbits.text.begin(), one.orbits.text.end(), '\n'), 13);
  EXPECT_EQ(one.orbits.text, two.orbits.text);
  EXPECT_EQ(one.orbits.text, four.orbits.text);
}

TEST(Figure3, ErrorsLeaveTheParallelLoop) {
  EXPECT_THROW(figures::diagram_from_rest({0.3, -1.0, 0.4}, figures::recorded_in_figure3(1), {}),
               std::invalid_argument);
}

// The rows of a table below its header, without the last cell.
std::vector<std::string> rows_of(const Table &table) {
  std::vector<std::string> rows;
  std::istringstream stream(table.text);
  for (std::string row; std::getline(stream, row);) rows.push_back(row.substr(0, row.rfind(',')));
  rows.erase(rows.begin());
  return rows;
}

// Where motions coexist, what is found depends on where it came from: followed upwards and
// downwards, impacts and periods are the same at most frequencies, but not at all.
TEST(Figure3, FollowedBothWaysThereAreMotionsThatCoexist) {
  std::vector<double> omegas = figures::frequencies_of_figure3(181);
  RecordOptions options = figures::recorded_in_figure3(5);
  options.settle.longest = 100;
  const auto up = rows_of(figures::diagram_followed(omegas, options, [] {}).orbits);
  std::reverse(omegas.begin(), omegas.end());
  auto down = rows_of(figures::diagram_followed(omegas, options, [] {}).orbits);
  std::reverse(down.begin(), down.end());
  ASSERT_EQ(up.size(), 181u);
  ASSERT_EQ(down.size(), 181u);
  int different = 0;
  for (std::size_t i = 0; i < up.size(); ++i) different += up[i] != down[i] ? 1 : 0;
  EXPECT_GT(different, 0);
  EXPECT_LT(different, 90);
}

TEST(Figure3, EqualVelocitiesCountOnce) {
  EXPECT_EQ(figures::distinct({-0.1, -0.2, -0.1 * (1.0 + 1e-9), -0.2}),
            (std::vector{-0.2, -0.1 * (1.0 + 1e-9)}));
  EXPECT_EQ(figures::distinct({1e-4, 1.001e-4}).size(), 2u);
}

// Figure 4: sticking phases of mass 1 in one settled forcing period, with the hold force along
// them.
struct HeldPeriod {
  HoldForceRecorder force;
  std::vector<Event> events;
  double start = 0.0;
};
HeldPeriod held_period(const Scene &scene) {
  HeldPeriod held;
  const double period = Clock(scene.omega).period;
  held.start = paper::figure4_settling_periods * period;
  held.force.mass = 1;
  held.force.from = held.start;
  held.force.to = held.start + period;
  held.force.every = 0.001;
  EventRecorder events{held.start};
  require_complete(simulate(scene, held.force.to, {}, held.force, events));
  held.events = events.events;
  return held;
}

void expect_in_the_box(const HeldPeriod &held) {
  const paper::AxisBox &box = paper::figure4_box;
  for (const auto &row : held.force.rows) {
    EXPECT_GT(row.time - held.start, box.from);
    EXPECT_LT(row.time - held.start, box.to);
    EXPECT_GT(row.force, box.lowest);
    // Pressed to the lower stop all along: negative, and zero at a release to within rounding.
    EXPECT_LT(row.force, 1e-15);
  }
}

TEST(Figure4, JustBeforeMultiSlidingTheForceTurnsShortOfZero) {
  const HeldPeriod held = held_period(paper::figure4a());
  expect_in_the_box(held);
  EXPECT_EQ(select(held.events, EventKind::stick, 1).size(), 1u);
  EXPECT_EQ(select(held.events, EventKind::release, 1).size(), 1u);
  double nearest = -1.0;
  for (const auto &row : held.force.rows)
    if (row.time - held.start < 15.0) nearest = std::max(nearest, row.force);
  EXPECT_LT(nearest, 0.0);
  // Computed. A sample lies within 0.0005 of the maximum, where |F''| < 0.2: off by less
  // than 2.5e-8.
  EXPECT_NEAR(nearest, -4.4585327530179651567e-05, 2.5e-8);
}

TEST(Figure4, JustAfterMultiSlidingThePhaseIsSplitByAChatter) {
  const HeldPeriod held = held_period(paper::figure4b());
  expect_in_the_box(held);
  const auto sticks = select(held.events, EventKind::stick, 1);
  const auto releases = select(held.events, EventKind::release, 1);
  ASSERT_EQ(sticks.size(), 2u);
  ASSERT_EQ(releases.size(), 2u);
  EXPECT_LT(sticks[0].time, releases[0].time);
  EXPECT_LT(releases[0].time, sticks[1].time);
  const auto chatter = select(held.events, EventKind::impact, 1, releases[0].time, sticks[1].time);
  ASSERT_GE(chatter.size(), 5u);
  for (std::size_t i = 1; i < chatter.size(); ++i)
    EXPECT_LT(-chatter[i].velocity_before, -chatter[i - 1].velocity_before);
  // One sticking phase starts, the other ends where that of panel (a) does, to the eye (0.05 on an
  // axis of 5.5).
  const HeldPeriod before = held_period(paper::figure4a());
  const auto stick = select(before.events, EventKind::stick, 1);
  const auto release = select(before.events, EventKind::release, 1);
  EXPECT_NEAR(sticks[0].instant.phase, stick[0].instant.phase, 0.05);
  EXPECT_NEAR(releases[1].instant.phase, release[0].instant.phase, 0.05);
}

}  // namespace
