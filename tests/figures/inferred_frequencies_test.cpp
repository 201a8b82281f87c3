// The frequencies inferred from the paper's axis boxes and text: the rule, what it leaves and what
// it refuses. (That it holds where the frequencies are printed: figures_test.)
#include "figures/measures/inferred_frequencies.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "tests/support/events.hpp"

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

// A mass that hits its stop between two samples reaches it, although no sample is there.
TEST(AxisRule, AnImpactReachesTheStop) {
  const Scene scene = paper::figure2();
  SampleRecorder samples(716.0, 716.02, 0.015);
  EventRecorder events{samples.from, infinity};
  require_complete(simulate(scene, samples.to, samples, events));
  ASSERT_EQ(std::count_if(events.events.begin(), events.events.end(),
                          [](const Event &event) { return event.mass == 2; }),
            1);
  EXPECT_LT(range_of(samples, 2).highest, 0.1 - 1e-4);
  EXPECT_EQ(shown(scene, {2}, samples, events.events).highest, 0.1);
  EXPECT_LT(shown(scene, {2}, samples, {}).highest, 0.1 - 1e-4);
}

// The values that fit, among 6,801, stand in figures/README.md (key_numbers).
TEST(InferredFrequencies, TheRuleOfChoiceLeavesTheOneThatIsDrawn) {
  EXPECT_EQ(choice_among({0.1825, 0.1912, 0.2, 0.2088, 0.2354, 0.2531, 0.2797, 0.3499, 0.3586}),
            paper::figure2().omega);
  EXPECT_EQ(choice_among({0.1451, 0.1702, 0.1769, 0.1778, 0.1843, 0.1902, 0.2561}),
            paper::figure5a().omega);
  EXPECT_EQ(choice_among({0.2995}), paper::figure5b().omega);
  EXPECT_EQ(choice_among({0.2, 0.2561}), 0.2561) << "printed comes before few decimals";
  EXPECT_EQ(choice_among({0.2531, 0.25}), 0.25);
  EXPECT_THROW(choice_among({0.2531, 0.2088}), std::runtime_error) << "no choice is left";
  EXPECT_THROW(choice_among({}), std::runtime_error);
  EXPECT_EQ(decimals(0.2), 1);
  EXPECT_EQ(decimals(0.256), 3);
  EXPECT_EQ(decimals(0.2561), 4);
  EXPECT_EQ(decimals(3.0), 0);
}

// Each condition refuses some frequency.
TEST(InferredFrequencies, EveryConditionRefusesSome) {
  using Met = std::vector<bool>;
  EXPECT_EQ(try_figure2(0.2709).met[0], false) << "lowest displacement below -0.5";
  EXPECT_EQ(try_figure2(0.28).met[1], false) << "x2 stays above 0.013 in (b)";
  EXPECT_EQ(try_figure2(0.48).met[2], false) << "no mass sticks";
  EXPECT_EQ(try_figure2(0.2901).met[3], false) << "the chatter began before the window";
  EXPECT_EQ(try_figure5a(0.2562).met, (Met{false, true, true})) << "lowest displacement -0.077";
  EXPECT_EQ(try_figure5a(0.1973).met, (Met{true, true, false})) << "mass 2 does not hit twice";
  EXPECT_EQ(try_figure5b(0.2996).met, (Met{false, true})) << "lowest displacement -0.248";
  EXPECT_FALSE(try_figure5b(0.2998).met[1]) << "at 918.94, not at about 920";
}

// The bounces of mass 2 that Figure 2(b) can show end before its window does. The limit of the
// chatter lies beyond the window.
TEST(InferredFrequencies, ChatterIsShownByItsVisibleBounces) {
  const auto events =
      vibro_impact::testing::events_of(paper::figure2(), 690.0, 750.0, all_visible_chatter);
  const paper::AxisBox box = paper::panel("figure2b");
  const Chatter chatter = chatter_after(events, 2, box.from, invisible(box));
  EXPECT_NEAR(chatter.first_impact, 716.008, 1e-3);
  EXPECT_LT(chatter.last_bounce_ends, box.to);
  EXPECT_GT(chatter.last_bounce_ends, box.to - 0.3);
  EXPECT_GT(chatter.stick, box.to);
  EXPECT_GT(chatter_after(events, 2, box.from).last_bounce_ends, box.to);
}

}  // namespace
