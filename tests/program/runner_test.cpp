// The scene runner, tested through the program itself: its options and its tables.
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "reference/paper_scenes.hpp"
#include "runner_program.hpp"
#include "vibro_impact/simulate.hpp"

namespace {

using namespace vibro_impact::testing;

const std::string paper_scene =
    "run --masses 2 --mass 1 --stiffness 1 --beta 0.1 --restitution 0.7 --amplitude 0.5,0 "
    "--omega 0.2797 --stop 1:lower:-0.3 --stop 2:upper:0.1 ";

// The cells are read back to the very doubles the library hands over: 17 digits, nothing rounded.
TEST_F(Runner, TablesHoldTheLibrarysNumbersBitForBit) {
  using namespace vibro_impact;
  const Scene scene = paper::figure2();
  EventRecorder events;
  events.from = 20.0;
  SampleRecorder samples;
  samples.from = 20.0;
  samples.to = 60.0;
  samples.every = 0.25;
  simulate(scene, 60.0, RunOptions{}, events, samples);

  const Result result =
      run(paper_scene + "--until 60 --from 20 --every 0.25 --events e.csv --samples s.csv");
  ASSERT_EQ(result.status, 0) << result.err;
  const auto event_rows = lines(contents(folder / "e.csv"));
  ASSERT_EQ(event_rows.size(), events.events.size() + 1);
  EXPECT_GT(event_rows.size(), 30u);
  EXPECT_EQ(event_rows[0], "time,mass,event,velocity_before,velocity_after,contact_mode");
  EXPECT_NE(result.err.find(" sticks, "), std::string::npos) << result.err;
  for (std::size_t i = 0; i < events.events.size(); ++i) {
    const Event &event = events.events[i];
    const auto row = cells(event_rows[i + 1]);
    ASSERT_EQ(row.size(), 6u);
    EXPECT_EQ(std::stod(row[0]), event.time);
    EXPECT_GE(event.time, 20.0);
    EXPECT_EQ(row[1], std::to_string(event.mass));
    EXPECT_EQ(row[2], name(event.kind));
    EXPECT_EQ(std::stod(row[3]), event.velocity_before);
    EXPECT_EQ(std::stod(row[4]), event.velocity_after);
    EXPECT_EQ(row[5], contact_mode_name(event.held));
  }
  const auto sample_rows = lines(contents(folder / "s.csv"));
  ASSERT_EQ(sample_rows.size(), 162u);  // 20, 20.25, ... 60 and the header
  ASSERT_EQ(samples.times.size(), 161u);
  for (std::size_t i = 0; i < samples.times.size(); ++i) {
    const auto row = cells(sample_rows[i + 1]);
    ASSERT_EQ(row.size(), 3u);
    EXPECT_EQ(std::stod(row[0]), samples.times[i]);
    EXPECT_EQ(std::stod(row[1]), samples.displacements[2 * i]);
    EXPECT_EQ(std::stod(row[2]), samples.displacements[2 * i + 1]);
  }
}

TEST_F(Runner, DefaultsAreThePaperScene) {
  const std::string table = run(paper_scene + "--until 750 --events -").out;
  EXPECT_GT(lines(table).size(), 1000u);
  EXPECT_EQ(run("run --events -").out, table);
  EXPECT_EQ(lines(run("run --until 1 --samples -").out).size(), 102u) << "every 0.01 from 0";
}

// The smaller the speed down to which chatter is resolved, the more impacts stand in the table;
// the sticking phases are the same.
TEST_F(Runner, ResolveChatterSetsHowFarChatterIsWrittenOut) {
  std::size_t before = 0;
  for (const char *option :
       {"", "--resolve-chatter 1e-4", "--resolve-chatter 1e-8", "--resolve-chatter 0"}) {
    const Result result = run(std::string("run --until 100 --events - ") + option);
    ASSERT_EQ(result.status, 0) << result.err;
    EXPECT_NE(result.err.find(" 8 sticks, 8 releases"), std::string::npos) << result.err;
    EXPECT_GT(lines(result.out).size(), before) << option;
    before = lines(result.out).size();
  }
}

TEST_F(Runner, ScalarsRepeatForAllMasses) {
  const std::string scalar = run("run --mass 2 --stiffness 3 --until 60 --events -").out;
  EXPECT_GT(lines(scalar).size(), 10u);
  EXPECT_EQ(scalar, run("run --mass 2,2 --stiffness 3,3 --until 60 --events -").out);
  EXPECT_NE(scalar, run("run --mass 2 --stiffness 3,2 --until 60 --events -").out);
}

TEST_F(Runner, RunsWithoutStopsAndWithAnyNumberOfMasses) {
  EXPECT_EQ(lines(run("run --masses 5 --stop none --until 50 --events -").out).size(), 1u);
  EXPECT_EQ(run("run --masses 5 --stop 5:upper:0.05 --until 100").status, 0);
  const std::string forced = "run --masses 3 --stop none --until 5 --every 1 --samples - ";
  const std::string on_the_first = run(forced).out;
  EXPECT_EQ(lines(on_the_first).front(), "time,x1,x2,x3");
  EXPECT_EQ(run(forced + "--amplitude 0.5,0,0").out, on_the_first);
  EXPECT_EQ(run("run --masses 1 --stop none --until 5").status, 0);
  EXPECT_EQ(lines(run("run --amplitude 0 --until 50 --events -").out).size(), 1u) << "at rest";
}

// A rigid, perfectly plastic stop on mass 1 beside an elastic one on mass 2.
TEST_F(Runner, AStopMayHaveARestitutionOfItsOwn) {
  const std::string stops = "--stop 1:lower:-0.3:0 --stop 2:upper:0.1:1 ";
  const Result own = run("run --until 100 --events - --restitution 0.3 " + stops);
  ASSERT_EQ(own.status, 0) << own.err;
  int impacts[2] = {0, 0};
  for (const std::string &line : lines(below_header(own.out))) {
    const auto row = cells(line);
    if (row[2] != "impact") continue;
    const bool first = row[1] == "1";
    ++impacts[first ? 0 : 1];
    const double before = std::stod(row[3]), after = std::stod(row[4]);
    EXPECT_NEAR(after, first ? 0.0 : -before, 1e-14 * std::abs(before)) << line;
  }
  EXPECT_GT(impacts[0], 0);
  EXPECT_GT(impacts[1], 0);
  EXPECT_EQ(own.out, run("run --until 100 --events - " + stops).out)
      << "the restitution of the scene is that of no stop";
  EXPECT_EQ(run("run --until 100 --events - --stop 1:lower:-0.3:0.7 --stop 2:upper:0.1").out,
            run("run --until 100 --events -").out);
}

// k_1 = 0: nothing ties the chain to the ground. Two equal masses that start alike move as one.
TEST_F(Runner, TheFirstLinkMayBeAbsent) {
  const Result drift =
      run("run --stiffness 0,1 --amplitude 0 --initial-velocity 0.25 --stop none "
          "--until 8 --every 4 --samples -");
  ASSERT_EQ(drift.status, 0) << drift.err;
  const auto rows = lines(drift.out);
  ASSERT_EQ(rows.size(), 4u);
  for (std::size_t i = 1; i < rows.size(); ++i) {
    const auto row = cells(rows[i]);
    EXPECT_NEAR(std::stod(row[1]), 0.25 * std::stod(row[0]), 1e-14) << rows[i];
    EXPECT_NEAR(std::stod(row[2]), 0.25 * std::stod(row[0]), 1e-14) << rows[i];
  }
  EXPECT_EQ(run("run --masses 1 --stiffness 0 --stop none --until 5").status, 0);
}

TEST_F(Runner, HelpAndVersionExplainThemselves) {
  for (const char *command : {"run --help", "--help"}) {
    const Result help = run(command);
    EXPECT_EQ(help.status, 0);
    EXPECT_TRUE(help.err.empty()) << help.err;
    for (const char *word : {"non-dimensional", "reconstructed", "Example:", "contact_mode"})
      EXPECT_NE(help.out.find(word), std::string::npos) << command << ": " << word;
  }
  const std::string options = run("run --help").out;
  for (const char *word :
       {"Usage: vibro-impact run", "--masses", "--stop", "--beta", "--resolve-chatter",
        "--initial-velocity", "--max-impacts", "--save-state", "--resume", "--plot", "Ctrl-C",
        "mass:side:position:restitution"})
    EXPECT_NE(options.find(word), std::string::npos) << word;
  EXPECT_EQ(run("--version").out, "vibro-impact " VIBRO_IMPACT_VERSION "\n");
}

}  // namespace
