// The paper's scenes are written down once, in reference/scenes/paper_scenes.hpp. The 50-digit
// generator takes them over to the last bit; and where they have to be written once more, in the
// defaults of the scene runner and in the examples, which users copy, they are the same.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

#include "lib/examples/paper_scene.hpp"
#include "program/options.hpp"
#include "reference/scenes.hpp"
#include "reference/scenes/paper_scenes.hpp"

namespace {

using namespace vibro_impact;

// Scenes compare member by member; a double made a Real is itself.
void expect_equal(const Scene &scene, const vibro_impact_reference::Scene &reference) {
  SCOPED_TRACE(reference.name);
  const auto &chain = reference.chain;
  const auto same = [](const std::vector<double> &ours, const auto &theirs) {
    return std::equal(ours.begin(), ours.end(), theirs.begin(), theirs.end());
  };
  EXPECT_TRUE(same(scene.mass, chain.masses));
  EXPECT_TRUE(same(scene.stiffness, chain.stiffnesses));
  EXPECT_TRUE(same(scene.amplitude, chain.amplitudes));
  const std::vector<double> at_rest(scene.mass.size(), 0.0);
  EXPECT_TRUE(same(at_rest, reference.initial_positions));
  EXPECT_TRUE(same(at_rest, reference.initial_velocities));
  EXPECT_TRUE(scene.displacement.empty() && scene.velocity.empty());
  EXPECT_EQ(scene.beta, chain.damping_ratio);
  EXPECT_EQ(scene.omega, chain.frequency);
  EXPECT_EQ(scene.restitution, reference.restitution);
  ASSERT_EQ(scene.stops.size(), reference.stops.size());
  for (std::size_t i = 0; i < scene.stops.size(); ++i) {
    const auto &[mass, side, position] = reference.stops[i];
    EXPECT_EQ(scene.stops[i].mass, static_cast<int>(mass) + 1);
    EXPECT_EQ(scene.stops[i].side == Side::upper, side == vibro_impact_reference::Side::upper);
    EXPECT_EQ(scene.stops[i].position, position);
  }
}

TEST(PaperScenes, AreTakenOverByTheFiftyDigitGenerator) {
  ASSERT_EQ(paper::named_scenes().size(), 6u);
  for (const auto &[name, scene, until] : paper::named_scenes()) {
    expect_equal(scene, vibro_impact_reference::scene_named(name));
    EXPECT_EQ(vibro_impact_reference::scene_named(name).end_time, until);
  }
  EXPECT_THROW(vibro_impact_reference::scene_named("figure6"), std::invalid_argument);
}

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
  std::string program = "vibro-impact", command = "run";
  char *words[] = {program.data(), command.data(), nullptr};
  runner::Request request;
  ASSERT_FALSE(runner::parse(2, words, request).has_value());
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
