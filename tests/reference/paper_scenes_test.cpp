// The paper's scenes stand in reference/scenes/paper_scenes.hpp. The defaults of the program and
// the examples, which users copy, repeat them and must be the same.
#include <gtest/gtest.h>

#include <cstddef>
#include <string>

#include "lib/examples/paper_scene.hpp"
#include "program/options.hpp"
#include "reference/scenes/paper_scenes.hpp"

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
