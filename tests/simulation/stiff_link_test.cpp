// A link of 1e9 between masses that move slowly: rounding does not set it in motion, and its force
// keeps its digits.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "tests/support/events.hpp"
#include "vibro_impact/vibro_impact.hpp"

namespace {

using namespace vibro_impact;
using vibro_impact::testing::events_of;

// Masses 1 and 2 swing together as cos t, and their link of 1e9 carries no force, while mass 4
// beyond the held mass 3 sticks and is released. The rounding of their displacements would set the
// link in motion at each of these changes, at some 1e-12. 1e-15: some ten roundings of their
// speeds.
TEST(StiffLink, StaysAtRestOverAChangeOfTheContactMode) {
  const Scene scene{.mass = {1.3, 2.1, 1.0, 1.0},
                    .stiffness = {1.3, 1e9, 2.1, 1.0},
                    .amplitude = {0.0, 0.0, 0.0, 0.5},
                    .constant = {0.0, 0.0, 5.0, 0.0},
                    .omega = 0.3,
                    .restitution = 0.0,
                    .stops = {{3, Side::upper, 0.0}, {4, Side::upper, 0.2}},
                    .displacement = {0.1, 0.1, 0.0, 0.0}};
  struct Stretch : Recorder {
    double time = 0.0, largest = 0.0;
    double next_time() const override {
      return time;
    }
    void sample(const Moment &moment) override {
      largest = std::max(largest, std::abs(moment.velocity(2) - moment.velocity(1)));
      time += 0.37;
    }
  } link;
  const Outcome outcome = require_complete(simulate(scene, 100.0, link));
  EXPECT_GE(outcome.counters.releases, 3);
  EXPECT_NEAR(outcome.state.displacement[0], 0.1 * std::cos(100.0), 1e-14);
  EXPECT_LE(link.largest, 1e-15);
}

// Mass 1 is pressed against mass 2, which is held at its stop, through a link of 1e9. It stands
// still while mass 3 sticks and is released. The rounding of its displacement, 1e-17, would be 1e-8
// of the force.
TEST(StiffLink, KeepsItsForceOverAChangeOfTheContactMode) {
  const Scene scene{.mass = {1.0, 1.0, 1.0},
                    .stiffness = {1.0, 1e9, 1.0},
                    .beta = 1e-3,
                    .amplitude = {0.0, 0.0, 0.5},
                    .constant = {2.0, 0.0, 0.0},
                    .omega = 0.3,
                    .restitution = 0.0,
                    .stops = {{2, Side::upper, 0.1}, {3, Side::upper, 0.3}},
                    .displacement = {0.1, 0.1, 0.0}};
  struct Releases : Recorder {
    std::vector<double> forces;
    void event(const Event &event, const Moment &moment) override {
      if (event.mass == 3 && event.kind == EventKind::release)
        forces.push_back(moment.hold_force(2));
    }
  } releases;
  require_complete(simulate(scene, 100.0, releases));
  const double x1 = (1e9 * 0.1 + 2.0) / (1e9 + 1.0);
  ASSERT_GE(releases.forces.size(), 3u);
  for (const double force : releases.forces) EXPECT_NEAR(force, 2.0 - x1 + (0.3 - 0.1), 1e-12);
}

// Mass 1 sticks and is released beside a damped link of 3e10. The force of this link in soft modes
// follows from its neighbours: its own rounding, 4e-11, would let mass 1 go and return many times.
// The times are those of the 50-digit generator. 1e-13: some hundred roundings of the clock.
TEST(StiffLink, ReleasesItsMassOnce) {
  const Scene scene{
      .mass = {0.5894847662420943, 1.6050043986178935, 0.9278860123595223, 1.0177793625043705,
               1.564320062752813},
      .stiffness = {1.0590667295036837, 33856428893.749115, 1.6489723810227588, 1.4941287783440202,
                    1.6468439748277888},
      .beta = 0.4407499545302163,
      .amplitude = {0.5, -0.7978268847800791, 0.6541181816719472, 0.0, -0.7086161407642066},
      .omega = 0.4964856616336117,
      .restitution = 0.5,
      .stops = {{1, Side::upper, 0.006582809244109569},
                {1, Side::lower, -0.0737460732228438},
                {4, Side::upper, 0.12622546829375259},
                {5, Side::upper, 0.0195830963289615}}};
  const std::vector<double> changes{1.870910161305145, 2.045433479252328, 3.605336436528265,
                                    6.233732091779854};
  std::vector<Event> events = events_of(scene, 0.0, 8.0);
  std::erase_if(events, [](const Event &event) { return !changes_contact_mode(event.kind); });
  ASSERT_EQ(events.size(), changes.size());
  for (std::size_t i = 0; i < changes.size(); ++i) {
    EXPECT_EQ(events[i].kind, i % 2 == 0 ? EventKind::stick : EventKind::release);
    EXPECT_NEAR(events[i].time, changes[i], 1e-13);
  }
}

}  // namespace
