// A chain of three masses that is its own mirror image moves as its half: masses 1 and 3 together.
#include <gtest/gtest.h>

#include <vector>

#include "tests/support/events.hpp"
#include "vibro_impact/vibro_impact.hpp"

namespace {

using namespace vibro_impact;
using namespace vibro_impact::testing;

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
