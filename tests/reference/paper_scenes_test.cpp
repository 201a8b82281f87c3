// The paper's scenes stand in reference/scenes/paper_scenes.hpp. The defaults of the program and
// the examples, which users copy, repeat them and must be the same.
#include <gtest/gtest.h>

#include "lib/examples/paper_scene.hpp"
#include "program/options.hpp"
#include "reference/numbers/panels.hpp"
#include "reference/scenes/paper_scenes.hpp"
#include "reference/scenes/table1_scenes.hpp"

namespace {

using namespace vibro_impact;

TEST(PaperScenes, AreTheDefaultsOfTheSceneRunner) {
  const char *words[] = {"vibro-impact", "run"};
  const auto request = std::get<runner::RunRequest>(runner::parse(2, words));
  EXPECT_TRUE(paper::figure2() == request.scene);
  EXPECT_EQ(request.until, paper::panel("figure2a").to);
}

// A run ends where the printed window ends, in Figure 4 where that of Figure 2 does.
TEST(PaperScenes, AreFollowedToTheEndOfTheirWindows) {
  for (const auto &[name, scene, until] : paper::named_scenes()) {
    const bool of_figure_5 = name.starts_with("figure5");
    EXPECT_EQ(until, paper::panel(of_figure_5 ? name : "figure2a").to) << name;
  }
  const paper::PairScene last = paper::table1_scenes().back();  // the scene of Figure 5(a)
  EXPECT_EQ(last.from, paper::panel("figure5a").from);
  EXPECT_EQ(last.to, paper::panel("figure5a").to);
  EXPECT_THROW(paper::panel("figure6"), std::runtime_error);
}

TEST(PaperScenes, AreThoseOfTheExamples) {
  for (double omega : {paper::figure2().omega, paper::figure4a().omega, 0.7})
    EXPECT_TRUE(paper::stops_of_different_sign(omega) == paper_scene(omega));
}

}  // namespace
