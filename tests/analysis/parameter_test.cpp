// The scalars of a scene by name.
#include <gtest/gtest.h>

#include <set>
#include <string>

#include "reference/scenes/paper_scenes.hpp"
#include "vibro_impact/analysis/analysis.hpp"
#include "vibro_impact/vibro_impact.hpp"

namespace {

using namespace vibro_impact;

// No field of a scene is left out of the list: vectors and doubles alone have no gaps between them.
static_assert(sizeof(Scene) == std::size(list_fields) * sizeof(std::vector<double>) +
                                   std::size(scalar_fields) * sizeof(double) +
                                   sizeof(Scene::stops));

const std::string names[] = {
    "omega",      "beta",          "restitution",   "restitution1", "restitution2", "stop1",
    "stop2",      "mass1",         "mass2",         "stiffness1",   "stiffness2",   "amplitude1",
    "amplitude2", "sine1",         "sine2",         "constant1",    "constant2",    "ground1",
    "ground2",    "displacement1", "displacement2", "velocity1",    "velocity2"};

// Every number of a scene, in a fixed order.
std::vector<double> numbers_of(const Scene &scene) {
  std::vector<double> all{scene.omega, scene.beta, scene.restitution};
  for (const auto *list : {&scene.mass, &scene.stiffness, &scene.amplitude, &scene.sine,
                           &scene.constant, &scene.ground, &scene.displacement, &scene.velocity})
    for (std::size_t i = 0; i < 2; ++i) all.push_back(list->empty() ? 0.0 : (*list)[i]);
  for (const Stop &stop : scene.stops) {
    all.push_back(stop.position);
    all.push_back(law_of(scene, stop).restitution);
  }
  return all;
}

// Setting a parameter and reading it back gives the number; nothing else of the scene changes, and
// no two names mean the same number.
TEST(Parameter, NamesOneNumberOfTheSceneEach) {
  std::set<std::size_t> places;
  const std::vector<double> before = numbers_of(paper::figure2());
  for (const std::string &word : names) {
    const Scene scene = paper::figure2();
    EXPECT_EQ(numbers_of(with(scene, word, get(scene, word))), before) << word;
    const Scene moved = with(scene, word, 0.3125);
    EXPECT_EQ(get(moved, word), 0.3125) << word;
    const std::vector<double> after = numbers_of(moved);
    ASSERT_EQ(after.size(), before.size());
    std::vector<std::size_t> changed;
    for (std::size_t i = 0; i < after.size(); ++i)
      if (after[i] != before[i]) changed.push_back(i);
    // The scene's restitution is that of its two stops, too.
    ASSERT_EQ(changed.size(), word == "restitution" ? 3u : 1u) << word;
    EXPECT_TRUE(places.insert(changed.front()).second) << word;
  }
}

// A stop with a restitution of its own does not follow the scene's.
TEST(Parameter, RestitutionOfAStopIsItsOwn) {
  const Scene own = with(paper::figure2(), "restitution1", 0.5);
  const Scene both = with(own, "restitution", 0.25);
  EXPECT_EQ(get(both, "restitution1"), 0.5);
  EXPECT_EQ(get(both, "restitution2"), 0.25);
}

}  // namespace
