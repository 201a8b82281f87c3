// When a chatter may be carried to its limit: the reach of other contacts.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "reference/scenes/paper_scenes.hpp"
#include "simulation/chatter/reach.hpp"
#include "tests/support/events.hpp"

namespace {

using namespace vibro_impact;
using namespace vibro_impact::testing;

// The verdict for a chatter of mass 1 whose limit is a time `left` away, and which will still
// change its velocity by `jump`, (1 + r) / (1 - r) times its own. All masses are at zero, and the
// others at rest.
bool stay_out_of_reach(const Scene &scene, const Held &held, double left, double jump) {
  const detail::Chain chain(scene);
  const detail::ContactMode mode = build_contact_mode(chain, held);
  detail::Motion motion;
  motion.mode = &mode;
  clear(chain, motion);
  const double r = scene.restitution, speed = (1.0 - r) / (1.0 + r) * jump;
  motion.v.front() = speed;
  find_acceleration(chain, motion);
  detail::Chatter chatter;
  chatter.add(chain, motion, mode.contacts.front(), -speed / r, left);
  const std::vector<detail::StopState> stops(2);
  return others_stay_out_of_reach(chain, chatter, motion, stops, left);
}

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
    EXPECT_EQ(stay_out_of_reach(scene, {0, 1}, 1e-9, -jumps_left), stays) << share;
  }
}

// The jumps J to come of mass 1 move mass 2, all else at rest, by at most beta k J t^2 / 2 within
// the time t to the limit. A gap of half of that may close; one of ten bounds may not, each of them
// above 2 w J t^2 with the rate w of the fastest mode.
TEST(ChatterReach, IsNotTakenWhereJumpsToComeMayCloseTheGapOfANeighbour) {
  constexpr double jump = 1e-3, left = 1e-3;
  Scene scene = paper::figure2();
  scene.amplitude = {0.0, 0.0};
  const double push = 0.5 * scene.beta * scene.stiffness[1] * jump * left * left;
  for (const auto &[gap, stays] :
       {std::pair{0.5 * push, false}, {100.0 * jump * left * left, true}}) {
    scene.stops = {{1, Side::upper, 0.0}, {2, Side::upper, gap}};
    EXPECT_EQ(stay_out_of_reach(scene, {0, 0}, left, -jump), stays) << gap;
  }
}

// Two masses on soft springs are pressed by constant forces, and a sine pulls mass 2 off its stop
// while mass 1 chatters. A limit that passes over the release makes it late by up to 0.03. 1e-12:
// the tolerance of a limit leaves 1e-13 of the motion.
TEST(ChatterReach, OfALimitEndsAtAReleaseByASine) {
  Scene scene{.mass = {1.0, 1.0},
              .stiffness = {0.01, 0.01},
              .sine = {0.0, -1.0},
              .omega = 0.5,
              .restitution = 0.5,
              .stops = {{1, Side::upper, 0.0}, {2, Side::upper, 0.0}},
              .velocity = {-0.5, 0.0}};
  for (int k = 0; k <= 400; ++k) {
    scene.constant = {1.0, std::sin(0.5 + 0.00175 * k)};
    SCOPED_TRACE(k);
    expect_holds_of_all_impacts(scene, 2.6, 1e-12);
  }
}

}  // namespace
