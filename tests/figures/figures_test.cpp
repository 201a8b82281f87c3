// What the paper's text says of Figure 3 beside the key numbers (`check`), the
// corrections and the axis boxes (reconstruction_test).
#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>
#include <string>
#include <vector>

#include "figures/figure3.hpp"
#include "reference/paper_scenes.hpp"
#include "tests/events.hpp"

namespace {

using namespace vibro_impact;
using namespace vibro_impact::testing;

// Chatter resolved as far as Figure 3 shows impacts.
const RunOptions shown{.resolve_chatter = paper::slowest_impact_shown};

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
    const auto events = events_of(paper::figure3(at.omega), from, from + 10 * period, shown);
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

TEST(Figure3, EqualVelocitiesCountOnce) {
  EXPECT_EQ(figures::distinct({-0.1, -0.2, -0.1 * (1.0 + 1e-9), -0.2}),
            (std::vector{-0.2, -0.1 * (1.0 + 1e-9)}));
  EXPECT_EQ(figures::distinct({1e-4, 1.001e-4}).size(), 2u);
}

TEST(Figure3, IncompleteChatterFallsButNotToZero) {
  for (double omega : {0.31, 0.385}) {
    const double period = Clock(omega).period, from = 150 * period;
    const auto impacts =
        select(events_of(paper::figure3(omega), from, from + period, shown), EventKind::impact, 1);
    ASSERT_GE(impacts.size(), 5u) << omega;
    double slowest = 1.0;
    for (const Event &impact : impacts) slowest = std::min(slowest, -impact.velocity_before);
    EXPECT_LT(slowest, 0.01) << omega;
    EXPECT_GT(slowest, paper::slowest_impact_shown) << omega;
  }
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

}  // namespace
