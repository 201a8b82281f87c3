// The progress line: what it says, and when it is written.
#include <gtest/gtest.h>

#include "program/progress.hpp"

namespace {

using namespace vibro_impact;

TEST(Progress, SaysHowFarAndHowLongStill) {
  const auto line = [](double before, double done, double total, double seconds) {
    return progress_line("time", before, done, total, seconds);
  };
  EXPECT_EQ(line(0, 75, 750, 3), "time: 75 of 750 (10 %), 0.45 min left");
  EXPECT_EQ(line(700, 725, 750, 4000), "time: 725 of 750 (96 %), 66.7 min left");
  EXPECT_EQ(line(0, 1e-3, 1e15, 2), "time: 0.001 of 1e+15 (0 %), 3.33e+16 min left");
  EXPECT_EQ(line(0, 750, 750, 9), "time: 750 of 750 (100 %), 0 min left");
  EXPECT_EQ(line(700, 700, 750, 5), "time: 700 of 750 (93 %)") << "nothing is known of the pace";
}

TEST(Progress, IsShownAfterTwoSecondsAndFiveTimesASecond) {
  EXPECT_FALSE(is_progress_due(1.9, 0.0));
  EXPECT_TRUE(is_progress_due(2.0, 0.0));
  EXPECT_FALSE(is_progress_due(2.1, 2.0));
  EXPECT_TRUE(is_progress_due(2.3, 2.0));
}

}  // namespace
