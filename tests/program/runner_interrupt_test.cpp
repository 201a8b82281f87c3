// Runs of the scene runner that a signal ends: their files are whole, and gone on with they are
// those of a run that nobody disturbed, byte for byte.
#include <fcntl.h>
#include <poll.h>

#include <cmath>
#include <csignal>
#include <limits>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "program/run_command.hpp"
#include "program/tables.hpp"
#include "program/watch.hpp"
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
    Scene &scene = request.scene;
    scene.mass = {1.0, 1.0};
    scene.stiffness = {1.0, 1.0};
    scene.beta = 0.1;
    scene.amplitude = {0.5, 0.0};
    scene.omega = 0.28;
    scene.restitution = 0.7;
    scene.stops = {{1, Side::lower, -0.3}, {2, Side::upper, 0.1}};
    request.until = 40.0;
    request.every = 0.25;
    name_files("");
  }
  void name_files(const std::string &part) {
    request.events = folder / ("e" + part + ".csv");
    request.samples = folder / ("s" + part + ".csv");
    request.save_state = folder / ("x" + part);
  }
  // The exit status, and what was said of it on standard error.
  std::pair<int, std::string> run_now(int (*signal)()) const {
    ::testing::internal::CaptureStderr();
    const int status = runner::run_scene(request, signal);
    return {status, ::testing::internal::GetCapturedStderr()};
  }
};

// A signal before the first flight, before the second, ... in all of them: far from events, within
// a chatter that is carried to its limit or resolved, in sticking.
TEST_F(InProcess, WhereverASignalComesTheTablesGoOnByteForByte) {
  for (const double resolve : {std::numeric_limits<double>::infinity(), 0.0}) {
    request.options.resolve_chatter = resolve;
    request.resume.clear();
    name_files("");
    ASSERT_EQ(run_now(no_signal).first, 0);
    const std::string events = contents(request.events), samples = contents(request.samples);
    EXPECT_GT(lines(events).size(), 50u);
    int interrupted = 0;
    for (int after = 1;; ++after) {
      request.resume.clear();
      name_files("1");
      questions_left = after;
      const auto [status, said] = run_now(signal_after_questions);
      if (status == 0) break;  // over before the signal
      ++interrupted;
      ASSERT_EQ(status, 128 + SIGINT);
      ASSERT_EQ(said.rfind("vibro-impact: interrupted at t = ", 0), 0u) << said;
      request.resume = request.save_state;
      name_files("2");
      ASSERT_EQ(run_now(no_signal).first, 0);
      const auto both = [this](const std::string &table) {
        return contents(folder / (table + "1.csv")) +
               below_header(contents(folder / (table + "2.csv")));
      };
      ASSERT_EQ(first_difference(both("e"), events), "") << said;
      ASSERT_EQ(first_difference(both("s"), samples), "") << said;
    }
    // It is asked before each of the samples and twice after it.
    EXPECT_GT(interrupted, 3 * 160);
  }
  EXPECT_EQ(files(), (std::vector<std::string>{"e.csv", "e1.csv", "e2.csv", "s.csv", "s1.csv",
                                               "s2.csv", "x", "x1", "x2"}));
}

// Beside a sample the time at which a run ended may be off by its rounding.
TEST(SampleRows, ReachAsFarAsTheirLastSampleAndShortOfTheNext) {
  runner::StreamedTable table(runner::Destination{}, "time,x1");
  const runner::SampleRows rows{table, 1.0, 10.0, 0.1, 3};  // at 1.0, 1.1 and 1.2
  const double last = sample_time(1.0, 10.0, 0.1, 2), next = sample_time(1.0, 10.0, 0.1, 3);
  for (const double time : {1.15, std::nextafter(last, 0.0), last, 1.25, std::nextafter(next, 0.0),
                            next, std::nextafter(next, 2.0)}) {
    const double reached = rows.reach(time);
    EXPECT_EQ(runner::samples_taken(1.0, 0.1, reached), 3u) << time;
    EXPECT_NEAR(reached, time, time < last ? 0.06 : 4e-15) << time;
  }
}

// The summary with the counts of work, too, is that of a run whose progress nobody follows.
TEST_F(InProcess, AProgressLineChangesNeitherTheTablesNorTheCounts) {
  const std::string said = run_now(no_signal).second;
  const std::string events = contents(request.events), samples = contents(request.samples);
  EXPECT_NE(said.find(" 161 modal evaluations"), std::string::npos) << said;
  for (const double every : {0.25, 1e9}) {
    request.every = every;
    request.progress = false;
    const std::string untold = run_now(no_signal).second;
    const std::string state = contents(request.save_state);
    request.progress = true;
    EXPECT_EQ(run_now(no_signal).second, untold);
    EXPECT_EQ(contents(request.events), events);
    EXPECT_EQ(contents(request.save_state), state);
    EXPECT_EQ(contents(request.samples) == samples, every == 0.25);
  }
}

// Asks for samples at the times at which the watch does.
struct Companion {
  const runner::Watch *watch = nullptr;
  double next = 0.0;
  long long sampled = 0;

  double next_time() const {
    return next;
  }
  void sample(const Moment &) {
    ++sampled;
    next = watch->next_time();
  }
};

// A moment that others have asked for, too, is no work of the watch.
TEST(Watch, CountsTheLooksThatNobodyElseAskedFor) {
  Scene scene;
  scene.mass = scene.stiffness = {1.0};
  scene.displacement = {1.0};
  Progress progress("time", 10.0, true);
  for (const bool in_company : {false, true}) {
    Companion companion;
    const RecorderRef beside[] = {recorder_ref(companion)};
    runner::Watch watch(0.0, 10.0, no_signal, progress, {beside, in_company ? 1u : 0u});
    companion.watch = &watch;
    companion.next = watch.next_time();
    std::vector<RecorderRef> all{recorder_ref(watch)};
    if (in_company) all.push_back(beside[0]);
    const Outcome outcome = simulate_seen(scene, start_of(scene), 10.0, {}, all);
    const long long looks = outcome.counters.modal_evaluations - 1;  // and one for the end
    EXPECT_GT(looks, 10) << "they begin close together";
    EXPECT_LT(looks, 1000) << "and are soon far apart";
    EXPECT_EQ(watch.looks(), in_company ? 0 : looks);
    EXPECT_EQ(companion.sampled, in_company ? looks : 0);
  }
}

// The program, started without a shell so that a signal finds it.
struct Started : Runner {
  pid_t program = 0;

  void start(std::vector<std::string> arguments, int error_to) {
    arguments.insert(arguments.begin(), VIBRO_IMPACT_PROGRAM);
    std::vector<char *> words;
    for (std::string &argument : arguments) words.push_back(argument.data());
    words.push_back(nullptr);
    program = fork();
    if (program != 0) return;
    if (chdir(folder.c_str()) != 0 || dup2(error_to, STDERR_FILENO) < 0) _exit(127);
    execv(VIBRO_IMPACT_PROGRAM, words.data());
    _exit(127);
  }
  int exit_status() {
    int status = 0;
    EXPECT_EQ(waitpid(program, &status, 0), program);
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }
  static void wait_a_little() {
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
};

TEST_F(Started, CtrlCAndTerminationLeaveWholeTablesAndAState) {
  for (const int signal : {SIGINT, SIGTERM}) {
    const fs::path err = folder / "err.txt";
    const int error_to = open(err.c_str(), O_CREAT | O_TRUNC | O_WRONLY | O_CLOEXEC, 0600);
    start({"run", "--until", "1e15", "--events", "e1.csv", "--samples", "s1.csv", "--every", "1",
           "--save-state", "x"},
          error_to);
    close(error_to);
    // In the midst of it.
    const auto written = [this](const char *file) {
      std::error_code none_yet;
      const auto size = fs::file_size(folder / file, none_yet);
      return none_yet ? 0 : size;
    };
    while (written("e1.csv.part") == 0 || written("s1.csv.part") == 0) wait_a_little();
    kill(program, signal);
    ASSERT_EQ(exit_status(), 128 + signal);
    const std::string said = contents(err);
    EXPECT_TRUE(is_one_message(said)) << said;
    EXPECT_NE(said.find("the tables hold what came before; the state reached is saved"),
              std::string::npos)
        << said;
    fs::remove(err);
    ASSERT_EQ(files(), (std::vector<std::string>{"e1.csv", "s1.csv", "x"}));

    const std::string events = contents(folder / "e1.csv"), samples = contents(folder / "s1.csv");
    EXPECT_EQ(events.back(), '\n');
    EXPECT_EQ(samples.back(), '\n');
    const double last = std::stod(cells(lines(samples).back()).front());
    const std::string until = " --every 1 --until " + std::to_string(last + 100.0);
    ASSERT_EQ(run("run --resume x --events e2.csv --samples s2.csv" + until).status, 0);
    ASSERT_EQ(run("run --events e.csv --samples s.csv" + until).status, 0);
    EXPECT_EQ(first_difference(events + below_header(contents(folder / "e2.csv")),
                               contents(folder / "e.csv")),
              "");
    EXPECT_EQ(first_difference(samples + below_header(contents(folder / "s2.csv")),
                               contents(folder / "s.csv")),
              "");
    for (const std::string &file : files()) fs::remove(folder / file);
  }
}

// A run without tables, too, hears the signal, and one in which nothing ever happens.
TEST_F(Started, TheProgressIsShownOnATerminalAndWiped) {
  for (const char *stop : {"1:lower:-0.3", "none"}) {
    const int terminal = posix_openpt(O_RDWR | O_NOCTTY | O_CLOEXEC);
    ASSERT_GE(terminal, 0);
    ASSERT_EQ(grantpt(terminal), 0);
    ASSERT_EQ(unlockpt(terminal), 0);
    const int screen = open(ptsname(terminal), O_RDWR | O_NOCTTY | O_CLOEXEC);
    // A sample now and then keeps the run without stops busy.
    start({"run", "--until", "1e15", "--stop", stop, "--samples", "/dev/null", "--every", "100"},
          screen);
    close(screen);
    std::string shown;
    bool signalled = false;
    for (char block[256];;) {
      const ssize_t size = read(terminal, block, sizeof block);
      if (size <= 0) break;  // the program has gone
      shown.append(block, static_cast<std::size_t>(size));
      if (signalled || shown.find(" left") == std::string::npos) continue;
      kill(program, SIGTERM);
      signalled = true;
    }
    close(terminal);
    EXPECT_EQ(exit_status(), 128 + SIGTERM);
    EXPECT_EQ(shown.rfind("\rtime: ", 0), 0u) << shown;
    EXPECT_NE(shown.find(" of 1e+15 (0 %), "), std::string::npos) << shown;
    EXPECT_NE(shown.find("  \rvibro-impact: interrupted at t = "), std::string::npos) << shown;
  }
}

TEST_F(Started, ASignalThatWasIgnoredIsIgnoredStill) {
  const std::string loop = "trap '' INT; " VIBRO_IMPACT_PROGRAM
                           " run --until 100000 --events e.csv & while [ ! -s e.csv.part ]; do "
                           "sleep 0.01; done; kill -s INT $!; wait $!";
  EXPECT_EQ(run("--version >/dev/null; " + loop).status, 0);
  EXPECT_EQ(files(), std::vector<std::string>{"e.csv"});
}

}  // namespace
