// Figure 3: its tables against the 50-digit events and what the paper says, and its panels against
// the tables, the printed axes and windows, and the bifurcations.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "figures/frequency_diagram.hpp"
#include "reference/numbers/checked_number.hpp"
#include "tests/support/panels.hpp"

namespace {

using namespace vibro_impact;
using namespace vibro_impact::testing;
using paper::AxisBox;

// The changes of sticking of one kind that a panel shows, against the 50 digits of the points with
// this name.
void expect_changes(const Curve &curve, const std::string &symbol) {
  std::vector<double> known;
  for (const auto &number : numbers::checked_numbers(REFERENCE_DIR))
    if (number.id.starts_with(symbol)) known.push_back(number.value);
  std::sort(known.begin(), known.end());
  ASSERT_EQ(curve.points.size(), known.size()) << symbol;
  for (std::size_t i = 0; i < known.size(); ++i)
    EXPECT_NEAR(curve.points[i][0], known[i], 1e-6) << symbol;  // six digits are written
}

// No two marks of panel (a) or (b) overlap: they stand 0.01 apart across or 0.02 in height.
void expect_marks_apart(const Panel &panel) {
  std::vector<Point> marks;
  for (const std::size_t k : {7u, 8u, 9u})
    marks.insert(marks.end(), panel.curves[k].points.begin(), panel.curves[k].points.end());
  ASSERT_GT(marks.size(), 3u);
  for (std::size_t i = 0; i < marks.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      EXPECT_TRUE(std::abs(marks[i][0] - marks[j][0]) > 0.01 ||
                  std::abs(marks[i][1] - marks[j][1]) > 0.02)
          << marks[i][0] << " and " << marks[j][0];
}

TEST(Figure3, IsDrawnFromTheImpactVelocitiesOfItsMasses) {
  const auto panels = drawn("figure3", folder_of("figure3"));
  ASSERT_EQ(panels.size(), 3u);
  for (const int mass : {1, 2}) {
    const std::string name = mass == 1 ? "figure3a" : "figure3b", v = "v" + std::to_string(mass);
    const AxisBox box = paper::panel(name);
    SCOPED_TRACE(name);
    auto columns = columns_of(folder_of("figure3") + "/" + name + ".csv");
    const std::vector<double> &omega = columns["omega"], &velocity = columns[v];
    ASSERT_GT(omega.size(), 10000u);
    ASSERT_EQ(velocity.size(), omega.size());
    EXPECT_EQ(omega.front(), box.from);
    EXPECT_EQ(omega.back(), box.to);
    for (const double value : velocity)
      ASSERT_EQ(value < 0.0, mass == 1) << "printed: v1 < 0, v2 > 0";
    const auto velocities_at = [&](double frequency) {
      std::vector<double> velocities;
      for (std::size_t i = 0; i < omega.size(); ++i)
        if (std::abs(omega[i] - frequency) < 1e-9 &&
            std::abs(velocity[i]) > paper::slowest_impact_shown)
          velocities.push_back(velocity[i]);
      return velocities;
    };
    // Printed: the speeds of a chatter that ends in sticking fall to zero. In 0.37 to 0.4 those of
    // mass 1 do not: its chatter is incomplete; neither do those of mass 2 there.
    const auto slowest_at = [&](double frequency) {
      const auto velocities = velocities_at(frequency);
      return mass == 1 ? -velocities.back() : velocities.front();
    };
    EXPECT_LT(slowest_at(0.35), 3e-4);
    EXPECT_GT(slowest_at(0.385), 5e-4);

    // At the frequency of Figure 4(a), the velocities of the 50 digits in their last periods.
    const std::vector<Event> events = true_events("figure4a");
    const double last = events.back().time - 2 * Clock(paper::figure4a().omega).period;
    std::vector<double> truth;
    for (const Event &event : select(events, EventKind::impact, mass))
      if (event.time > last && std::abs(event.velocity_before) > paper::slowest_impact_shown)
        truth.push_back(event.velocity_before);
    truth = figures::distinct(truth);
    const auto of_figure4a = velocities_at(paper::figure4a().omega);
    ASSERT_EQ(of_figure4a.size(), truth.size());
    for (std::size_t i = 0; i < truth.size(); ++i) EXPECT_NEAR(of_figure4a[i], truth[i], 1e-8);

    const Panel &panel = panels[static_cast<std::size_t>(mass - 1)];
    expect_axes(panel, name.back(), box, 10);
    ASSERT_EQ(panel.curves.size(), 11u);
    // Printed: the chatter of mass 1 is incomplete from about 0.3 to 0.35 and from 0.37 to 0.4.
    for (const std::size_t k : {0u, 1u}) {
      ASSERT_EQ(panel.curves[k].points.size(), mass == 1 ? 1u : 0u);
      if (mass == 1) {
        EXPECT_EQ(panel.curves[k].points[0][0], k == 0 ? 0.3 : 0.37);
      }
    }
    // The bar is where the mass sticks: its edges below 0.5 are the border orbits.
    EXPECT_EQ(panel.curves[2].colour, colour_of_line_type(7));
    const auto sticks_at = [&](double frequency) {
      const std::vector<Point> &bar = panel.curves[2].points;
      return std::any_of(bar.begin(), bar.end(), [frequency](const Point &point) {
        return std::abs(point[0] - frequency) < 1.3e-4;
      });
    };
    EXPECT_TRUE(sticks_at(0.29));
    EXPECT_EQ(sticks_at(0.32), mass == 2);
    EXPECT_FALSE(sticks_at(0.385));
    EXPECT_TRUE(sticks_at(0.45));
    EXPECT_FALSE(sticks_at(0.48));
    EXPECT_EQ(sticks_at(0.65), mass == 1);
    // Lines from the lower edge, and marks on them.
    const std::string kinds[] = {"border orbit", "multi-sliding", "jump"};
    const std::string symbols[] = {"border", "multi_sliding", "jump"};
    for (const std::size_t k : {0u, 1u, 2u}) {
      const std::string symbol = symbols[k] + "_mass_" + std::to_string(mass);
      expect_changes(panel.curves[3 + k], symbol);
      for (const Point &point : panel.curves[3 + k].points)
        EXPECT_NEAR(point[1], box.lowest, 1e-9) << symbol;
      EXPECT_EQ(panel.curves[7 + k].title, kinds[k]);
      expect_changes(panel.curves[7 + k], symbol);
    }
    expect_marks_apart(panel);
    expect_points(panel.curves[10], omega, velocity);
    EXPECT_EQ(panel.curves[10].colour, colour_of_line_type(mass));
  }
}

// Panel (c) shows that the chatter of mass 1 is complete from 0.331 on, where the paper prints
// 0.35: its speeds fall to the lower edge of the axis within the printed window.
TEST(Figure3, SpeedsOfMass1OnALogarithmicAxis) {
  const auto panels = drawn("figure3", folder_of("figure3_speeds"));
  ASSERT_EQ(panels.size(), 3u);
  const Panel &panel = panels[2];
  ASSERT_EQ(panel.curves.size(), 8u);
  EXPECT_EQ(panel.curves[0].points[0][0], 0.3);
  EXPECT_EQ(panel.curves[1].points[0][0], 0.37);
  auto columns = columns_of(folder_of("figure3_speeds") + "/figure3a.csv");
  std::vector<double> speeds = columns["v1"];
  for (double &speed : speeds) speed = -speed;
  expect_points(panel.curves[6], columns["omega"], speeds);
  const auto slowest_from = [&](double from, double to) {
    double slowest = 1.0;
    for (const Point &point : panel.curves[6].points)
      if (point[0] > from && point[0] < to) slowest = std::min(slowest, point[1]);
    return slowest;
  };
  // Impacts follow each other at speeds in the ratio r = 0.7.
  const double edge = paper::slowest_impact_shown;
  EXPECT_GT(slowest_from(0.31, 0.32), 30 * edge);
  for (double omega = 0.332; omega < 0.367; omega += 0.005)
    EXPECT_LT(slowest_from(omega, omega + 0.001), edge / 0.69) << omega;
  expect_changes(panel.curves[3], "border_mass_1");
}

TEST(Figure3, EqualVelocitiesCountOnce) {
  EXPECT_EQ(figures::distinct({-0.1, -0.2, -0.1 * (1.0 + 1e-9), -0.2}),
            (std::vector{-0.2, -0.1 * (1.0 + 1e-9)}));
  EXPECT_EQ(figures::distinct({1e-4, 1.001e-4}).size(), 2u);
}

}  // namespace
