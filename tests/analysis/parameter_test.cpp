// The scalars of a scene by name.
#include <gtest/gtest.h>

#include <set>
#include <string>

#include "reference/scenes/paper_scenes.hpp"
#include "tests/support/refusals.hpp"
#include "vibro_impact/analysis/analysis.hpp"
#include "vibro_impact/vibro_impact.hpp"

namespace {

using namespace vibro_impact;

// No field of a scene is left out of the list: vectors and doubles alone have no gaps between them.
static_assert(sizeof(Scene) == std::size(list_fields) * sizeof(std::vector<double>) +
                                   std::size(scalar_fields) * sizeof(double) +
                                   sizeof(Scene::stops));

// The name of every number of a chain of two masses with a stop each.
std::vector<std::string> names() {
  std::vector<std::string> all{"stop1", "stop2", "restitution1", "restitution2"};
  for (const auto &field : scalar_fields) all.push_back(field.name);
  for (const auto &field : list_fields)
    for (const char *mass : {"1", "2"}) all.push_back(std::string(field.name) + mass);
  return all;
}

// Every number of a scene, in a fixed order.
std::vector<double> numbers_of(const Scene &scene) {
  std::vector<double> all;
  for (const auto &field : scalar_fields) all.push_back(scene.*field.value);
  for (const auto &field : list_fields)
    for (std::size_t i = 0; i < 2; ++i)
      all.push_back((scene.*field.value).empty() ? 0.0 : (scene.*field.value)[i]);
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
  for (const std::string &word : names()) {
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

// Every number of a scene enters the motion: none is read and then forgotten.
TEST(Parameter, ChangesTheMotion) {
  const auto end_of = [](const Scene &scene) { return simulate(scene, 60.0).state.displacement; };
  const Scene scene = paper::figure2();
  for (const std::string &word : names())
    EXPECT_NE(end_of(with(scene, word, get(scene, word) + 0.0625)), end_of(scene)) << word;
}

// No number of a scene may be infinite or none. The message has this value.
TEST(Parameter, MustBeFinite) {
  for (const std::string &word : names())
    for (const char *value : {"nan", "inf"})
      vibro_impact::testing::expect_refused(
          {{[&] { check(with(paper::figure2(), word, std::stod(value))); }, value}});
}

// The list of the kinds of events ends with the last kind.
TEST(EventKinds, AreAllInTheList) {
  for (const EventKind kind : all_event_kinds) EXPECT_NO_THROW(name(kind));
  EXPECT_THROW(name(static_cast<EventKind>(std::size(all_event_kinds))), std::logic_error);
}

// A stop with a restitution of its own does not follow the scene's.
TEST(Parameter, RestitutionOfAStopIsItsOwn) {
  const Scene own = with(paper::figure2(), "restitution1", 0.5);
  const Scene both = with(own, "restitution", 0.25);
  EXPECT_EQ(get(both, "restitution1"), 0.5);
  EXPECT_EQ(get(both, "restitution2"), 0.25);
}

}  // namespace
