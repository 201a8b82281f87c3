// Long flights in modal coordinates, where a mode decays fast, or the motion grows at resonance.
#include <gtest/gtest.h>

#include <boost/multiprecision/cpp_bin_float.hpp>

#include "reference/scenes/extreme_scenes.hpp"
#include "tests/support/long_flight_scenes.hpp"
#include "vibro_impact/vibro_impact.hpp"

namespace {

using namespace vibro_impact;
using namespace vibro_impact::testing;

// 240 dips of a hold force beside a mode that decays beta times as fast as the mass swings, and 48
// beside a stiff link. Their releases are those of the closed form.
TEST(LongFlight, PassesOverNoDipBesideAFastMode) {
  struct FastMode {
    double stiffness, beta;
  };
  unsigned seed = 0;
  for (const auto &[stiffness, beta] :
       {FastMode{1.0, 1e4}, FastMode{1.0, 1e6}, FastMode{1.0, 1e8}, FastMode{1.0, 1e10},
        FastMode{1.0, 1e12}, FastMode{1e12, 2e-7}})
    for (const double depth : {1e-5, 1e-7, 1e-9, 1e-11, 1e-12, 1e-13})
      for (int k = 0; k < 8; ++k) {
        Draw draw{std::mt19937(++seed)};
        const double amplitude = draw.uniform(0.3, 3.0), omega = draw.uniform(0.1, 1.0);
        const Scene scene = dip_beside_a_fast_mode(stiffness, beta, amplitude, omega, depth);
        const double until = 0.8 * Clock(omega).period;
        EventRecorder recorder;
        const Outcome outcome = simulate(scene, until, recorder);
        EXPECT_EQ(broken_by_a_release({scene, until, {}, recorder.events, outcome}), "")
            << "beta " << beta << " depth " << depth << " seed " << seed;
      }
}

// At resonance, damped by nothing, the motion grows by at most a t / (2 omega).
TEST(WithoutEvents, AFlightAtResonanceIsFewSteps) {
  Scene scene = extremes::one_mass(0.0, 0.5, 1.0, 0.7, 1e12);
  const Outcome outcome = simulate(scene, 1e7);
  EXPECT_EQ(outcome.ending, Ending::reached);
  EXPECT_LT(outcome.counters.expansions + outcome.counters.search_steps, 100);
}

struct FirstEvent : EventRecorder {
  bool done() const override {
    return !events.empty();
  }
};

// At resonance x = F t sin(t) / 2 from rest. The stop at 1 is hit after some 2 / F radians, beside
// which a radian is short. The speed tells the time to the rounding of sin(t), 1e-16 of a radian,
// which the reported time of 2e9 does not resolve. 1e-14 leaves room for a hundred roundings.
TEST(LongFlight, HasTheSpeedOfAnImpactAfterMillionsOfRadians) {
  using Digits = boost::multiprecision::cpp_bin_float_50;
  for (const double force : {1e-7, 1e-8, 1e-9}) {
    const Scene scene{.mass = {1},
                      .stiffness = {1},
                      .amplitude = {force},
                      .omega = 1.0,
                      .restitution = 0.5,
                      .stops = {{1, Side::upper, 1.0}}};
    FirstEvent recorder;
    require_complete(simulate(scene, 2.2 / force, recorder));
    ASSERT_FALSE(recorder.events.empty());
    Digits t = recorder.events.front().time;
    const auto speed = [&] { return force / 2 * (sin(t) + t * cos(t)); };
    for (int step = 0; step < 6; ++step) t += (1 - force / 2 * t * sin(t)) / speed();
    EXPECT_NEAR(recorder.events.front().velocity_before / static_cast<double>(speed()), 1.0, 1e-14)
        << force;
  }
}

// A mass leaves its stop at x = 1 with a gap b t^3 (1 - t / T), which is seen above 2e-26 from half
// of T on, and comes back at T, before a step of the search ends. The other mass makes steps short:
// the flight is a long one. At a stop at x = 0 no gap is small. The gap at x = 1 is known to 1e-32,
// and its speed is 1e-27.
TEST(LongFlight, SeesAGapThatOpensAndClosesWithinAStepOfTheSearch) {
  constexpr double omega = 1e-3, seen = 1e-26;
  for (double closing = 218.0; closing < 238.0; closing += 1.0)
    for (double share = 0.39; share < 0.405; share += 0.005) {
      const double cube = std::pow(share * closing, 3), b = seen / (cube * (1.0 - share)),
                   sine = 6.0 * b / omega, cosine = 24.0 * b / (closing * omega * omega);
      double times[2];
      for (const int place : {0, 1}) {
        const Scene scene{.mass = {1.0, 1.0},
                          .stiffness = {0.0, 1e-200},
                          .amplitude = {-cosine, 0.0},
                          .sine = {-sine, 0.0},
                          .constant = {cosine, 0.0},
                          .ground = {0.0, 1.0},
                          .omega = omega,
                          .restitution = 0.5,
                          .stops = {{1, Side::upper, 1.0 * place}},
                          .displacement = {1.0 * place, 0.0},
                          .velocity = {0.0, 1.0}};
        times[place] = events_of(scene, 0.0, 1.5 * closing).at(0).time;
      }
      EXPECT_NEAR(times[1], times[0], 1e-3) << closing << ' ' << share;
    }
}

}  // namespace
