// Long phases, resonance, tolerances and energy of flights. modes_test and random_scenes_test
// compare the motion with 50 digits and with a witness in extended precision.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "reference/scenes/paper_scenes.hpp"
#include "tests/support/random_scenes.hpp"
#include "tests/support/witness.hpp"
#include "vibro_impact/vibro_impact.hpp"

namespace {

using namespace vibro_impact;
using vibro_impact::testing::energy_of;

// From the start of a scene without stops to the end, in one flight: within this share of the
// motion, in the energy norm.
void expect_that_a_witness_agrees(const Scene &scene, double until, double share) {
  SCOPED_TRACE(::testing::Message() << "beta " << scene.beta << ", omega " << scene.omega);
  vibro_impact::testing::Witness witness(scene);
  witness.close(simulate(scene, until).state);
  EXPECT_LE(witness.apart(), share * witness.size());
}

// Through critical damping, up to modes split in two decays; unforced, at and near resonance, and
// under a constant force. Sixteen steps take the shorter time at most, and the longer one is a
// flight in closed form. 1e-13: some hundred roundings.
TEST(Flow, OfOneMassAgreesWithAWitness) {
  const double lambda = 1.7, critical = 2.0 / std::sqrt(lambda);
  Scene scene;
  scene.mass = {1.0};
  scene.stiffness = {lambda};
  scene.displacement = {0.3};
  scene.velocity = {-0.8};
  for (const double ratio : {0.0, 1e-8, 1e-4, 0.05, 0.9, 1.0 - 1e-9, 1.0 - 1e-12, 1.0, 1.0 + 1e-12,
                             1.0 + 1e-9, 1.1, 3.0, 8.0}) {
    scene.beta = ratio * critical;
    for (const double until : {9.0, 50.0}) {
      scene.amplitude = {0.0};
      expect_that_a_witness_agrees(scene, until, 1e-13);
      scene.amplitude = {0.6};
      for (const double omega : {0.0, std::sqrt(lambda), std::sqrt(lambda) * (1.0 + 1e-9), 1.29}) {
        scene.omega = omega;
        expect_that_a_witness_agrees(scene, until, 1e-13);
      }
    }
  }
}

// In double precision the phase sqrt(2) 1e15 is known to 0.16. A run so long is refused without
// damping, and a damping that takes 1e-15 of the amplitude makes the phase no better. The cosine of
// this phase was computed with 40 digits. 1e-4: what the bound of the phase, 1e12, leaves.
TEST(Flow, OfAHardlyDampedMassIsRightOrRefused) {
  Scene scene;
  scene.mass = {1.0};
  scene.stiffness = {2.0};
  scene.displacement = {1.0};
  for (const double beta : {0.0, 1e-30, 1e-18}) {
    scene.beta = beta;
    try {
      EXPECT_NEAR(simulate(scene, 1e15).state.displacement[0],
                  -0.99403738326598532 * std::exp(-1e15 * beta), 1e-4);
    } catch (const std::invalid_argument &refused) {
      EXPECT_NE(std::string(refused.what()).find("1e+12"), std::string::npos) << refused.what();
    }
  }
}

double largest_difference(const std::vector<double> &a, const std::vector<double> &b) {
  double largest = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) largest = std::max(largest, std::abs(a[i] - b[i]));
  return largest;
}

// A mode next to resonance, hardly damped, swings up to twice its steady response before it
// settles. A stop beyond the steady response can therefore be hit.
TEST(Flow, AStopBeyondTheSteadyResponseOfAModeNearResonanceIsHit) {
  Scene scene;
  scene.mass = scene.stiffness = {1.0};
  scene.beta = 1e-5;
  scene.amplitude = {0.01};
  scene.omega = std::sqrt(1.0 / 1.025);
  const double steady = 0.01 / (1.0 - 1.0 / 1.025);
  scene.stops = {{1, Side::upper, 1.6 * steady}};
  EXPECT_GT(simulate(scene, 600.0).counters.impacts, 0);
  scene.stops = {{1, Side::upper, 2.2 * steady}};
  const Counters far = simulate(scene, 1e5).counters;
  EXPECT_EQ(far.impacts, 0);
  EXPECT_LT(far.expansions, 100);  // out of reach for ever
}

// 0.3 is not 3 times 0.1 in double precision: the end of a range is in it to within rounding.
TEST(Samples, TakeTheEndOfTheirRange) {
  for (int n = 1; n <= 1000; ++n) {
    const double to = 0.1 * n;
    for (const double end : {to, std::nextafter(to, 0.0)})
      EXPECT_LE(sample_time(0.0, end, 0.1, static_cast<std::size_t>(n)), end) << n;
    EXPECT_GT(sample_time(0.0, to, 0.1, static_cast<std::size_t>(n) + 1), 1e9) << n;
  }
}

// The tolerance of the flights buys lower orders, and bounds what they cost: relative to the
// second-order term of each expansion, of which the run has some forty.
TEST(Flow, AnErrorAllowedLowersTheOrders) {
  const Outcome exact = simulate(paper::figure2(), 24.0);
  long long coefficients = exact.counters.coefficients;
  for (const double tolerance : {1e-14, 1e-12, 1e-10, 1e-8, 1e-6, 1e-4}) {
    const Outcome outcome = simulate(paper::figure2(), 24.0, {.flight_tolerance = tolerance});
    EXPECT_LT(largest_difference(exact.state.displacement, outcome.state.displacement),
              10.0 * tolerance);
    EXPECT_LT(largest_difference(exact.state.velocity, outcome.state.velocity), 10.0 * tolerance);
    EXPECT_LE(outcome.counters.coefficients, coefficients) << tolerance;
    coefficients = outcome.counters.coefficients;
  }
  EXPECT_LT(1.8 * static_cast<double>(coefficients),
            static_cast<double>(exact.counters.coefficients));
}

// x = cos t of one mass, by the highest order of a step. Some seven steps round it by 2^-53 each.
TEST(Flow, OfTheLeastToleranceIsTheClosedForm) {
  const Scene scene{.mass = {1.0}, .stiffness = {1.0}, .displacement = {1.0}};
  const Outcome outcome = simulate(scene, 13.0, {.flight_tolerance = 1e-21});
  EXPECT_NEAR(outcome.state.displacement[0], std::cos(13.0), 1e-15);
  EXPECT_EQ(outcome.counters.coefficients, 28 * outcome.counters.expansions) << "order 27";
}

// A chain of n masses that are hit from both sides, without damping and forcing.
Scene elastic_chain(int n) {
  Scene scene{.omega = 0.0, .restitution = 1.0};
  for (int i = 1; i <= n; ++i) {
    scene.mass.push_back(1.0 + 0.37 * (i % 3));
    scene.stiffness.push_back(0.8 + 0.53 * (i * 2 % 5));
    scene.displacement.push_back(0.0);
    scene.velocity.push_back(i % 2 == 0 ? -0.43 : 0.71);
    scene.stops.push_back({i, Side::lower, -0.31});
    scene.stops.push_back({i, Side::upper, 0.23});
  }
  return scene;
}

// Asks for the end at a million impacts.
struct AMillionImpacts : Recorder {
  long long impacts = 0;
  void event(const Event &, const Moment &) override {
    ++impacts;
  }
  bool done() const override {
    return impacts == 1'000'000;
  }
};

// A step rounds the energy by at most some 2^-53 of it. Roundings of either sign add up to the root
// of the number of steps, of which eight times as much is allowed. A rounding that is the same at
// every impact adds up to a million times itself.
TEST(Flow, KeepsTheEnergyOfAMillionElasticImpacts) {
  for (const int masses : {1, 2, 3, 10}) {
    const Scene scene = elastic_chain(masses);
    AMillionImpacts impacts;
    const Outcome end = simulate(scene, 1e9, {.max_steps = 100'000'000}, impacts);
    ASSERT_EQ(end.ending, Ending::stopped);
    const double before = energy_of(scene, start_of(scene)),
                 steps = static_cast<double>(end.counters.expansions);
    EXPECT_LE(std::abs(energy_of(scene, end.state) / before - 1.0),
              8.0 * 0x1p-53 * std::sqrt(steps))
        << masses << " masses, " << steps << " steps";
  }
}

}  // namespace
