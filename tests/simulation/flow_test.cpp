// Resonance, damping and tolerances of flights. modes_test and random_scenes_test
// compare the motion with 50 digits and with a witness in extended precision.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "reference/scenes/paper_scenes.hpp"
#include "tests/support/witness.hpp"
#include "vibro_impact/vibro_impact.hpp"

namespace {

using namespace vibro_impact;
using namespace vibro_impact::testing;

// From the start of a scene without stops to the end, in one flight: within this share of the
// motion, in the energy norm.
void expect_that_a_witness_agrees(const Scene &scene, double until, double share) {
  SCOPED_TRACE(::testing::Message() << "beta " << scene.beta << ", omega " << scene.omega);
  Witness witness(scene);
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

double largest_difference(const std::vector<double> &a, const std::vector<double> &b) {
  double largest = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) largest = std::max(largest, std::abs(a[i] - b[i]));
  return largest;
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

}  // namespace
