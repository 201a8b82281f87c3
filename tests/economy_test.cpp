// Nothing is computed that a scene does not need: shown by the counters of work.
#include <gtest/gtest.h>

#include <set>

#include "extreme_cases.hpp"
#include "vibro_impact/expansion.hpp"
#include "vibro_impact/vibro_impact.hpp"

namespace {

using namespace vibro_impact;

// Every contact mode a run was in: the free one and those its events led to.
long long modes_entered(const std::vector<Event> &events, int masses) {
  std::set<Held> modes{Held(static_cast<std::size_t>(masses), 0)};
  for (const Event &event : events) modes.insert(event.held);
  return static_cast<long long>(modes.size());
}

Scene without_stops(Scene scene) {
  scene.stops.clear();
  return scene;
}

TEST(Economy, AContactModeIsBuiltWhenItIsFirstEntered) {
  for (const Scene &scene : {paper::figure2(), paper::figure5a(), paper::figure5b(),
                             extremes::long_chain(10, 0.7), without_stops(paper::figure2())}) {
    EventRecorder events;
    const Outcome outcome = simulate(scene, 300.0, {}, events);
    EXPECT_EQ(outcome.counters.modes_built, modes_entered(events.events, scene.masses()));
  }
}

// One polynomial per stop and expansion, or flight of a chatter, whether dismissed or searched:
// masses without stops have none, however many there are.
TEST(Economy, OnlyStopsThatExistAreTested) {
  for (const int masses : {3, 10, 50}) {
    Scene scene = extremes::long_chain(masses, 0.7);
    for (const std::size_t stops : {3u, 2u, 1u}) {
      scene.stops.resize(stops);
      const Counters counters = simulate(scene, 40.0, {}).counters;
      const long long tested =
          counters.stops_out_of_reach + counters.roots_dismissed + counters.roots_searched;
      const long long flights = counters.expansions + counters.flights_followed;
      EXPECT_LE(tested, static_cast<long long>(stops) * flights) << masses;
      EXPECT_GT(tested, 0);
    }
    scene.stops.clear();
    const Counters counters = simulate(scene, 40.0, {}).counters;
    EXPECT_EQ(counters.stops_out_of_reach + counters.roots_dismissed + counters.roots_searched, 0);
  }
}

// What is expanded is the gaps and forces that are looked at, one coefficient by one product per
// lane and speed of a lane: in proportion to the stops, and to N, not to its square.
TEST(Economy, AnExpansionCostsInProportionToTheStops) {
  const auto products_per_stop = [](int masses, std::size_t stops) {
    Scene scene = extremes::long_chain(masses, 0.7);
    scene.stops.resize(stops);
    const Counters counters = simulate(scene, 40.0, {}).counters;
    const long long looked_at =
        counters.roots_dismissed + counters.roots_searched + counters.crossings_sought;
    EXPECT_GE(looked_at, 40);
    // And the two lanes of the forcing; less where masses stick.
    const long long per_coefficient = 2 * masses + 2;
    // A reading more is followed across each chatter limit, of every other stop.
    EXPECT_LE(counters.products,
              (looked_at + 3 * counters.chatter_limits) * (max_order + 1) * per_coefficient);
    return static_cast<double>(counters.products) /
           static_cast<double>(looked_at * per_coefficient);
  };
  for (const std::size_t stops : {1u, 2u, 3u}) {
    const double few = products_per_stop(10, stops);
    EXPECT_LE(few, max_order + 1) << stops;
    // Surveyed only, or expanded as well: which, and how often, depends on the motion.
    for (const int masses : {50, 200})
      EXPECT_NEAR(products_per_stop(masses, stops), few, 0.45 * few) << masses << " " << stops;
  }
}

// r = 0 stops a mass at once; r = 1 bounces for ever at the same speed, however hard it is pressed.
TEST(Economy, NoChatterTableWhereChatterCannotBe) {
  const auto counters_of = [](double r) {
    const Scene scene = extremes::one_mass(0.0, 0.0, 1.0, r, -0.5, -0.51);  // flights of 0.4
    return simulate(scene, 30.0, {}).counters;
  };
  for (const double r : {0.0, 1.0}) {
    EXPECT_GT(counters_of(r).impacts, 0) << r;
    EXPECT_EQ(counters_of(r).chatter_nodes, 0) << r;
    EXPECT_EQ(counters_of(r).chatter_limits, 0) << r;
  }
  EXPECT_GT(counters_of(0.7).chatter_nodes, 0);
}

// Also where every mass comes to rest, and the state at the limit is nothing but a position: 53
// impacts, 124 when the limit is not taken before the rest lies below rounding.
TEST(Economy, AChatterThatEndsAllMotionIsCarriedToItsLimit) {
  const Counters counters =
      simulate(extremes::one_mass(0.0, 0.0, 1.0, 0.9, -0.5, -1.0), 100.0, {}).counters;
  EXPECT_EQ(counters.chatter_limits, 1);
  EXPECT_LE(counters.impacts, 60);
}

TEST(Economy, NoForcingIsCarriedWhereThereIsNone) {
  Scene scene = paper::figure2();
  EXPECT_EQ(simulate(scene, 60.0, {}).counters.forcing_lanes, 2);
  scene.amplitude = {0.0, 0.0};
  scene.velocity = {-1.0, 1.0};
  const Counters counters = simulate(scene, 60.0, {}).counters;
  EXPECT_GT(counters.impacts, 0);
  EXPECT_EQ(counters.forcing_lanes, 0);
}

// Without stops nothing can happen: no expansion, one closed-form evaluation per sample asked for
// and one for the state at the end.
TEST(Economy, WithoutStopsASampleIsOneEvaluation) {
  for (const int masses : {1, 2, 50}) {
    const Scene scene = without_stops(extremes::long_chain(std::max(2, masses), 0.7));
    SampleRecorder samples{.from = 1.0, .to = 90.0, .every = 0.37, .masses = scene.masses()};
    const Counters counters = simulate(scene, 100.0, {}, samples).counters;
    EXPECT_GT(samples.times.size(), 200u);
    EXPECT_EQ(counters.modal_evaluations, static_cast<long long>(samples.times.size()) + 1);
    EXPECT_EQ(counters.expansions, 0);
  }
}

TEST(Economy, WithStopsNothingIsEvaluatedThatNobodyAskedFor) {
  EventRecorder events;
  EXPECT_EQ(simulate(paper::figure2(), 300.0, {}, events).counters.modal_evaluations, 0);
}

// The first masses of a long chain move alike until a wave has been to the far end and back, so the
// motion, its events and with them the work are those of the shorter chain. (The rate of the
// fastest mode, and so the step, still grows by one in a hundred from N = 10 to 200.)
TEST(Economy, TheWorkDoesNotGrowWithMassesThatDoNothing) {
  const auto counters_of = [](int masses) {
    Scene scene = extremes::long_chain(masses, 0.7);
    scene.velocity.clear();
    scene.stops.pop_back();
    return simulate(scene, 11.0, {}).counters;  // before the chatter of mass 1 completes
  };
  const Counters few = counters_of(10);
  EXPECT_GT(few.impacts, 5);
  for (const int masses : {20, 50, 200}) {
    const Counters many = counters_of(masses);
    EXPECT_EQ(many.impacts, few.impacts) << masses;
    EXPECT_LE(many.expansions, few.expansions + 1) << masses;
    EXPECT_LE(many.coefficients, few.coefficients * 102 / 100 + max_order) << masses;
    const auto looked_at = [](const Counters &counters) {
      return counters.stops_out_of_reach + counters.roots_dismissed + counters.roots_searched +
             counters.crossings_sought;
    };
    EXPECT_LE(looked_at(many), looked_at(few) + 2) << masses;
  }
}

}  // namespace
