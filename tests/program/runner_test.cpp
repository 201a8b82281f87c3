// The scene runner, tested through the program itself: its options, its tables and its progress.
#include <regex>
#include <string>
#include <vector>

#include "program/progress.hpp"
#include "reference/scenes/paper_scenes.hpp"
#include "reference/truth/table_reader.hpp"
#include "tests/support/runner_program.hpp"
#include "vibro_impact/analysis/table.hpp"
#include "vibro_impact/simulate.hpp"

namespace {

using namespace vibro_impact::testing;

// The cells of the samples are read back to the very doubles that the library gives, with 17 digits
// and nothing rounded. The cells of events, here on standard output, are written by the same
// function.
TEST_F(Runner, TablesHoldTheLibrarysNumbersBitForBit) {
  using namespace vibro_impact;
  EventRecorder events{20.0};
  SampleRecorder samples{20.0, 60.0, 0.25};
  require_complete(simulate(paper::figure2(), 60.0, events, samples));

  const Result result = run("run --until 60 --from 20 --every 0.25 --events - --samples s.csv");
  ASSERT_EQ(result.status, 0) << result.err;
  EXPECT_NE(result.err.find(" sticks, "), std::string::npos) << result.err;
  Table expected(
      "time,mass,event,velocity_before,velocity_after,contact_mode,stop,side,phase,impulse");
  for (const Event &event : events.events)
    expected.row(event.time, event.mass, name(event.kind), event.velocity_before,
                 event.velocity_after, contact_mode_name(event.held), event.stop, name(event.side),
                 event.instant.phase, event.taken.impulse);
  EXPECT_EQ(lines(result.out), lines(expected.text));
  EXPECT_GT(events.events.size(), 30u);
  const truth::Rows rows = table("s.csv");
  ASSERT_EQ(rows.size(), 161u);  // 20, 20.25, ... 60
  EXPECT_EQ(rows[0].columns(), (truth::Cells{"time", "x1", "x2"}));
  for (std::size_t i = 0; i < rows.size(); ++i) {
    EXPECT_EQ(rows.at(i).number("time"), samples.times[i]);
    EXPECT_EQ(rows.at(i).number("x1"), samples.displacements[2 * i]);
    EXPECT_EQ(rows.at(i).number("x2"), samples.displacements[2 * i + 1]);
  }
}

// Times on a grid of decimals are those decimals, and no zero has a sign.
TEST_F(Runner, NumbersArePrintedAsTheyAreMeant) {
  for (const int from : {0, 700}) {
    const std::string start = std::to_string(from);
    ASSERT_EQ(run("run --samples s.csv --every 0.01 --from " + start + " --until " +
                  std::to_string(from + 1))
                  .status,
              0);
    const vibro_impact::truth::Rows rows = table("s.csv");
    ASSERT_EQ(rows.size(), 101u);
    for (int k = 1; k < 100; ++k) {
      const std::string number = std::to_string(from * 100 + 100 + k);  // 1.00 is 100
      std::string decimal = std::to_string(from) + "." + number.substr(number.size() - 2);
      if (decimal.ends_with('0')) decimal.pop_back();
      EXPECT_EQ(rows.at(static_cast<std::size_t>(k)).cell("time"), decimal);
    }
  }
  const Result result = run("run --restitution 0 --until 30 --events -");
  EXPECT_NE(result.out.find(",0,"), std::string::npos);
  EXPECT_EQ(result.out.find(",-0,"), std::string::npos);
}

// The smaller the speed down to which chatter is listed or resolved, the more impacts stand in the
// table; the sticking phases are the same. By default it is 1e-4 of the first impact, some 1e-5.
TEST_F(Runner, SlowestAndResolveChatterSetHowFarChatterIsWrittenOut) {
  std::size_t before = 0;
  for (const char *option :
       {"--slowest 1e-2", "", "--slowest 1e-6", "--resolve-chatter 1e-8", "--resolve-chatter 0"}) {
    const Result result = run(std::string("run --until 100 --events - ") + option);
    ASSERT_EQ(result.status, 0) << result.err;
    EXPECT_NE(result.err.find(" 6 sticks, 5 releases"), std::string::npos) << result.err;
    EXPECT_GT(lines(result.out).size(), before) << option;
    before = lines(result.out).size();
  }
}

TEST_F(Runner, SlowestSetsWhichImpactsOfASweepAreWritten) {
  std::size_t before = 0;
  for (const char *speed : {"1", "1e-4", "1e-6"}) {
    const std::string sweep = "sweep --vary omega=0.3:0.3:1 --impacts i.csv --slowest ";
    ASSERT_EQ(run(sweep + speed).status, 0);
    EXPECT_GT(lines(contents(folder / "i.csv")).size(), before) << speed;
    before = lines(contents(folder / "i.csv")).size();
  }
}

// Two ways to say the same scene give the same table, to the byte.
TEST_F(Runner, OptionsOfTheSceneMeanWhatTheHelpSays) {
  const auto table = [this](const std::string &options) {
    const Result result = run("run --until 60 --every 1 --samples - " + options);
    EXPECT_EQ(result.status, 0) << options << result.err;
    return result.out;
  };
  EXPECT_EQ(table("--mass 2 --stiffness 3"), table("--mass 2,2 --stiffness 3,3"));
  EXPECT_NE(table("--stiffness 3"), table("--stiffness 3,2"));
  EXPECT_EQ(table("--masses 3 --ground 0"), table("--masses 3"));
  EXPECT_EQ(table("--masses 3 --stop none"), table("--masses 3 --stop none --amplitude 0.5,0,0"));
  EXPECT_EQ(table("--stop 1:lower:-0.3:0.7 --stop 2:upper:0.1"), table(""));
  const std::string own = "--stop 1:lower:-0.3:0 --stop 2:upper:0.1:1 ";
  EXPECT_EQ(table(own + "--restitution 0.3"), table(own)) << "no stop has that of the scene";
  EXPECT_NE(table(own), table(""));
  EXPECT_EQ(table("--masses 1 --stop none --stiffness 0 --amplitude 0 --velocity 0.25"),
            table("--masses 1 --stop none --stiffness 0 --amplitude 0 --velocity 0.25 "
                  "--displacement 0"));
}

// A single value stands for all masses, also that of a force, and the summary says how many masses
// are forced. The default forces mass 1, in chains of every length.
TEST_F(Runner, ASingleAmplitudeForcesAllMasses) {
  const struct {
    std::string options, summary;
  } cases[] = {{"", "masses: 2, forced: 1, stops: 2, restitution: 0.7, beta: 0.1; "},
               {"--masses 1", "masses: 1, forced: 1, stops: 1, restitution: 0.7, beta: 0.1; "},
               {"--masses 3", "masses: 3, forced: 1, stops: 2, restitution: 0.7, beta: 0.1; "},
               {"--masses 3 --amplitude 0.5",
                "masses: 3, forced: 3, stops: 2, restitution: 0.7, beta: 0.1; "},
               {"--masses 3 --amplitude 0.5,0.5,0 --sine 0,0.1,0 --stop none",
                "masses: 3, forced: 2, stops: 0, restitution: 0.7, beta: 0.1; "},
               {"--stop 1:lower:-1:0.5 --stop 1:upper:1:0.8 --stop 2:upper:1:0.5",
                "masses: 2, forced: 1, stops: 3, restitution: 0.5 and 0.8, beta: 0.1; "},
               {"--amplitude 0", "masses: 2, forced: 0, stops: 2, restitution: 0.7, beta: 0.1; "}};
  for (const auto &[options, summary] : cases)
    EXPECT_TRUE(run("run --until 10 " + options).err.starts_with(summary)) << options;
  EXPECT_TRUE(run("run --until 1")
                  .err.ends_with("no table was asked for, as by --events, "
                                 "--samples or --summary\n"));
  const std::string masses = "run --masses 3 --print-scene ";
  EXPECT_EQ(run(masses + "--amplitude 0.5").out, run(masses + "--amplitude 0.5,0.5,0.5").out);
  EXPECT_EQ(run(masses).out, run(masses + "--amplitude 0.5,0,0").out);
}

TEST_F(Runner, TheExamplesOfTheHelpWork) {
  if (!there_is_gnuplot()) GTEST_SKIP() << "gnuplot is not there";
  std::string help;
  for (const char *command : {"", "run ", "orbit ", "sweep "}) {
    const Result result = run(command + std::string("--help"));
    EXPECT_EQ(result.status, 0);
    EXPECT_EQ(result.err, "");
    help += result.out;
  }
  int examples = 0;
  const std::string begin = "  vibro-impact ",
                    joined = std::regex_replace(help, std::regex("\\\\\n"), "");
  for (const std::string &line : lines(joined)) {
    if (!line.starts_with(begin)) continue;
    ++examples;
    const Result result = run(line.substr(begin.size()));
    EXPECT_EQ(result.status, 0) << line << result.err;
  }
  EXPECT_EQ(examples, 12);
  EXPECT_EQ(files(),
            (std::vector<std::string>{"atlas.csv",    "ball.csv",    "ball.png",    "basins.csv",
                                      "basins.png",   "branch.csv",  "branch.png",  "branches.csv",
                                      "branches.png", "diagram.csv", "events.csv",  "impacts.csv",
                                      "impacts.png",  "orbit.csv",   "orbit.png",   "response.csv",
                                      "response.png", "run.png",     "samples.csv", "section.csv",
                                      "section.png",  "states.csv",  "states.png"}));
  EXPECT_EQ(run("run --help").out.find("{"), std::string::npos) << "no word of CLI11's own";
  EXPECT_EQ(run("--version").out, "vibro-impact " VIBRO_IMPACT_VERSION "\n");
}

TEST(Progress, SaysHowFarAndHowLongStill) {
  const auto line = [](double done, double total, double seconds) {
    return vibro_impact::progress_line("time", done, total, seconds);
  };
  EXPECT_EQ(line(75, 750, 3), "time: 75 of 750 (10 %), 0.45 min left");
  EXPECT_EQ(line(1e-3, 1e15, 2), "time: 0.001 of 1e+15 (0 %), 3.33e+16 min left");
  EXPECT_EQ(line(750, 750, 9), "time: 750 of 750 (100 %), 0 min left");
  EXPECT_EQ(line(0, 750, 5), "time: 0 of 750 (0 %)") << "nothing is known of the pace";
}

TEST(Progress, IsShownAfterTwoSecondsAndFiveTimesASecond) {
  EXPECT_FALSE(vibro_impact::is_progress_due(1.9, 0.0));
  EXPECT_TRUE(vibro_impact::is_progress_due(2.0, 0.0));
  EXPECT_FALSE(vibro_impact::is_progress_due(2.1, 2.0));
  EXPECT_TRUE(vibro_impact::is_progress_due(2.3, 2.0));
}

}  // namespace
