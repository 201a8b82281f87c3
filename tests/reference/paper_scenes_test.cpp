// The paper's scenes are written down once, in reference/paper_scenes.hpp. Where they have
// to be written once more, beside their words in the table of key numbers, in the defaults of the
// scene runner and in the examples, which users copy, they are the same.
#include <gtest/gtest.h>

#include <cstddef>
#include <map>
#include <string>

#include "lib/examples/paper_scene.hpp"
#include "program/options.hpp"
#include "reference/paper_scenes.hpp"
#include "reference/table_reader.hpp"

namespace {

using namespace vibro_impact;

void expect_equal(const Scene &scene, const Scene &other) {
  EXPECT_EQ(scene.mass, other.mass);
  EXPECT_EQ(scene.stiffness, other.stiffness);
  EXPECT_EQ(scene.beta, other.beta);
  EXPECT_EQ(scene.amplitude, other.amplitude);
  EXPECT_EQ(scene.omega, other.omega);
  EXPECT_EQ(scene.restitution, other.restitution);
  ASSERT_EQ(scene.stops.size(), other.stops.size());
  for (std::size_t i = 0; i < scene.stops.size(); ++i) {
    EXPECT_EQ(scene.stops[i].mass, other.stops[i].mass);
    EXPECT_EQ(scene.stops[i].side, other.stops[i].side);
    EXPECT_EQ(scene.stops[i].position, other.stops[i].position);
    EXPECT_EQ(scene.stops[i].restitution, other.stops[i].restitution);
  }
}

// The words for these numbers stand in a table, and the numbers beside them.
TEST(PaperScenes, AreThoseOfTheTableOfKeyNumbers) {
  const auto stated = figures::read_references(REFERENCE_DIR "/key_numbers.csv");
  using namespace paper;
  const Scene two = figure2(), a = figure5a(), b = figure5b(), c = figure5c();
  std::map<std::string, double> expected{{"m", two.mass[0]},
                                         {"k", two.stiffness[0]},
                                         {"c", two.beta * two.stiffness[0]},
                                         {"r", two.restitution},
                                         {"A1", two.amplitude[0]},
                                         {"A2", two.amplitude[1]},
                                         {"figure2_s1", two.stops[0].position},
                                         {"figure2_s2", two.stops[1].position},
                                         {"figure2_Omega", two.omega},
                                         {"figure3_Omega_min", figure3a_box.from},
                                         {"figure3_Omega_max", figure3a_box.to},
                                         {"figure3a_v1_min", figure3a_box.lowest},
                                         {"figure3b_v2_max", figure3b_box.highest},
                                         {"multi_sliding_Omega_below", figure4a().omega},
                                         {"multi_sliding_Omega_above", figure4b().omega},
                                         {"figure5a_s1", a.stops[0].position},
                                         {"figure5a_s2", a.stops[1].position},
                                         {"figure5a_Omega", a.omega},
                                         {"figure5b_s2", b.stops[1].position},
                                         {"figure5b_r", b.restitution},
                                         {"figure5b_Omega", b.omega},
                                         {"figure5c_s1", c.stops[0].position},
                                         {"figure5c_s2", c.stops[1].position},
                                         {"figure5c_Omega", c.omega}};
  const auto box = [&](const std::string &panel, const AxisBox &of, const std::string &ordinate) {
    expected[panel + "_t_min"] = of.from;
    expected[panel + "_t_max"] = of.to;
    expected[panel + "_" + ordinate + "_min"] = of.lowest;
    expected[panel + "_" + ordinate + "_max"] = of.highest;
  };
  box("figure2a", figure2a_box, "x");
  box("figure2b", figure2b_box, "x");
  box("figure4", figure4_box, "F");
  box("figure5a", figure5a_box, "x");
  box("figure5b", figure5b_box, "x");
  box("figure5c", figure5c_box, "x");
  for (const auto &[symbol, value] : expected) {
    ASSERT_EQ(stated.count(symbol), 1u) << symbol;
    EXPECT_EQ(stated.at(symbol).value, value) << symbol;
  }
}

TEST(PaperScenes, AreTheDefaultsOfTheSceneRunner) {
  const char *words[] = {"vibro-impact", "run"};
  const auto request = std::get<runner::RunRequest>(runner::parse(2, words));
  expect_equal(paper::figure2(), request.scene);
  for (double v : request.scene.displacement) EXPECT_EQ(v, 0.0);
  for (double v : request.scene.velocity) EXPECT_EQ(v, 0.0);
  EXPECT_EQ(request.until, paper::figure2a_box.to);
}

TEST(PaperScenes, AreThoseOfTheExamples) {
  for (double omega : {paper::figure2().omega, paper::figure4a().omega, 0.7})
    expect_equal(paper::stops_of_different_sign(omega), paper_scene(omega));
}

}  // namespace
