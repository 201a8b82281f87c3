// Refusals of the program: one line that names the value and the rule, exit status 2, and no file.
// There is one case of each rule; the rules of scenes and grids are tested with the library. The
// words of CLI11 itself differ from version to version and are not compared.
#include <string>
#include <vector>

#include "tests/support/runner_program.hpp"

namespace {

using namespace vibro_impact::testing;

struct BadCase {
  std::string arguments, names;  // what the one line must contain
};

const std::string run_files = "run --events e.csv --samples s.csv ",
                  sweep_files = "sweep --table t.csv ", omega = "--vary omega=0.3:0.5:2 ";

const std::vector<BadCase> bad_cases = {
    // Commands and options.
    {"", "needs a command, run, orbit or sweep"},
    {"walk", "not expected: walk; the commands are run, orbit and sweep"},
    {run_files + "--bogus 3", "not expected: --bogus 3"},
    {run_files + "--damping 0.1", "--damping: is no option; --beta may be meant"},
    {run_files + "--gap 0.1", "--gap: is no option; --stop may be meant"},
    {"sweep --forces 0.1", "--force: is no option; --amplitude may be meant"},
    {run_files + "--omega", "--omega"},
    {"run --samples s.csv --events ''", "--events: needs a value"},
    {run_files + "--omega 1 --omega 2", "--omega"},
    {"sweep --table t.csv", "--vary"},
    {"sweep " + omega, "--table"},
    {sweep_files + omega + "--longest 0", "--longest"},
    // Bounds, just beyond each.
    {"run --masses 2001", "--masses: '2001' must be a whole number from 1 to 2000"},
    {run_files + "--stop 2001:upper:1", "stop on mass 2001: the chain has masses 1 to 2"},
    {run_files + "--max-steps 1.1e15",
     "'1.1e15' must be a whole number from 1 to 1000000000000000"},
    {sweep_files + omega + "--longest 1000001",
     "'1000001' must be a whole number from 1 to 1000000"},
    {sweep_files + "--vary omega=0.3:0.5:1000000001",
     "must be a whole number from 1 to 1000000000"},
    {"run --until 50000 --every 0.003 --samples s.csv", "0.003: 16666667 samples of 3 numbers"},
    {"run --until 30000 --every 0.003 --samples s.csv --velocities", "samples of 5 numbers, and"},
    // Numbers, lists, stops and ranges.
    {run_files + "--omega 1e400", "--omega: '1e400' is not a number in double precision"},
    {run_files + "--mass 1,x", "--mass: 'x' is not a number"},
    {run_files + "--mass 1,2,3", "--mass: 3 values given, the chain has 2 masses"},
    {run_files + "--stop '1:left\n:3'", "'1:left?:3' must read mass:side:position"},
    {run_files + "--mass " + std::string(500, 'x'), "xxx...' is not a number"},
    {run_files + "--stop 1.5:upper:1", "'1.5' must be a whole number from 1 to 1000000"},
    {sweep_files + "--vary omega=0.3:0.5",
     "--vary: 'omega=0.3:0.5' must read parameter=from:to:count"},
    {sweep_files + "--vary omega=0:0.5:3:log", "logarithmic steps need ends of one sign"},
    {run_files + "--resolve-chatter -1", "--resolve-chatter -1: must be non-negative"},
    {"sweep --impacts i.csv --slowest nan " + omega, "--slowest nan: must be non-negative"},
    {run_files + "--plot p.png --panels 1,3", "--panels: '3' must be a whole number from 1 to 2"},
    {sweep_files + "--vary colour=0.1:0.2:3", "colour"},
    // Times.
    {run_files + "--from 800", "--from 800: must lie between 0 and --until 750"},
    {run_files + "--from -1", "--from -1: must lie between 0 and --until 750"},
    {run_files + "--from 20P --until 10P", "--from 20P: must lie between 0 and --until 10P"},
    {run_files + "--from 20PP", "--from: '20PP' is not a number, nor one with a P behind it"},
    {run_files + "--until nan", "--until nan: must be finite"},
    {run_files + "--every -1", "--every -1: must be positive"},
    {"orbit --omega 0", "--omega 0: an orbit needs a forcing period"},
    {"orbit --vary omega=0.1:0.3:9", "--vary omega=0.1:0.3:9: needs --table"},
    {"orbit --table t.csv --vary omega=0.1:0.3:9:log", "in equal steps, without log"},
    {"orbit --table t.csv --vary omega=0.1:0.3:9 --vary beta=0:1:9", "along one range"},
    {"orbit --table t.csv --vary omega=0.3:0.4:9", "omega = 0.2: must lie in the range from 0.3"},
    {"orbit --samples s.csv --every 1e-300P", "--every 1e-300P: too short"},
    {run_files + "--every 1e-14", "--every 1e-14: too short"},
    // Refusals of the library: the scene, the run and the grid as a whole.
    {run_files + "--stiffness 1,0", "stiffness of link 2 = 0"},
    {"run --until inf --events e.csv", "--until inf: must be finite"},
    {run_files + "--every 0", "--every 0: must be positive"},
    {sweep_files + "--vary omega=0:0.5:3", "omega = 0"},
    // Files.
    {"run --events missing/e.csv", "missing is no folder"},
    {"run --events 'miss\n\x7fing/e.csv'", "miss  ing is no folder"},
    {"run --samples .", "--samples .: is no file"},
    {"run --events ./t.csv --samples t.csv",
     "t.csv: the scene or another table of the command stands there"},
    {"run --events - --samples -", "--samples -: the scene or another table"},
    {"sweep --pairs=1 --table t.csv " + omega, "pairs"},
    {"sweep " + omega, "needs --table, --impacts or --section"},
    {"sweep --table t.csv --vary omega=1:1:3", "'omega=1:1:3' has equal values; one is enough"},
    {run_files + "--every 1P --omega 0", "--every: '1P' without a forcing frequency"},
    {"run --beta 0 --stiffness 1,1e30 --until 100 --events e.csv", "of a chain that swings on"},
    {"run --samples s.csv --from 5 --until 5 --plot p.png", "needs at least two samples"},
    {"run --samples s.csv --portrait p.png", "--portrait p.png: needs --velocities"},
    {sweep_files + omega + "--plot p.png", "is drawn from the table of --impacts"},
    {sweep_files + omega + "--vary beta=0:1:2 --plot p.png --column x", "--column x: is no column"},
    {sweep_files + omega + "--column period", "--column: needs --plot"},
    {sweep_files + omega + "--pairs --plot p.png --column pairs", "--column pairs: has words"},
    {"sweep --impacts i.csv --lyapunov " + omega, "--lyapunov: needs --table"},
    {sweep_files + omega + "--exponent-periods 640", "--exponent-periods: needs --lyapunov"},
    {sweep_files + omega + "--slowest 0.1", "--slowest: needs --impacts"},
    {sweep_files + omega + "--panels 1", "--panels: needs a picture"},
    {sweep_files + omega + "--plot p.png --column period --panels 1", "has one panel"},
    {"sweep --impacts i.csv --plot p.png --panels 1,1 " + omega, "--panels 1,1: has mass 1 twice"},
    {sweep_files + omega + "--part 4/3", "--part: '4' must be a whole number from 1 to 3"},
    {sweep_files + omega + "--part 4", "--part: '4' must read K/N"},
    {"sweep --impacts i.csv --plot p.png --part 1/2 " + omega, "--part 1/2: a picture needs all"},
    {sweep_files + omega + "--attractor --part 1/2",
     "the states of --section tell those of several"},
    {"orbit --near-start --longest 5", "--longest: bounds the settling"},
    {"run --velocities", "--velocities: needs --samples"},
    {"run --events e.csv --every 0.1", "--every: needs --samples"},
    {"run --until 10 --from 5", "--from: needs --events, --samples or --summary"},
    {"run --until 10 --samples s.csv --slowest 0.1", "--slowest: needs --events or --summary"},
    {"orbit --longest 1 --table t.csv --vary displacement1=-0.1:0.1:5",
     "displacement1: is an initial state"},
    {sweep_files + omega + "--vary beta=0:1:2 --vary restitution=0:1:2 --plot p.png",
     "draws one or two ranges, not 3"},
    {"sweep --impacts i.csv " + omega + "--vary beta=0:1:2 --plot p.png",
     "is drawn from the table of --table"},
    {"sweep --table missing/t.csv " + omega, "missing is no folder"},
    {"run --samples s.csv --plot p.jpg", "--plot p.jpg: must end in .png, .pdf or .svg"},
    {"run --plot p.png", "--plot p.png: is drawn from the table of --samples"},
};

TEST_F(Runner, RefusesBadInputInOneLineAndLeavesNoFile) {
  for (const auto &[arguments, names] : bad_cases) {
    const Result result = run(arguments);
    SCOPED_TRACE(arguments);
    expect_message(result, names);
    EXPECT_EQ(result.out, "");
    EXPECT_TRUE(fs::is_empty(folder)) << "it left a file";
  }
}

// The other programs of the project say their own name, every choice, and no folder of the machine
// they were built on.
TEST_F(Runner, OtherProgramsRefuseInTheSameWay) {
  const Result unknown = run("figure9 t.csv", "true", "", PROGRAM_DIR "/reference-generate");
  EXPECT_EQ(unknown.status, 2);
  EXPECT_TRUE(
      unknown.err.starts_with("reference-generate: table 'figure9': must be one of figure2"))
      << unknown.err;
  const Result usage = run("", "true", "", PROGRAM_DIR "/reference-generate");
  EXPECT_EQ(usage.status, 2);
  for (const char *table : {"figure5c", "extremes", "work_precision_events"}) {
    EXPECT_NE(unknown.err.find(table), std::string::npos) << unknown.err;
    EXPECT_NE(usage.err.find(table), std::string::npos) << usage.err;
  }
  EXPECT_TRUE(fs::is_empty(folder));
  const Result help = run("--help", "true", "", PROGRAM_DIR "/check");
  EXPECT_EQ(help.status, 0);
  EXPECT_EQ(help.out.find(SOURCE_DIR), std::string::npos) << help.out;
}

}  // namespace
