// The exact flow: closed form and Taylor expansion, against an independent integration and
// against each other.
#include <gtest/gtest.h>

#include <array>
#include <boost/numeric/odeint.hpp>

#include "reference/scenes/paper_scenes.hpp"
#include "simulation/chain/oscillator.hpp"
#include "vibro_impact/analysis/analysis.hpp"
#include "vibro_impact/vibro_impact.hpp"

namespace {

using namespace vibro_impact;
using Pair = std::array<double, 2>;

Pair integrate(double kappa, double lambda, double force, double omega, Pair y, double until) {
  namespace odeint = boost::numeric::odeint;
  odeint::bulirsch_stoer<Pair> stepper(1e-14, 1e-14);
  const auto equation = [=](const Pair &p, Pair &rate, double t) {
    rate = {p[1], force * std::cos(omega * t) - kappa * p[1] - lambda * p[0]};
  };
  odeint::integrate_adaptive(stepper, equation, y, 0.0, until, 1e-3);
  return y;
}

// 1e-12: the tolerance of the integration, 1e-14 per step, over some hundred steps.
TEST(Flow, FreeResponseAgreesWithAnIntegrationForEveryDamping) {
  const double lambda = 1.7, critical = 2.0 * std::sqrt(lambda);
  for (double ratio : {0.0, 1e-8, 0.05, 0.9, 1.0 - 1e-9, 1.0, 1.0 + 1e-9, 1.1, 3.0, 8.0}) {
    const auto y = free_response(ratio * critical, lambda, OscillatorState<double>{0.3, -0.8}, 4.0);
    const Pair expected = integrate(ratio * critical, lambda, 0.0, 0.0, {0.3, -0.8}, 4.0);
    EXPECT_NEAR(y.value, expected[0], 1e-12) << ratio;
    EXPECT_NEAR(y.slope, expected[1], 1e-12) << ratio;
  }
}

TEST(Flow, PassesSmoothlyThroughCriticalDamping) {
  const double lambda = 1.7, critical = 2.0 * std::sqrt(lambda);
  const auto at = [&](double ratio) {
    return free_response(ratio * critical, lambda, OscillatorState<double>{0.3, -0.8}, 2.0).value;
  };
  // The derivative by the damping ratio is of order one: half of its change over 2e-8, to 1e-15.
  EXPECT_NEAR(at(1.0), 0.5 * (at(1.0 - 1e-8) + at(1.0 + 1e-8)), 4e-16);
}

// From rest under force cos(omega t), after t.
OscillatorState<double> forced(double kappa, double lambda, double force, double omega, double t) {
  return forced_from_rest(kappa, lambda, force, std::polar(force, omega * t), omega, t);
}

TEST(Flow, ResponseAtAndNearResonance) {
  const double lambda = 1.7;
  for (double kappa : {0.0, 1e-4, 1e-2})
    for (double omega : {std::sqrt(lambda), std::sqrt(lambda) * (1 + 1e-9), 1.29}) {
      const auto y = forced(kappa, lambda, 0.6, omega, 9.0);
      const Pair expected = integrate(kappa, lambda, 0.6, omega, {0.0, 0.0}, 9.0);
      EXPECT_NEAR(y.value, expected[0], 1e-11) << kappa << " " << omega;
      EXPECT_NEAR(y.slope, expected[1], 1e-11) << kappa << " " << omega;
    }
}

// When what was there at the start has died out, the steady response is left.
TEST(Flow, ResponseInResonanceLongAfterTheStart) {
  const double lambda = 1.7, kappa = 1e-2, omega = std::sqrt(lambda), force = 0.6;
  for (double t : {1e4, 1e5, 1e6}) {
    const auto y = forced(kappa, lambda, force, omega, t);
    // The angle is rounded to 1e-16 of itself.
    const double size = force / (kappa * omega), rounding = size * (1e-13 + 2e-16 * omega * t);
    EXPECT_NEAR(y.value, size * std::sin(omega * t), rounding) << t;
    EXPECT_NEAR(y.slope, size * omega * std::cos(omega * t), omega * rounding) << t;
  }
}

// The rigid-body mode of a free chain, which has no steady response.
TEST(Flow, ResponseOfAFreeMass) {
  for (double omega : {0.0, 1e-9, 0.1, 1.0, 7.0}) {
    const auto y = forced(0.0, 0.0, 0.6, omega, 9.0);
    const Pair expected = integrate(0.0, 0.0, 0.6, omega, {0.0, 0.0}, 9.0);
    EXPECT_NEAR(y.value, expected[0], 1e-11) << omega;
    EXPECT_NEAR(y.slope, expected[1], 1e-11) << omega;
  }
}

Scene chain(double beta, double omega) {
  Scene scene;
  scene.mass = {1.0, 0.5, 2.0};
  scene.stiffness = {1.0, 3.0, 0.7};
  scene.beta = beta;
  scene.amplitude = {0.5, 0.0, -0.2};
  scene.omega = omega;
  scene.displacement = {0.1, -0.2, 0.3};
  scene.velocity = {-0.4, 0.2, 0.1};
  return scene;
}

// Damping ratios up to 40: split modes. `first_link` = 0: a free chain.
void expect_that_an_integration_agrees(double first_link) {
  namespace odeint = boost::numeric::odeint;
  const std::vector<double> lambda = natural_modes(chain(0.0, 0.7), Held{0, 0, 0}).lambda;
  for (double beta : {0.0, 0.1, 1.0, 5.0, 30.0})
    for (double omega : {0.0, 0.7, std::sqrt(lambda[0]), 6.0}) {
      Scene scene = chain(beta, omega);
      scene.stiffness[0] = first_link;
      const Outcome outcome = simulate(scene, 10.0);
      std::array<double, 6> y{0.1, -0.2, 0.3, -0.4, 0.2, 0.1};
      const auto equation = [&](const auto &s, auto &rate, double t) {
        std::array<double, 4> tension{};  // of the links; none beyond the last mass
        for (std::size_t i = 0; i < 3; ++i)
          tension[i] = scene.stiffness[i] *
                       (s[i] - (i ? s[i - 1] : 0.0) + beta * (s[3 + i] - (i ? s[2 + i] : 0.0)));
        for (std::size_t i = 0; i < 3; ++i) {
          rate[i] = s[3 + i];
          rate[3 + i] = (tension[i + 1] - tension[i] + scene.amplitude[i] * std::cos(omega * t)) /
                        scene.mass[i];
        }
      };
      odeint::bulirsch_stoer<std::array<double, 6>> stepper(1e-14, 1e-14);
      odeint::integrate_adaptive(stepper, equation, y, 0.0, 10.0, 1e-3);
      for (std::size_t i = 0; i < 3; ++i) {
        // 2e-11: 1e-14 per step, up to a thousand steps where the damping makes it stiff.
        EXPECT_NEAR(outcome.state.displacement[i], y[i], 2e-11) << beta << " " << omega;
        EXPECT_NEAR(outcome.state.velocity[i], y[3 + i], 2e-11) << beta << " " << omega;
      }
    }
}

TEST(Flow, ForcedChainAgreesWithAnIntegration) {
  expect_that_an_integration_agrees(1.0);
}

TEST(Flow, FreeForcedChainAgreesWithAnIntegration) {
  expect_that_an_integration_agrees(0.0);
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

// 1e-13: fifty rounding errors of numbers of order one over some ten expansions.
TEST(Flow, TaylorExpansionsAgreeWithTheClosedForm) {
  for (double beta : {0.0, 0.1, 1.0, 30.0}) {
    const Scene scene = chain(beta, 0.7);
    const Outcome closed = simulate(scene, 10.0);
    const Outcome taylor = simulate(all_but_stopped(scene, 10.0), 10.0);
    EXPECT_EQ(taylor.counters.impacts, 0);
    EXPECT_GT(taylor.counters.expansions, 3);
    EXPECT_EQ(closed.counters.expansions, 0);
    EXPECT_LT(largest_difference(closed.state.displacement, taylor.state.displacement), 1e-13);
    EXPECT_LT(largest_difference(closed.state.velocity, taylor.state.velocity), 1e-13);
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
      RunOptions options;
      options.flight_tolerance = tolerance;
      const Outcome outcome = simulate(scene, until, options);
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

TEST(Flow, TolerancesOutOfRangeAreRefused) {
  for (const double tolerance : {0.0, -1e-9, 1.0, std::nan("")}) {
    RunOptions options;
    options.flight_tolerance = tolerance;
    EXPECT_THROW(simulate(paper::figure2(), 1.0, options), std::invalid_argument);
    options = {};
    options.chatter_tolerance = tolerance;
    EXPECT_THROW(simulate(paper::figure2(), 1.0, options), std::invalid_argument);
  }
}

TEST(Flow, FreeFlightIsReversible) {
  Scene scene = chain(0.0, 0.7);
  scene.amplitude.clear();
  scene = all_but_stopped(scene, 20.0);
  const Outcome there = simulate(scene, 20.0);
  EXPECT_GT(there.counters.expansions, 10);
  for (std::size_t i = 0; i < 3; ++i) {
    scene.displacement[i] = there.state.displacement[i];
    scene.velocity[i] = -there.state.velocity[i];
  }
  const Outcome back = simulate(scene, 20.0);
  const Scene start = chain(0.0, 0.7);
  for (std::size_t i = 0; i < 3; ++i)  // rounding of two runs of 20 units of time each
    EXPECT_NEAR(back.state.displacement[i], start.displacement[i], 1e-13);
}

// The phase does not drift: after a million periods the undisturbed steady motion is where it was.
TEST(Instant, AMillionPeriodsDoNotShiftThePhase) {
  const Clock clock(0.28);
  Instant instant{};
  const double step = clock.period / 7.0;
  for (int i = 0; i < 700000; ++i) instant = later(instant, step, clock);
  // 700,000 additions of a rounded step: the error of the step itself dominates, 1e5 periods times
  // 7 half units in its last place.
  EXPECT_NEAR(time_of(instant, clock), 1e5 * clock.period, 7e5 * 4.5e-16 + 1e-8);
  const Instant far = instant_at(1e6 * clock.period, clock);
  EXPECT_LE(std::min(far.phase, clock.period - far.phase), 1e6 * clock.period * 2.3e-16);
}

}  // namespace
