// Sweeps of the program: the table, on threads and on processes, and what is refused.
#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

#include "program/processes.hpp"
#include "runner_program.hpp"
#include "vibro_impact/analysis/analysis.hpp"
#include "vibro_impact/vibro_impact.hpp"

namespace {

using namespace vibro_impact::testing;
using namespace vibro_impact;

const std::string ranges =
    "--vary omega=0.25:0.7:19 --vary restitution=0.3:0.9:4 --longest 100 --table t.csv ";

const std::string one_thread = "export OMP_NUM_THREADS=1";

TEST_F(Runner, ASweepGivesTheRecordsOfTheLibrary) {
  const Result result = run("sweep " + ranges);
  ASSERT_EQ(result.status, 0) << result.err;
  const auto rows = lines(contents(folder / "t.csv"));
  ASSERT_EQ(rows.size(), 1u + 76u);
  EXPECT_EQ(rows[0],
            "omega,restitution,period,sticks1,sticks2,impacts1,impacts2,dual_sticking,lyapunov");
  Scene scene;
  scene.mass = scene.stiffness = {1.0, 1.0};
  scene.beta = 0.1;
  scene.amplitude = {0.5, 0.0};
  scene.stops = {{1, Side::lower, -0.3}, {2, Side::upper, 0.1}};
  RecordOptions options;
  options.settle.longest = 100;
  options.lyapunov = true;
  for (const std::size_t k : {0u, 9u, 38u, 75u}) {
    scene.omega = std::lerp(0.25, 0.7, static_cast<double>(k / 4) / 18.0);
    scene.restitution = std::lerp(0.3, 0.9, static_cast<double>(k % 4) / 3.0);
    const OrbitRecord record = record_of(scene, options);
    const double n = record.counts.periods;
    Table row("");
    row.row(scene.omega, scene.restitution, record.period, record.counts.sticks[0] / n,
            record.counts.sticks[1] / n, record.counts.impacts[0] / n, record.counts.impacts[1] / n,
            record.counts.dual_sticking ? 1 : 0, *record.lyapunov);
    EXPECT_EQ("\n" + rows[k + 1] + "\n", row.text);
  }
}

// Figure 5(a): one mass hits while the other is held.
TEST_F(Runner, ASweepTellsThePairsOfTableI) {
  const Result result =
      run("sweep --omega 0.1769 --stop 1:upper:0.3 --stop 2:upper:0.3 --vary restitution=0.6:0.7:2 "
          "--pairs --no-lyapunov --table t.csv");
  ASSERT_EQ(result.status, 0) << result.err;
  const auto rows = lines(contents(folder / "t.csv"));
  ASSERT_EQ(rows.size(), 3u);
  EXPECT_TRUE(rows[0].ends_with(",dual_sticking,pairs"));
  EXPECT_TRUE(rows[2].ends_with(",0,SI")) << rows[2];
}

TEST_F(Runner, ASweepDoesNotDependOnThreadsOrProcesses) {
  ASSERT_EQ(run("sweep " + ranges, one_thread).status, 0);
  const std::string expected = contents(folder / "t.csv");
  ASSERT_EQ(lines(expected).size(), 77u);
  for (const char *threads : {"2", "4"}) {
    const Result result = run("sweep " + ranges, std::string("export OMP_NUM_THREADS=") + threads);
    ASSERT_EQ(result.status, 0) << result.err;
    EXPECT_EQ(first_difference(contents(folder / "t.csv"), expected), "") << threads;
    EXPECT_EQ(files(), std::vector<std::string>{"t.csv"});
  }
  if (!with_mpi) GTEST_SKIP() << "built without MPI";
  for (const int processes : {2, 4}) {
    const Result result = run("sweep " + ranges, one_thread, mpirun(processes));
    ASSERT_EQ(result.status, 0) << result.err;
    EXPECT_EQ(first_difference(contents(folder / "t.csv"), expected), "") << processes;
    EXPECT_EQ(files(), std::vector<std::string>{"t.csv"});
  }
}

// The test starts itself as two processes, of which the second fails.
TEST_F(Runner, AnErrorOnAnotherProcessIsSaidAndEndsAll) {
  if (!with_mpi) GTEST_SKIP() << "built without MPI";
  if (std::getenv("OMPI_COMM_WORLD_SIZE") != nullptr)
    return Processes().share_out(
        1, [](std::size_t) -> std::vector<double> { throw std::logic_error("no such point"); },
        [](int, const ComputeRow &row) { row(0); });
  const Result result =
      run("--version; timeout 30 env " + mpirun(2) + fs::read_symlink("/proc/self/exe").string() +
          " --gtest_filter=*AnErrorOnAnother*");
  EXPECT_EQ(result.status, 2);
  EXPECT_NE(result.err.find("vibro-impact: process 1: no such point\n"), std::string::npos)
      << result.err;
}

TEST_F(Runner, APointThatIsGivenUpHasEmptyCells) {
  const Result result =
      run("sweep --vary omega=0.3:0.6:2 --vary restitution=0:0.9:2 --max-impacts 6 --longest 20 "
          "--table t.csv");
  EXPECT_EQ(result.status, 0);
  const auto rows = lines(contents(folder / "t.csv"));
  ASSERT_EQ(rows.size(), 5u);
  EXPECT_EQ(rows[2], "0.29999999999999999,0.90000000000000002,,,,,,,");
  EXPECT_NE(result.err.find("were given up"), std::string::npos) << result.err;
}

// No more memory for ten times as many periods, or as many points.
TEST_F(Runner, TheMemoryOfASweepDoesNotGrow) {
  without_quarantine();
  const auto peak = [this](const std::string &options) {
    const Result result = run("sweep --table t.csv --no-lyapunov " + options, one_thread);
    EXPECT_EQ(result.status, 0) << result.err;
    return result.peak_memory;
  };
  const long brief = peak("--vary omega=0.685:0.7:10 --longest 50");
  // KiB. Kept events of the longest would be 30 MB; address sanitizer packs its memory less well.
#ifdef __SANITIZE_ADDRESS__
  const long more = 8 * 1024;
#else
  const long more = 1024;
#endif
  EXPECT_LT(peak("--vary omega=0.685:0.7:10 --longest 2000"), brief + more);
  EXPECT_LT(peak("--vary omega=0.26:0.29:2000 --longest 50"), brief + more);
}

}  // namespace
