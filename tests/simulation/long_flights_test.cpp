// Long flights in modal coordinates, where parts of a coordinate cancel, a mode decays fast, or the
// motion grows at resonance. The times have twenty digits from an integration of its own.
#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "reference/scenes/extreme_scenes.hpp"
#include "tests/support/events.hpp"
#include "tests/support/long_flight_scenes.hpp"
#include "vibro_impact/vibro_impact.hpp"

namespace {

using namespace vibro_impact;
using namespace vibro_impact::testing;

// Identical oscillators on links so weak that a mass moves by 1e-15 of the one before it and less.
// Their coordinates cancel there. 1e-9 of the time: the gap rounds to 1e-16 of the modes.
TEST(LongFlight, PassesOverNoImpactBehindAWeakLink) {
  struct Links {
    std::vector<double> stiffness;
    double beta, omega, until, impact;
  };
  for (const auto &[stiffness, beta, omega, until, impact] :
       {Links{{0.0, 1e-15}, 1.0, 0.002, 1500.0, 786.39817006411817627},
        Links{{0.0, 1e-16}, 1.0, 0.002, 1500.0, 786.39817006411817627},
        Links{{0.0, 1e-20}, 1.0, 0.002, 1500.0, 786.39817006411817627},
        Links{{0.0, 1e-8, 1e-8}, 2.0, 0.0005, 6000.0, 3143.5926544231258268}}) {
    Scene scene = extremes::chain(static_cast<int>(stiffness.size()), beta);
    scene.stiffness = stiffness;
    scene.ground = scene.mass;
    scene.amplitude.assign(stiffness.size(), 0.0);
    scene.amplitude[0] = 1.0;
    scene.omega = omega;
    scene.restitution = 0.0;
    scene.stops = {{scene.masses(), Side::lower, 0.0}};
    const std::vector<Event> events = events_of(scene, 0.0, until);
    ASSERT_FALSE(events.empty());
    EXPECT_NEAR(events[0].time, impact, 1e-9 * impact) << stiffness[1];
  }
}

// The motion behind a link below rounding is proportional to its stiffness: events do not depend on
// it. A link of 1e-30 gives the reference, 1295.761108, to its six decimals.
TEST(LongFlight, MovesAMassBehindALinkBelowRounding) {
  for (const double link : {1e-30, 1e-31, 1e-60}) {
    Scene scene = extremes::chain(2, 0.0618051);
    scene.mass = {1.16465, 1.74353};
    scene.stiffness = {0.0, link};
    scene.ground = {1.92534, 0.323727};
    scene.amplitude = {1.0, 0.0};
    scene.omega = 0.00121257;
    scene.restitution = 0.0;
    scene.stops = {{2, Side::lower, 0.0}};
    const std::vector<Event> events = events_of(scene, 0.0, 16494.0);
    const auto stick = std::find_if(events.begin(), events.end(), [](const Event &event) {
      return event.kind == EventKind::stick;
    });
    ASSERT_NE(stick, events.end()) << link;
    EXPECT_NEAR(stick->time, 1295.761108, 1e-6) << link;
  }
}

// The force of a held mass beside a mode that decays beta times as fast as the forcing turns.
TEST(LongFlight, PassesOverNoReleaseBesideAFastMode) {
  Scene scene = extremes::chain(2, 1e15);
  scene.amplitude = {0.0, 1e8};
  scene.omega = 0.3;
  scene.restitution = 0.0;
  scene.stops = {{1, Side::upper, 0.0}};
  const auto release_of = [](const Scene &of, double until) {
    for (const Event &event : events_of(of, 0.0, until))
      if (event.kind == EventKind::release) return event.time;
    return infinity;
  };
  EXPECT_NEAR(release_of(scene, 20.0), 5.2359877559829899245, 1e-12);
  scene.beta = 1e8;
  scene.amplitude = {0.0, 2.9698280511160737};
  scene.constant = {2.969828051113104, 0.0};
  scene.omega = 0.7984200338784511;
  EXPECT_NEAR(release_of(scene, 6.2624), 3.9347600436576450232, 1e-9);
}

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
