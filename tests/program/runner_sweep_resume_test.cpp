// A sweep of the program that was ended, wherever that was, is gone on with: no point twice, none
// lost.
#include <fcntl.h>
#include <signal.h>

#include <chrono>
#include <functional>
#include <string>
#include <thread>
#include <vector>

#include "program/partial_table.hpp"
#include "runner_program.hpp"

namespace {

using namespace vibro_impact::testing;
using namespace vibro_impact;

// The rows of a partial table that stand there whole, below its two lines of a head.
std::size_t points_kept(const fs::path &partial) {
  const std::string text = contents(partial);
  const auto whole = static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
  return std::max<std::size_t>(whole, 2) - 2;
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
    "sweep --vary omega=0.25:0.7:181 --vary restitution=0.6:0.85:7 --longest 150 --no-lyapunov ";

// Waits until `partial` holds more than `before` points, or the process has ended.
void wait_for_more(const fs::path &partial, std::size_t before, pid_t process) {
  while (!ended(process) && points_kept(partial) <= before)
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  EXPECT_FALSE(ended(process)) << "too fast to be killed";
}

// The process that mpirun has started with the number `rank`.
pid_t rank_of(pid_t mpirun, std::size_t rank) {
  const std::string of = std::to_string(mpirun);
  std::istringstream list(contents("/proc/" + of + "/task/" + of + "/children"));
  std::vector<pid_t> ranks;
  for (pid_t one = 0; list >> one;) ranks.push_back(one);
  EXPECT_EQ(ranks.size(), 2u);
  return ranks.at(rank);
}

// The program alone, and one of two processes: mpirun ends the other.
TEST_F(Runner, AKilledSweepIsGoneOnWith) {
  ASSERT_EQ(run(long_sweep + "--table whole.csv").status, 0);
  const std::string expected = contents(folder / "whole.csv");
  fs::remove(folder / "whole.csv");
  const fs::path partial = folder / "t.csv.partial";
  const std::string go_on = long_sweep + "--resume --table " + (folder / "t.csv").string();
  std::size_t kept = 0;
  for (int killed = 0; killed < (with_mpi ? 4 : 2); ++killed) {
    const bool alone = killed < 2;
    const pid_t sweep = start((alone ? "" : "env " + mpirun(2)) + VIBRO_IMPACT_PROGRAM " " + go_on);
    wait_for_more(partial, kept, sweep);
    kill(alone ? sweep : rank_of(sweep, static_cast<std::size_t>(3 - killed)), SIGKILL);
    wait_for(sweep);
    EXPECT_GT(points_kept(partial), kept);
    kept = points_kept(partial);
    EXPECT_EQ(files(), std::vector<std::string>{"t.csv.partial"});
  }
  // Not by mistake over what was computed, and not as another sweep.
  for (const auto &[given, names] : {std::pair{"", "--resume goes on with it"},
                                     {"--resume --beta 0.2", "not the rows of this sweep"}}) {
    const Result refused = run(long_sweep + "--table t.csv " + given);
    EXPECT_EQ(refused.status, 2);
    EXPECT_TRUE(is_one_message(refused.err)) << refused.err;
    EXPECT_NE(refused.err.find(names), std::string::npos) << refused.err;
  }
  // The options may come in another order.
  const Result rest =
      run("sweep --resume --no-lyapunov --longest 150 --table t.csv --vary " +
              long_sweep.substr(long_sweep.find("omega="),
                                long_sweep.find("--longest") - long_sweep.find("omega=")),
          "true", with_mpi ? mpirun(2) : "");
  ASSERT_EQ(rest.status, 0) << rest.err;
  EXPECT_NE(rest.err.find("1267 points: " + std::to_string(1267 - kept) + " computed"),
            std::string::npos)
      << rest.err << kept << " kept";
  EXPECT_EQ(first_difference(contents(folder / "t.csv"), expected), "");
  EXPECT_EQ(files(), std::vector<std::string>{"t.csv"});
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

// The rows of a sweep by themselves.
struct PartialTable : Runner {
  static constexpr std::size_t points = 40;
  std::string path, table;

  void SetUp() override {
    Runner::SetUp();
    path = folder / "t.partial";
    table = folder / "t";
  }
  runner::PartialTable begun(bool resume) const {
    return {path, "squares", "point,square\n", resume};
  }
  static std::string row(std::size_t point) {
    return std::to_string(point) + "," + std::to_string(point * point) + "\n";
  }
  // Adds the rows that are missing up to `end`.
  static void add_to(runner::PartialTable &partial, std::size_t end) {
    while (partial.points() < end) partial.add(row(partial.points()));
  }
};

// Cut at any byte, as a write is that never came to its end: the whole rows are there, the others
// are computed again, and the table is the same. With another byte in it the file is refused.
TEST_F(PartialTable, RowsCutShortAreGoneOnWithAndChangedOnesRefused) {
  std::string whole = "point,square\n";
  for (std::size_t k = 0; k < points; ++k) whole += row(k);
  {
    runner::PartialTable partial = begun(false);
    add_to(partial, points);
  }
  const std::string file = contents(path);
  EXPECT_EQ(points_kept(path), points);
  for (std::size_t length = 0; length <= file.size(); ++length) {
    std::ofstream(path, std::ios::binary) << file.substr(0, length);
    const std::size_t expected = points_kept(path);
    runner::PartialTable partial = begun(true);
    EXPECT_EQ(partial.points(), expected) << length;
    add_to(partial, points);
    partial.finish(table);
    ASSERT_EQ(contents(table), whole) << length;
    ASSERT_FALSE(fs::exists(path));
  }
  for (std::size_t i = 0; i + 1 < file.size(); ++i) {  // the last byte is the end of a line
    std::string changed = file;
    changed[i] = changed[i] == '1' ? '2' : '1';
    std::ofstream(path, std::ios::binary) << changed;
    EXPECT_THROW(begun(true), std::invalid_argument) << i;
    EXPECT_EQ(contents(path), changed) << "left as it was";
  }
  // One that cannot be opened a second time, to be read.
  std::ofstream(path, std::ios::binary) << file;
  const rlimit few{static_cast<rlim_t>(::dup(0) + 2), 4096}, many{4096, 4096};
  ::setrlimit(RLIMIT_NOFILE, &few);
  EXPECT_THROW(begun(true), std::invalid_argument);
  ::setrlimit(RLIMIT_NOFILE, &many);
  EXPECT_EQ(contents(path), file);
}

// A file of rows that is cut or changed while the sweep runs gives no table, and spares the one
// that was there.
TEST_F(PartialTable, ASweepWithoutItsRowsEndsWithoutATable) {
  std::ofstream(table) << "old";
  const std::pair<const char *, std::function<void()>> damages[] = {
      {"cut", [this] { fs::resize_file(path, 500); }},
      {"emptied", [this] { fs::resize_file(path, 0); }},
      {"changed", [this] {
         std::fstream file(path, std::ios::in | std::ios::out);
         file.seekp(300);
         file << "7";
       }}};
  for (const auto &[name, damage] : damages)
    for (const std::size_t after : {points / 2, points}) {  // then rows are written, or none are
      runner::PartialTable partial = begun(false);
      add_to(partial, after);
      damage();
      EXPECT_ANY_THROW({
        add_to(partial, points);
        partial.finish(table);
      }) << name
         << after;
      EXPECT_EQ(contents(table), "old") << name << after;
      fs::remove(path);
    }
}

// One that loses its name is held all the same, also where another sweep begins under that name.
TEST_F(PartialTable, ASweepKeepsItsRowsWhateverHasTheirName) {
  const std::function<void()> losses[] = {[this] { fs::remove(path); },
                                          [this] {
                                            std::ofstream(path + "2") << "other";
                                            fs::rename(path + "2", path);
                                          }};
  for (const auto &loss : losses) {
    runner::PartialTable partial = begun(false);
    add_to(partial, points / 2);
    loss();
    const std::string of_others = contents(path);
    add_to(partial, points);
    partial.finish(table);
    EXPECT_EQ(lines(contents(table)).size(), points + 1);
    EXPECT_EQ(contents(path), of_others);
  }
}

}  // namespace
