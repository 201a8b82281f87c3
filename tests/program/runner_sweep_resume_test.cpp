// A sweep of the program that was killed is gone on with: no point twice, none lost.
#include <fcntl.h>
#include <signal.h>

#include <chrono>
#include <functional>
#include <string>
#include <thread>
#include <vector>

#include "program/bad_input.hpp"
#include "program/partial_table.hpp"
#include "runner_program.hpp"

namespace {

using namespace vibro_impact::testing;
using namespace vibro_impact;

// The points of a partial table that stand under a checksum.
std::size_t points_kept(const fs::path &partial) {
  std::size_t points = 0;
  const std::string text = contents(partial);
  for (const std::string &line : lines(text.substr(0, text.rfind('\n') + 1)))
    if (line.rfind("points ", 0) == 0) points = std::stoul(line.substr(7));
  return points;
}

// A process started in the background, in a group of its own.
pid_t start(const std::string &command) {
  const pid_t child = fork();
  if (child != 0) return child;
  setpgid(0, 0);
  const int nowhere = open("/dev/null", O_WRONLY);
  dup2(nowhere, 1);
  dup2(nowhere, 2);
  execl("/bin/sh", "sh", "-c", ("exec " + command).c_str(), nullptr);
  _exit(127);
}

void wait_for(pid_t process) {
  int status = 0;
  EXPECT_EQ(waitpid(process, &status, 0), process);
}

bool ended(pid_t process) {
  siginfo_t info = {};
  waitid(P_PID, static_cast<id_t>(process), &info, WEXITED | WNOHANG | WNOWAIT);
  return info.si_pid == process;
}

// Some 1,300 points, about two seconds' work.
const std::string long_sweep =
    "sweep --omega 0.25:0.7:181 --restitution 0.6:0.85:7 --longest 150 --no-lyapunov --threads 2 ";

// Waits until `partial` holds more than `before` points, or the process has ended.
void wait_for_more(const fs::path &partial, std::size_t before, pid_t process) {
  while (!ended(process) && points_kept(partial) <= before)
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
}

TEST_F(Runner, AKilledSweepIsGoneOnWith) {
  const std::string expected = run(long_sweep).out;
  const fs::path partial = folder / "t.csv.partial";
  const std::string go_on = long_sweep + "--resume --table " + (folder / "t.csv").string();
  std::size_t kept = 0;
  for (int killed = 0; killed < 3; ++killed) {
    const pid_t sweep = start(VIBRO_IMPACT_PROGRAM " " + go_on);
    wait_for_more(partial, kept, sweep);
    EXPECT_FALSE(ended(sweep)) << "too fast to be killed";
    kill(sweep, SIGKILL);
    wait_for(sweep);
    EXPECT_GT(points_kept(partial), kept);
    kept = points_kept(partial);
    EXPECT_EQ(files(), std::vector<std::string>{"t.csv.partial"});
  }
  // Not by mistake over what was computed, and not as another sweep.
  const Result without = run(long_sweep + "--table t.csv");
  EXPECT_EQ(without.status, 2);
  EXPECT_TRUE(is_one_message(without.err)) << without.err;
  const Result another = run(long_sweep + "--table t.csv --resume --beta 0.2");
  EXPECT_EQ(another.status, 2);
  EXPECT_NE(another.err.find("another sweep"), std::string::npos) << another.err;
  EXPECT_EQ(points_kept(partial), kept);

  const Result rest = run(go_on);
  ASSERT_EQ(rest.status, 0) << rest.err;
  EXPECT_NE(rest.err.find("1267 points: " + std::to_string(1267 - kept) + " computed"),
            std::string::npos)
      << rest.err << kept << " kept";
  EXPECT_EQ(first_difference(contents(folder / "t.csv"), expected), "");
  EXPECT_EQ(files(), std::vector<std::string>{"t.csv"});
}

// One of the processes is killed: mpirun ends the others.
TEST_F(Runner, ASweepOfWhichAProcessWasKilledIsGoneOnWith) {
  if (!with_mpi) GTEST_SKIP() << "built without MPI";
  const std::string expected = run(long_sweep).out;
  const fs::path partial = folder / "t.csv.partial";
  const std::string go_on = long_sweep + "--resume --table " + (folder / "t.csv").string();
  std::size_t kept = 0;
  for (const std::size_t victim : {1u, 0u}) {
    setenv("OMPI_ALLOW_RUN_AS_ROOT", "1", 1);
    setenv("OMPI_ALLOW_RUN_AS_ROOT_CONFIRM", "1", 1);
    const pid_t sweep = start(MPIRUN " --oversubscribe -n 2 " VIBRO_IMPACT_PROGRAM " " + go_on);
    wait_for_more(partial, kept, sweep);
    EXPECT_FALSE(ended(sweep)) << "too fast to be killed";
    const std::string children =
        "/proc/" + std::to_string(sweep) + "/task/" + std::to_string(sweep) + "/children";
    std::istringstream list(contents(children));
    std::vector<pid_t> ranks;
    for (pid_t rank = 0; list >> rank;) ranks.push_back(rank);
    ASSERT_EQ(ranks.size(), 2u);
    kill(ranks[victim], SIGKILL);
    wait_for(sweep);
    EXPECT_GT(points_kept(partial), kept);
    kept = points_kept(partial);
  }
  const Result rest = run(go_on, "true", mpirun(2));
  ASSERT_EQ(rest.status, 0) << rest.err;
  EXPECT_EQ(first_difference(contents(folder / "t.csv"), expected), "");
  EXPECT_EQ(files(), std::vector<std::string>{"t.csv"});
}

std::string row(std::size_t point) {
  return std::to_string(point) + "," + std::to_string(point * point) + "\n";
}

std::string table_of(std::size_t points) {
  std::string table = "point,square\n";
  for (std::size_t k = 0; k < points; ++k) table += row(k);
  return table;
}

// Cut at any byte, as a write is that never came to its end: the points that were checked are
// there, the others are computed again, and the table is the same.
TEST_F(Runner, RowsCutShortAnywhereAreGoneOnWith) {
  constexpr std::size_t points = 200;
  const std::string path = (folder / "t.partial").string(), whole = (folder / "t").string();
  {
    runner::PartialTable partial(path, "squares", "point,square\n", false);
    for (std::size_t k = 0; k < points; ++k) partial.add(row(k));
  }
  const std::string file = contents(path);
  EXPECT_EQ(points_kept(path), 192u);  // 3 times 64
  EXPECT_GT(file.size(), 1500u);
  for (std::size_t length = 0; length <= file.size(); ++length) {
    std::ofstream(path, std::ios::binary) << file.substr(0, length);
    const std::size_t expected = points_kept(path);
    runner::PartialTable partial(path, "squares", "point,square\n", true);
    const std::size_t kept = partial.points();
    EXPECT_EQ(kept, expected) << length;
    for (std::size_t k = kept; k < points; ++k) partial.add(row(k));
    partial.finish({"--table", whole});
    ASSERT_EQ(contents(whole), table_of(points)) << length;
    ASSERT_FALSE(fs::exists(path));
  }
}

TEST_F(Runner, ChangedRowsAreRefused) {
  const std::string path = (folder / "t.partial").string();
  {
    runner::PartialTable partial(path, "squares", "point,square\n", false);
    for (std::size_t k = 0; k < 64; ++k) partial.add(row(k));
  }
  const std::string file = contents(path);
  for (std::size_t i = 0; i < file.size(); ++i) {
    std::string changed = file;
    changed[i] = changed[i] == '1' ? '2' : '1';
    std::ofstream(path, std::ios::binary) << changed;
    const bool last_end = i + 1 == file.size();  // then the checksum itself seems cut
    if (last_end) continue;
    try {
      const runner::PartialTable partial(path, "squares", "point,square\n", true);
      // A line that is no longer one of checksums makes what follows rows without any.
      EXPECT_LT(partial.points(), 64u) << i;
    } catch (const runner::BadInput &error) {
      EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
      EXPECT_EQ(contents(path), changed) << "left as it was";
    }
  }
}

// Two at once on one table: one holds the rows, the other is refused.
TEST_F(Runner, OneSweepAtATimeHoldsTheTable) {
  const fs::path table = folder / "t.csv", partial = folder / "t.csv.partial";
  const std::string both = long_sweep + "--resume --table " + table.string();
  const pid_t first = start(VIBRO_IMPACT_PROGRAM " " + both);
  wait_for_more(partial, 0, first);
  const Result second = run(both);
  EXPECT_FALSE(ended(first)) << "too fast";
  EXPECT_EQ(second.status, 2);
  EXPECT_EQ(second.err, "vibro-impact: " + partial.string() + ": another sweep is writing it\n");
  wait_for(first);
  EXPECT_EQ(lines(contents(table)).size(), 1268u);
  EXPECT_EQ(files(), std::vector<std::string>{"t.csv"});
}

// A file of rows that is removed or changed while the sweep runs gives no table, and spares the one
// that was there.
TEST_F(Runner, ASweepWithoutItsRowsEndsWithoutATable) {
  const std::string path = (folder / "t.partial").string();
  const runner::Named table{"--table", (folder / "t").string()};
  std::ofstream(table.path) << "old";
  const auto remove = [&] { fs::remove(path); };
  const auto replace = [&] {
    fs::copy_file(path, path + "2");
    fs::rename(path + "2", path);
  };
  const auto cut = [&] { fs::resize_file(path, 500); };
  const auto empty = [&] { fs::resize_file(path, 0); };
  const auto change = [&] {
    std::fstream file(path, std::ios::in | std::ios::out);
    file.seekp(300);
    file << "7";
  };
  for (const auto &[name, damage] :
       {std::pair<const char *, std::function<void()>>{"remove", remove},
        {"replace", replace},
        {"cut", cut},
        {"empty", empty},
        {"change", change}})
    for (const std::size_t after : {100u, 192u}) {  // then rows are written, or none are
      std::ofstream(path).close();
      fs::remove(path);
      runner::PartialTable partial(path, "squares", "point,square\n", false);
      for (std::size_t k = 0; k < after; ++k) partial.add(row(k));
      damage();
      EXPECT_THROW(
          {
            for (std::size_t k = after; k < 192; ++k) partial.add(row(k));
            partial.finish(table);
          },
          std::runtime_error)
          << name << after;
      EXPECT_EQ(contents(table.path), "old") << name << after;
      fs::remove(path);
    }
}

}  // namespace
