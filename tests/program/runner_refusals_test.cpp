// Refusals of the program: one line that names the value and the rule, exit status 2, and no file.
// refused.txt has one case of each rule; the rules of scenes and grids are tested with the library.
// The words of CLI11 itself differ from version to version and are not compared.
#include <string>

#include "tests/support/runner_program.hpp"

namespace {

using namespace vibro_impact::testing;

// A refusal writes one line, which contains these words, no output and no file.
void expect_refusal(const Runner &runner, const std::string &arguments, const std::string &words) {
  SCOPED_TRACE(arguments);
  const Result result = runner.run(arguments);
  expect_message(result, words);
  EXPECT_EQ(result.out, "");
  EXPECT_TRUE(fs::is_empty(runner.folder)) << "it left a file";
}

TEST_F(Runner, RefusesBadInputInOneLineAndLeavesNoFile) {
  const std::string arrow = " -> ";
  std::size_t refused = 0;
  for (const std::string &line : lines(contents(SOURCE_DIR "/tests/program/refused.txt"))) {
    if (line.starts_with('#')) continue;
    const std::size_t end = line.find(arrow);
    ASSERT_LT(end, line.size()) << line;
    expect_refusal(*this, line.substr(0, end), line.substr(end + arrow.size()));
    ++refused;
  }
  EXPECT_GT(refused, 80u) << "the table is not empty";
}

TEST_F(Runner, RefusesInOneLineWhateverTheWords) {
  expect_refusal(*this, "run --stop '1:left\n:3'", "'1:left?:3' must read mass:side:position");
  expect_refusal(*this, "run --mass " + std::string(500, 'x'), "xxx...' is not a number");
  expect_refusal(*this, "run --events 'miss\n\x7fing/e.csv'", "miss  ing is no folder");
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
