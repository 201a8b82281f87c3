// Long flights in modal coordinates, where a mode decays fast, or the motion grows at resonance.
#include <gtest/gtest.h>

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

}  // namespace
