// Runs that a signal ends: their files are whole, and gone on with they are those of a run that
// nobody disturbed, byte for byte.
#include <fcntl.h>
#include <sys/stat.h>

#include <chrono>
#include <cmath>
#include <csignal>
#include <limits>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "program/options.hpp"
#include "program/sample_times.hpp"
#include "runner_program.hpp"

namespace {

using namespace vibro_impact::testing;
using namespace vibro_impact;

int questions_left;  // until there is a signal
int signal_after_questions() {
  return questions_left > 0 && --questions_left > 0 ? 0 : SIGINT;
}
int no_signal() {
  return 0;
}

// Runs by `run_scene` itself, in which a signal comes when the test wants.
struct InProcess : Runner {
  runner::Request request;

  void SetUp() override {
    Runner::SetUp();
    ask_for({"--omega", "0.28", "--until", "40", "--every", "0.25"});
  }
  void ask_for(std::vector<std::string> words) {
    words.insert(words.begin(), {"vibro-impact", "run"});
    std::vector<char *> arguments;
    for (std::string &word : words) arguments.push_back(word.data());
    request = {};
    ASSERT_FALSE(runner::parse(static_cast<int>(arguments.size()), arguments.data(), request));
  }
  void name_files(const std::string &part) {
    request.events = folder / ("e" + part + ".csv");
    request.samples = folder / ("s" + part + ".csv");
    request.save_state = folder / ("x" + part);
  }
  // The exit status, and what is said of a signal.
  std::pair<int, std::string> run_now(int (*signal)()) const {
    ::testing::internal::CaptureStderr();
    std::pair<int, std::string> ending{0, ""};
    try {
      runner::run_scene(request, signal);
    } catch (const runner::EndedBySignal &ended) {
      ending = {128 + ended.signal, ended.said};
    }
    ::testing::internal::GetCapturedStderr();
    return ending;
  }
  // Ends the run at the first question for a signal, at the second, ... : each with what follows
  // gives the tables of the whole. How often that was.
  int interrupt_everywhere() {
    request.resume.clear();
    name_files("");
    EXPECT_EQ(run_now(no_signal).first, 0);
    const std::string events = contents(request.events), samples = contents(request.samples);
    EXPECT_GT(lines(events).size(), 10u);
    for (int after = 1;; ++after) {
      request.resume.clear();
      name_files("1");
      questions_left = after;
      const auto [status, said] = run_now(signal_after_questions);
      if (status == 0) return after - 1;  // over before the signal
      EXPECT_EQ(status, 128 + SIGINT);
      EXPECT_EQ(said.rfind("interrupted at t = ", 0), 0u) << said;
      request.resume = request.save_state;
      name_files("2");
      EXPECT_EQ(run_now(no_signal).first, 0);
      const auto both = [this](const std::string &table) {
        return contents(folder / (table + "1.csv")) +
               below_header(contents(folder / (table + "2.csv")));
      };
      EXPECT_EQ(first_difference(both("e"), events), "") << said;
      EXPECT_EQ(first_difference(both("s"), samples), "") << said;
      if (HasFailure()) return after;
    }
  }
};

// In all flights, and between samples of one: far from events, within a chatter that is carried to
// its limit or resolved, in sticking.
TEST_F(InProcess, WhereverASignalComesTheTablesGoOnByteForByte) {
  for (const double resolve : {std::numeric_limits<double>::infinity(), 0.0}) {
    request.options.resolve_chatter = resolve;
    EXPECT_GT(interrupt_everywhere(), 200) << "it is asked before each flight and sample";
  }
  EXPECT_EQ(files(), (std::vector<std::string>{"e.csv", "e1.csv", "e2.csv", "s.csv", "s1.csv",
                                               "s2.csv", "x", "x1", "x2"}));
}

// Impacts at the times of samples, but for rounding: a free mass between two elastic stops.
TEST_F(InProcess, ASignalMayComeWhereASampleAndAnEventMeet) {
  ask_for({"--masses", "1", "--stiffness", "0", "--amplitude", "0", "--restitution", "1",
           "--initial-velocity", "1", "--stop", "1:lower:-0.3", "--stop", "1:upper:0.3", "--until",
           "20", "--every", "0.1"});
  EXPECT_GT(interrupt_everywhere(), 200);
}

// Beside a sample the time at which a run ended may be off by its rounding.
TEST(SampleTimes, ReachAsFarAsTheirLastSampleAndShortOfTheNext) {
  const runner::SampleTimes samples{1.0, 10.0, 0.1, 3};  // at 1.0, 1.1 and 1.2
  const double last = sample_time(1.0, 10.0, 0.1, 2), next = sample_time(1.0, 10.0, 0.1, 3);
  for (const double time : {1.15, std::nextafter(last, 0.0), last, 1.25, std::nextafter(next, 0.0),
                            next, std::nextafter(next, 2.0)}) {
    const double reached = samples.reach(time);
    runner::SampleTimes after{1.0, 10.0, 0.1};
    after.skip_to(reached);
    EXPECT_EQ(after.taken, 3u) << time;
    EXPECT_NEAR(reached, time, time < last ? 0.06 : 4e-15) << time;
  }
}

// The program, started without a shell so that a signal finds it.
struct Started : Runner {
  pid_t program = 0;

  void start(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), VIBRO_IMPACT_PROGRAM);
    std::vector<char *> words;
    for (std::string &argument : arguments) words.push_back(argument.data());
    words.push_back(nullptr);
    program = fork();
    if (program != 0) return;
    const int err =
        chdir(folder.c_str()) == 0 ? open("err.txt", O_CREAT | O_TRUNC | O_WRONLY, 0600) : -1;
    if (err < 0 || dup2(err, STDERR_FILENO) < 0) _exit(127);
    execv(VIBRO_IMPACT_PROGRAM, words.data());
    _exit(127);
  }
  // As a shell tells it; what was said comes from the file that is removed.
  std::pair<int, std::string> ending() {
    int status = 0;
    EXPECT_EQ(waitpid(program, &status, 0), program);
    const std::string said = contents(folder / "err.txt");
    fs::remove(folder / "err.txt");
    return {WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status), said};
  }
  // Until something stands in the file, which it may not have put in place yet.
  void wait_for(const std::string &file) const {
    const fs::path part = folder / (file + ".part" + std::to_string(program));
    std::error_code none;
    while (!(fs::file_size(folder / file, none) > 0 && !none) &&
           !(fs::file_size(part, none) > 0 && !none))
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
};

TEST_F(Started, CtrlCAndTerminationLeaveWholeTablesAndAState) {
  for (const auto &[signal, stop] : {std::pair{SIGINT, "1:lower:-0.3"}, {SIGTERM, "none"}}) {
    start({"run", "--until", "1e15", "--stop", stop, "--events", "e1.csv", "--samples", "s1.csv",
           "--every", "1", "--save-state", "x"});
    wait_for("s1.csv");
    for (int times = 0; times < 20; ++times) {  // `timeout` sends it twice
      kill(program, signal);
      std::this_thread::sleep_for(std::chrono::microseconds(200));
    }
    const auto [status, said] = ending();
    ASSERT_EQ(status, 128 + signal);
    EXPECT_TRUE(is_one_message(said)) << said;
    EXPECT_NE(said.find("; the tables hold what came before; the state reached is saved\n"),
              std::string::npos)
        << said;
    ASSERT_EQ(files(), (std::vector<std::string>{"e1.csv", "s1.csv", "x"}));
    // Whole: their last lines, too, have all their cells.
    EXPECT_TRUE(contents(folder / "e1.csv").ends_with('\n'));
    EXPECT_TRUE(contents(folder / "s1.csv").ends_with('\n'));
    EXPECT_EQ(cells(lines(contents(folder / "s1.csv")).back()).size(), 3u);
    for (const std::string &file : files()) fs::remove(folder / file);
  }
}

// Where nobody looks at the flag: the modes of 6,000 masses take minutes, a pipe has no other end.
TEST_F(Started, ASignalEndsWhateverTakesLong) {
  ASSERT_EQ(mkfifo((folder / "pipe").c_str(), 0600), 0);
  for (const std::vector<std::string> &arguments :
       {std::vector<std::string>{"run", "--masses", "6000", "--stop", "1:lower:-0.3"},
        {"run", "--resume", "pipe"},
        {"run", "--events", "pipe"}})
    for (const int signal : {SIGINT, SIGTERM}) {
      start(arguments);
      std::this_thread::sleep_for(std::chrono::milliseconds(300));
      const auto begin = std::chrono::steady_clock::now();
      kill(program, signal);
      const auto [status, said] = ending();
      EXPECT_EQ(status, 128 + signal) << arguments[1];
      EXPECT_EQ(is_one_message(said), arguments[1] == "--masses") << said;  // others: not yet begun
      EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(5)) << arguments[1];
    }
  EXPECT_EQ(files(), std::vector<std::string>{"pipe"});
}

// At once, where nobody looks for the first.
TEST_F(Started, ASecondSignalEndsTheProgramAtOnce) {
  for (const int signal : {SIGINT, SIGTERM}) {
    start({"run", "--masses", "6000", "--stop", "1:lower:-0.3", "--events", "e.csv"});
    std::this_thread::sleep_for(std::chrono::milliseconds(300));
    kill(program, signal);
    std::this_thread::sleep_for(std::chrono::milliseconds(300));
    EXPECT_EQ(waitpid(program, nullptr, WNOHANG), 0) << "ended by the first";
    kill(program, signal);
    EXPECT_EQ(ending().first, 128 + signal);
    EXPECT_FALSE(fs::exists(folder / "e.csv"));
  }
}

TEST_F(Started, AnInterruptedSweepSaysWhereItsRowsStand) {
  start({"sweep", "--vary", "omega=0.25:0.7:2000", "--table", "t.csv"});
  wait_for("t.csv.partial");
  kill(program, SIGINT);
  const auto [status, said] = ending();
  EXPECT_EQ(status, 128 + SIGINT);
  EXPECT_EQ(said,
            "vibro-impact: interrupted; the rows so far stand in t.csv.partial: --resume goes on "
            "with them\n");
  EXPECT_EQ(files(), std::vector<std::string>{"t.csv.partial"});
}

TEST_F(Started, ASignalThatWasIgnoredIsIgnoredStill) {
  const std::string loop = "trap '' INT; " VIBRO_IMPACT_PROGRAM
                           " run --until 100000 --events e.csv & while [ ! -s e.csv.part$! ]; do "
                           "sleep 0.01; done; kill -s INT $!; wait $!";
  EXPECT_EQ(run("--version >/dev/null; " + loop).status, 0);
  EXPECT_EQ(files(), std::vector<std::string>{"e.csv"});
}

}  // namespace
