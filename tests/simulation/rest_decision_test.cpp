// Which of the masses at rest at their stops stick, and which leave: forces that are zero, that
// rounding must not decide, and that a damper adds.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "tests/support/events.hpp"
#include "tests/support/random_scenes.hpp"
#include "vibro_impact/vibro_impact.hpp"

namespace {

using namespace vibro_impact;
using namespace vibro_impact::testing;

// A mass at rest at its stop, k = A = 1, is released when A cos(Omega t) falls to zero. The force
// is exactly zero at this root, whatever the rounding of the cosine, and its rate decides: one
// order decides at the start, two at the root.
TEST(RestDecision, TheForceIsExactlyZeroAtTheRootThatEndsASticking) {
  for (double omega = 0.1; omega < 2.0; omega += 0.05) {
    const Scene scene{.mass = {1.0},
                      .stiffness = {1.0},
                      .amplitude = {1.0},
                      .omega = omega,
                      .stops = {{1, Side::upper, 0.0}}};
    const Outcome outcome = require_complete(simulate(scene, 1.6 / omega));
    EXPECT_EQ(outcome.counters.releases, 1);
    EXPECT_EQ(outcome.counters.rest_orders, 3) << omega;
  }
}

// Counts the sticks of masses without forcing that a neighbour does not push there by a damper.
struct UnpressedSticks : Recorder {
  const Scene &scene;
  int sticks = 0, unpressed = 0;

  explicit UnpressedSticks(const Scene &of_run) : scene(of_run) {
  }
  void event(const Event &event, const Moment &moment) override {
    if (event.kind != EventKind::stick) return;
    ++sticks;
    const auto approaches = [&](int mass) {
      return mass >= 1 && mass <= scene.masses() && moment.velocity(mass) > 0.0;
    };
    const bool pushed = approaches(event.mass - 1) || approaches(event.mass + 1);
    if (!scene.forced(event.mass) && !(scene.beta > 0.0 && pushed)) ++unpressed;
  }
};

// All masses have a stop where they start, at 0.1. The hold force of a mass without forcing is the
// sum of k (x_j - 0.1) + beta k v_j over its neighbours and the wall. It presses only where a
// neighbour approaches its stop and there is a damper, though it may be zero but for the rounding
// of the tensions and their rates. At other times such a mass does not stick.
TEST(RestDecision, NothingHoldsAMassThatNoForcePresses) {
  int sticks = 0;
  for (const double beta : {0.0, 0.5})
    for (unsigned seed = 1; seed <= 200; ++seed) {
      Draw draw{std::mt19937(seed)};
      const int masses = draw.between(3, 8);
      const double link = draw.one_of({0.25, 1.0, 3.0});
      Scene scene{.beta = beta,
                  .omega = draw.one_of({0.3, 0.7, 1.0}),
                  .restitution = draw.one_of({0.0, 0.3, 0.7})};
      for (int i = 1; i <= masses; ++i) {
        scene.mass.push_back(1.0);
        scene.stiffness.push_back(link);
        scene.amplitude.push_back(draw.one_in(2) ? 0.5 : 0.0);
        scene.displacement.push_back(0.1);
        scene.stops.push_back({i, Side::upper, 0.1});
      }
      UnpressedSticks found(scene);
      require_complete(simulate(scene, 30.0 / scene.omega, found));
      EXPECT_EQ(found.unpressed, 0) << "beta " << beta << ", seed " << seed;
      sticks += found.sticks;
    }
  EXPECT_GT(sticks, 1000);
}

// A mass at the middle of three, held at its stop, is released by a jump of its force when the
// damper to the neighbour on either side passes on the impact of that neighbour. The impact itself
// decides this: no further step looks for the root of a force that is negative already.
TEST(RestDecision, AnImpactOfEitherNeighbourReleasesByAJump) {
  for (const int hit : {1, 3}) {
    const auto neighbour = static_cast<std::size_t>(hit - 1);
    Scene scene{.mass = {1.0, 1.0, 1.0},
                .stiffness = {1.0, 1.0, 1.0},
                .beta = 1.0,
                .constant = {0.0, 0.1, 0.0},
                .ground = {0.0, 0.0, 1.0},
                .omega = 0.0,
                .restitution = 1.0,
                .stops = {{2, Side::upper, 0.0}, {hit, Side::upper, 0.1}},
                .displacement = {0.0, 0.0, 0.0},
                .velocity = {0.0, 0.0, 0.0}};
    scene.velocity[neighbour] = 1.0;
    EventRecorder recorder;
    const Outcome outcome = require_complete(simulate(scene, 0.3, recorder));
    const std::vector<Event> &events = recorder.events;
    ASSERT_EQ(events.size(), 3u) << hit;
    EXPECT_EQ(outcome.counters.expansions, 2) << "to the impact, and to the end";
    EXPECT_EQ(events[0].kind, EventKind::stick);
    EXPECT_EQ(events[1].kind, EventKind::impact);
    EXPECT_EQ(events[1].mass, hit);
    EXPECT_EQ(events[2].kind, EventKind::release);
    EXPECT_EQ(events[2].instant, events[1].instant);
    EXPECT_TRUE(events[2].by_a_jump) << hit;
  }
}

// Mass 1 is held by a constant force, which exceeds the largest force of the spring to mass 2. With
// that of the damper the hold force k (x + beta v) + P falls to zero, soon after the start.
TEST(RestDecision, ADamperEndsASticking) {
  const double m = 0.386, k = 3.66, beta = 0.0735, press = 2.56, x0 = -0.623, v0 = -0.941;
  const Scene scene{.mass = {1.0, m},
                    .stiffness = {1.0, k},
                    .beta = beta,
                    .constant = {press, 0.0},
                    .omega = 0.0,
                    .stops = {{1, Side::upper, 0.0}},
                    .displacement = {0.0, x0},
                    .velocity = {0.0, v0}};
  EXPECT_GT(press, k * std::hypot(x0, v0 * std::sqrt(m / k)));
  const std::vector<Event> releases = select(events_of(scene, 0.0, 1.0), EventKind::release);
  ASSERT_FALSE(releases.empty());
  const double t = releases[0].time, decay = beta * k / (2.0 * m),
               omega = std::sqrt(k / m - decay * decay), b = (v0 + decay * x0) / omega,
               size = std::exp(-decay * t), c = std::cos(omega * t), s = std::sin(omega * t),
               x = size * (x0 * c + b * s),
               v = size * (omega * (b * c - x0 * s) - decay * (x0 * c + b * s));
  EXPECT_NEAR(k * (x + beta * v) + press, 0.0, 1e-14);  // rounding of 2.56, some ten times
}

}  // namespace
