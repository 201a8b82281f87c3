// Sweeps of the program: their tables, and points without a record.
#include <algorithm>
#include <fstream>
#include <optional>
#include <regex>
#include <string>
#include <utility>
#include <vector>

#include "reference/scenes/extreme_scenes.hpp"
#include "reference/scenes/paper_scenes.hpp"
#include "reference/truth/table_reader.hpp"
#include "tests/support/runner_program.hpp"
#include "vibro_impact/analysis/analysis.hpp"

namespace {

using namespace vibro_impact::testing;
using namespace vibro_impact;

// The rows of a grid from the library. With `back`, a point starts where the motion of the latest
// point with a record has settled, along the inner axis to its end and back.
SweepTables tables_of(const Grid &grid, const RecordOptions &options, bool back) {
  SweepTables tables = sweep_tables(grid, options);
  const std::size_t count = grid.axes.back().count, length = back ? 2 * count : 1;
  std::optional<OrbitRecord> before;
  for (std::size_t row = 0; row < (back ? 2 : 1) * grid.points(); ++row) {
    const std::size_t k = row % length, first = back ? row / length * count : row,
                      point = first + (k < count ? k : length - 1 - k);
    if (k == 0) before.reset();
    const PointRecord result = point_record(grid.scene_at(point), options, before);
    add_rows(tables, grid, options, point, result.record);
    if (back && result.record) before = result.record;
  }
  return tables;
}

// The tables are those of the library, to the byte. Branches are shared out whole, and go on behind
// points that are given up.
TEST_F(Runner, ASweepGivesTheTablesOfTheLibrary) {
  const Grid grid{paper::figure2(), {{"omega", 0.25, 0.7, 19}, {"restitution", 0.3, 0.9, 4}}};
  const Grid branches{extremes::one_mass(0.1, 0.1, 1.0, 0.7, 0.3),
                      {{"restitution", 0.5, 0.8, 5}, {"omega", 1.1, 1.2, 9}}};
  RecordOptions few_steps{.impacts = true, .section = true};
  few_steps.settle.run.max_steps = 120;
  const struct {
    std::string arguments;
    SweepTables tables;
    std::string said = "";
  } sweeps[] = {
      {"--vary omega=0.25:0.7:19 --vary restitution=0.3:0.9:4 --longest 100 --lyapunov --pairs "
       "--table t.csv",
       tables_of(grid, {.settle = {.longest = 100}, .lyapunov = true, .pairs = true}, false)},
      {"--vary restitution=0.5:0.8:5 --vary omega=1.1:1.2:9 --back --masses 1 --beta 0.1 "
       "--amplitude 0.1 --stop 1:upper:0.3 --table t.csv --impacts i.csv --section s.csv",
       tables_of(branches, {.impacts = true, .section = true}, true)},
      {"--vary omega=1.05:1.45:81 --back --masses 1 --beta 0.1 --amplitude 0.1 --stop 1:upper:0.3 "
       "--max-steps 120 --table t.csv --impacts i.csv --section s.csv",
       tables_of({branches.scene, {{"omega", 1.05, 1.45, 81}}}, few_steps, true),
       "\n1 of 162 points start at the latest point with a record"}};
  for (const auto &[arguments, tables, said] : sweeps) {
    SCOPED_TRACE(arguments);
    const Result result = run("sweep " + arguments);
    ASSERT_EQ(result.status, 0) << result.err;
    EXPECT_EQ(lines(contents(folder / "t.csv")), lines(tables.records.text));
    const std::size_t written = files().size();
    EXPECT_EQ(written, arguments.ends_with("s.csv") ? 3u : 1u);
    if (written == 1) continue;
    EXPECT_EQ(lines(contents(folder / "i.csv")), lines(tables.impacts.text));
    EXPECT_EQ(lines(contents(folder / "s.csv")), lines(tables.section.text));
    EXPECT_NE(result.err.find(said), std::string::npos) << result.err;
  }
}

// Points without a record have empty cells, and a line for each reason with the number of its
// points and the first of them. A forcing period is longer than double precision can count; r = 0.9
// takes more steps than are allowed; a start lies beyond a stop. Only a sweep without any record
// fails.
TEST_F(Runner, APointThatIsRefusedOrGivenUpHasEmptyCellsAndItsReasonIsSaid) {
  const struct {
    std::string vary, reason;
    std::size_t points, missing;
  } cases[] = {
      {"omega=1e-307:0.6:2",
       "1 of 2 points: until = inf: must be finite; first at omega = 1e-307\n", 2, 1},
      {"restitution=0:0.9:2 --max-steps 400 --longest 20 --omega 0.3",
       "1 of 2 points: at least 400 steps, given up at t = ", 2, 1},
      {"displacement1=-0.6:0:4",
       "2 of 4 points: start: mass 1 at -0.6, beyond its lower stop at -0.3; "
       "its displacement (--displacement) must lie within its stops; first at displacement1 = "
       "-0.6\n",
       4, 2},
      {"displacement1=-0.6:0:2 --vary omega=1e-307:0.6:2",
       "first at displacement1 = -0.6, omega = 1e-307\n1 of 4 points: until = inf: ", 4, 3},
      {"omega=0.3:0.4:2 --vary beta=0.1:0.2:2 --max-steps 1",
       " (--max-steps) can allow more; first at omega = 0.3, beta = 0.1\n"
       "vibro-impact: every point of the sweep was refused or given up\n",
       4, 4}};
  for (const auto &[vary, reason, points, missing] : cases) {
    SCOPED_TRACE(vary);
    const Result result = run("sweep --table t.csv --vary " + vary);
    EXPECT_EQ(result.status, missing == points ? 1 : 0);
    EXPECT_NE(result.err.find(reason), std::string::npos) << result.err;
    EXPECT_NE(result.err.find(" " + std::to_string(missing) + " were refused or given up"),
              std::string::npos)
        << result.err;
    const auto rows = lines(contents(folder / "t.csv"));
    ASSERT_EQ(rows.size(), points + 1);
    std::size_t empty = 0;
    for (const std::string &row : rows) empty += row.ends_with(",,,,,,,") ? 1 : 0;
    EXPECT_EQ(empty, missing);
  }
}

// The numbers are those of the order of the rows, in each scene anew, whatever thread computes a
// point. Two of the three orbits at omega = 2.5 are mirror images. Orbits followed up and down are
// one where they have the same impacts. At omega = 2 the motion is chaotic before it settles: of
// motions that differ by 1e-12, one of ten does not settle in the 400 periods of the default, and
// all of 200 do in 4,000.
TEST_F(Runner, AttractorsAreNumberedAsTheyAppear) {
  const std::string symmetric =
                        " --masses 1 --restitution 0.8 --stop 1:lower:-0.5 "
                        "--stop 1:upper:0.5 --amplitude 2.36 --attractor --table ",
                    starts = "--vary displacement1=-0.5:0.5:21 --vary velocity1=-3:3:21 ";
  const auto numbers = [this] {
    std::vector<std::string> found;
    for (const truth::Row &row : table("t.csv")) found.push_back(row.cell("attractor"));
    return found;
  };
  ASSERT_EQ(
      run("sweep --omega 2.5 " + starts + symmetric + "t.csv", "export OMP_NUM_THREADS=1").status,
      0);
  std::vector<std::string> appeared;
  for (const std::string &number : numbers())
    if (std::ranges::find(appeared, number) == appeared.end()) appeared.push_back(number);
  EXPECT_EQ(appeared, (std::vector<std::string>{"1", "2", "3"}));
  ASSERT_EQ(
      run("sweep --omega 2.5 " + starts + symmetric + "u.csv", "export OMP_NUM_THREADS=4").status,
      0);
  EXPECT_EQ(contents(folder / "t.csv"), contents(folder / "u.csv"));
  ASSERT_EQ(run("sweep --vary velocity1=-3:-1:3 --vary omega=2:2.5:2 --longest 4000" + symmetric +
                "t.csv")
                .status,
            0);
  EXPECT_EQ(numbers(), (std::vector<std::string>{"1", "1", "2", "1", "2", "1"}));
  ASSERT_EQ(run("sweep --masses 1 --amplitude 0.1 --stop 1:upper:0.3 --vary omega=1.1:1.3:5 --back "
                "--attractor --table t.csv")
                .status,
            0);
  const truth::Rows rows = table("t.csv");
  for (std::size_t k = 0; k < 5; ++k)
    EXPECT_EQ(rows.at(9 - k).cell("attractor"),
              rows.at(k).cell("impacts1") == rows.at(9 - k).cell("impacts1") ? "1" : "2");
}

// One of three parts of this sweep has a point less than the others, or no branch. One thread
// computes the whole sweep in two blocks.
const std::string small =
    "sweep --vary restitution=0.5:0.6:2 --vary omega=1.1:1.2:151 --masses 1 "
    "--amplitude 0.1 --stop 1:upper:0.3 --longest 5 ";

TEST_F(Runner, TheTablesOfAllPartsPutTogetherAreThoseOfTheSweep) {
  for (const std::string more : {"", "--header ", "--back "}) {
    const std::string sweep = small + more + "--table t.csv --impacts i.csv ";
    ASSERT_EQ(run(sweep, "export OMP_NUM_THREADS=1").status, 0);
    std::string records, impacts;
    for (const std::string part : {"01/3", "2/3", "3/3"}) {
      const Result result = run(small + more + "--impacts of_part.csv --table - --part " + part,
                                "export OMP_NUM_THREADS=4");
      EXPECT_EQ(result.status, 0) << result.err;
      records += result.out;
      impacts += contents(folder / "of_part.csv");
    }
    EXPECT_EQ(records, contents(folder / "t.csv")) << more;
    EXPECT_EQ(impacts, contents(folder / "i.csv")) << more;
  }
  const Result refused = run("sweep --vary displacement1=-3:-2:2 --table t.csv --part 1/2");
  EXPECT_EQ(refused.status, 0) << "another part may have records";
}

// The limit of the size of files kills the second job while it writes.
TEST_F(Runner, PartsThatWereKilledAreComputedWhenTheCommandIsGivenAgain) {
  ASSERT_EQ(run(small + "--section t.csv").status, 0);
  const std::string command =
      "parallel -j 2 --joblog jobs --resume-failed 'test {} != 2 || test -e tried || "
      "{ touch tried; ulimit -f 0; }; exec " VIBRO_IMPACT_PROGRAM " " +
      small + "--part {}/3 --section part-{}.csv' ::: 1 2 3; ";
  EXPECT_EQ(run("", command + "test $? = 1", "true ").status, 0);
  EXPECT_FALSE(fs::exists(folder / "part-2.csv"));
  fs::remove(folder / "part-1.csv");  // is complete, and not computed again
  const Result result = run("", command + "test $? = 0", "true ");
  EXPECT_EQ(result.status, 0) << result.err;
  EXPECT_FALSE(fs::exists(folder / "part-1.csv"));
  ASSERT_EQ(run(small + "--part 1/3 --section part-1.csv").status, 0);
  std::string parts;
  for (const char *part : {"part-1.csv", "part-2.csv", "part-3.csv"})
    parts += contents(folder / part);
  EXPECT_EQ(parts, contents(folder / "t.csv"));
}

// The jobs of the help, which the README shows, too, run as a script of the shell: with few points,
// on this machine, and with a loop in the place of Slurm.
TEST_F(Runner, TheJobsOfTheHelpRun) {
  const std::string help = run("sweep --help").out;
  const std::size_t begin = help.find("  parallel "), end = help.find("\n\n", begin);
  ASSERT_LT(end, help.size());
  std::string jobs = help.substr(begin, end - begin);
  jobs = std::regex_replace(jobs, std::regex("\nThe table [^\n]*"), "");
  const auto outdented = std::regex_replace(jobs, std::regex("(^|\n)  "), "$1");
  EXPECT_NE(contents(SOURCE_DIR "/README.md").find(outdented), std::string::npos) << outdented;
  for (const auto &[from, to] :
       {std::pair{"1001", "3"},
        {"one,two", ":"},
        {"64", "4"},
        {"sbatch --array=1-4 --wrap", "for SLURM_ARRAY_TASK_ID in 1 2 3 4; do eval"},
        {"TASK_ID.csv'", "TASK_ID.csv'; done"}})
    jobs = std::regex_replace(jobs, std::regex(from), to);
  const std::size_t slurm = jobs.find("  for "), cat = jobs.find("  cat ");
  ASSERT_LT(cat, jobs.size());
  fs::create_directory_symlink(fs::path(VIBRO_IMPACT_PROGRAM).parent_path(), folder / "bin");
  ASSERT_EQ(run("sweep --vary omega=0.25:0.7:3 --vary restitution=0.5:0.9:3 --table t.csv").status,
            0);
  for (const std::string &job : {jobs.substr(0, slurm), jobs.substr(slurm, cat - slurm)}) {
    std::ofstream(folder / "job") << "PATH=$PWD/bin:$PATH\n" << job << jobs.substr(cat) << '\n';
    const Result result = run("", "true", "sh ", "job");
    EXPECT_EQ(result.status, 0) << job << result.err;
    EXPECT_EQ(contents(folder / "atlas.csv"), contents(folder / "t.csv")) << job;
    for (int part = 1; part <= 4; ++part)
      EXPECT_TRUE(fs::remove(folder / ("part-" + std::to_string(part) + ".csv"))) << job;
    fs::remove(folder / "atlas.csv");
  }
}

// The limit of a file's size stands for a full disk.
TEST_F(Runner, ASweepOnAFullDiskIsAnErrorAndHasNoFile) {
  expect_message(run("sweep --vary omega=0.3:0.5:40 --table t.csv", full_disk(1024)),
                 "vibro-impact: t.csv: cannot be written: File too large\n", 1);
  EXPECT_TRUE(fs::is_empty(folder));
}

}  // namespace
