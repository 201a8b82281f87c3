// The scene runner, tested through the program itself.
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

namespace {

namespace fs = std::filesystem;

struct Result {
  int status;
  std::string out, err;
};

std::string contents(const fs::path &path) {
  std::ostringstream text;
  text << std::ifstream(path).rdbuf();
  return text.str();
}

std::vector<std::string> lines(const std::string &text) {
  std::vector<std::string> found;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) found.push_back(line);
  return found;
}

struct Runner : testing::Test {
  fs::path folder;

  void SetUp() override {
    std::string pattern = (fs::temp_directory_path() / "vibro-impact-XXXXXX").string();
    ASSERT_NE(mkdtemp(pattern.data()), nullptr);
    folder = pattern;
  }
  void TearDown() override {
    fs::remove_all(folder);
  }
  Result run(const std::string &arguments) const {
    const fs::path out = folder / "out.txt", err = folder / "err.txt";
    const std::string command = "cd " + folder.string() + " && " VIBRO_IMPACT_PROGRAM " " +
                                arguments + " >" + out.string() + " 2>" + err.string();
    const int status = std::system(command.c_str());
    Result result{WEXITSTATUS(status), contents(out), contents(err)};
    fs::remove(out);
    fs::remove(err);
    return result;
  }
};

const std::string paper_scene =
    "run --masses 2 --mass 1 --stiffness 1 --damping 0.1 --restitution 0.7 --amplitude 0.5,0 "
    "--omega 0.28 --stop 1:lower:-0.3 --stop 2:upper:0.1 ";

TEST_F(Runner, WritesTheEventTableOfThePaperScene) {
  const Result result = run(paper_scene + "--until 750 --events e.csv --resolve-chatter 1e-4");
  ASSERT_EQ(result.status, 0) << result.err;
  const auto rows = lines(contents(folder / "e.csv"));
  ASSERT_FALSE(rows.empty());
  EXPECT_EQ(rows[0], "time,mass,event,velocity_before,velocity_after,contact_mode");
  int sticks = 0, releases = 0, impacts = 0, slow = 0;
  double last = 0.0;
  for (std::size_t i = 1; i < rows.size(); ++i) {
    std::istringstream row(rows[i]);
    std::vector<std::string> cells;
    for (std::string cell; std::getline(row, cell, ',');) cells.push_back(cell);
    ASSERT_EQ(cells.size(), 6u) << rows[i];
    EXPECT_GE(std::stod(cells[0]), last) << "events in order of time";
    last = std::stod(cells[0]);
    sticks += cells[2] == "stick";
    releases += cells[2] == "release";
    impacts += cells[2] == "impact";
    slow += cells[2] == "impact" && std::abs(std::stod(cells[3])) < 2e-4;
    EXPECT_TRUE(cells[5] == "-" || cells[5] == "1" || cells[5] == "2" || cells[5] == "1+2");
  }
  EXPECT_EQ(sticks, 66);
  EXPECT_EQ(releases, 66);
  EXPECT_LT(impacts, 2500);
  EXPECT_GT(slow, 66) << "chatter is resolved down to 1e-4";
  EXPECT_NE(result.err.find("66 sticks, 66 releases"), std::string::npos) << result.err;
}

TEST_F(Runner, DefaultsAreThePaperScene) {
  EXPECT_EQ(run("run --until 100 --events -").out, run(paper_scene + "--until 100 --events -").out);
}

TEST_F(Runner, ScalarsRepeatForAllMassesAndBetaIsDampingOverStiffness) {
  const std::string scalar = run(paper_scene + "--until 60 --events -").out;
  EXPECT_GT(lines(scalar).size(), 10u);
  EXPECT_EQ(scalar,
            run("run --mass 1,1 --stiffness 1,1 --damping 0.1,0.1 --until 60 --events -").out);
  EXPECT_EQ(scalar, run("run --beta 0.1 --until 60 --events -").out);
}

TEST_F(Runner, SamplesEveryIntervalFromTheStartAskedFor) {
  const Result result = run(paper_scene + "--until 20 --from 10 --every 0.5 --samples s.csv");
  ASSERT_EQ(result.status, 0) << result.err;
  const auto rows = lines(contents(folder / "s.csv"));
  ASSERT_EQ(rows.size(), 22u);
  EXPECT_EQ(rows[0], "time,x1,x2");
  EXPECT_EQ(rows[1].substr(0, 3), "10,");
  EXPECT_EQ(rows[21].substr(0, 3), "20,");
}

TEST_F(Runner, RunsWithoutStopsAndWithAnyNumberOfMasses) {
  EXPECT_EQ(lines(run("run --masses 5 --stop none --until 50 --events -").out).size(), 1u);
  EXPECT_EQ(run("run --masses 5 --stop 5:upper:0.05 --until 100").status, 0);
}

TEST_F(Runner, HelpAndVersionExplainThemselves) {
  const Result help = run("run --help");
  EXPECT_EQ(help.status, 0);
  for (const char *word : {"--resolve-chatter", "--stop", "non-dimensional", "contact_mode"})
    EXPECT_NE((help.out + run("--help").out).find(word), std::string::npos) << word;
  EXPECT_EQ(run("--version").out, "vibro-impact 0.1.0\n");
}

struct BadCase {
  const char *arguments, *names;  // what the one line must contain
};

TEST_F(Runner, BadInputGivesOneLineStatusTwoAndNoFile) {
  const std::vector<BadCase> cases = {
      {"--mass nan", "mass = nan"},
      {"--mass 0", "mass = 0"},
      {"--mass 1,-2", "mass = -2"},
      {"--stiffness inf", "stiffness = inf"},
      {"--restitution 1.1", "1.1"},
      {"--restitution -0.1", "-0.1"},
      {"--restitution nan", "nan"},
      {"--omega -1", "-1"},
      {"--amplitude 0.5,nan", "nan"},
      {"--initial-displacement 0,0.2", "0.2"},
      {"--initial-displacement 0,0,0", "0,0,0"},
      {"--initial-velocity x", "x"},
      {"--stop 1:lower:0.0 --stop 1:upper:0.0", "lower must lie below"},
      {"--stop 1:upper:0.1 --stop 1:upper:0.2", "same side"},
      {"--stop 1:left:3", "1:left:3"},
      {"--stop 3:upper:1", "stop on mass 3"},
      {"--stop 1:upper:", "not a number"},
      {"--until 0", "--until 0"},
      {"--until 1e", "1e"},
      {"--from 800", "800"},
      {"--every 0", "--every 0"},
      {"--masses 0", "--masses 0"},
      {"--masses 2.5", "2.5"},
      {"--stiffness 1,2", "proportional"},
      {"--beta 0.1 --damping 0.1", "--beta"},
      {"--beta -1", "-1"},
      {"--resolve-chatter -1", "-1"},
      {"--max-impacts 0", "0"},
      {"--bogus 3", "--bogus"},
      {"--events /nonexistent/e.csv", "/nonexistent/e.csv"},
      {"--events . ", "--events ."},
      {"--events - --samples -", "standard output"},
  };
  for (const BadCase &bad : cases) {
    const std::string given = bad.arguments;
    const auto unless_given = [&given](const std::string &option, const std::string &path) {
      return given.find(option) == std::string::npos ? option + path : std::string();
    };
    const Result result = run("run " + unless_given("--events", " e.csv ") +
                              unless_given("--samples", " s.csv ") + given);
    EXPECT_EQ(result.status, 2) << bad.arguments;
    EXPECT_EQ(lines(result.err).size(), 1u) << bad.arguments << ": " << result.err;
    EXPECT_NE(result.err.find(bad.names), std::string::npos) << bad.arguments << ": " << result.err;
    EXPECT_TRUE(fs::is_empty(folder)) << bad.arguments << " left a file";
  }
}

TEST_F(Runner, EndlessImpactsEndWithTheStateAndStatusOne) {
  // r = 1 between two stops 2e-6 apart: some 1e6 impacts a period.
  const Result result =
      run("run --restitution 1 --stop 1:lower:-1e-6 --stop 1:upper:1e-6 --initial-velocity 0.3,0 "
          "--max-impacts 1000 --events e.csv");
  EXPECT_EQ(result.status, 1);
  EXPECT_EQ(lines(result.err).size(), 1u);
  EXPECT_NE(result.err.find("more than 1000 impacts"), std::string::npos) << result.err;
  EXPECT_NE(result.err.find("x1 = "), std::string::npos) << result.err;
  EXPECT_TRUE(fs::is_empty(folder));
}

}  // namespace
