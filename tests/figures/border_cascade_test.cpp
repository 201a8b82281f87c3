// Beyond a border orbit impacts are added one by one: the factor of the distances derived,
// simulated for the scaled problem, and counted on orbits of the scene of Figure 2.
#include "figures/beyond/border_cascade.hpp"

#include <gtest/gtest.h>

namespace {

using namespace vibro_impact;
using namespace vibro_impact::figures;

// Impacts of a ball that starts at its stop at time 0 with this speed, pressed by the acceleration
// 1 - t, until it is let go; `many` where there is no end to them. The flight is the smaller root
// of speed - press t / 2 + t^2 / 6.
constexpr int many = 400;
int impacts_of_ball(long double speed, long double r) {
  long double time = 0.0L;
  for (int impacts = 0; impacts < many; ++impacts) {
    const long double press = 1.0L - time, under = press * press - 8.0L * speed / 3.0L;
    if (press <= 0.0L || under < 0.0L) return impacts;
    const long double flight = 4.0L * speed / (press + std::sqrt(under));
    speed = r * (flight * (press - flight / 2.0L) - speed);
    time += flight;
  }
  return many;
}

// The largest speed below `above` from which there are more than `impacts`, to the last bit.
long double speed_with_more(int impacts, long double r, long double above) {
  long double below = 0.0L;
  for (int halving = 0; halving < 80; ++halving) {
    const long double middle = 0.5L * (below + above);
    (impacts_of_ball(middle, r) > impacts ? below : above) = middle;
  }
  return below;
}

// Independent of every formula of the self-similar chatter but the equation of the flight.
TEST(BorderCascade, APressedBallAddsImpactsByTheDerivedFactor) {
  for (const double r : {0.3, 0.7, 0.9}) {
    const auto restitution = static_cast<long double>(r);
    const long double border = speed_with_more(many - 1, restitution, 1.0L);
    // At distances d the factor is that of the limit to order d, rounding 1e-19 / d.
    int compared = 0;
    long double before = speed_with_more(3, restitution, 1.0L) - border;
    for (int impacts = 4; before > 1e-10L; ++impacts) {
      const long double distance = speed_with_more(impacts, restitution, 1.0L) - border;
      if (before < 1e-8L) {
        EXPECT_NEAR(static_cast<double>(distance / before), cascade_factor(r), 1e-7) << r;
        ++compared;
      }
      before = distance;
    }
    EXPECT_GT(compared, 3) << r;
  }
}

// With q, the ratio of the pressing forces at consecutive impacts, as the parameter.
TEST(BorderCascade, TheFactorHasAClosedForm) {
  for (const double q : {0.05, 0.3, 0.8, 0.99}) {
    const double c = (1 + 2 * q) / (2 + q);
    EXPECT_NEAR(cascade_factor(q * q / c), q * c * c, 1e-13);
  }
  EXPECT_NEAR(cascade_factor(0.7), 0.70050542985638, 1e-13);
}

// Counted from 1e-9 to 1e-5: the number of impacts grows with the derived slope, to the one impact
// that a count is short of at most, at either end. Over four decades these are 26.
TEST(BorderCascade, CountsOfImpactsHaveTheDerivedSlope) {
  for (const char *name : {"border_mass_1_3", "border_mass_2_2", "border_mass_1_7"}) {
    std::optional<UnfoldedChatter> nearest, farthest;
    for (const UnfoldedChatter &at : unfolded(start_named(name), 1e-5)) {
      if (at.distance < 0.99e-9) continue;
      if (!nearest) nearest = at;
      farthest = at;
    }
    ASSERT_TRUE(nearest && farthest->distance > 0.99e-5) << name;
    const double slope = -1.0 / std::log(cascade_factor(0.7));
    const double expected = slope * std::log(farthest->distance / nearest->distance);
    EXPECT_NEAR(nearest->impacts - farthest->impacts, expected, 1.0) << name;
  }
}

// The orbit that is followed is that which the motion from rest comes to.
TEST(BorderCascade, CountsFromRestAreThoseOfTheOrbitFollowed) {
  const CurveStart start = start_named("border_mass_1_2");
  for (const UnfoldedChatter &at : unfolded(start, 1e-6)) {
    if (at.distance < 0.99e-7) continue;
    const Scene scene = paper::stops_of_different_sign(start.at.x - start.whole.x * at.distance);
    ImpactSpeedRecorder impacts{1, -1.0};
    stroboscopic_map(scene, at_quiet_phase(scene, state_after_periods(scene, 400)), 1, {}, impacts);
    EXPECT_EQ(static_cast<int>(impacts.velocities.size()), at.impacts) << at.distance;
  }
}

}  // namespace
