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

const std::vector<BadCase> runs = {
    {"--mass nan", "mass = nan"},
    {"--mass 0", "mass = 0"},
    {"--stiffness inf", "stiffness = inf: must be finite"},
    {"--restitution 1.1", "1.1"},
    {"--omega -1", "-1"},
    {"--amplitude 0.5,nan", "nan"},
    {"--initial-displacement 0,0.2", "0.2"},
    {"--initial-displacement 0,0,0", "0,0,0"},
    {"--initial-velocity x", "x"},
    {"--stop 1:lower:0.0 --stop 1:upper:0.0", "lower must lie below"},
    {"--stop 1:upper:0.1 --stop 1:upper:0.2", "same side"},
    {"--stop 1:upper:0.1:", "--stop 1:upper:0.1:"},
    {"--stop 1:upper:0.1:x", "--stop 1:upper:0.1:x"},
    {"--stop 1:upper:0.1:1.5", "restitution = 1.5: must lie in [0, 1]"},
    {"--stop 1:upper:0.1:nan", "restitution = nan"},
    {"--stop 1:upper:0.1:0.7:0", "--stop 1:upper:0.1:0.7:0"},
    {"--stop 1:left:3", "1:left:3"},
    {"--stop 3:upper:1", "stop on mass 3"},
    {"--stop 1:upper:", "--stop 1:upper:"},
    {"--stop 1:upper:x", "--stop 1:upper:x"},
    {"--stop 1:upper:nan", "nan"},
    {"--stop 1.5:upper:1", "1.5:upper:1"},
    {"--stop 0:upper:1", "0:upper:1"},
    {"--masses 1", "stop on mass 2"},
    {"--until 0", "--until 0: must be positive and finite"},
    {"--until 1e", "--until: Failed parsing 1e as a"},
    {"--until nan", "--until nan: must be positive"},
    {"--until inf", "--until inf: must be"},
    {"--omega 1e400", "--omega 1e400"},
    {"--omega 0.28x", "--omega 0.28x"},
    {"--omega ''", "--omega: needs a value"},
    {"--mass 1,", "--mass 1,"},
    {"--from 800", "--from 800"},
    {"--from -1", "--from -1: must lie between 0 and --until 750"},
    {"--from nan", "--from nan"},
    {"--every 0", "--every 0: must be positive"},
    {"--every 1e-14", "--every 1e-14"},
    {"--every inf", "--every inf"},
    {"--masses 0", "--masses: Value 0 not in range 1 to 10000"},
    {"--masses 2.5", "Value 2.5 not in range"},
    {"--stiffness 1,0", "stiffness of link 2 = 0"},
    {"--beta ''", "--beta"},
    {"--beta -1", "beta = -1: must be non-negative"},
    {"--resolve-chatter -1", "--resolve-chatter -1: must be non-negative"},
    {"--resolve-chatter nan", "nan"},
    {"--resolve-chatter ''", "--resolve-chatter"},
    {"--max-impacts 0", "--max-impacts: Value 0 not in range"},
    {"--max-impacts 2.5", "--max-impacts: Value 2.5 not in range"},
    {"--bogus 3", "not expected: --bogus 3"},
    {"--event t.csv", "not expected: --event t.csv"},
    {"--omega", "--omega: 1 required NUMBER missing"},
    {"--omega 1 --omega 2", "--omega: may be given once"},
    {"stray", "not expected: stray"},
    {"--events /nonexistent/e.csv", "/nonexistent/e.csv"},
    {"--samples /nonexistent/s.csv", "/nonexistent/s.csv"},
    {"--events . ", ".: is a directory"},
    {"--events ''", "--events"},
    {"--events ./t.csv --samples t.csv", "t.csv: cannot be written: another file"},
    {"--events - --samples -", "one place"},
    {"--events - --samples /dev/stdout", "--samples /dev/stdout: two tables"},
    {"--save-state e.csv", "e.csv: cannot be written: another file"},
    {"--save-state /nonexistent/state", "/nonexistent/state"},
    {"--save-state ''", "--save-state"},
    {"--resume ''", "--resume"},
    {"--resume absent.state", "--resume absent.state"},
    {"--resume .", "--resume .: cannot be read, or does not begin with"},
    {"--resume /dev/zero", "--resume /dev/zero: cannot be read, or does not begin with"},
};

const std::vector<BadCase> sweeps = {
    {"", "--vary is required"},
    {"--vary omega=0.3:0.5:2 --table", "--table: 1 required FILE missing"},
    {"--vary omega=0.3:0.5", "--vary omega=0.3:0.5: must read parameter=from:to:count"},
    {"--vary omega=0.3:0.5:0", "--vary omega=0.3:0.5:0: '0' must be a whole number"},
    {"--vary omega=0.3:0.5:2.5", "whole number"},
    {"--vary omega=0.3:x:2", "'x' is not a number"},
    {"--vary omega=0:0.5:3", "omega = 0"},
    {"--vary omega=nan:0.5:3", "nan"},
    {"--vary omega=0.3:inf:3", "inf"},
    {"--vary omega=0.3:0.5:2 --vary omega=0.2:0.3:2", "given twice"},
    {"--vary stop3=0.1:0.2:3", "stop3: the scene has 2 stops"},
    {"--vary mass0=0.1:0.2:3", "parameter 'mass0'"},
    {"--vary colour=0.1:0.2:3", "colour"},
    {"--vary omega", "--vary omega"},
    {"--vary omega=0.1:0.2:1e9 --vary beta=0.1:0.2:1e9", "more points"},
    {"--vary omega=0.3:0.5:2 --longest 0", "--longest: Value 0"},
    {"--vary omega=0.3:0.5:2 --table -", "must be files"},
    {"--vary omega=0.3:0.5:2 --table ''", "--table"},
    {"--vary omega=0.3:0.5:2 --table .", ".: is a directory"},
    {"--vary omega=0.3:0.5:2 --table /nonexistent/t.csv", "/nonexistent/t.csv"},
    {"--vary omega=0.3:0.5:2 --until 3", "--until"},
};

const std::vector<BadCase> commands = {
    {"", "needs a command, run or sweep"},
    {"walk", "not expected: walk"},
    {"sweep --vary omega=0.3:0.5:2", "--table is required"},
};

TEST_F(Runner, BadInputGivesOneLineStatusTwoAndNoFile) {
  const auto refused = [this](const std::string &given, const char *names) {
    const Result result = run(given);
    EXPECT_EQ(result.status, 2) << given;
    EXPECT_EQ(result.out, "") << given;
    EXPECT_TRUE(is_one_message(result.err)) << given << ": " << result.err;
    EXPECT_NE(result.err.find(names), std::string::npos) << given << ": " << result.err;
    EXPECT_TRUE(fs::is_empty(folder)) << given << " left a file";
  };
  // With files to be written, unless these are what is wrong.
  const auto beside = [](const std::string &file, const std::string &given) {
    const bool is_given = given.find(file.substr(0, file.find(' '))) < given.size();
    return is_given ? given : file + " " + given;
  };
  for (const auto &[given, names] : runs)
    refused("run " + beside("--events e.csv", beside("--samples s.csv", given)), names);
  for (const auto &[given, names] : sweeps)
    refused("sweep " + beside("--table t.csv", given), names);
  for (const auto &[given, names] : commands) refused(given, names);
}

TEST_F(Runner, OneOfAllProcessesSaysWhatIsWrong) {
  if (!with_mpi) GTEST_SKIP() << "built without MPI";
  const Result many = run("sweep --table t --vary omega=0.3:0.5:0", "true", mpirun(2));
  EXPECT_EQ(many.status, 2);
  EXPECT_EQ(many.err.find("vibro-impact: "), many.err.rfind("vibro-impact: ")) << many.err;
}

}  // namespace
