// The paper's scenes stand in reference/scenes/paper_scenes.hpp. The defaults of the program and
// the examples, which users copy, repeat them and must be the same.
#include <gtest/gtest.h>

#include "lib/examples/paper_scene.hpp"
#include "program/options.hpp"
#include "reference/scenes/paper_scenes.hpp"

namespace {

using namespace vibro_impact;

TEST(PaperScenes, AreTheDefaultsOfTheSceneRunner) {
  const char *words[] = {"vibro-impact", "run"};
  const auto request = std::get<runner::RunRequest>(runner::parse(2, words));
  EXPECT_TRUE(paper::figure2() == request.scene);
  EXPECT_EQ(request.until, paper::figure2a_box.to);
}

TEST(PaperScenes, AreThoseOfTheExamples) {
  for (double omega : {paper::figure2().omega, paper::figure4a().omega, 0.7})
    EXPECT_TRUE(paper::stops_of_different_sign(omega) == paper_scene(omega));
}

}  // namespace
