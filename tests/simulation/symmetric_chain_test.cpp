// A chain of three masses that is its own mirror image moves as its half: masses 1 and 3 together,
// and mass 2 as half a mass. Two hold forces come to zero at one instant. The force on mass 2 is
// zero until masses 1 and 3 are released. The derivatives of this force then decide mass 2.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "tests/support/events.hpp"
#include "vibro_impact/vibro_impact.hpp"

namespace {

using namespace vibro_impact;
using namespace vibro_impact::testing;

// Sticks, releases and impacts faster than those that a chatter limit may leave out.
std::vector<Event> of_mass(const std::vector<Event> &events, int mass) {
  std::vector<Event> found;
  for (const Event &event : events)
    if (event.mass == mass &&
        (event.kind != EventKind::impact || std::abs(event.velocity_before) > 1e-3))
      found.push_back(event);
  return found;
}

// 1e-11: rounding parts masses 1 and 3, some ten roundings at each of some hundred events.
TEST(SymmetricChain, MovesAsItsHalf) {
  for (const double beta : {0.0, 0.1})
    for (const double r : {0.0, 0.5}) {
      Scene whole{.mass = {1.0, 1.5, 1.0},
                  .stiffness = {1.0, 0.7, 0.7},
                  .beta = beta,
                  .amplitude = {0.8, 0.0, 0.8},
                  .ground = {0.0, 0.0, 1.0},
                  .omega = 0.3,
                  .restitution = r,
                  .stops = {{1, Side::upper, 0.3}, {2, Side::upper, 0.3}, {3, Side::upper, 0.3}},
                  .displacement = {0.3, 0.3, 0.3}};
      Scene half{.mass = {1.0, 0.75},
                 .stiffness = {1.0, 0.7},
                 .beta = beta,
                 .amplitude = {0.8, 0.0},
                 .omega = 0.3,
                 .restitution = r,
                 .stops = {{1, Side::upper, 0.3}, {2, Side::upper, 0.3}},
                 .displacement = {0.3, 0.3}};
      const std::vector<Event> all = events_of(whole, 0.0, 60.0), ours = events_of(half, 0.0, 60.0);
      for (const auto &[mass, other] : {std::pair{1, 1}, {2, 2}, {3, 1}}) {
        const std::vector<Event> found = of_mass(all, mass), expected = of_mass(ours, other);
        ASSERT_EQ(found.size(), expected.size()) << mass << " " << beta << " " << r;
        EXPECT_GE(found.size(), 4u);
        for (std::size_t i = 0; i < found.size(); ++i)
          EXPECT_NEAR(found[i].time, expected[i].time, 1e-11) << mass;
      }
    }
}

// Roots that only rounding parts are one instant: masses 1 and 3 have their events at the same bits
// of time, and chatter together to the limit. Resolved in turn, they would never end in one.
TEST(SymmetricChain, HasTheEventsOfItsHalvesAtOneInstant) {
  for (const double r : {0.3, 0.5, 0.7})
    for (const double link : {0.25, 1.0, 2.7}) {
      const Scene scene{.mass = {1.0, 2.0, 1.0},
                        .stiffness = {1.0, link, link},
                        .beta = 0.1,
                        .amplitude = {1.0, 0.0, 1.0},
                        .ground = {0.0, 0.0, 1.0},
                        .omega = 0.3,
                        .restitution = r,
                        .stops = {{1, Side::upper, 0.1}, {3, Side::upper, 0.1}}};
      const std::vector<Event> events = events_of(scene, 0.0, 40.0);
      EXPECT_GE(select(events, EventKind::stick).size(), 4u);
      ASSERT_EQ(events.size() % 2, 0u);
      for (std::size_t i = 0; i < events.size(); i += 2) {
        EXPECT_EQ(events[i].kind, events[i + 1].kind);
        EXPECT_EQ(events[i].instant, events[i + 1].instant) << r << " " << link;
      }
    }
}

}  // namespace
