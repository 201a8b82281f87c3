// Scene files: what is read, and the one line about what is not.
#include <fstream>
#include <string>
#include <vector>

#include "tests/support/runner_program.hpp"
#include "vibro_impact/scene_fields.hpp"

namespace {

using namespace vibro_impact::testing;

struct SceneFile : Runner {
  // The scene that the program reads from a file with this text.
  Result read(const std::string &text) const {
    std::ofstream(folder / "scene", std::ios::binary) << text;
    return run("run --scene scene --print-scene");
  }
};

TEST_F(SceneFile, SaysTheSameInEveryNotation) {
  const std::string expected =
      run("run --omega 0.5 --mass 1,2 --stop 1:lower:-1 --stop 2:upper:2 --print-scene").out;
  for (const char *text : {
           "omega = 0.5\nmass = 1,2\nstop = 1:lower:-1, 2:upper:2\n",
           "omega=0.5\nmass=[1, 2]\nstop=[\"1:lower:-1\", \"2:upper:2\"]",
           "\xEF\xBB\xBFomega = '0.5'\r\nmass = \"1,2\"\r\nstop = [1:lower:-1,2:upper:2]\r\n",
           "# a comment\n\n  omega\t= 0.5  # of the paper\n mass = 1 , 2\nstop = "
           "1:lower:-1,2:upper:2",
       }) {
    const Result result = read(text);
    EXPECT_EQ(result.status, 0) << text << result.err;
    EXPECT_EQ(result.out, expected) << text;
  }
}

TEST_F(SceneFile, RefusesWhatItCannotReadWithFileLineAndRule) {
  const struct {
    std::string text, line, rule;
  } refused[] = {
      {"beta = 0.15\nomega = [0.55", "line 2", "a bracket or a quote is not closed"},
      {"mass = [1,2", "line 1", "a bracket or a quote is not closed"},
      {"mass = 1,2]", "line 1", "a bracket or a quote is not closed"},
      {"omega = \"0.5", "line 1", "a bracket or a quote is not closed"},
      {"massess = 3", "line 1", "is no option of a scene"},
      {"omega = 0.5\nomega = 0.6", "line 2", "is given twice"},
      {"[scene]", "line 1", "must read name = value"},
      {"omega", "line 1", "must read name = value"},
      {"omega: 0.5", "line 1", "must read name = value"},
      {"= 3", "line 1", "is no option of a scene"},
      {"events = leak.csv", "line 1", "is no option of a scene"},
      {"until = 10", "line 1", "is no option of a scene"},
      {"help = true", "line 1", "is no option of a scene"},
      {"scene = x", "line 1", "is no option of a scene"},
      {"omega = +1", "line 1", "'+1' is not a number"},
      {"omega =", "line 1", "'' is not a number"},
      {"beta = 0.1\nstop = 1:left:3", "line 2", "must read mass:side:position"},
      {std::string(300'000, 'x'), "line 1", "must read name = value"},
      {std::string("\x7f\x1b[31m\0\xff", 8), "line 1", "must read name = value"},
  };
  for (const auto &[text, line, rule] : refused) {
    const Result result = read(text);
    EXPECT_EQ(result.out, "");
    expect_message(result, "--scene scene, " + line + ": ");
    expect_message(result, rule);
    EXPECT_LE(result.err.size(), 200u);
    for (const char c : result.err) EXPECT_TRUE(c == '\n' || (c >= ' ' && c <= '~'));
  }
}

// An option takes the place of its line, whose value need not fit the chain of another option.
TEST_F(SceneFile, AnOptionReplacesItsLine) {
  ASSERT_EQ(read("masses = 2\nmass = 1,2\nomega = 0.5\n").status, 0);
  const Result result = run("run --print-scene --scene scene --masses 3 --mass 1,2,3");
  EXPECT_EQ(result.out, run("run --print-scene --masses 3 --mass 1,2,3 --omega 0.5").out)
      << result.err;
  EXPECT_NE(result.out, "");
}

TEST_F(SceneFile, RefusesWhatIsNoFile) {
  for (const std::string file : {".", "/proc/self/mem", "/dev/null", "missing"})
    expect_message(run("run --until 20 --scene " + file), file);
}

// Numbers are read in one way, in options as in lists and files.
TEST_F(Runner, NumbersAreReadInOneWay) {
  for (const char *word : {"+1", "0x10", "' 1'", "1,5", "1e400", "1e", "''"})
    for (const char *name : {"--beta", "--mass", "--masses", "--until", "--max-steps"}) {
      const Result result = run(std::string("run --events - ") + name + "=" + word);
      const bool is_list = std::string(word) == "1,5" && std::string(name) == "--mass";
      EXPECT_EQ(result.status, is_list ? 0 : 2) << name << word;
    }
  EXPECT_EQ(run("run --until 5e0 --max-steps 1e10 --masses 2e0").status, 0);
}

// The options, the files and the parameters have what the list of fields has.
TEST_F(SceneFile, EveryFieldOfASceneIsAnOptionALineAndAParameter) {
  std::vector<std::pair<std::string, std::string>> fields;  // and the parameter of mass 2
  for (const auto &field : vibro_impact::scalar_fields) fields.emplace_back(field.name, field.name);
  for (const auto &field : vibro_impact::list_fields)
    fields.emplace_back(field.name, std::string(field.name) + "2");
  const std::string help = run("run --help").out, scene = run("run --print-scene").out;
  for (const auto &[name, parameter] : fields) {
    EXPECT_NE(help.find("  --" + name + " "), std::string::npos) << name;
    EXPECT_NE(scene.find("\n" + name + " = "), std::string::npos) << name;
    const Result option = run("run --print-scene --" + name + " 0.0625"),
                 line = read(name + " = 0.0625\n");
    EXPECT_NE(option.out.find("\n" + name + " = 0.0625\n"), std::string::npos) << option.err;
    EXPECT_EQ(line.out, option.out) << line.err;
    const Result sweep =
        run("sweep --stop none --longest 1 --table t.csv --vary " + parameter + "=0.0625:0.07:2");
    EXPECT_EQ(sweep.status, 0) << sweep.err;
  }
}

TEST_F(Runner, ATableSaysWhatMadeIt) {
  const std::string scene = "--masses 2 --beta 0.2 --stop 1:upper:0.3:0.5 --amplitude 0.5,0.1 ";
  ASSERT_EQ(run("run --until 20 --header --events e.csv " + scene).status, 0);
  ASSERT_EQ(run("sweep --vary omega=0.3:0.4:2 --header --table t.csv " + scene).status, 0);
  EXPECT_EQ(lines(contents(folder / "t.csv"))[0],
            "# vibro-impact " VIBRO_IMPACT_VERSION " sweep --vary=omega=0.3:0.4:2");
  for (const char *table : {"e.csv", "t.csv"})
    EXPECT_EQ(run(std::string("run --print-scene --scene ") + table).out,
              run("run --print-scene " + scene).out);
  // Without its comments it is the table without the option.
  ASSERT_EQ(run("run --until 20 --events plain.csv " + scene).status, 0);
  const std::string with = contents(folder / "e.csv");
  EXPECT_EQ(with.substr(with.find("\ntime,") + 1), contents(folder / "plain.csv"));
}

}  // namespace
