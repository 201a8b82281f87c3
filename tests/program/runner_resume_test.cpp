// Runs of the scene runner in parts: what --save-state writes, --resume goes on with.
#include <regex>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "program/state_file.hpp"
#include "runner_program.hpp"

namespace {

using namespace vibro_impact::testing;
using namespace vibro_impact;

// As many parts as one likes, each in the place of the one before; the scene is carried along, all
// of it.
TEST_F(Runner, AStateMayBeGoneOnWithAgainAndAgain) {
  const std::string scene =
      "--masses 3 --mass 1,2,1 --stiffness 0,2,1 --beta 0.15 --amplitude 0.1,0.5,0 "
      "--omega 0.9 --restitution 0.6 --initial-displacement 0.01,0.02,0 "
      "--initial-velocity -0.1,0.2,0.3 --stop 1:lower:-0.3 --stop 1:upper:0.4 "
      "--stop 2:upper:0.1:0.4 --stop 3:lower:-0.5:0 ";
  const std::string tables = " --every 0.25 --events e.csv --samples s.csv ";
  for (const std::string resolve : {"", "--resolve-chatter 0 "}) {
    ASSERT_EQ(run("run " + scene + resolve + "--until 40" + tables).status, 0);
    const std::string events = contents(folder / "e.csv"), samples = contents(folder / "s.csv");
    EXPECT_GT(lines(events).size(), 30u);
    std::string event_parts = "", sample_parts = "", from = scene;
    for (const char *until : {"10", "10", "11.6", "25", "40"}) {
      const Result part = run("run " + from + resolve + "--save-state x --until " + until + tables);
      ASSERT_EQ(part.status, 0) << part.err;
      const bool first = event_parts.empty();
      for (const auto &[all, file] : {std::pair{&event_parts, "e.csv"}, {&sample_parts, "s.csv"}})
        *all += first ? contents(folder / file) : below_header(contents(folder / file));
      from = "--resume x ";
    }
    EXPECT_EQ(first_difference(event_parts, events), "") << resolve;
    EXPECT_EQ(first_difference(sample_parts, samples), "") << resolve;
  }
  EXPECT_EQ(files(), (std::vector<std::string>{"e.csv", "s.csv", "x"}));
}

// A run given up at its limit of impacts goes on under a higher one.
TEST_F(Runner, AGivenUpRunMayBeGoneOnWith) {
  const std::string rattle =
      "run --restitution 1 --stop 1:lower:-1e-6 --stop 1:upper:1e-6 --initial-velocity 0.3,0 ";
  const std::string whole = run(rattle + "--until 0.02 --events -").out;
  const Result first = run(rattle + "--until 0.02 --max-impacts 1000 --events - --save-state x");
  EXPECT_EQ(first.status, 1);
  EXPECT_NE(first.err.find("the state reached is saved"), std::string::npos) << first.err;
  const Result second = run("run --resume x --until 0.02 --events -");
  EXPECT_EQ(second.status, 0) << second.err;
  EXPECT_EQ(first_difference(first.out + below_header(second.out), whole), "");
}

TEST_F(Runner, TheSceneOfASavedStateIsNotToBeChanged) {
  ASSERT_EQ(run("run --until 30 --save-state x.state").status, 0);
  for (const std::string option :
       {"--masses 2", "--mass 1", "--stiffness 1", "--beta 0.1", "--restitution 0.7",
        "--amplitude 0.5,0", "--omega 0.28", "--stop none", "--initial-displacement 0",
        "--initial-velocity 0"}) {
    const Result result = run("run --resume x.state --events e.csv " + option);
    EXPECT_EQ(result.status, 2) << option;
    EXPECT_TRUE(is_one_message(result.err)) << result.err;
    EXPECT_EQ(
        result.err,
        "vibro-impact: --resume x.state: the scene comes from there, and cannot be changed by " +
            std::regex_replace(option, std::regex(" "), "=") + "\n");
  }
  const Result before = run("run --resume x.state --until 29");
  EXPECT_EQ(before.status, 2);
  EXPECT_EQ(before.err,
            "vibro-impact: --until 29: lies before the end 30 of the run saved in x.state\n");
  EXPECT_EQ(files(), std::vector<std::string>{"x.state"});
  EXPECT_EQ(contents(folder / "x.state").substr(0, 30), "vibro-impact state 6, checksum");
}

// The text with the line that begins with `key` replaced, under a checksum that fits.
std::string with_line(const std::string &text, const std::string &key, const std::string &line) {
  std::string changed;
  for (const std::string &old : lines(below_header(text)))
    changed += old.rfind(key, 0) == 0 ? line : old + "\n";
  return runner::first_line(changed) + changed;
}

TEST_F(Runner, ADamagedStateIsRefused) {
  ASSERT_EQ(run("run --until 30 --omega 0.28 --stop 1:lower:-0.3 --save-state x.state").status, 0);
  const std::string good = contents(folder / "x.state");
  const auto read = [](const std::string &text) {
    std::istringstream file(text);
    return runner::read_saved_run(file, "state");
  };
  ASSERT_EQ(runner::text_of(read(good)), good);
  for (std::size_t length = 0; length < good.size(); ++length)
    EXPECT_THROW(read(good.substr(0, length)), std::invalid_argument) << "cut after " << length;
  for (std::size_t i = 0; i < good.size(); ++i) {
    std::string changed = good;
    changed[i] = changed[i] == '1' ? '2' : '1';
    EXPECT_THROW(read(changed), std::invalid_argument) << "byte " << i << " changed";
  }
  const std::pair<std::string, const char *> cases[] = {
      {"time,mass\n", "does not begin with 'vibro-impact state 6, checksum '"},
      {good.substr(0, good.size() / 2), "cut short or changed"},
      {good + "more\n", "the checksum does not fit"},
      {"vibro-impact state 5, checksum" + good.substr(30), "does not begin with"},
      {with_line(good, " --omega", "--omega=x\n"), "--omega x: 'x' is not a number"},
      {with_line(good, " --omega", "--omega=nan\n"), "omega = nan"},
      {with_line(good, " --omega", "--colour=1\n"), "--colour"},
      {with_line(good, " --omega", "--stop=3:upper:0.1\n"), "stop on mass 3"},
      {with_line(good, "time", ""), "'time' expected"},
      {with_line(good, "time", "time x\n"), "'time' expected"},
      {with_line(good, "vibro-impact run", "vibro-impact run state 4, checksum 1\n"),
       "cut short or changed"},
      {good.substr(0, good.size() - 3) + "zz\n", "the checksum does not fit"},
  };
  for (const auto &[text, names] : cases) {
    std::ofstream(folder / "bad.state", std::ios::binary) << text;
    const Result result = run("run --resume bad.state --events e.csv --save-state y.state");
    EXPECT_EQ(result.status, 2) << names;
    EXPECT_EQ(result.out, "");
    EXPECT_TRUE(is_one_message(result.err)) << result.err;
    EXPECT_NE(result.err.find(names), std::string::npos) << names << ": " << result.err;
    EXPECT_EQ(files(), (std::vector<std::string>{"bad.state", "x.state"})) << names;
  }
}

}  // namespace
