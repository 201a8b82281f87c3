// Beyond a border orbit impacts are added one by one: the factor of the distances predicted,
// simulated for the scaled problem, and measured on orbits of the scene of Figure 2.
#include <gtest/gtest.h>

#include "figures/beyond/cascade_factors.hpp"
#include "figures/table_reader.hpp"

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
TEST(BorderCascade, APressedBallAddsImpactsByThePredictedFactor) {
  for (const double r : {0.3, 0.7, 0.9}) {
    const auto restitution = static_cast<long double>(r);
    const long double border = speed_with_more(many - 1, restitution, 1.0L);
    // At distances d the factor is that of the limit to order d, rounding 1e-19 / d.
    int compared = 0;
    long double before = speed_with_more(3, restitution, 1.0L) - border;
    for (int impacts = 4; before > 1e-10L; ++impacts) {
      const long double distance = speed_with_more(impacts, restitution, 1.0L) - border;
      if (before < 1e-8L) {
        EXPECT_NEAR(static_cast<double>(distance / before), predicted_cascade(r).factor, 1e-7) << r;
        ++compared;
      }
      before = distance;
    }
    EXPECT_GT(compared, 3) << r;
  }
}

// With q, the ratio of the pressing forces at consecutive impacts, as the parameter.
TEST(BorderCascade, ThePredictionHasClosedForms) {
  for (const double q : {0.05, 0.3, 0.8, 0.99}) {
    const double r = q * q * (2 + q) / (1 + 2 * q), c = (1 + 2 * q) / (2 + q);
    const CascadePrediction cascade = predicted_cascade(r);
    EXPECT_NEAR(cascade.factor, q * c * c, 1e-13);
    EXPECT_NEAR(cascade.correction, q / (c * c), 1e-13);
    // What the end of a chatter does to the next one dies out for every restitution.
    EXPECT_LT(cascade.correction, 1.0);
  }
  EXPECT_NEAR(predicted_cascade(0.7).factor, 0.70050542985638, 1e-13);
}

// The cascade of a border orbit that is in reference/located.csv.
struct MeasuredCascade {
  Unfolding of;
  std::vector<UnfoldedOrbit> orbits;
  std::vector<AddedImpact> added;
};

MeasuredCascade cascade_of(const std::string &name, double farthest) {
  for (const CurveStart &border : borders_to_unfold()) {
    if (border.name != name) continue;
    MeasuredCascade found{unfolding(name, border.mass, border.x, border.side), {}, {}};
    found.orbits = followed(found.of, farthest);
    found.added = added_impacts(found.of, found.orbits);
    return found;
  }
  throw std::runtime_error(name + ": no such border orbit");
}

double distance_of(const MeasuredCascade &cascade, int impact) {
  for (const AddedImpact &one : cascade.added)
    if (one.impact == impact) return one.distance;
  ADD_FAILURE() << "impact " << impact << " was not located";
  return std::numeric_limits<double>::quiet_NaN();
}

double ratio_at(const MeasuredCascade &cascade, int impact) {
  return distance_of(cascade, impact) / distance_of(cascade, impact - 1);
}

constexpr double four_digits = 5e-5;

void expect_predicted_factor(const MeasuredCascade &cascade) {
  static const References located = read_references(REFERENCE_DIR "/located.csv");
  EXPECT_NEAR(cascade.of.border, located.at(cascade.of.name).value, 1e-14);
  const CascadePrediction predicted = predicted_cascade(0.7);
  const auto measured = measured_factor(cascade.added, predicted);
  ASSERT_TRUE(measured.has_value());
  EXPECT_NEAR(measured->value, predicted.factor, four_digits);
  EXPECT_LT(measured->uncertainty, four_digits);
}

TEST(BorderCascade, TheFactorAt03310IsThePredictedOne) {
  const MeasuredCascade cascade = cascade_of("border_mass_1_3", 1e-5);
  expect_predicted_factor(cascade);
  // There the ratio itself has four digits, with nothing taken away.
  EXPECT_NEAR(ratio_at(cascade, 52), predicted_cascade(0.7).factor, four_digits);
}

TEST(BorderCascade, TheFactorAt04642IsReachedAsPredicted) {
  const MeasuredCascade cascade = cascade_of("border_mass_1_7", 1e-5);
  expect_predicted_factor(cascade);
  const CascadePrediction predicted = predicted_cascade(0.7);
  const auto off = [&](int impact) { return ratio_at(cascade, impact) - predicted.factor; };
  // By the correction per impact; other things die out faster and leave half a per cent.
  EXPECT_NEAR(std::pow(off(45) / off(35), 0.1), predicted.correction, 5e-3);
}

// Impacts of mass 1 in each of `periods` forcing periods from `state`, 300 periods later.
std::vector<int> counts_later(const Scene &scene, const MotionState &start, int periods) {
  MotionState state = stroboscopic_map(scene, start, 300).state;
  std::vector<int> counts;
  for (int period = 0; period < periods; ++period) {
    ImpactSpeedRecorder impacts{1, -1.0};
    state = stroboscopic_map(scene, state, 1, {}, impacts).state;
    counts.push_back(static_cast<int>(impacts.velocities.size()));
  }
  return counts;
}

TEST(BorderCascade, CountsFromRestAreThoseOfTheOrbitFollowed) {
  const MeasuredCascade cascade = cascade_of("border_mass_1_2", 2e-4);
  for (const int impacts : {21, 47}) {
    const double distance =
        std::sqrt(distance_of(cascade, impacts) * distance_of(cascade, impacts + 1));
    const Scene scene = cascade.of.scene_at(distance);
    const MotionState rest = at_quiet_phase(scene, settled(scene, 100));
    EXPECT_EQ(counts_later(scene, rest, 2), std::vector(2, impacts));
  }
  // Beside an added impact both orbits exist, up to a fold: relative to the distance so far as
  // the square of the correction says, to one per cent at these distances.
  const auto fold = [&](int impact) {
    for (std::size_t i = cascade.orbits.size(); i-- > 0;)
      if (cascade.orbits[i].impacts == impact &&
          cascade.orbits[i].distance < distance_of(cascade, impact))
        for (const AddedImpact &one : cascade.added)
          if (one.impact == impact)
            return fold_beyond(cascade.of, one, cascade.orbits[i]).value_or(-1.0);
    return -1.0;
  };
  const double predicted = std::pow(predicted_cascade(0.7).correction, 2);
  EXPECT_NEAR(std::pow(fold(36) / fold(30), 1.0 / 6), predicted, 0.01 * predicted);
}

// From the orbit just outside, the motion stays on the orbit until that grazes; inside, the period
// doubles at once, and every other chatter has the impact.
TEST(BorderCascade, AnImpactIsAddedWhereCountingSaysSo) {
  const MeasuredCascade cascade = cascade_of("border_mass_1_3", 1e-3);
  const double located = distance_of(cascade, 18);
  const auto outer =
      std::find_if(cascade.orbits.begin(), cascade.orbits.end(),
                   [&](const UnfoldedOrbit &orbit) { return orbit.distance > located; });
  ASSERT_NE(outer, cascade.orbits.end());
  const auto beside = orbit_at(cascade.of, (1.0 + 1e-8) * located, *outer);
  ASSERT_TRUE(beside.has_value());
  const auto most = [&](double distance) {
    const std::vector<int> counts =
        counts_later(cascade.of.scene_at(distance), beside->orbit.state, 2);
    return *std::max_element(counts.begin(), counts.end());
  };
  const Change change =
      bisect(most, (1.0 - 1e-8) * located, (1.0 + 1e-8) * located, 1e-11 * located);
  EXPECT_EQ(change.count_below, 18);
  EXPECT_EQ(change.count_above, 17);
  // Started 1e-8 outside, the motion leaves the orbit a tenth of that early.
  EXPECT_NEAR(change.above / located, 1.0, 5e-9);
}

}  // namespace
