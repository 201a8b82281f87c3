// The paper's scenes stand in reference/scenes/paper_scenes.hpp. The defaults of the program and
// the examples, which users copy, repeat them and must be the same. Scenes in tables are written as
// scene files are.
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>

#include "lib/examples/paper_scene.hpp"
#include "program/options.hpp"
#include "program/scene_text.hpp"
#include "reference/numbers/panels.hpp"
#include "reference/scenes/paper_scenes.hpp"
#include "reference/scenes/table1_scenes.hpp"
#include "reference/truth/extreme_cases.hpp"
#include "tests/support/refusals.hpp"

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
  for (const auto &[name, scene, until, inferred] : paper::named_scenes()) {
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
    EXPECT_TRUE(paper::figure3(omega) == paper_scene(omega));
}

// A list of zeros is written as a list that is left out.
Scene without_zeros(Scene scene) {
  for (const auto &field : list_fields) {
    std::vector<double> &values = scene.*field.value;
    if (field.optional && std::ranges::count(values, 0.0) == std::ssize(values)) values.clear();
  }
  return scene;
}

// The program reads a file that its fields in words make, as the tables have them.
Scene read_by_the_program(const Scene &scene) {
  const std::string path = PROGRAM_DIR "/../scene_in_words";
  {
    std::ofstream file(path);
    for (const auto &[name, words] : fields_in_words(scene))
      if (!words.empty()) file << name << " = " << words << '\n';
  }
  return runner::scene_of(runner::scene_lines(path));
}

TEST(ExtremeScenes, AreReadAlikeByTheProgramAndFromTheTable) {
  for (const truth::Case &extreme : truth::extreme_cases()) {
    Scene with_own_restitution = extreme.scene;
    with_own_restitution.stops[0].restitution = 0.1;
    for (const Scene &scene : {extreme.scene, with_own_restitution})
      EXPECT_TRUE(without_zeros(scene) == read_by_the_program(scene)) << extreme.name;
  }
}

TEST(ScenesInWords, ThatBreakARuleAreRefusedWithTheirPlace) {
  const auto columns =
      std::make_shared<truth::Cells>(truth::Cells{"case", "masses", "mass", "amplitud"});
  const auto refusal = [&](const truth::Cells &cells) {
    return vibro_impact::testing::refusal<std::runtime_error>([&] {
      truth::scene_in({columns, cells, "t.csv: line 2"});
    });
  };
  EXPECT_EQ(refusal({"", "2", "1,2", ""}), "accepted");
  EXPECT_EQ(refusal({"", "2", "1,2,3", ""}),
            "t.csv: line 2, column mass: 3 values given, the chain has 2 masses");
  EXPECT_EQ(refusal({"", "2", "1", "1"}), "t.csv: line 2, column amplitud: is no field of a scene");
}

}  // namespace
