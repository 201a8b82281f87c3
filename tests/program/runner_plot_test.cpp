// The picture of a run, as gnuplot draws it from the tables.
#include <map>
#include <regex>
#include <string>
#include <utility>
#include <vector>

#include "runner_program.hpp"

namespace {

using namespace vibro_impact::testing;

bool there_is_gnuplot() {
  return std::system("gnuplot -d -e 'set terminal pngcairo' >/dev/null 2>&1") == 0;
}

// The marks of impacts in a picture (.svg): how many there are at each height.
std::map<double, long> marks_in(const std::string &picture) {
  std::map<double, long> marks;
  const std::regex mark("'#gpPt5' transform='translate\\([0-9.]*,([0-9.]*)\\)");
  for (std::sregex_iterator found(picture.begin(), picture.end(), mark), end; found != end; ++found)
    ++marks[std::stod((*found)[1])];
  return marks;
}

// The pieces of the line that shows sticking.
long pieces_of_sticking(const std::string &picture) {
  long pieces = 0;
  const std::string line = "stroke='rgb(224, 160,  48)'  d='";
  for (std::size_t at = picture.find(line); at != picture.npos; at = picture.find(line, at)) {
    at += line.size();
    const std::string path = picture.substr(at, picture.find('\'', at) - at);
    pieces += std::count(path.begin(), path.end(), 'M');
  }
  return pieces;
}

// One of each stands in the key.
TEST_F(Runner, APictureHoldsEveryImpactAtItsStopAndEverySticking) {
  if (!there_is_gnuplot()) GTEST_SKIP() << "gnuplot is not there";
  const Result result =
      run("run --stop 1:lower:-0.3 --stop 1:upper:0.33 --stop 2:upper:0.1 --from 30 --until 150 "
          "--events e.csv --samples s.csv --plot p.svg");
  ASSERT_EQ(result.status, 0) << result.err;
  std::map<std::pair<int, bool>, long> impacts;  // mass, at its upper stop
  long sticks = 0;
  for (const std::string &line : lines(below_header(contents(folder / "e.csv")))) {
    const auto row = cells(line);
    if (row[2] == "impact") ++impacts[{std::stoi(row[1]), std::stod(row[3]) > 0.0}];
    if (row[2] == "stick") ++sticks;
  }
  ASSERT_EQ(impacts.size(), 3u);
  EXPECT_GE(sticks, 4);
  const std::string picture = contents(folder / "p.svg");
  // From the top: the key, the upper and the lower stop of mass 1, the stop of mass 2.
  std::vector<long> marks;
  for (const auto &[height, count] : marks_in(picture)) marks.push_back(count);
  EXPECT_EQ(marks,
            (std::vector<long>{1, impacts[{1, true}], impacts[{1, false}], impacts[{2, true}]}));
  EXPECT_EQ(pieces_of_sticking(picture), sticks + 1);
}

// Whatever the files are called, and at the end of a run that was given up.
TEST_F(Runner, GnuplotDrawsEveryKindOfFile) {
  if (!there_is_gnuplot()) GTEST_SKIP() << "gnuplot is not there";
  for (const auto &[name, start] : {std::pair{"it's | ~ \\ it.png", "\x89PNG\r\n\x1a\n"},
                                    {"p.pdf", "%PDF-"},
                                    {"p.svg", "<?xml"}}) {
    const Result result =
        run(std::string("run --restitution 1 --stop 1:lower:-1e-6 --stop 1:upper:1e-6 "
                        "--max-impacts 1000 --initial-velocity 0.3,0 --every 1e-5 "
                        "--samples \"it's \\$s.csv\" --events - --plot \"") +
            name + "\"");
    EXPECT_EQ(result.status, 1) << "given up";
    EXPECT_TRUE(contents(folder / name).starts_with(start)) << name << result.err;
  }
}

TEST_F(Runner, ARefusedOrFailedPictureLeavesNothing) {
  const std::pair<const char *, const char *> cases[] = {
      {"--samples s.csv --plot p.jpg", "--plot p.jpg: must end in .png, .pdf or .svg"},
      {"--samples s.csv --plot -", "must end in"},
      {"--samples s.csv --plot ''", "--plot"},
      {"--plot p.png", "--plot p.png: is drawn from the table of --samples"},
      {"--samples - --plot p.png", "of --samples; both must be files"},
      {"--samples s.csv --plot p.png --events p.png", "another file is being written there"},
      {"--samples s.csv --plot /nonexistent/p.png", "/nonexistent/p.png"},
  };
  for (const auto &[arguments, names] : cases) {
    const Result result = run(std::string("run ") + arguments);
    EXPECT_EQ(result.status, 2) << arguments;
    EXPECT_TRUE(is_one_message(result.err)) << result.err;
    EXPECT_NE(result.err.find(names), std::string::npos) << result.err;
  }
  const Result without = run("run --samples s.csv --plot p.png", "PATH=/nonexistent");
  EXPECT_EQ(without.status, 2);
  EXPECT_EQ(without.err,
            "vibro-impact: --plot p.png: needs gnuplot with its terminal pngcairo, not found\n");
  EXPECT_TRUE(fs::is_empty(folder));

  // One that takes the terminal and then fails; the tables are whole by then.
  std::ofstream(folder / "gnuplot") << "#!/bin/sh\ntest \"$2\" = -e\n";
  fs::permissions(folder / "gnuplot", fs::perms::owner_all);
  const Result failed =
      run("run --samples s.csv --plot p.png", "PATH=\"$PWD:$PATH\" && export PATH");
  EXPECT_EQ(failed.status, 1);
  EXPECT_EQ(failed.err, "vibro-impact: --plot p.png: gnuplot could not draw it\n");
  EXPECT_EQ(files(), (std::vector<std::string>{"gnuplot", "s.csv"}));
}

}  // namespace
