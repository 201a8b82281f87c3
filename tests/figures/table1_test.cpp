// Table I and the exit boundaries: each picture against the parameters of its scenes and the tables
// of its driver.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "reference/scenes/table1_scenes.hpp"
#include "tests/support/panels.hpp"

namespace {

using namespace vibro_impact;
using namespace vibro_impact::testing;

// Every panel says its parameters, and marks the event of each mass of its pair: an open circle
// where it grazes (curves 6 and 7), a dot where it impacts (8 and 9), no mark where it sticks.
TEST(Table1, EveryPanelSaysItsParametersAndMarksItsEvents) {
  const std::string folder = folder_of("table1");
  const auto panels = drawn("table1", folder);
  const auto texts = texts_of(folder + "/table1.svg");
  const auto scenes = paper::table1_scenes();
  const auto pairs = truth::read_rows(folder + "/table1_pairs.csv", 8);
  ASSERT_EQ(panels.size(), scenes.size());
  const std::string events[][2] = {{"G", "G"}, {"S", "S"}, {"I", "I"},
                                   {"S", "G"}, {"G", "I"}, {"S", "I"}};  // of masses 1 and 2
  for (std::size_t n = 0; n < scenes.size(); ++n) {
    const auto &[name, scene, from, to] = scenes[n];
    SCOPED_TRACE(name);
    const double s1 = scene.stops[0].position, s2 = scene.stops[1].position;
    const std::string stops = s1 == s2 ? fmt::format("s₁ = s₂ = {:.5g}", s1)
                                       : fmt::format("s₁ = {:.5g},  s₂ = {:.5g}", s1, s2);
    const std::string parameters =
        fmt::format("Ω = {:.6g},  r = {:g},  {}", scene.omega, scene.restitution, stops);
    EXPECT_EQ(texts.count(parameters), 1u) << parameters;
    ASSERT_EQ(panels[n].curves.size(), 10u);
    for (const std::size_t mass : {1u, 2u})
      for (const auto &[letter, curve] : {std::pair{"G", panels[n].curves[5 + mass]},
                                          std::pair{"I", panels[n].curves[7 + mass]}}) {
        std::vector<double> times, heights;
        for (const auto &pair : pairs) {
          if (pair[0] != name || events[n][mass - 1] != letter) continue;
          times.push_back(std::stod(pair[1]));
          heights.push_back(std::stod(pair[2 + mass]));
          EXPECT_NEAR(heights.back(), scene.stops[mass - 1].position, 1e-6)
              << "the events of a pair are up to 1e-6 apart";
        }
        EXPECT_EQ(times.empty(), events[n][mass - 1] != letter) << letter << " of mass " << mass;
        expect_points(curve, times, heights);
      }
  }
}

// The bold curve of (a) is the last of all sticking phases of mass 2 from its stick to its release.
TEST(ExitBoundary, TheLastStickingPhaseIsBold) {
  const std::string folder = folder_of("exit_boundary");
  const auto panels = drawn("exit_boundary", folder);
  ASSERT_EQ(panels.size(), 2u);
  ASSERT_EQ(panels[0].curves.size(), 8u);
  const Curve &all = panels[0].curves[3], &last = panels[0].curves[4];
  EXPECT_EQ(last.title, "the last time");
  std::vector<double> x, v;
  int phase = 0;
  std::vector<int> released;
  const auto rows = truth::read_rows(folder + "/exit_boundary2.csv", 5);
  for (const auto &row : rows) {
    EXPECT_NE(row[1], "gap") << "no sticking phase";
    if (row[1] == "release") released.push_back(std::stoi(row[0]));
  }
  ASSERT_GT(released.size(), 5u);
  phase = released.back();
  for (const auto &row : rows)
    if (row[1] == "orbit" && std::stoi(row[0]) == phase) {
      x.push_back(std::stod(row[3]));
      v.push_back(std::stod(row[4]));
    }
  expect_points(last, x, v);
  EXPECT_GT(all.points.size(), 5 * last.points.size());
}

}  // namespace
