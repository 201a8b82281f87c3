// The frequencies inferred from the paper's axis boxes and text: the rule, what it leaves and what
// it refuses. (That it holds where the frequencies are printed: figures_test.)
#include "figures/inferred_frequencies.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace {

using namespace vibro_impact;
using namespace vibro_impact::figures;

TEST(AxisRule, AnAxisEndsAtTheFirstTickBeyondTheData) {
  const Range axis{-0.4, 0.5};
  EXPECT_TRUE(fills({-0.326, 0.45}, axis, 0.1));
  EXPECT_FALSE(fills({-0.248, 0.45}, axis, 0.1)) << "the axis would have ended at -0.3";
  EXPECT_FALSE(fills({-0.326, 0.39}, axis, 0.1)) << "the axis would have ended at 0.4";
  EXPECT_FALSE(fills({-0.41, 0.45}, axis, 0.1)) << "beyond the axis";
  EXPECT_FALSE(fills({-0.326, 0.51}, axis, 0.1)) << "beyond the axis";
  // A stop on a tick is exceeded: the axis ends one tick beyond it.
  EXPECT_TRUE(fills({-0.05, 0.1}, {-0.06, 0.12}, 0.02));
  EXPECT_FALSE(fills({-0.05, 0.1 - 1e-6}, {-0.06, 0.12}, 0.02));
  EXPECT_FALSE(fills({never, 0.1}, {-0.06, 0.12}, 0.02));
  EXPECT_FALSE(fills({-0.05, never}, {-0.06, 0.12}, 0.02));
  EXPECT_FALSE(fills({}, axis, 0.1)) << "no data";
}

// The frequencies between the given ones that boxes and text leave.
std::vector<double> left_between(double from, double to, Trial (*attempt)(double omega)) {
  std::vector<double> left;
  for (const Trial &trial : scan(from, to, attempt))
    if (trial.boxes && trial.text) left.push_back(trial.omega);
  return left;
}

// The table of figures/README.md. Ranges around what is left, in place of all 4,000 values.
TEST(InferredFrequencies, BoxesAndTextLeaveThoseOfTheTable) {
  EXPECT_EQ(left_between(0.2083, 0.2093, try_figure2), std::vector{0.2088});
  EXPECT_EQ(left_between(0.2349, 0.2359, try_figure2), std::vector{0.2354});
  EXPECT_EQ(left_between(0.2526, 0.2536, try_figure2), std::vector{0.2531});
  EXPECT_EQ(left_between(0.2791, 0.2805, try_figure2), std::vector{paper::figure2().omega});
  EXPECT_EQ(left_between(0.3495, 0.3503, try_figure2), std::vector{0.3499});
  EXPECT_EQ(left_between(0.3582, 0.3590, try_figure2), std::vector{0.3586});
  EXPECT_EQ(left_between(0.1700, 0.1704, try_figure5a), std::vector{0.1702});
  EXPECT_EQ(left_between(0.1765, 0.1780, try_figure5a), std::vector{paper::figure5a().omega});
  EXPECT_EQ(left_between(0.1900, 0.1904, try_figure5a), std::vector{0.1902});
  EXPECT_EQ(left_between(0.2559, 0.2563, try_figure5a), std::vector{0.2561});
  EXPECT_EQ(left_between(0.2985, 0.3005, try_figure5b), std::vector{paper::figure5b().omega});
}

TEST(InferredFrequencies, ValuesBesideThemBreakTheBoxesOrTheText) {
  EXPECT_FALSE(try_figure2(0.28).boxes) << "x2 stays above 0.013 in (b)";
  EXPECT_FALSE(try_figure2(0.28).text) << "the chatter began before the window, at 714.80";
  EXPECT_FALSE(try_figure2(0.2901).text) << "the chatter began before the window";
  EXPECT_FALSE(try_figure2(0.2709).boxes) << "lowest displacement below -0.5";
  EXPECT_TRUE(try_figure5a(0.1973).boxes);
  EXPECT_FALSE(try_figure5a(0.1973).text) << "mass 2 does not hit twice while mass 1 sticks";
  EXPECT_FALSE(try_figure5b(0.2996).boxes) << "lowest displacement -0.248";
  EXPECT_TRUE(try_figure5b(0.2996).text);
  EXPECT_FALSE(try_figure5b(0.2998).text) << "at 918.94, not at about 920";
}

}  // namespace
