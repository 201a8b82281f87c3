// Sweeps of the program: the table, on threads and on processes, and a sweep that was killed.
#include <fstream>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "program/journal.hpp"
#include "program/processes.hpp"
#include "reference/scenes/extreme_scenes.hpp"
#include "reference/scenes/paper_scenes.hpp"
#include "reference/truth/table_reader.hpp"
#include "tests/support/runner_program.hpp"
#include "vibro_impact/analysis/analysis.hpp"

namespace {

using namespace vibro_impact::testing;
using namespace vibro_impact;

const std::string one_thread = "export OMP_NUM_THREADS=1 && ";

// The rows of a grid from the library. With `back`, a point starts where the motion of the point
// before has settled, along the inner axis to its end and back.
SweepTables tables_of(const Grid &grid, const RecordOptions &options, bool back) {
  SweepTables tables = sweep_tables(grid, options);
  const std::size_t count = grid.axes.back().count, length = back ? 2 * count : 1;
  PointRecord result;
  for (std::size_t row = 0; row < (back ? 2 : 1) * grid.points(); ++row) {
    const std::size_t k = row % length, first = back ? row / length * count : row,
                      point = first + (k < count ? k : length - 1 - k);
    result = point_record(grid.scene_at(point), options,
                          k > 0 ? result.record : std::optional<OrbitRecord>());
    add_rows(tables, grid, options, point, result.record);
  }
  return tables;
}

// The tables are those of the library, to the byte, whatever the number of processes. (Of threads:
// sweep_test.) Branches are shared out whole.
TEST_F(Runner, ASweepGivesTheTablesOfTheLibrary) {
  const Grid grid{paper::figure2(), {{"omega", 0.25, 0.7, 19}, {"restitution", 0.3, 0.9, 4}}};
  const Grid branches{extremes::one_mass(0.1, 0.1, 1.0, 0.7, 0.3),
                      {{"restitution", 0.5, 0.8, 5}, {"omega", 1.1, 1.2, 9}}};
  const struct {
    std::string arguments;
    SweepTables tables;
  } sweeps[] = {
      {"--vary omega=0.25:0.7:19 --vary restitution=0.3:0.9:4 --longest 100 --lyapunov --pairs "
       "--table t.csv",
       tables_of(grid, {.settle = {.longest = 100}, .lyapunov = true, .pairs = true}, false)},
      {"--vary restitution=0.5:0.8:5 --vary omega=1.1:1.2:9 --back --masses 1 --beta 0.1 "
       "--amplitude 0.1 --stop 1:upper:0.3 --table t.csv --impacts i.csv --section s.csv",
       tables_of(branches, {.impacts = true, .section = true}, true)}};
  for (const int processes : {1, 3, 4})
    for (const auto &[arguments, tables] : sweeps) {
      if (processes > 1 && !with_mpi) GTEST_SKIP() << "built without MPI";
      SCOPED_TRACE(::testing::Message() << arguments << " by " << processes << " processes");
      const Result result =
          run("sweep " + arguments, "true", processes > 1 ? mpirun(processes) : "");
      ASSERT_EQ(result.status, 0) << result.err;
      EXPECT_EQ(lines(contents(folder / "t.csv")), lines(tables.records.text));
      const std::size_t written = files().size();
      EXPECT_EQ(written, arguments.ends_with("s.csv") ? 3u : 1u);
      if (written == 1) continue;
      EXPECT_EQ(lines(contents(folder / "i.csv")), lines(tables.impacts.text));
      EXPECT_EQ(lines(contents(folder / "s.csv")), lines(tables.section.text));
      for (const char *name : {"i.csv", "s.csv"}) fs::remove(folder / name);
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
       "1 of 2 points: more than 400 steps, given up at t = ", 2, 1},
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

TEST_F(Runner, AKilledSweepGoesOnWithItsRowsAndNoOthers) {
  const std::string sweep =
      "sweep --vary omega=0.25:0.7:181 --vary restitution=0.6:0.8:5 --longest 50 --table t.csv ";
  const std::string all_computed = "905 points, 905 computed now";
  ASSERT_NE(run(sweep).err.find(all_computed), std::string::npos);
  const std::string whole = contents(folder / "t.csv");
  const fs::path path = folder / "t.csv.partial";
  // The shell kills the sweep as soon as five rows stand in its journal, unless the sweep ends
  // first.
  const std::string kill =
      "& until test -e t.csv || test 5 -le \"$(grep -c ^row t.csv.partial)\"; do :; done; "
      "kill -KILL $!; wait $!";
  do {
    fs::remove(folder / "t.csv");
  } while (run(sweep + kill, one_thread + "true").status != 128 + 9);
  ASSERT_EQ(files(), std::vector<std::string>{"t.csv.partial"});
  std::string partial = contents(path);
  // The second row is lost, as if another process were still computing it.
  const std::size_t second = partial.find("\nrow ", partial.find("\nrow ") + 1);
  std::ofstream(path) << partial.erase(second, partial.find("\nrow ", second + 1) - second);

  // A sweep does not replace a table by mistake, nor extend that of another sweep or program: one
  // byte more is another file.
  const struct {
    std::string options, program, message;
  } refused[] = {{"", VIBRO_IMPACT_PROGRAM, "--resume goes on with it"},
                 {"--resume --beta 0.2", VIBRO_IMPACT_PROGRAM, "not the rows of this sweep"},
                 {"--resume --impacts i.csv", VIBRO_IMPACT_PROGRAM, "not the rows of this sweep"},
                 {"--resume", folder.string() + "-other", "not the rows of this sweep"}};
  fs::copy_file(VIBRO_IMPACT_PROGRAM, folder.string() + "-other");
  std::ofstream(folder.string() + "-other", std::ios::app) << 'x';
  for (const auto &[options, program, message] : refused) {
    expect_message(run(sweep + options, "true", "", program), message);
    EXPECT_EQ(contents(path), partial);
    EXPECT_EQ(files(), std::vector<std::string>{"t.csv.partial"});
  }
  fs::remove(folder.string() + "-other");

  // Its rows are kept, and no others are computed. (A journal that is cut: journal_test.) The name
  // of a scene file does not count, and an empty one has no options.
  const std::string scene = folder.string() + "-scene";
  std::ofstream{scene};
  const Result rest = run(sweep + "--resume --scene " + scene, "true", with_mpi ? mpirun(2) : "");
  ASSERT_EQ(rest.status, 0) << rest.err;
  std::size_t kept = 0;
  for (const std::string &line : lines(partial)) kept += line.starts_with("row ");
  EXPECT_NE(rest.err.find("905 points, " + std::to_string(905 - kept) + " computed now"),
            std::string::npos)
      << rest.err;
  EXPECT_EQ(lines(contents(folder / "t.csv")), lines(whole));
  EXPECT_EQ(files(), std::vector<std::string>{"t.csv"});
  fs::remove(scene);
}

// The job that the help shows runs as a script of the shell, here with few points and with the
// program and the number of processes of the test. Run once more, it has nothing to do.
TEST_F(Runner, TheJobOfTheHelpRuns) {
  if (!with_mpi) GTEST_SKIP() << "built without MPI";
  const std::string help = run("--help").out;
  const std::size_t begin = help.find("#!/bin/sh"), end = help.find("\n\n", begin);
  ASSERT_LT(end, help.size());
  std::string job = help.substr(begin, end - begin);
  for (const auto &[from, to] : std::vector<std::pair<std::string, std::string>>{
           {":1001", ":3"},
           {":1001", ":3"},
           {"mpirun", mpirun(2)},
           {"vibro-impact", "'" VIBRO_IMPACT_PROGRAM "'"}}) {
    ASSERT_LT(job.find(from), job.size()) << from;
    job.replace(job.find(from), from.size(), to);
  }
  fs::create_directory(folder / "atlas");
  std::ofstream(folder / "job") << job << '\n';
  for (const bool first : {true, false}) {  // the second finds its tables
    const Result result = run("", "export HOME='" + folder.string() + "'", "sh ", "job");
    EXPECT_EQ(result.status, 0) << result.err;
    // mpirun may add lines about the network.
    const bool computed = result.err.find("9 points, 9 computed now") != std::string::npos;
    EXPECT_EQ(computed, first) << result.err;
    EXPECT_EQ(lines(contents(folder / "atlas" / "atlas.csv")).size(), 10u);
  }
  EXPECT_TRUE(fs::exists(folder / "atlas" / "impacts.csv"));
}

// The limit of a file's size stands for a full disk. The journal keeps the rows that fitted.
TEST_F(Runner, ASweepOnAFullDiskGoesOnLater) {
  const std::string sweep =
      "sweep --vary omega=1.1:1.2:40 --back --masses 1 --amplitude 0.1 --stop 1:upper:0.3 ";
  ASSERT_EQ(run(sweep + "--table whole.csv", one_thread + "true").status, 0);
  const std::string whole = contents(folder / "whole.csv");
  expect_message(run(sweep + "--table t.csv", one_thread + full_disk(1024)),
                 "vibro-impact: t.csv.partial: cannot be written: File too large\n", 1);
  EXPECT_EQ(fs::file_size(folder / "t.csv.partial"), 1024u);
  ASSERT_EQ(run(sweep + "--resume --table t.csv").status, 0);
  EXPECT_EQ(lines(contents(folder / "t.csv")), lines(whole));
}

// The last but 800 to 710 of 1,800 tasks take ten times as long as the others. Three equal parts
// of consecutive tasks would have an efficiency of 0.6.
TEST(Processes, HardlyWaitForEachOther) {
  for (const std::size_t processes : {3u, 16u}) {
    std::vector<double> ends(processes, 0.0);
    double sum = 0.0;
    for (std::size_t left = 1800; left > 0;) {
      double &end = *std::ranges::min_element(ends);
      for (std::size_t count = tasks_at_once(left, processes); count > 0; --count, --left) {
        const double time = left <= 800 && left > 710 ? 10.0 : 1.0;
        end += time;
        sum += time;
      }
    }
    EXPECT_GT(sum / (static_cast<double>(processes) * std::ranges::max(ends)), 0.98) << processes;
  }
}

TEST_F(Runner, ASecondSweepOnTheSameTableIsRefused) {
  const runner::Journal held(folder / "t.csv.partial", "a head\n", 2, false);
  expect_message(run("sweep --vary omega=0.3:0.5:2 --resume --table t.csv"),
                 "vibro-impact: t.csv.partial: another sweep is writing it\n");
  EXPECT_EQ(contents(folder / "t.csv.partial"), "a head\n");
}

}  // namespace
