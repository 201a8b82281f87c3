// The picture of a run, as gnuplot draws it from the tables.
#include <string>
#include <utility>
#include <vector>

#include "reference/truth/table_reader.hpp"
#include "tests/support/runner_program.hpp"

namespace {

using namespace vibro_impact::testing;
namespace truth = vibro_impact::truth;

// The rows that the script draws as points, or as pieces of a line, with numbers in both columns.
// With `set table`, gnuplot writes one block of rows for each plot instead of drawing.
std::vector<int> rows_drawn(const std::string &table) {
  std::vector<int> rows;
  for (const std::string &line : lines(table)) {
    if (line.starts_with("# Curve ") && line.ends_with(" points")) rows.push_back(0);
    if (!rows.empty() && line.ends_with(" i")) ++rows.back();
  }
  return rows;
}

// The impacts of both masses stand in the last of the five plots of their panel, each at the stop
// that it hits, and sticking in the third.
TEST_F(Runner, ThePictureHasEveryImpactAtItsStopAndEverySticking) {
  if (!there_is_gnuplot()) GTEST_SKIP() << "gnuplot is not there";
  const Result result =
      run("run --stop 1:lower:-0.3 --stop 1:upper:0.33 --stop 2:upper:0.1 --from 30 --until 150 "
          "--events e.csv --samples s.csv --plot p.svg");
  ASSERT_EQ(result.status, 0) << result.err;
  EXPECT_EQ(files(), (std::vector<std::string>{"e.csv", "p.svg", "s.csv"}));
  std::vector<int> impacts(2, 0), stuck_samples(2, 0);
  for (const truth::Row &row : truth::read_rows(folder / "e.csv", 3))
    if (row[2] == "impact") ++impacts[row[1] == "1" ? 0 : 1];
  for (const truth::Row &row : truth::read_rows(folder / "s.csv", 3)) {
    const double x1 = std::stod(row[1]), x2 = std::stod(row[2]);
    stuck_samples[0] += x1 == -0.3 || x1 == 0.33 ? 1 : 0;
    stuck_samples[1] += x2 == 0.1 ? 1 : 0;
  }
  // The script as the program calls it, but for the pictures, which become tables.
  std::ofstream(folder / "table.sh")
      << "sed '/multiplot/d; 1i set table \"drawn\"' '" PLOT_SCRIPT
         "' >table.gp\n"
         "gnuplot -c table.gp svg motion '1 2' s.csv e.csv '-0.3 NaN' '0.33 0.1'\n";
  ASSERT_EQ(run("--version; sh table.sh").status, 0);
  const std::vector<int> drawn = rows_drawn(contents(folder / "drawn"));
  ASSERT_EQ(drawn.size(), 10u);
  EXPECT_EQ(drawn[4], impacts[0]);
  EXPECT_EQ(drawn[9], impacts[1]);
  EXPECT_EQ(drawn[2], stuck_samples[0]);
  EXPECT_EQ(drawn[7], stuck_samples[1]);
}

TEST_F(Runner, GnuplotDrawsEveryKindOfFileWhateverItsName) {
  if (!there_is_gnuplot()) GTEST_SKIP() << "gnuplot is not there";
  for (const auto &[name, start] : {std::pair{"it's | ~ \\ it.png", "\x89PNG\r\n\x1a\n"},
                                    {"p.pdf", "%PDF-"},
                                    {"p.svg", "<?xml"}}) {
    const Result result =
        run(std::string("run --until 50 --samples \"it's \\$s.csv\" --events - ") + "--plot \"" +
            name + "\"");
    EXPECT_EQ(result.status, 0) << result.err;
    EXPECT_TRUE(contents(folder / name).starts_with(start)) << name << result.err;
  }
}

TEST_F(Runner, APictureThatCannotBeDrawnLeavesTheTablesAlone) {
  expect_message(
      run("run --samples s.csv --plot p.png", "PATH=$PWD/missing"),
      "vibro-impact: --plot p.png: needs gnuplot with its terminal pngcairo, not found\n");
  EXPECT_TRUE(fs::is_empty(folder));

  // A program without its script.
  fs::create_directory(folder / "bin");
  fs::copy_file(VIBRO_IMPACT_PROGRAM, folder / "bin/program");
  expect_message(run("run --samples s.csv --plot p.png", "true", "", "bin/program"),
                 "plot.gp, which is not there");
  fs::remove_all(folder / "bin");
  EXPECT_TRUE(fs::is_empty(folder));

  // A gnuplot that takes the terminal and then fails.
  std::ofstream(folder / "gnuplot") << "#!/bin/sh\ntest \"$2\" = -e || { printf 'plot\\n\"p.gp\" "
                                       "line 7: bad\\n\\n' >&2; false; }\n";
  fs::permissions(folder / "gnuplot", fs::perms::owner_all);
  expect_message(run("run --samples s.csv --plot p.png", "PATH=\"$PWD:$PATH\" && export PATH"),
                 "vibro-impact: --plot p.png: gnuplot could not draw it: bad\n", 1);
  EXPECT_EQ(files(), (std::vector<std::string>{"gnuplot", "s.csv"}));
}

}  // namespace
