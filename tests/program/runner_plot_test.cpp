// The picture of a run as a file, and what is wrong with it. The digests of tests/pictures show
// what it draws.
#include <string>
#include <utility>
#include <vector>

#include "tests/support/runner_program.hpp"

namespace {

using namespace vibro_impact::testing;

TEST_F(Runner, GnuplotDrawsEveryKindOfFileWhateverItsName) {
  if (!there_is_gnuplot()) GTEST_SKIP() << "gnuplot is not there";
  for (const auto &[name, start] : {std::pair{"it's | ~ \\ it.png", "\x89PNG\r\n\x1a\n"},
                                    {"p.pdf", "%PDF-"},
                                    {"p.svg", "<?xml"}}) {
    const Result result =
        run(std::string("run --until 50 --samples \"it's \\$s.csv\" --events - ") + "--plot \"" +
            name + "\"");
    EXPECT_EQ(result.status, 0) << result.err;
    EXPECT_TRUE(contents(folder / name).starts_with(start)) << name << result.err;
  }
}

TEST_F(Runner, APictureThatCannotBeDrawnLeavesTheTablesAlone) {
  expect_message(
      run("run --samples s.csv --plot p.png", "PATH=$PWD/missing"),
      "vibro-impact: --plot p.png: needs gnuplot with its terminal pngcairo, not found\n");
  EXPECT_TRUE(fs::is_empty(folder));

  // A program without its script.
  fs::create_directory(folder / "bin");
  fs::copy_file(VIBRO_IMPACT_PROGRAM, folder / "bin/program");
  expect_message(run("run --samples s.csv --plot p.png", "true", "", "bin/program"),
                 "plot.gp, which is not there");
  fs::remove_all(folder / "bin");
  EXPECT_TRUE(fs::is_empty(folder));

  // A gnuplot that takes the terminal and then fails.
  std::ofstream(folder / "gnuplot") << "#!/bin/sh\ntest \"$2\" = -e || { printf 'plot\\n\"p.gp\" "
                                       "line 7: bad\\n\\n' >&2; false; }\n";
  fs::permissions(folder / "gnuplot", fs::perms::owner_all);
  expect_message(run("run --samples s.csv --plot p.png", "PATH=\"$PWD:$PATH\" && export PATH"),
                 "vibro-impact: --plot p.png: gnuplot could not draw it: bad\n", 1);
  EXPECT_EQ(files(), (std::vector<std::string>{"gnuplot", "s.csv"}));
}

}  // namespace
