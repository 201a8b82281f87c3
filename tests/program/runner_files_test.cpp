// The files of a run, its picture among them, are whole or absent.
#include <regex>
#include <string>
#include <utility>
#include <vector>

#include "program/options.hpp"
#include "tests/support/runner_program.hpp"

namespace {

using namespace vibro_impact::testing;

TEST_F(Runner, ARefusedRunSparesTheTableThatWasThere) {
  std::ofstream(folder / "e.csv") << "old";
  EXPECT_EQ(run("run --mass 0 --events e.csv").status, 2);
  EXPECT_EQ(run("run --events e.csv --samples missing/s.csv").status, 2);
  EXPECT_EQ(contents(folder / "e.csv"), "old");
  EXPECT_EQ(run("run --until 5 --events e.csv").status, 0);
  EXPECT_EQ(contents(folder / "e.csv").substr(0, 5), "time,");
  EXPECT_EQ(files(), std::vector<std::string>{"e.csv"});
}

// A run ends by its work, too. The default bounds are those that the help shows.
TEST_F(Runner, ARunOfTooManyStepsIsGivenUpAndLeavesNoFile) {
  expect_message(
      run("run --max-steps 100 --events e.csv --samples s.csv --beta 0 --stiffness 1,1e6"),
      "at least 100 steps, given up at t = ", 1);
  for (const char *command : {"run --max-steps 100", "orbit --max-steps 100"})
    expect_message(run(command), "; RunOptions::max_steps (--max-steps) can allow more\n", 1);
  EXPECT_TRUE(fs::is_empty(folder));
  // CLI11 writes a default as N=10000000 up to its version 2.3, and as N [10000000] after it.
  const std::regex of_a_run(R"(--max-steps N(=10000000| \[10000000\]) )"),
      of_a_sweep(R"(--max-steps N(=1000000| \[1000000\]) )");
  EXPECT_TRUE(std::regex_search(run("run --help").out, of_a_run));
  EXPECT_TRUE(std::regex_search(run("sweep --help").out, of_a_sweep));
  const auto steps = [](const char *masses, auto... more) {
    const char *words[] = {"vibro-impact", "run", "--stop", "none", "--masses", masses, more...};
    using namespace vibro_impact::runner;
    return std::get<RunRequest>(parse(std::size(words), words)).options.max_steps;
  };
  EXPECT_EQ(steps("1"), 10'000'000);
  EXPECT_EQ(steps("2"), 10'000'000);
  EXPECT_EQ(steps("100"), 200'000);
  EXPECT_EQ(steps("2000"), 20'000);
  EXPECT_EQ(steps("100", "--max-steps", "7"), 7);
}

TEST_F(Runner, NoOutputTakesThePlaceOfTheScene) {
  std::ofstream(folder / "own.scene") << "omega = 0.5\n";
  fs::create_symlink("own.scene", folder / "link");
  for (const char *command :
       {"run --scene own.scene --events own.scene", "run --scene own.scene --samples ./own.scene",
        "run --scene link --events own.scene", "run --scene own.scene --events link",
        "sweep --vary omega=0.3:0.5:2 --scene own.scene --table own.scene",
        "sweep --vary omega=0.3:0.5:2 --table a --impacts a"}) {
    EXPECT_EQ(run(command).status, 2) << command;
    EXPECT_EQ(contents(folder / "own.scene"), "omega = 0.5\n");
  }
}

// A pipe gets the table at once.
TEST_F(Runner, APipeIsWrittenTo) {
  const Result result =
      run("run --until 20 --events pipe | cat >copy.csv", "ln -s /dev/stdout pipe");
  ASSERT_EQ(result.status, 0) << result.err;
  ASSERT_EQ(run("run --until 20 --events e.csv").status, 0);
  EXPECT_EQ(contents(folder / "copy.csv"), contents(folder / "e.csv"));
}

// A file of the temporary name is neither overwritten nor removed. `exec` keeps the process number.
TEST_F(Runner, AFileOfTheTemporaryNameIsLeftAlone) {
  expect_message(run("run --until 20 --events e.csv", "echo mine >e.csv.part.$$", "exec "),
                 "vibro-impact: e.csv: cannot be written: File exists\n", 1);
  ASSERT_EQ(files().size(), 1u);
  EXPECT_EQ(contents(folder / files()[0]), "mine\n");
}

TEST_F(Runner, ALinkIsWrittenThroughOrRefused) {
  std::ofstream(folder / "x.csv") << "old";
  fs::create_symlink("x.csv", folder / "link.csv");
  ASSERT_EQ(run("run --until 20 --events link.csv").status, 0);
  EXPECT_TRUE(fs::is_symlink(folder / "link.csv"));
  EXPECT_EQ(contents(folder / "x.csv").substr(0, 5), "time,");
  fs::create_symlink("missing.csv", folder / "dangling.csv");
  fs::create_symlink("loop.csv", folder / "loop.csv");
  for (const std::string &name :
       {std::string("dangling.csv"), std::string("loop.csv"), std::string(300, 'x')})
    expect_message(run("run --until 20 --events " + name), name);
}

TEST_F(Runner, AFullDiskIsAnErrorAndHasNoFile) {
  for (const std::string command : {"--help", "--version", "run --print-scene", "run --events -"})
    expect_message(run(command + " >/dev/full"),
                   "vibro-impact: standard output cannot be written\n", 1);
  expect_message(run("run --until 100 --events e.csv", full_disk(512)),
                 "vibro-impact: e.csv: cannot be written: File too large\n", 1);
  EXPECT_TRUE(fs::is_empty(folder));
}

// A folder that cannot be written to is noticed before the run. Root can write to every folder.
TEST_F(Runner, AWriteProtectedFolderIsRefusedBeforeTheRun) {
  fs::create_directory(folder / "ro");
  fs::permissions(folder / "ro", fs::perms(0555));
  std::string program = VIBRO_IMPACT_PROGRAM, by;
  if (geteuid() == 0) {  // root writes everywhere, and starts a copy as a user who does not
    fs::permissions(folder, fs::perms(0755));
    fs::copy_file(program, folder / "program");
    program = "./program";
    by = "setpriv --reuid=65534 --clear-groups ";
  }
  expect_message(run("run --until 20 --events ro/x.csv", "true", by, program),
                 "is write-protected");
}

// The digests of tests/pictures show what a picture draws.
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
