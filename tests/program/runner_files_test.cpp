// The files of a run are whole or absent.
#include <string>
#include <vector>

#include "runner_program.hpp"

namespace {

using namespace vibro_impact::testing;

// r = 1 between two stops 2e-6 apart: an impact every 6.7e-6, some 1e6 a period.
const std::string rattle =
    "run --restitution 1 --stop 1:lower:-1e-6 --stop 1:upper:1e-6 --initial-velocity 0.3,0 "
    "--max-impacts 1000 ";

TEST_F(Runner, ARefusedRunSparesTheTableThatWasThere) {
  std::ofstream(folder / "e.csv") << "old";
  EXPECT_EQ(run("run --mass 0 --events e.csv").status, 2);
  EXPECT_EQ(run("run --events e.csv --samples missing/s.csv").status, 2);
  EXPECT_EQ(contents(folder / "e.csv"), "old");
  EXPECT_EQ(run("run --until 5 --events e.csv").status, 0);
  EXPECT_EQ(contents(folder / "e.csv").substr(0, 5), "time,");
  EXPECT_EQ(files(), std::vector<std::string>{"e.csv"});
}

TEST_F(Runner, ARunThatIsGivenUpLeavesNoFile) {
  const Result result = run(rattle + "--until 100 --events e.csv --samples s.csv --every 1e-5");
  EXPECT_EQ(result.status, 1);
  EXPECT_TRUE(is_one_message(result.err)) << result.err;
  EXPECT_NE(result.err.find("more than 1000 impacts"), std::string::npos) << result.err;
  EXPECT_TRUE(fs::is_empty(folder));
}

TEST_F(Runner, ADashIsStandardOutput) {
  ASSERT_EQ(run("run --until 50 --events e.csv").status, 0);
  EXPECT_EQ(run("run --until 50 --events -").out, contents(folder / "e.csv"));
  const Result full = run("run --until 50 --events - >/dev/full");
  EXPECT_EQ(full.status, 1);
  EXPECT_EQ(full.err, "vibro-impact: standard output cannot be written\n");
}

}  // namespace
