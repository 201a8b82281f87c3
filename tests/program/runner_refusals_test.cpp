// What the scene runner refuses, tested through the program itself: one line, an exit status, and
// no file touched.
#include <string>
#include <vector>

#include "runner_program.hpp"

namespace {

using namespace vibro_impact::testing;

struct BadCase {
  const char *arguments, *names;  // what the one line must contain
};

TEST_F(Runner, BadInputGivesOneLineStatusTwoAndNoFile) {
  const std::vector<BadCase> cases = {
      {"--mass nan", "mass = nan"},
      {"--mass 0", "mass = 0"},
      {"--mass 1,-2", "mass = -2"},
      {"--stiffness inf", "stiffness of link 1 = inf"},
      {"--restitution 1.1", "1.1"},
      {"--restitution -0.1", "-0.1"},
      {"--restitution nan", "nan"},
      {"--omega -1", "-1"},
      {"--amplitude 0.5,nan", "nan"},
      {"--initial-displacement 0,0.2", "0.2"},
      {"--initial-displacement 0,0,0", "0,0,0"},
      {"--initial-velocity x", "x"},
      {"--stop 1:lower:0.0 --stop 1:upper:0.0", "lower must lie below"},
      {"--stop 1:lower:0.1 --stop 1:upper:-0.1",
       "stops on mass 1, lower at 0.1, upper at -0.1: the lower must lie below the upper"},
      {"--stop 1:upper:0.1 --stop 1:upper:0.2", "same side"},
      {"--stop 1:upper:0.1:", "--stop 1:upper:0.1:"},
      {"--stop 1:upper:0.1:x", "--stop 1:upper:0.1:x"},
      {"--stop 1:upper:0.1:1.5", "--stop 1:upper:0.1:1.5"},
      {"--stop 1:upper:0.1:nan", "--stop 1:upper:0.1:nan"},
      {"--stop 1:upper:0.1:0.7:0", "--stop 1:upper:0.1:0.7:0"},
      {"--stop 1:left:3", "1:left:3"},
      {"--stop 3:upper:1", "stop on mass 3"},
      {"--stop 1:upper:", "--stop 1:upper:"},
      {"--stop 1:upper:x", "--stop 1:upper:x"},
      {"--stop 1:upper:nan", "nan"},
      {"--stop 1.5:upper:1", "1.5:upper:1"},
      {"--stop 0:upper:1", "0:upper:1"},
      {"--masses 1", "--masses 1: the default stops"},
      {"--until 0", "--until: '0' must be a positive"},
      {"--until 1e", "--until: '1e' must be"},
      {"--until nan", "--until: 'nan' must"},
      {"--until inf", "--until: 'inf' must"},
      {"--omega 1e400", "--omega 1e400"},
      {"--omega 0.28x", "--omega 0.28x"},
      {"--omega ''", "not a number"},
      {"--mass 1,", "--mass 1,"},
      {"--from 800", "--from 800"},
      {"--from -1", "--from: '-1' must be a number, 0 or more"},
      {"--from nan", "--from: 'nan'"},
      {"--every 0", "--every: '0' must be"},
      {"--every 1e-14", "--every 1e-14"},
      {"--masses 0", "--masses: '0' must be"},
      {"--masses 2.5", "2.5"},
      {"--stiffness 1,2", "proportional"},
      {"--stiffness 1,2", "--beta"},
      {"--damping 0.1,0.1000000000005", "proportional"},
      {"--damping nan", "--damping nan: must be non-negative and finite"},
      {"--damping -0.1", "--damping -0.1"},
      {"--stiffness 1,0", "stiffness of link 2 = 0"},
      {"--stiffness 0,1", "link 1 has no stiffness, 0"},
      {"--stiffness 0,1 --damping 0.1,0.1", "--damping 0.1,0.1"},
      {"--beta ''", "--beta"},
      {"--beta 0.1 --damping 0.1", "--beta"},
      {"--beta -1", "-1"},
      {"--resolve-chatter -1", "-1"},
      {"--resolve-chatter nan", "nan"},
      {"--resolve-chatter ''", "--resolve-chatter"},
      {"--max-impacts 0", "--max-impacts: '0' must"},
      {"--max-impacts 2.5", "--max-impacts: '2.5' must be a whole number"},
      {"--bogus 3", "--bogus"},
      {"--event t.csv", "--event"},
      {"--omega", "--omega"},
      {"--omega 1 --omega 2", "--omega"},
      {"stray", "not expected: stray"},
      {"--events /nonexistent/e.csv", "/nonexistent/e.csv"},
      {"--samples /nonexistent/s.csv", "/nonexistent/s.csv"},
      {"--events . ", "--events ."},
      {"--events ''", "--events"},
      {"--events ./t.csv --samples t.csv", "--samples t.csv"},
      {"--events - --samples -", "two files"},
      {"--events - --samples /dev/stdout", "--samples /dev/stdout: these need"},
      {"--save-state e.csv", "--save-state e.csv"},
      {"--save-state /nonexistent/state", "/nonexistent/state"},
      {"--save-state ''", "--save-state"},
      {"--resume ''", "--resume"},
      {"--resume absent.state", "--resume absent.state"},
      {"--resume .", "--resume .: is not a state file"},
      {"--resume /dev/zero", "--resume /dev/zero: is not a state file"},
  };
  for (const BadCase &bad : cases) {
    const std::string given = bad.arguments;
    const auto unless_given = [&given](const std::string &option, const std::string &path) {
      return given.find(option) == std::string::npos ? option + path : std::string();
    };
    const Result result = run("run " + unless_given("--events", " e.csv ") +
                              unless_given("--samples", " s.csv ") + given);
    EXPECT_EQ(result.status, 2) << bad.arguments;
    EXPECT_EQ(result.out, "") << bad.arguments;
    EXPECT_EQ(lines(result.err).size(), 1u) << bad.arguments << ": " << result.err;
    EXPECT_EQ(result.err.rfind("vibro-impact: ", 0), 0u) << bad.arguments << ": " << result.err;
    EXPECT_NE(result.err.find(bad.names), std::string::npos) << bad.arguments << ": " << result.err;
    EXPECT_TRUE(fs::is_empty(folder)) << bad.arguments << " left a file";
  }
}

TEST_F(Runner, ACommandIsNeeded) {
  const Result result = run("");
  EXPECT_EQ(result.status, 2);
  EXPECT_TRUE(is_one_message(result.err)) << result.err;
  EXPECT_NE(result.err.find("subcommand is required"), std::string::npos) << result.err;
}

}  // namespace
