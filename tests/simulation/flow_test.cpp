// The exact flow in closed form, against a witness in extended precision. (By Taylor expansions,
// and in hundreds of steps: random_scenes_test.)
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "reference/paper_scenes.hpp"
#include "vibro_impact/analysis/analysis.hpp"
#include "vibro_impact/vibro_impact.hpp"
#include "witness.hpp"

namespace {

using namespace vibro_impact;

// From the start of a scene without stops to the end, in one flight: within this share of the
// motion, in the energy norm.
void expect_that_a_witness_agrees(const Scene &scene, double until, double share) {
  SCOPED_TRACE(::testing::Message() << "beta " << scene.beta << ", omega " << scene.omega);
  vibro_impact::testing::Witness witness(scene);
  witness.close(simulate(scene, until).state);
  EXPECT_LE(witness.apart(), share * witness.size());
}

// Through critical damping, up to modes split in two decays; unforced, at and near resonance, and
// under a constant force. 1e-13: some hundred roundings.
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
    scene.amplitude = {0.0};
    expect_that_a_witness_agrees(scene, 4.0, 1e-13);
    scene.amplitude = {0.6};
    for (const double omega : {0.0, std::sqrt(lambda), std::sqrt(lambda) * (1.0 + 1e-9), 1.29}) {
      scene.omega = omega;
      expect_that_a_witness_agrees(scene, 9.0, 1e-13);
    }
  }
}

// Three masses; `first_link` = 0: a free chain.
Scene chain(double beta, double omega, double first_link = 1.0) {
  Scene scene;
  scene.mass = {1.0, 0.5, 2.0};
  scene.stiffness = {first_link, 3.0, 0.7};
  scene.beta = beta;
  scene.amplitude = {0.5, 0.0, -0.2};
  scene.omega = omega;
  scene.displacement = {0.1, -0.2, 0.3};
  scene.velocity = {-0.4, 0.2, 0.1};
  return scene;
}

// Damping ratios up to 40.
TEST(Flow, OfAChainTiedOrFreeAgreesWithAWitness) {
  const double slowest = std::sqrt(natural_modes(chain(0.0, 0.7), Held{0, 0, 0}).lambda[0]);
  for (const double first_link : {1.0, 0.0})
    for (const double beta : {0.0, 0.1, 1.0, 5.0, 30.0})
      for (const double omega : {0.0, 1e-9, 0.7, slowest, 6.0})
        expect_that_a_witness_agrees(chain(beta, omega, first_link), 10.0, 1e-13);
}

double largest_difference(const std::vector<double> &a, const std::vector<double> &b) {
  double largest = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) largest = std::max(largest, std::abs(a[i] - b[i]));
  return largest;
}

// The same motion with an upper stop on mass 2 that it all but reaches until then. No bound of the
// amplitudes keeps it clear of that stop for ever, so that the run goes by Taylor expansions.
Scene all_but_stopped(Scene scene, double until) {
  SampleRecorder samples{.from = 0.0, .to = until, .every = 1e-3};
  require_complete(simulate(scene, until, {}, samples));
  double highest = samples.displacements[1];
  for (std::size_t k = 1; k < samples.displacements.size(); k += scene.mass.size())
    highest = std::max(highest, samples.displacements[k]);
  // A maximum between two samples is missed by |x''| / 8 * 1e-6 < 1e-6.
  scene.stops = {{2, Side::upper, highest + 1e-6}};
  return scene;
}

// The centre of mass of a forced free chain, in two thousand periods of one step each: f (1 - cos
// (Omega t)) / Omega^2 beside the drift. (Summed up flight by flight it was 3.5e-5 off.)
TEST(Flow, TheCentreOfMassOfAFreeChainIsExactForever) {
  Scene scene = paper::figure2();
  scene.stiffness = {0.0, 0.35};
  scene.amplitude = {0.5, 0.0};
  scene.omega = 0.05;
  scene.stops = {{1, Side::upper, 1e4}};
  SampleRecorder samples{.from = 0.0, .to = 125300.0, .every = 313.25};
  require_complete(simulate(scene, 125300.0, {}, samples));
  ASSERT_EQ(samples.times.size(), 401u);
  for (std::size_t k = 0; k < samples.times.size(); ++k) {
    const double x = (samples.displacements[2 * k] + samples.displacements[2 * k + 1]) / 2;
    const double exact = 100.0 * (1.0 - std::cos(0.05 * samples.times[k]));
    EXPECT_NEAR(x, exact, 1e-9) << samples.times[k];
  }
}

// A mode next to resonance, hardly damped, swings up to twice its steady response before it settles
// to that: what stands farther than the steady response alone is not clear for ever.
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
  EXPECT_LT(far.expansions, 100);  // that is clear for ever
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
// second-order term of each expansion, of which the runs have some ten, and forty. The short
// flights of a chatter have few terms to lose.
TEST(Flow, AnErrorAllowedLowersTheOrders) {
  const Scene free = all_but_stopped(chain(0.1, 0.7), 10.0), impacting = paper::figure2();
  for (const auto &[scene, until] : {std::pair{free, 10.0}, {impacting, 24.0}}) {
    const Outcome exact = simulate(scene, until);
    long long coefficients = exact.counters.coefficients;
    for (const double tolerance : {1e-14, 1e-12, 1e-10, 1e-8, 1e-6, 1e-4}) {
      const Outcome outcome = simulate(scene, until, {.flight_tolerance = tolerance});
      EXPECT_LT(largest_difference(exact.state.displacement, outcome.state.displacement),
                10.0 * tolerance);
      EXPECT_LT(largest_difference(exact.state.velocity, outcome.state.velocity), 10.0 * tolerance);
      EXPECT_LE(outcome.counters.coefficients, coefficients) << tolerance;
      coefficients = outcome.counters.coefficients;
    }
    EXPECT_LT(1.8 * static_cast<double>(coefficients),
              static_cast<double>(exact.counters.coefficients));
  }
}

}  // namespace
