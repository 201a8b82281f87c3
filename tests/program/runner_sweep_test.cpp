// Sweeps of the program: the table, on threads and on processes, and a sweep that was killed.
#include <fstream>
#include <iterator>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

#include "program/journal.hpp"
#include "program/processes.hpp"
#include "reference/scenes/paper_scenes.hpp"
#include "reference/truth/table_reader.hpp"
#include "tests/support/runner_program.hpp"
#include "vibro_impact/analysis/analysis.hpp"

namespace {

using namespace vibro_impact::testing;
using namespace vibro_impact;

const std::string one_thread = "export OMP_NUM_THREADS=1 && ";

// The table is that of the library, to the byte, whatever the number of processes. (Of threads:
// sweep_test.)
TEST_F(Runner, ASweepGivesTheTableOfTheLibrary) {
  const Grid grid{paper::figure2(), {{"omega", 0.25, 0.7, 19}, {"restitution", 0.3, 0.9, 4}}};
  RecordOptions options;
  options.settle.longest = 100;
  options.lyapunov = options.pairs = true;
  SweepTables tables = sweep_tables(grid, options);
  for (std::size_t point = 0; point < grid.points(); ++point)
    add_rows(tables, grid, options, point, record_of(grid.scene_at(point), options));

  const std::string arguments =
      "sweep --vary omega=0.25:0.7:19 --vary restitution=0.3:0.9:4 --longest 100 --lyapunov "
      "--pairs --table t.csv";
  for (const int processes : {1, 3, 4}) {
    if (processes > 1 && !with_mpi) GTEST_SKIP() << "built without MPI";
    const Result result = run(arguments, "true", processes > 1 ? mpirun(processes) : "");
    ASSERT_EQ(result.status, 0) << result.err;
    EXPECT_EQ(lines(contents(folder / "t.csv")), lines(tables.records.text))
        << processes << " processes";
    EXPECT_EQ(files(), std::vector<std::string>{"t.csv"});
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
       "2 of 4 points: start: mass 1 at -0.6, beyond its lower stop at -0.3; first at "
       "displacement1 = "
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
    // mpirun may say of the network what it likes.
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

// The processes take the points of Figure 3, each with the time that it took once. The slowest
// twentieth of the points takes ten times the median, the slowest point twenty times. An equal part
// of consecutive points for each process would have an efficiency below 0.4 on 16.
TEST(Processes, HardlyWaitForEachOther) {
  std::ifstream file(SOURCE_DIR "/tests/program/point_times.txt");
  std::string comment;
  std::getline(file, comment);
  const std::vector<double> times(std::istream_iterator<double>{file}, {});
  ASSERT_EQ(times.size(), 1801u);
  const double sum = std::accumulate(times.begin(), times.end(), 0.0);
  // Measured: 0.999, 0.998, 0.996 and 0.986.
  for (const auto &[processes, efficiency] :
       std::vector<std::pair<std::size_t, double>>{{2, 0.99}, {4, 0.99}, {8, 0.99}, {16, 0.98}}) {
    std::vector<double> ends(processes, 0.0);
    for (std::size_t taken = 0; taken < times.size();) {
      const std::size_t count = tasks_at_once(times.size() - taken, processes);
      double &end = *std::ranges::min_element(ends);
      for (const std::size_t begin = taken; taken < begin + count; ++taken) end += times.at(taken);
    }
    EXPECT_GT(sum / (static_cast<double>(processes) * std::ranges::max(ends)), efficiency)
        << processes << " processes";
  }
}

TEST_F(Runner, ASecondSweepOnTheSameTableIsRefused) {
  const runner::Journal held(folder / "t.csv.partial", "a head\n", 2, false);
  expect_message(run("sweep --vary omega=0.3:0.5:2 --resume --table t.csv"),
                 "vibro-impact: t.csv.partial: another sweep is writing it\n");
  EXPECT_EQ(contents(folder / "t.csv.partial"), "a head\n");
}

}  // namespace
