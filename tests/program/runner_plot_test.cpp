// The picture of a run: what gnuplot is told, and that it draws it.
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "runner_program.hpp"

namespace {

using namespace vibro_impact::testing;

// The numbers of a layer of panel `k` (from 0) in what gnuplot is told, row by row; an empty line
// is an empty row.
std::vector<std::vector<double>> block(const std::string &script, const std::string &layer, int k) {
  const std::string begin = "$" + layer + " << END\n", none = "NaN NaN\n";
  std::size_t from = script.find(begin);
  for (int panel = 0; panel <= k && from != std::string::npos; ++panel)
    from = script.find(none, from + 1);
  EXPECT_NE(from, std::string::npos) << layer;
  if (from == std::string::npos) return {};
  from += none.size();
  std::vector<std::vector<double>> rows;
  for (const std::string &row :
       lines(script.substr(from, script.find("\n\n\n", from - 1) - from))) {
    std::istringstream words(row);
    rows.emplace_back();
    for (double number; words >> number;) rows.back().push_back(number);
  }
  return rows;
}

struct PlotRunner : Runner {
  // Runs with a gnuplot that keeps what it is told and draws something.
  std::string script_of(const std::string &arguments) {
    std::ofstream(folder / "gnuplot") << "#!/bin/sh\ncat >script.gp\necho drawn >p.png.part\n";
    fs::permissions(folder / "gnuplot", fs::perms::owner_all);
    const Result result = run(arguments + " --plot p.png", "PATH=\"$PWD:$PATH\" && export PATH");
    EXPECT_EQ(result.status, 0) << result.err;
    EXPECT_EQ(contents(folder / "p.png"), "drawn\n");
    return contents(folder / "script.gp");
  }
};

TEST_F(PlotRunner, HoldsEveryImpactAndSticking) {
  const std::string script = script_of("run --from 30 --until 75 --events e.csv");
  std::vector<double> impacts[2], ends[2];
  double held_since[2] = {-1.0, -1.0};
  for (const std::string &line : lines(below_header(contents(folder / "e.csv")))) {
    const auto row = cells(line);
    const std::size_t i = row[1] == "1" ? 0 : 1;
    const double time = std::stod(row[0]);
    if (row[2] == "impact") impacts[i].push_back(time);
    if (row[2] == "stick") held_since[i] = time;
    if (row[2] == "release") ends[i].insert(ends[i].end(), {held_since[i], time});
  }
  for (const std::size_t i : {0u, 1u}) {
    const int panel = static_cast<int>(i);
    const double stop = i == 0 ? -0.3 : 0.1;
    EXPECT_EQ(block(script, "stop", panel), (std::vector<std::vector<double>>{{0.0, stop}}));
    // A mark stands for those that fall on the same place of the paper.
    const auto marks = block(script, "impact", panel);
    EXPECT_GT(impacts[i].size(), 20u);
    EXPECT_LE(marks.size(), impacts[i].size());
    for (const double time : impacts[i])
      EXPECT_TRUE(std::any_of(marks.begin(), marks.end(), [&](const std::vector<double> &mark) {
        return mark[1] == stop && std::abs(mark[0] - time) < 45.0 / 8000.0;
      })) << time;
    const auto sticking = block(script, "sticking", panel);
    ASSERT_GE(ends[i].size(), 4u);
    ASSERT_EQ(sticking.size(), ends[i].size() / 2 * 3) << "an empty line and two ends";
    for (std::size_t k = 0; k < ends[i].size(); ++k) {
      const auto &end = sticking[k / 2 * 3 + 1 + k % 2];
      ASSERT_EQ(end.size(), 2u);
      EXPECT_NEAR(end[0], ends[i][k], 1e-7) << "nine digits";
      EXPECT_EQ(end[1], stop);
    }
    const auto line = block(script, "displacement", panel);
    EXPECT_GT(line.size(), 4001u) << "samples, and corners at the events";
    EXPECT_EQ(line.front()[0], 30.0);
    EXPECT_EQ(line.back()[0], 75.0);
    for (std::size_t k = 1; k < line.size(); ++k) {
      EXPECT_GE(line[k][0], line[k - 1][0]);
      EXPECT_LE((line[k][1] - stop) * (i == 0 ? -1.0 : 1.0), 1e-6) << "beyond the stop";
    }
  }
}

// A run taken up while a mass sticks, and one that ends so.
TEST_F(PlotRunner, StickingIsDrawnFromTheStartAndToTheEnd) {
  const std::string whole = run("run --until 60 --events -").out;
  double stick = 0.0, release = 0.0;
  for (const std::string &line : lines(below_header(whole))) {
    const auto row = cells(line);
    if (row[2] == "stick" && row[5] == "2") stick = std::stod(row[0]);
    if (row[2] == "release" && row[1] == "2" && row[5] == "-") release = std::stod(row[0]);
    if (stick > 0.0 && release > stick) break;
  }
  ASSERT_GT(release, stick);
  const double middle = (stick + release) / 2;
  const auto first =
      block(script_of("run --save-state x --until " + std::to_string(middle)), "sticking", 1);
  const auto second = block(script_of("run --resume x --until 60"), "sticking", 1);
  ASSERT_GE(first.size(), 3u);
  ASSERT_GE(second.size(), 3u);
  EXPECT_NEAR(first[first.size() - 2][0], stick, 1e-6);
  EXPECT_NEAR(first[first.size() - 1][0], middle, 1e-6);
  EXPECT_NEAR(second[1][0], middle, 1e-6);
  EXPECT_NEAR(second[2][0], release, 1e-6);
}

TEST_F(PlotRunner, EightMassesAreDrawnThoseWithStopsFirst) {
  const std::string script =
      script_of("run --masses 12 --stop 12:upper:0.1 --stop 12:lower:-0.2 --until 20");
  EXPECT_NE(script.find("masses = '1 2 3 4 5 6 7 12 '"), std::string::npos);
  EXPECT_EQ(block(script, "stop", 7), (std::vector<std::vector<double>>{{0.0, 0.1}, {0.0, -0.2}}));
}

// Whatever the file is called, and at the end of a run that was given up.
TEST_F(PlotRunner, GnuplotDrawsIt) {
  const bool there = std::system("gnuplot -d -e 'set terminal pngcairo' >/dev/null 2>&1") == 0;
  const Result result = run("run --until 60 --plot \"it's | ~ \\\\ it.png\"");
  if (!there) {
    EXPECT_EQ(result.status, 2) << result.err;
    return;
  }
  EXPECT_EQ(result.status, 0) << result.err;
  EXPECT_EQ(files(), std::vector<std::string>{"it's | ~ \\ it.png"});
  EXPECT_EQ(contents(folder / files().front()).substr(0, 8), "\x89PNG\r\n\x1a\n");
  EXPECT_EQ(run("run --restitution 1 --stop 1:lower:-1e-6 --stop 1:upper:1e-6 --max-impacts 1000 "
                "--initial-velocity 0.3,0 --plot p.svg")
                .status,
            1);
  EXPECT_NE(contents(folder / "p.svg").find("</svg>"), std::string::npos);
}

TEST_F(PlotRunner, ARefusedOrFailedPictureLeavesNothing) {
  const std::pair<const char *, const char *> cases[] = {
      {"--plot p.jpg", "--plot p.jpg: must end in .png, .pdf or .svg"},
      {"--plot -", "must end in"},
      {"--plot ''", "--plot"},
      {"--plot p.png --from 750", "nothing to be drawn from t = 750 to 750"},
      {"--plot p.png --until 1e6", "give a later --from"},
      {"--plot p.png --events p.png", "two files"},
      {"--plot /nonexistent/p.png", "/nonexistent/p.png"},
  };
  for (const auto &[arguments, names] : cases) {
    const Result result = run(std::string("run ") + arguments);
    EXPECT_EQ(result.status, 2) << arguments;
    EXPECT_TRUE(is_one_message(result.err)) << result.err;
    EXPECT_NE(result.err.find(names), std::string::npos) << result.err;
  }
  const Result without = run("run --events e.csv --plot p.png", "PATH=/nonexistent");
  EXPECT_EQ(without.status, 2);
  EXPECT_EQ(without.err,
            "vibro-impact: --plot p.png: needs gnuplot with its terminal pngcairo, not found\n");
  EXPECT_TRUE(fs::is_empty(folder));

  // One that takes the terminal and then fails; the tables are whole by then.
  std::ofstream(folder / "gnuplot") << "#!/bin/sh\n! grep -q output\n";
  fs::permissions(folder / "gnuplot", fs::perms::owner_all);
  const Result failed =
      run("run --events e.csv --plot p.png", "PATH=\"$PWD:$PATH\" && export PATH");
  EXPECT_EQ(failed.status, 1);
  EXPECT_EQ(failed.err, "vibro-impact: --plot p.png: gnuplot could not draw it\n");
  EXPECT_EQ(files(), (std::vector<std::string>{"e.csv", "gnuplot"}));
}

}  // namespace
