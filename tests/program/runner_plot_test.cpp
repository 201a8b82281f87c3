// The picture of a run: what gnuplot is told, and that it draws it.
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "runner_program.hpp"

namespace {

using namespace vibro_impact::testing;

using Rows = std::vector<std::vector<double>>;

// The rows of a block of what gnuplot is told, below the one that is not drawn.
Rows block(const std::string &script, const std::string &name) {
  const std::string begin = "$" + name + " << END\nNaN NaN NaN\n";
  const std::size_t from = script.find(begin);
  EXPECT_NE(from, std::string::npos) << name;
  Rows rows;
  for (const std::string &line :
       lines(script.substr(from, script.find("END\n", from + begin.size()) - from)
                 .substr(begin.size()))) {
    std::istringstream words(line);
    std::vector<double> row;
    for (std::string number; words >> number;) row.push_back(std::stod(number));
    rows.push_back(row);
  }
  return rows;
}

// The times at which a sticking of the k-th mass drawn begins and ends, to a sample.
std::vector<double> ends_of_sticking(const Rows &motion, std::size_t k) {
  std::vector<double> ends;
  double last = 0.0;
  for (const auto &row : motion) {
    const bool held = !std::isnan(row.at(2 * k));
    if (held) {
      EXPECT_EQ(row[2 * k], row[2 * k - 1]);
    }
    if (held != (ends.size() % 2 == 1)) ends.push_back(held ? row[0] : last);
    last = row[0];
  }
  if (ends.size() % 2 == 1) ends.push_back(last);
  return ends;
}

struct PlotRunner : Runner {
  // Runs with a gnuplot that keeps what it is told and draws something.
  std::string script_of(const std::string &arguments) {
    std::ofstream(folder / "gnuplot") << "#!/bin/sh\ncat >script.gp\necho drawn\n";
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
  const Rows motion = block(script, "displacement");
  EXPECT_EQ(motion.size(), 4001u);
  EXPECT_EQ(motion.front()[0], 30.0);
  EXPECT_EQ(motion.back()[0], 75.0);
  EXPECT_EQ(block(script, "stop"), (Rows{{1.0, -0.3}, {2.0, 0.1}}));
  EXPECT_NE(script.find("'stop displacement impact sticking'"), std::string::npos);
  const double sample = 45.0 / 4000.0;
  for (const int mass : {1, 2}) {
    const auto i = static_cast<std::size_t>(mass - 1);
    const double stop = mass == 1 ? -0.3 : 0.1;
    // A mark stands for those that fall on the same place of the paper.
    Rows marks = block(script, "impact");
    std::erase_if(marks, [mass](const auto &mark) { return mark[1] != mass; });
    EXPECT_GT(impacts[i].size(), 20u);
    EXPECT_LE(marks.size(), impacts[i].size());
    for (const double time : impacts[i])
      EXPECT_TRUE(std::any_of(marks.begin(), marks.end(), [&](const std::vector<double> &mark) {
        return mark[2] == stop && std::abs(mark[0] - time) < 45.0 / 8000.0;
      })) << time;
    const auto sticking = ends_of_sticking(motion, i + 1);
    ASSERT_GE(sticking.size(), 4u);
    ASSERT_EQ(sticking.size(), ends[i].size());
    for (std::size_t k = 0; k < sticking.size(); ++k)
      EXPECT_NEAR(sticking[k], ends[i][k], sample) << "no sample is held before or after";
    for (const auto &row : motion)
      EXPECT_LE((row[2 * i + 1] - stop) * (mass == 1 ? -1.0 : 1.0), 1e-6) << "beyond the stop";
  }
}

// A run taken up while a mass sticks, and one that ends so.
TEST_F(PlotRunner, StickingIsDrawnFromTheStartAndToTheEnd) {
  const auto sticking = [this](const std::string &arguments) {
    return ends_of_sticking(block(script_of(arguments), "displacement"), 2);
  };
  const auto whole = sticking("run --until 60");
  ASSERT_GE(whole.size(), 2u);
  const double middle = (whole[0] + whole[1]) / 2, sample = 60.0 / 4000.0;
  const auto first = sticking("run --save-state x --until " + std::to_string(middle)),
             second = sticking("run --resume x --until 60");
  ASSERT_EQ(first.size(), 2u);
  ASSERT_EQ(second.size(), whole.size());
  EXPECT_NEAR(first[0], whole[0], sample);
  EXPECT_NEAR(first[1], middle, 1e-6) << "std::to_string has six digits";
  EXPECT_NEAR(second[0], middle, 1e-6);
  EXPECT_NEAR(second[1], whole[1], sample);
}

TEST_F(PlotRunner, EightMassesAreDrawnThoseWithStopsFirst) {
  const std::string script =
      script_of("run --masses 12 --stop 12:upper:0.1 --stop 12:lower:-0.2 --until 20");
  EXPECT_NE(script.find("masses = '1 2 3 4 5 6 7 12'"), std::string::npos);
  EXPECT_EQ(block(script, "stop"), (Rows{{12.0, 0.1}, {12.0, -0.2}}));
  EXPECT_EQ(block(script, "displacement").at(0).size(), 17u);
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
      {"--plot p.png --events p.png", "another file is being written there"},
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
  std::ofstream(folder / "gnuplot") << "#!/bin/sh\n! grep -q multiplot\n";
  fs::permissions(folder / "gnuplot", fs::perms::owner_all);
  const Result failed =
      run("run --events e.csv --plot p.png", "PATH=\"$PWD:$PATH\" && export PATH");
  EXPECT_EQ(failed.status, 1);
  EXPECT_EQ(failed.err, "vibro-impact: --plot p.png: gnuplot could not draw it\n");
  EXPECT_EQ(files(), (std::vector<std::string>{"e.csv", "gnuplot"}));
}

}  // namespace
