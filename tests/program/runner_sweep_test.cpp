// Sweeps of the program: the table, on threads and on processes, and a sweep that was killed.
#include <fstream>
#include <string>
#include <vector>

#include "program/files.hpp"
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
  Table expected = sweep_table(grid, options);
  for (std::size_t point = 0; point < grid.points(); ++point)
    add_row(expected, grid, options, point, record_of(grid.scene_at(point), options));

  const std::string arguments =
      "sweep --vary omega=0.25:0.7:19 --vary restitution=0.3:0.9:4 --longest 100 --lyapunov "
      "--pairs --table t.csv";
  for (const int processes : {1, 2, 3}) {  // 64 and 96 points a block, of 76: the last is short
    if (processes > 1 && !with_mpi) GTEST_SKIP() << "built without MPI";
    const Result result = run(arguments, "true", processes > 1 ? mpirun(processes) : "");
    ASSERT_EQ(result.status, 0) << result.err;
    EXPECT_EQ(lines(contents(folder / "t.csv")), lines(expected.text)) << processes << " processes";
    EXPECT_EQ(files(), std::vector<std::string>{"t.csv"});
  }
}

// At the first frequency a forcing period is longer than double precision can count, and the scene
// is refused there; with few steps allowed, r = 0.9 is given up.
TEST_F(Runner, APointThatIsRefusedOrGivenUpHasEmptyCells) {
  ASSERT_EQ(run("sweep --vary omega=1e-307:0.6:2 --table t.csv").status, 0);
  auto rows = lines(contents(folder / "t.csv"));
  ASSERT_EQ(rows.size(), 3u);
  EXPECT_EQ(rows[1].substr(rows[1].find(',')), ",,,,,,");
  EXPECT_GT(std::stod(truth::cells_of(rows[2])[1]), 0.0);

  const Result result =
      run("sweep --vary restitution=0:0.9:2 --max-steps 400 --longest 20 --omega 0.3 "
          "--table t.csv");
  ASSERT_EQ(result.status, 0);
  rows = lines(contents(folder / "t.csv"));
  ASSERT_EQ(rows.size(), 3u);
  EXPECT_EQ(rows[2], "0.90000000000000002,,,,,,");
  EXPECT_NE(result.err.find(" 1 were refused or given up"), std::string::npos) << result.err;
}

TEST_F(Runner, AKilledSweepGoesOnWithItsRowsAndNoOthers) {
  const std::string sweep =
      "sweep --vary omega=0.25:0.7:181 --vary restitution=0.6:0.8:5 --longest 50 --table t.csv ";
  const std::string all_computed = "905 points, 905 computed now";
  ASSERT_NE(run(sweep).err.find(all_computed), std::string::npos);
  const std::string whole = contents(folder / "t.csv");
  const fs::path path = folder / "t.csv.partial";
  // The shell kills the sweep as soon as a block stands in its journal, unless the sweep ends
  // first.
  const std::string kill =
      "& while test ! -e t.csv && ! grep -q crc t.csv.partial; do :; done; kill -KILL $!; wait $!";
  do {
    fs::remove(folder / "t.csv");
  } while (run(sweep + kill, one_thread + "true").status != 128 + 9);
  ASSERT_EQ(files(), std::vector<std::string>{"t.csv.partial"});
  const std::string partial = contents(path);

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

  // The rows of whole blocks are kept. (A journal that is cut: journal_test.) The name of a scene
  // file does not count, and an empty one has no options.
  const std::string scene = folder.string() + "-scene";
  std::ofstream{scene};
  const Result rest = run(sweep + "--resume --scene " + scene, "true", with_mpi ? mpirun(2) : "");
  ASSERT_EQ(rest.status, 0) << rest.err;
  EXPECT_EQ(rest.err.find(all_computed), std::string::npos) << rest.err;
  EXPECT_EQ(lines(contents(folder / "t.csv")), lines(whole));
  EXPECT_EQ(files(), std::vector<std::string>{"t.csv"});
  fs::remove(scene);
}

// The limit of a file's size stands for a full disk. The journal keeps the rows that fitted.
TEST_F(Runner, ASweepOnAFullDiskGoesOnLater) {
  const std::string sweep =
      "sweep --vary omega=1.1:1.2:40 --back --masses 1 --amplitude 0.1 --stop 1:upper:0.3 ";
  ASSERT_EQ(run(sweep + "--table whole.csv", one_thread + "true").status, 0);
  const std::string whole = contents(folder / "whole.csv");
  expect_message(run(sweep + "--table t.csv", one_thread + full_disk(1024)),
                 "vibro-impact: t.csv.partial: cannot be written: File too large\n", 1);
  const std::string journal = contents(folder / "t.csv.partial");
  EXPECT_EQ(journal.size(), 1024u);
  ASSERT_EQ(run(sweep + "--resume --table t.csv").status, 0);
  EXPECT_EQ(lines(contents(folder / "t.csv")), lines(whole));

  // A block with the right checksum and wrong rows, as another program could write it: of another
  // point, twice, with a column less and one more, beyond the last point, and of half a chain.
  const auto rows = lines(whole);
  const std::string head = journal.substr(0, journal.find(rows[1])),
                    all = whole.substr(whole.find('\n') + 1);
  const auto lines_of_head = std::count(head.begin(), head.end(), '\n');
  const auto at_line = [&](long line) {
    return "t.csv.partial: line " + std::to_string(lines_of_head + line) +
           ": not the row of its point; remove the file";
  };
  const struct {
    std::string rows;
    int status;
    std::string message;
  } refused[] = {{rows[2], 2, at_line(1)},
                 {rows[1] + '\n' + rows[1], 2, at_line(2)},
                 {rows[1].substr(0, rows[1].rfind(',')), 2, at_line(1)},
                 {rows[1] + ',', 2, at_line(1)},
                 {all + rows[1], 2, at_line(81)},
                 {rows[1] + '\n' + rows[2], 1, "82 rows of 80 points"}};
  for (const auto &[rows_of_block, status, message] : refused) {
    fs::remove(folder / "t.csv");
    fs::remove(folder / "t.csv.partial");
    runner::Journal((folder / "t.csv.partial").string(), head, false, {})
        .add({rows_of_block + '\n', "", ""});
    expect_message(run(sweep + "--resume --table t.csv"), "vibro-impact: " + message + '\n',
                   status);
    EXPECT_FALSE(fs::exists(folder / "t.csv"));
  }
}

TEST_F(Runner, ASecondSweepOnTheSameTableIsRefused) {
  const runner::Journal held(folder / "t.csv.partial", "a head\n", false,
                             [](auto...) { return true; });
  expect_message(run("sweep --vary omega=0.3:0.5:2 --resume --table t.csv"),
                 "vibro-impact: t.csv.partial: another sweep is writing it\n");
  EXPECT_EQ(contents(folder / "t.csv.partial"), "a head\n");
}

}  // namespace
