// Where the tables of the scene runner go, tested through the program itself: written while the run
// goes on, in place when they are whole, gone when they cannot be.
#include <sys/stat.h>

#include <string>
#include <vector>

#include "runner_program.hpp"

namespace {

using namespace vibro_impact::testing;

// r = 1 between two stops 2e-6 apart: an impact every 6.7e-6, some 1e6 a period.
const std::string rattle =
    "run --restitution 1 --stop 1:lower:-1e-6 --stop 1:upper:1e-6 --initial-velocity 0.3,0 ";

// A table is renamed into place: a link or a file of somebody else must survive that.
TEST_F(Runner, SparesLinksAndTheFilesOfOthers) {
  fs::create_symlink("target.csv", folder / "link.csv");
  EXPECT_EQ(run("run --until 5 --events link.csv").status, 2) << "the link leads nowhere";
  std::ofstream(folder / "target.csv") << "old";
  EXPECT_EQ(run("run --until 5 --events link.csv").status, 0);
  EXPECT_TRUE(fs::is_symlink(folder / "link.csv"));
  EXPECT_EQ(contents(folder / "target.csv").substr(0, 5), "time,");

  std::ofstream(folder / "e.csv") << "old";
  EXPECT_EQ(run("run --mass 0 --events e.csv").status, 2);
  EXPECT_EQ(run("run --events e.csv --samples /nonexistent/s.csv").status, 2);
  EXPECT_EQ(run("run --events e.csv --resume absent.state").status, 2);
  EXPECT_EQ(contents(folder / "e.csv"), "old") << "kept when the run does not take place";

  // Nor is a file of somebody else under the name that the table has until it is whole: sh runs the
  // program under its own number.
  const Result blocked =
      run("--version >/dev/null; sh -c 'echo theirs >o.csv.part$$; exec " VIBRO_IMPACT_PROGRAM
          " run --events o.csv'");
  EXPECT_EQ(blocked.status, 2);
  EXPECT_TRUE(is_one_message(blocked.err)) << blocked.err;
  EXPECT_FALSE(fs::exists(folder / "o.csv"));
  ASSERT_EQ(files().size(), 4u);
  EXPECT_EQ(contents(folder / files()[2]), "theirs\n") << files()[2];
}

// Devices and pipes are written as they stand: a file renamed onto them would take their place.
TEST_F(Runner, WritesDevicesAndPipesAsTheyStand) {
  const std::string table = run("run --until 50 --events -").out;
  EXPECT_GT(lines(table).size(), 10u);

  ASSERT_EQ(mkfifo((folder / "pipe").c_str(), 0600), 0);
  EXPECT_EQ(run("run --until 50 --events pipe && wait", "{ cat pipe >read.csv & }").status, 0);
  EXPECT_TRUE(fs::is_fifo(folder / "pipe"));
  EXPECT_EQ(contents(folder / "read.csv"), table);

  EXPECT_EQ(run("run --until 50 --events /dev/stdout | cat").out, table);
  EXPECT_EQ(run("run --until 50 --events /dev/null --samples /dev/null").status, 0);
  EXPECT_TRUE(fs::is_character_file("/dev/null"));
  EXPECT_EQ(files(), (std::vector<std::string>{"pipe", "read.csv"}));

  // What stands in a file that is open already is kept.
  for (const char *to : {"/dev/stdout >>log", "/dev/fd/3 3>>log", "/dev/stderr 2>>log"}) {
    std::ofstream(folder / "log") << "old\n";
    EXPECT_EQ(run(std::string("run --until 50 --events ") + to).status, 0) << to;
    EXPECT_EQ(contents(folder / "log").rfind("old\n" + table, 0), 0u) << to;
  }
}

// Standard output and error that are closed become no file of the program's: no table, and no line
// of progress, is written into another file.
TEST_F(Runner, WritesNothingOfAClosedDescriptorIntoItsFiles) {
  const std::string table = run("run --until 50 --events -").out;
  EXPECT_EQ(run("run --until 50 --save-state x --events - >&-").status, 2);
  EXPECT_EQ(files(), std::vector<std::string>{});
  EXPECT_EQ(run("run --until 50 --events e.csv <&- 2>&- >&-").status, 0);
  EXPECT_EQ(contents(folder / "e.csv"), table);
}

// Neither table is left when one cannot be written; the run ends there, far from its end.
TEST_F(Runner, AWriteThatFailsEndsTheRunAndLeavesNoTable) {
  const std::string without_end = "run --until 1e9 --resolve-chatter 0 --save-state x.state ";
  for (const char *tables : {"--events /dev/full", "--events - --samples s.csv >/dev/full",
                             "--events e.csv --every 10 --samples /dev/full"}) {
    const Result full = run(without_end + tables);
    EXPECT_EQ(full.status, 1) << tables;
    EXPECT_TRUE(is_one_message(full.err)) << tables << ": " << full.err;
    EXPECT_NE(full.err.find("cannot be written: No space left on device"), std::string::npos)
        << full.err;
    EXPECT_TRUE(fs::is_empty(folder)) << tables;
  }
  // The same halfway through a file: no more than 100 blocks are allowed.
  const Result limited = run(without_end + "--events e.csv --samples s.csv", "ulimit -f 100");
  EXPECT_EQ(limited.status, 1);
  EXPECT_TRUE(is_one_message(limited.err)) << limited.err;
  EXPECT_NE(limited.err.find("File too large"), std::string::npos) << limited.err;
  EXPECT_TRUE(fs::is_empty(folder));
  // A short table, too, is found out when it is closed.
  EXPECT_EQ(run("run --until 1 --events /dev/full").status, 1);
  // The reader of a pipe may leave early.
  const Result left = run(without_end + "--samples s.csv --events - | head -n 1");
  EXPECT_EQ(left.out, "time,mass,event,velocity_before,velocity_after,contact_mode\n");
  EXPECT_EQ(left.err, "") << "which is no error";
  EXPECT_TRUE(fs::is_empty(folder));
}

TEST_F(Runner, MemoryDoesNotGrowWithTheLengthOfTheRun) {
  without_quarantine();
  const Result brief = run("run --until 100 --every 0.1 --samples /dev/null --events /dev/null");
  const Result longer = run(
      "run --until 10000 --every 0.01 --samples /dev/null --events /dev/null --resolve-chatter 0");
  ASSERT_EQ(brief.status, 0) << brief.err;
  ASSERT_EQ(longer.status, 0) << longer.err;
  // A million rows are some 60 MB. Address sanitizer keeps freed memory for a while and has a byte
  // of its own for every eight.
#ifdef __SANITIZE_ADDRESS__
  EXPECT_LT(longer.peak_memory - brief.peak_memory, 24 * 1024) << "KiB";
#else
  EXPECT_LT(longer.peak_memory - brief.peak_memory, 8 * 1024) << "KiB";
  EXPECT_LT(longer.peak_memory, 50 * 1024) << "KiB";
#endif
}

TEST_F(Runner, ARunThatIsGivenUpWritesThePartBefore) {
  const Result result =
      run(rattle + "--max-impacts 1000 --events e.csv --samples s.csv --every 1e-5");
  EXPECT_EQ(result.status, 1);
  EXPECT_TRUE(is_one_message(result.err)) << result.err;
  EXPECT_NE(result.err.find("more than 1000 impacts"), std::string::npos) << result.err;
  EXPECT_NE(result.err.find("the tables hold what came before"), std::string::npos) << result.err;
  EXPECT_EQ(files(), (std::vector<std::string>{"e.csv", "s.csv"}));

  const auto events = lines(contents(folder / "e.csv")),
             samples = lines(contents(folder / "s.csv"));
  EXPECT_EQ(events.size(), 1002u) << "the header, the impacts within the limit, the one beyond";
  const double end = std::stod(cells(events.back())[0]);
  EXPECT_NEAR(end, 1000 * 2e-6 / 0.3, 1e-5);
  EXPECT_EQ(samples.front(), "time,x1,x2");
  EXPECT_NEAR(std::stod(cells(samples.back())[0]), end, 2.1e-5);
  // They are those of a run under a higher limit, as far as they go.
  const std::string higher = run(rattle + "--max-impacts 1500 --events - --resolve-chatter 0").out;
  EXPECT_GT(higher.size(), contents(folder / "e.csv").size());
  EXPECT_EQ(higher.rfind(contents(folder / "e.csv"), 0), 0u);

  const Result untold = run(rattle + "--max-impacts 1000");
  EXPECT_EQ(untold.status, 1);
  EXPECT_EQ(untold.err.find("tables"), std::string::npos) << "none was asked for";
}

}  // namespace
