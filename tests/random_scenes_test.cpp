// Properties that must hold in every scene, tried on random ones: no penetration, hold forces that
// press, events in order, the impact law, the mirror image and the scene in other units bit for
// bit.
//
// With an argument, `random_scenes_test N [first seed]` tries N scenes (`make random-scenes`).
#include "random_scenes.hpp"

#include <gtest/gtest.h>

#include <cstdlib>

namespace {

using namespace vibro_impact;
using namespace vibro_impact::testing;

int try_scenes(unsigned first, int count) {
  int failed = 0, given_up = 0;
  for (int k = 0; k < count; ++k) {
    const unsigned seed = first + static_cast<unsigned>(k);
    bool gave_up = false;
    const std::string broken = broken_property(random_scene(seed), gave_up);
    given_up += gave_up;
    if (broken.empty()) continue;
    ++failed;
    fmt::print("seed {}: {}\n", seed, broken);
  }
  fmt::print("{} random scenes, {} broke a property, {} ended at the limit of impacts\n", count,
             failed, given_up);
  return failed;
}

TEST(RandomScenes, KeepEveryProperty) {
  EXPECT_EQ(try_scenes(1, 500), 0);
}

}  // namespace

int main(int argc, char **argv) {
  ::testing::InitGoogleTest(&argc, argv);
  if (argc > 1)
    return try_scenes(argc > 2 ? static_cast<unsigned>(std::atoi(argv[2])) : 1u,
                      std::atoi(argv[1])) == 0
               ? 0
               : 1;
  return RUN_ALL_TESTS();
}
