// When a chatter may be carried to its limit: the reach of other contacts, in the engine in modal
// coordinates.
#include <gtest/gtest.h>

#include "reference/scenes/paper_scenes.hpp"
#include "simulation/chain/mode_change.hpp"
#include "simulation/chatter/limit.hpp"

namespace {

using namespace vibro_impact;

// A mass held next to a chattering mass feels the jumps of its neighbour through the damper between
// them. A limit is only taken where all jumps to come, r / (1 - r) of the latest, cannot release
// it.
TEST(ChatterReach, IsNotTakenWhereJumpsToComeMayReleaseANeighbour) {
  constexpr double r = 0.7, jump = 1e-3, jumps_left = jump * r / (1.0 - r);
  Scene scene = paper::figure2();
  scene.restitution = r;
  scene.stops = {{1, Side::upper, 0.0}, {2, Side::upper, 0.0}};
  // Both at rest at the origin, and a phase of the forcing that presses the second by its share.
  for (const auto &[share, stays] : {std::pair{1.2, false}, {0.5, false}, {3.0, true}}) {
    scene.amplitude = {0.0, share * scene.beta * scene.stiffness[1] * jumps_left};
    const auto pressed_mode = detail::build_contact_mode(scene, Held{0, 1});
    detail::Motion motion;
    detail::ChainMotion chain;
    detail::express(scene, start_of(scene), pressed_mode, Clock(scene.omega), chain, motion);
    detail::Chatter chatter;
    detail::begin_chatter(chatter, {0}, r);
    detail::add_impact(chatter, 1e-9, {jump}, motion);
    detail::LimitState limit;
    const std::vector<detail::StopState> stops(2);
    EXPECT_EQ(detail::others_stay_out_of_reach(chatter, motion, stops, scene.omega, 1e-9, limit),
              stays)
        << share;
  }
}

}  // namespace
