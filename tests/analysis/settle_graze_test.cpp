// Motions that settle next to a grazing. Their sections repeat within the tolerance long before
// what is still to come brings an impact.
#include <gtest/gtest.h>

#include <complex>
#include <vector>

#include "reference/scenes/extreme_scenes.hpp"
#include "reference/scenes/paper_scenes.hpp"
#include "tests/support/events.hpp"
#include "vibro_impact/analysis/analysis.hpp"
#include "vibro_impact/vibro_impact.hpp"

namespace {

using namespace vibro_impact;

// One mass whose steady free motion, of amplitude |H(Omega)|, turns the part `depth` of it beyond
// its stop, or before the stop where `depth` is negative.
Scene next_to_a_graze(double omega, double restitution, double depth) {
  const double beta = 2.5,
               steady = 1.0 / std::abs(std::complex<double>(1.0 - omega * omega, beta * omega));
  return extremes::one_mass(beta, 1.0, omega, restitution, steady * (1.0 - depth));
}

// The settled motion. If a period was found, its events are those of one period far out.
SettledMotion settled_with_events_far_out(const Scene &scene) {
  SettledMotion motion = settle(scene, start_of(scene));
  if (motion.period == 0) return motion;
  const MotionState far_out = state_after_periods(scene, 1000);
  EventRecorder recorder(-infinity);
  stroboscopic_map(scene, far_out, motion.period, {}, recorder);
  const EventCounts expected = counts_of(scene, recorder.events, motion.period, far_out.held);
  EXPECT_EQ(motion.counts.impacts, expected.impacts);
  EXPECT_EQ(motion.counts.sticks, expected.sticks);
  return motion;
}

// The steady motion before a stop is found, unless the gap is so small that rounding may bring an
// impact. A motion with impacts has one after several periods. It is found where that was measured.
TEST(SettleNextToAGraze, AMassThatComesNearItsSteadyMotion) {
  for (const double omega : {1.3, 2.0, 2.2013570520538277, 3.1})
    for (const double restitution : {0.0, 0.5, 0.8, 0.95})
      for (const double depth : {1e-12, 1e-11, 1e-10, 5.8e-10, 1e-9, 1e-8, -1e-12, -1e-11, -1e-10,
                                 -5.8e-10, -1e-9, -1e-8}) {
        SCOPED_TRACE(::testing::Message() << omega << " " << restitution << " " << depth);
        const SettledMotion motion =
            settled_with_events_far_out(next_to_a_graze(omega, restitution, depth));
        EXPECT_TRUE(motion.period == 1 || depth > -1e-11);
        EXPECT_TRUE(motion.period >= 4 || depth < 1e-11 || omega > 1.3);
        EXPECT_TRUE(std::max(motion.period, motion.approached) == 1 || depth > 0.0);
      }
}

// A chain with other impacts and sticks. Mass 1 has a second stop next to the largest displacement
// of its settled motion.
TEST(SettleNextToAGraze, AChainWithOtherImpacts) {
  int found = 0;
  for (const double omega : {0.28, 0.3, 0.45, 0.55, 0.58, 0.61}) {
    Scene scene = paper::figure3(omega);
    const MotionState start = settle(scene, start_of(scene)).state;
    const double far_stop = 2.0;
    const double largest =
        far_stop - least_gap(scene, start, {1, Side::upper, far_stop}).value().value;
    scene.displacement = start.displacement;
    scene.velocity = start.velocity;
    for (const double depth : {1e-11, 1e-9, 1e-7, -1e-11, -1e-9, -1e-7}) {
      SCOPED_TRACE(::testing::Message() << omega << " " << depth);
      scene.stops.resize(2);
      scene.stops.push_back({1, Side::upper, largest * (1.0 - depth)});
      if (settled_with_events_far_out(scene).period > 0) ++found;
    }
  }
  EXPECT_GE(found, 18);
}

// An impact just after the section comes before it when its stop is nearer.
TEST(SettleNextToAGraze, AnImpactMayLieAtTheSection) {
  vibro_impact::testing::AtEvents impact([](const Event &event, const Moment &) {
    return event.time >= 200.0 && event.kind == EventKind::impact;
  });
  const Scene scene = next_to_a_graze(2.0, 0.8, 0.5);
  const MotionState begin = simulate(scene, 300.0, impact).state;
  for (const double earlier : {0.0, 1e-14, 1e-13, 1e-12, 1e-11}) {
    MotionState start = begin;
    start.instant.phase -= earlier;
    const SettledMotion motion = settle(scene, start);
    EXPECT_EQ(motion.period, 1) << earlier;
    EXPECT_EQ(motion.counts.impacts, std::vector{1}) << earlier;
  }
}

}  // namespace
