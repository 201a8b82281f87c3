// A motion beyond a stop shows itself: in the displacements that a run reports, and in its end.
#include <gtest/gtest.h>

#include <memory>

#include "reference/scenes/extreme_scenes.hpp"
#include "simulation/chain/scene.hpp"
#include "simulation/run/run.hpp"
#include "vibro_impact/vibro_impact.hpp"

namespace {

using namespace vibro_impact;

constexpr double position = 0.2;

const Scene forced = extremes::one_mass(0.0, 0.5, 0.4, 0.7, position);

// A run of one mass that stands at x, as if the search for events had passed over its stop.
std::unique_ptr<detail::Run> run_at(double x, double v, const Scene &scene = forced) {
  MotionState start = detail::first_motion(scene);
  start.displacement = {x};
  start.velocity = {v};
  return std::unique_ptr<detail::Run>(
      new detail::Run{.problem = {std::make_shared<const Scene>(scene), {}}, .start = start});
}

// The displacement that the run reports at the end of a call in which no time passes.
double reported(double x, const Scene &scene = forced) {
  const auto run = run_at(x, 0.0, scene);
  detail::advance(*run, {}, {});
  return run->progress.last.displacement[0];
}

// Rounding alone is taken from a displacement: 1e-13 of the terms of the gap, which are 0.4 here.
TEST(MissedEvent, IsSeenInTheDisplacement) {
  for (const double beyond : {1.0, 1e-3, 1e-12})
    EXPECT_EQ(reported(position + beyond), position + beyond);
  for (const double beyond : {0.0, 1e-16, 1e-14}) EXPECT_EQ(reported(position + beyond), position);
}

// A great force has not moved the mass yet. No spring has a radian that would end the time in which
// it does.
TEST(MissedEvent, IsSeenInTheDisplacementOfAMassWithoutASpring) {
  const Scene scene{.mass = {1.0},
                    .stiffness = {0.0},
                    .constant = {-1e20},
                    .omega = 0.0,
                    .restitution = 0.7,
                    .stops = {{1, Side::upper, position}}};
  EXPECT_EQ(reported(position + 1e-8, scene), position + 1e-8);
}

// A mass that bounces about its equilibrium at the stop becomes slower than any normal number.
TEST(MissedEvent, IsNoneInAMotionThatUnderflows) {
  Scene scene = extremes::one_mass(0.1, 0.0, 1.0, 0.5, 0.0);
  scene.displacement = {-1.0};
  const Outcome outcome = require_complete(simulate(scene, 4000.0));
  EXPECT_EQ(outcome.state.displacement[0], 0.0);
}

// The run does not go on from a place beyond a stop.
TEST(MissedEvent, GivesTheRunUp) {
  const auto run = run_at(position + 1e-3, -0.1);
  detail::advance(*run, Instant{.phase = 1.0}, {});
  EXPECT_EQ(run->progress.ending, Ending::given_up);
  EXPECT_EQ(run->progress.reason,
            "mass 1 lies beyond its stop at t = 0, given up: an event was missed");
}

}  // namespace
