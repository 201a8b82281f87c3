// The progress line: what it says, and on a terminal that it is gone at the end.
#include "program/progress.hpp"

#include "runner_program.hpp"

namespace {

using namespace vibro_impact::testing;
using vibro_impact::progress_line;

TEST(Progress, SaysHowFarAndHowLongStill) {
  const auto line = [](double before, double done, double total, double seconds) {
    return progress_line("time", before, done, total, seconds);
  };
  EXPECT_EQ(line(0, 75, 750, 3), "time: 75 of 750 (10 %), 0.45 min left");
  EXPECT_EQ(line(700, 725, 750, 4000), "time: 725 of 750 (96 %), 66.7 min left");
  EXPECT_EQ(line(0, 1e-3, 1e15, 2), "time: 0.001 of 1e+15 (0 %), 3.33e+16 min left");
  EXPECT_EQ(line(0, 750, 750, 9), "time: 750 of 750 (100 %), 0 min left");
  EXPECT_EQ(line(700, 700, 750, 5), "time: 700 of 750 (93 %)") << "nothing known of the pace";
}

// Not in the first two seconds (of six, for a busy machine starts late); then lines at 2, 4, 8,
// ..., one line that is rewritten on a terminal, none beside a table.
TEST_F(Runner, TheProgressOfARunIsShownAndWiped) {
  const std::string program = VIBRO_IMPACT_PROGRAM " run --until 1e15 --events /dev/null ";
  const Result lines_of = run("--version; timeout -s TERM 6 " + program);
  EXPECT_EQ(lines_of.err.rfind("time: ", 0), 0u) << lines_of.err;
  EXPECT_NE(lines_of.err.find(" left\nvibro-impact: interrupted at t = "), std::string::npos)
      << lines_of.err;
  EXPECT_EQ(run("--version; timeout -s TERM 6 " + program + "--samples - --every 1e14")
                .err.rfind("vibro-impact: ", 0),
            0u);
  const Result shown =
      run("--version >/dev/null; timeout 6 script -qefc 'exec " + program + "' /dev/null");
  const std::string wipe = "\r\033[K";
  EXPECT_EQ(shown.out.rfind(wipe + "time: ", 0), 0u) << shown.out;
}

}  // namespace
