// The numbers behind Figure 5: what the paper's text says of its panels, and what their axes show.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "figures/beyond/reconstruction.hpp"
#include "paper_runs.hpp"

namespace {

using namespace vibro_impact;
using namespace vibro_impact::testing;

TEST(Figure5a, MassTwoHitsTwiceWhileMassOneSticks) {
  const Scene scene = paper::figure5a();
  // From period to period the distance from the periodic motion falls by 5.7: below 1e-11 after 15.
  const double period = Clock(scene.omega).period, settled = 15 * period;
  const double until = paper::figure5a_box.to;
  const auto events = events_of(scene, settled, until + period);
  const auto sticks = select(events, EventKind::stick, 1, settled, until);
  const auto releases = select(events, EventKind::release, 1, sticks.at(0).time);
  ASSERT_EQ(sticks.size(), 12u) << "one stick a period, in periods 15 to 26";
  ASSERT_GE(releases.size(), sticks.size());
  for (std::size_t i = 0; i < sticks.size(); ++i) {
    if (i > 0) {
      EXPECT_NEAR(sticks[i].time - sticks[i - 1].time, period, same_time);
    }
    EXPECT_EQ(select(events, EventKind::impact, 2, sticks[i].time, releases[i].time).size(), 2u)
        << "from t = " << sticks[i].time << " to " << releases[i].time;
  }
  EXPECT_TRUE(select(events, EventKind::stick, 2).empty());
  const auto shown = select(events, EventKind::stick, 1, paper::figure5a_box.from, until);
  ASSERT_EQ(shown.size(), 1u);
  EXPECT_NEAR(shown[0].time, 958.68221432487518902, same_time);  // computed
}

TEST(Figure5b, MassTwoAllButReachesItsStopWhileMassOneSticks) {
  const paper::AxisBox &box = paper::figure5b_box;
  const Scene scene = paper::figure5b();
  figures::HighestWhileHeld highest{box.from, box.to, 1e-4};
  EventRecorder shown{box.from};
  require_complete(simulate(scene, box.to, {}, highest, shown));
  EXPECT_NEAR(highest.time, 920.0, 0.5);  // printed: t of about 920
  // Computed. Samples lie 1e-4 apart, where |x''| < 0.2: off by 2.5e-10 at most.
  EXPECT_NEAR(highest.time, 919.95120552526468838, 5.1e-5);
  EXPECT_NEAR(scene.stops[1].position - highest.place, 7.5381700700966828334e-05, 2.6e-10);
  EXPECT_TRUE(select(shown.events, EventKind::impact, 2).empty());
  const auto sticks = select(shown.events, EventKind::stick, 1);
  ASSERT_EQ(sticks.size(), 1u);
  EXPECT_NEAR(sticks[0].time, 919.52559642580975186, same_time);  // computed
  EXPECT_LT(sticks[0].time, highest.time);
  const auto releases = select(shown.events, EventKind::release, 1);
  ASSERT_EQ(releases.size(), 1u);
  EXPECT_GT(releases[0].time, highest.time);
  // A very short chatter: with r = 0.001 each speed is a thousandth of the one before it.
  EXPECT_LE(select(shown.events, EventKind::impact, 1, 0.0, sticks[0].time).size(), 4u);
  // s1 < s2: while mass 1 is held the static force on mass 2 points away from its stop, so that the
  // two cannot stick together, neither here nor in the whole run.
  for (const Event &event : events_of(scene, 0.0, box.to))
    EXPECT_NE(contact_mode_name(event.held), "1+2") << event.time;
}

// The next frequency of four digits lies above the grazing (0.29952): mass 2 reaches its stop.
TEST(Figure5b, AboveTheGrazingMassTwoReachesItsStop) {
  const paper::AxisBox &box = paper::figure5b_box;
  Scene scene = paper::figure5b();
  scene.omega = 0.2996;
  const auto touches = select(events_of(scene, box.from, box.to), EventKind::impact, 2);
  ASSERT_EQ(touches.size(), 1u);
  // Computed, when this was the scene of the figure.
  EXPECT_NEAR(touches[0].time, 919.59421797950667662, same_time);
  EXPECT_NEAR(touches[0].velocity_before, 0.01104678322719986233, same_time);
  EXPECT_EQ(contact_mode_name(touches[0].held), "1");
}

TEST(Figure5c, MassTwoGoesOnBouncingAtAConstantInterval) {
  const paper::AxisBox &box = paper::figure5c_box;
  const auto events = events_of(paper::figure5c(), 0.0, box.to);
  EXPECT_TRUE(select(events, EventKind::stick, 2).empty()) << "no stick is invented";
  const auto releases = select(events, EventKind::release, 1, box.from, box.to);
  ASSERT_EQ(releases.size(), 1u);
  EXPECT_NEAR(releases[0].time, 988.84255668919496048, same_time);  // computed; seen at about 989
  const auto sticks = select(events, EventKind::stick, 1, 0.0, releases[0].time);
  ASSERT_FALSE(sticks.empty());
  const auto bounces = select(events, EventKind::impact, 2, sticks.back().time, releases[0].time);
  ASSERT_GE(bounces.size(), 25u);
  // Derived: half a period of the damped mass on its own spring, zeta = 0.05, and the decay over
  // it. Times near 1000 are rounded to 1e-13; 1e-9 in the interval leaves no room for a drift.
  const double zeta = 0.05, root = std::sqrt(1.0 - zeta * zeta);
  const double interval = std::numbers::pi / root, ratio = 0.7 * std::exp(-zeta * interval);
  for (std::size_t i = 1; i < bounces.size(); ++i) {
    EXPECT_NEAR(bounces[i].time - bounces[i - 1].time, interval, 1e-9) << i;
    EXPECT_NEAR(bounces[i].velocity_before / bounces[i - 1].velocity_before, ratio, 1e-9) << i;
  }
  // Computed: still moving at the end of the sticking phase.
  EXPECT_NEAR(bounces.back().velocity_before / 3.8533250460927914888e-09, 1.0, 1e-9);
}

// Every axis ends at the first tick beyond the data.
TEST(Figure5, CurvesFillTheAxisBoxes) {
  for (const auto &[scene, box] : {std::pair{paper::figure5a(), paper::figure5a_box},
                                   {paper::figure5b(), paper::figure5b_box},
                                   {paper::figure5c(), paper::figure5c_box}}) {
    const figures::Range shown = figures::range_of(sampled(scene, box));
    EXPECT_TRUE(figures::fills(shown, figures::ordinate(box), box.tick))
        << shown.lowest << " to " << shown.highest;
  }
}

}  // namespace
