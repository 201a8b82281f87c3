// The progress line: what it says, when, and that it is gone at the end. Time is told, not taken.
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <functional>
#include <string>

#include "program/progress.hpp"

namespace {

using namespace vibro_impact;

// What `work` writes on a screen, with a clock that it may set forward.
std::string written(bool terminal, bool asked_for, double before,
                    const std::function<void(Progress &, double &seconds)> &work) {
  static double seconds;
  seconds = 1000.0;
  Progress::Screen screen{std::tmpfile(), terminal, [] {
                            return std::chrono::steady_clock::time_point(
                                std::chrono::duration_cast<std::chrono::steady_clock::duration>(
                                    std::chrono::duration<double>(seconds)));
                          }};
  {
    Progress progress("time", 750.0, asked_for, before, screen);
    work(progress, seconds);
  }
  std::string text;
  std::rewind(screen.file);
  for (int c; (c = std::fgetc(screen.file)) != EOF;) text.push_back(static_cast<char>(c));
  std::fclose(screen.file);
  return text;
}

TEST(Progress, SaysHowFarAndHowLongStill) {
  const auto line = [](double before, double done, double total, double seconds) {
    return progress_line("time", before, done, total, seconds);
  };
  EXPECT_EQ(line(0, 75, 750, 3), "time: 75 of 750 (10 %), 27 s left");
  EXPECT_EQ(line(0, 75.5, 750, 30), "time: 75.5 of 750 (10 %), 4 min 29 s left");
  EXPECT_EQ(line(700, 725, 750, 4000), "time: 725 of 750 (96 %), 1 h 6 min left");
  EXPECT_EQ(line(0, 1, 101, 2 * 86400), "time: 1 of 101 (0 %), 200 days left");
  EXPECT_EQ(line(0, 1e6, 1e15, 2), "time: 1e+06 of 1e+15 (0 %), 63.4 years left");
  EXPECT_EQ(line(0, 1e-3, 1e15, 2), "time: 0.001 of 1e+15 (0 %), more than a million years left");
  EXPECT_EQ(line(0, 749.99, 750, 9), "time: 749.99 of 750 (99 %), 1 s left");
  EXPECT_EQ(line(0, 750, 750, 9), "time: 750 of 750 (100 %), 0 s left");
  EXPECT_EQ(line(700, 700, 750, 5), "time: 700 of 750 (93 %)") << "nothing known of the pace";
}

TEST(Progress, RewritesItsLineFiveTimesASecondAndWipesIt) {
  const std::string text = written(true, false, 0.0, [](Progress &progress, double &seconds) {
    for (int i = 1; i <= 300; ++i) {  // for three seconds, a hundred times a second
      seconds = 1000.0 + i / 100.0;
      progress.advance(1.0);
    }
  });
  EXPECT_EQ(text.substr(0, 40), "\rtime: 200 of 750 (26 %), 6 s left\rtime:");
  EXPECT_EQ(text.find('\n'), std::string::npos);
  // What a terminal shows in the end.
  std::string shown;
  std::size_t at = 0, lines = 0;
  for (const char c : text) {
    if (c == '\r') {
      at = 0;
      ++lines;
      continue;
    }
    shown.resize(std::max(shown.size(), at + 1), ' ');
    shown[at++] = c;
  }
  EXPECT_EQ(lines, 6u + 2u) << "at 2.0, 2.2, ... 3.0 s, and two to wipe it";
  EXPECT_EQ(shown.find_first_not_of(' '), std::string::npos) << "'" << shown << "'";
  EXPECT_EQ(at, 0u);
}

TEST(Progress, AShorterLineLeavesNothingOfALongerOne) {
  const std::string text = written(true, false, 0.0, [](Progress &progress, double &seconds) {
    seconds += 50.0;
    progress.reach(123.456);
    seconds += 1.0;
    progress.reach(700.0);
  });
  EXPECT_NE(text.find("\rtime: 123.456 of 750 (16 %), 4 min 14 s left\rtime: 700 of 750 (93 %), "
                      "4 s left           \r"),
            std::string::npos)
      << text;
}

TEST(Progress, SaysNothingOfShortWorkAndWhereNobodyReads) {
  const auto short_work = [](Progress &progress, double &seconds) {
    EXPECT_TRUE(progress.is_read());
    seconds += 1.99;
    progress.reach(700.0);
  };
  EXPECT_EQ(written(true, false, 0.0, short_work), "");
  EXPECT_EQ(written(false, true, 0.0, short_work), "");
  EXPECT_EQ(written(false, false, 0.0,
                    [](Progress &progress, double &seconds) {
                      EXPECT_FALSE(progress.is_read());
                      seconds += 100.0;
                      progress.reach(700.0);
                    }),
            "");
}

// A file gets lines, ever fewer.
TEST(Progress, WritesLinesToAFileAfterTwoFourEightSeconds) {
  const std::string text = written(false, true, 650.0, [](Progress &progress, double &seconds) {
    for (int i = 1; i <= 100; ++i) {
      seconds += 0.125;
      progress.reach(650.0 + i);
    }
  });
  EXPECT_EQ(text,
            "time: 666 of 750 (88 %), 11 s left\n"
            "time: 682 of 750 (90 %), 9 s left\n"
            "time: 714 of 750 (95 %), 5 s left\n");
}

}  // namespace
