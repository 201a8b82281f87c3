// The totals of the stops: closed forms, no dependence on the cut of chatter, additivity over time,
// and the pressing force of the library summed up.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "reference/scenes/paper_scenes.hpp"
#include "tests/support/windows.hpp"
#include "vibro_impact/analysis/totals.hpp"

namespace {

using namespace vibro_impact;
using namespace vibro_impact::testing;

std::vector<StopTotals> totals(const Scene &scene, double from, double to,
                               const RunOptions &options = {}) {
  TotalsRecorder recorder(scene, from, to);
  require_complete(simulate(scene, to, options, recorder));
  return recorder.stops;
}

// Both stops of the first of three masses, all terms of the equation of motion, and sticking.
Scene rich_scene() {
  return {.mass = {1.0, 2.0, 0.5},
          .stiffness = {1.0, 2.0, 0.7},
          .beta = 0.1,
          .amplitude = {0.5, 0.0, 0.2},
          .sine = {0.0, 0.3, 0.0},
          .constant = {0.0, 0.1, 0.0},
          .ground = {0.3, 0.2, 0.1},
          .omega = 0.3,
          .restitution = 0.6,
          .stops = {{1, Side::lower, -0.3}, {1, Side::upper, 0.2}, {3, Side::upper, 0.25}}};
}

// A mass of weight m falls from height 1/2 in a field of strength 1, half of it a forcing that does
// not turn, and comes to rest at the time (1 + r) / (1 - r). Up to then the impulse is the weight
// times the time; all energy is lost. The impacts have the speeds 1, r, r^2, .... The tolerance is
// that of the extrapolation over the nodes of r = 0.9.
TEST(Totals, OfABouncingMassHaveTheirClosedForms) {
  for (const double r : {0.0, 0.5, 0.9}) {
    const double m = 2.0, rest = (1.0 + r) / (1.0 - r), to = 30.0;
    const StopTotals stop = totals({.mass = {m},
                                    .stiffness = {0.0},
                                    .amplitude = {-m / 2.0},
                                    .constant = {-m / 2.0},
                                    .omega = 0.0,
                                    .restitution = r,
                                    .stops = {{1, Side::lower, 0.0}},
                                    .displacement = {0.5}},
                                   0.0, to)
                                .at(0);
    long long impacts = 0;
    for (double speed = 1.0; speed >= 1e-4; speed *= r) ++impacts;
    EXPECT_EQ(stop.impacts, impacts) << r;
    EXPECT_NEAR(stop.largest_speed, 1.0, 1e-15) << r;
    EXPECT_EQ(stop.sticks, 1);
    EXPECT_NEAR(stop.taken.impulse, m * rest, 1e-13 * m * rest) << r;
    EXPECT_NEAR(stop.taken.energy, m / 2.0, 1e-14) << r;
    EXPECT_NEAR(stop.contact, to - rest, 1e-13 * to) << r;
    EXPECT_NEAR(stop.pressing, m * (to - rest), 1e-13 * m * to) << r;
  }
}

void expect_near(const StopTotals &a, const StopTotals &b, double error) {
  EXPECT_EQ(a.impacts, b.impacts);
  EXPECT_EQ(a.sticks, b.sticks);
  EXPECT_NEAR(a.taken.impulse, b.taken.impulse, error * b.taken.impulse);
  EXPECT_NEAR(a.taken.energy, b.taken.energy, error * b.taken.energy);
  EXPECT_NEAR(a.contact, b.contact, error * b.contact);
  EXPECT_NEAR(a.pressing, b.pressing, error * b.pressing);
}

// A limit is accepted at an error of 1e-13 of its time. Three orders more are left for the states
// at the limit, which have the errors of lib/README.md.
TEST(Totals, DoNotDependOnTheCutOfChatter) {
  for (const Scene &scene : {paper::figure2(), rich_scene()}) {
    const auto resolved = totals(scene, 0.0, 100.0, all_impacts);
    for (const double cut : {1e-3, infinity}) {
      const auto stops = totals(scene, 0.0, 100.0, {.limit_below_speed = cut});
      for (std::size_t k = 0; k < stops.size(); ++k) {
        SCOPED_TRACE(k + 1);
        expect_near(stops[k], resolved[k], 1e-10);
      }
    }
  }
}

// The pressing force that the library reports, on the side of each stop, summed up at distances h.
struct Press : Recorder {
  const Scene &scene;
  static constexpr double h = 1e-3;
  double taken = 0.0;
  std::vector<double> sum;

  explicit Press(const Scene &of) : scene(of), sum(of.stops.size(), 0.0) {
  }
  double next_time() const override {
    return (taken + 0.5) * h < 100.0 ? (taken + 0.5) * h : infinity;
  }
  void sample(const Moment &moment) override {
    ++taken;
    for (std::size_t k = 0; k < sum.size(); ++k)
      if (const double press = sign(scene.stops[k].side) * moment.hold_force(scene.stops[k].mass);
          press > 0.0)
        sum[k] += h * press;
  }
};

// The sum misses at most h times the force at the ends of each phase, which stays below 1.
TEST(Totals, OfPressingAreThoseOfTheForce) {
  for (const Scene &scene : {paper::figure2(), rich_scene()}) {
    Press press(scene);
    require_complete(simulate(scene, 100.0, press));
    const auto stops = totals(scene, 0.0, 100.0);
    for (std::size_t k = 0; k < stops.size(); ++k) {
      EXPECT_GT(stops[k].sticks, 0) << k;
      EXPECT_NEAR(stops[k].pressing, press.sum[k], Press::h * static_cast<double>(stops[k].sticks))
          << "stop " << k + 1;
    }
  }
}

// The first window ends in flight (t = 28), while a mass sticks (t = 35), or inside a chatter.
TEST(Totals, OfPartsOfTheTimeAddUp) {
  const Scene scene = paper::figure2();
  const auto whole = totals(scene, 0.0, 100.0);
  for (const double cut : {16.2437, 28.0, 35.0}) {
    auto sum = totals(scene, 0.0, cut);
    const auto second = totals(scene, cut, 100.0);
    for (std::size_t k = 0; k < whole.size(); ++k) {
      SCOPED_TRACE(cut);
      sum[k].impacts += second[k].impacts;
      sum[k].sticks += second[k].sticks;
      sum[k].taken += second[k].taken;
      sum[k].contact += second[k].contact;
      sum[k].pressing += second[k].pressing;
      expect_near(sum[k], whole[k], 1e-12);
    }
  }
}

// A held mass between stiff links, whose force is 0.1 of theirs. The masses are at rest.
TEST(Totals, OfPressingKeepTheirDigitsBesideAStiffLink) {
  for (const double stiff : {1.0, 1e9, 1e17}) {
    const Scene scene{.mass = {1.0, 1.0},
                      .stiffness = {1.0, stiff},
                      .constant = {0.5, 0.25},
                      .omega = 0.0,
                      .stops = {{1, Side::upper, 0.0}}};
    // Mass 2 begins at its equilibrium.
    Scene at_rest = scene;
    at_rest.displacement = {0.0, 0.25 / stiff};
    EXPECT_NEAR(totals(at_rest, 0.0, 10.0).at(0).pressing, 7.5, 1e-13) << stiff;
  }
}

// A ball falls from 13.5 under 9.81 and leaves with 0.95 of its speed. Flight k has the speed
// v r^k, so that impact k is at (1 + 2 (r + ... + r^k)) v / 9.81.
TEST(Totals, OfABallInsideItsChatterAreThoseOfItsImpacts) {
  const double r = 0.95, g = 9.81, v = std::sqrt(2.0 * g * 13.5);
  const Scene scene{.mass = {1.0},
                    .stiffness = {0.0},
                    .constant = {-g},
                    .restitution = r,
                    .stops = {{1, Side::lower, 0.0}},
                    .displacement = {13.5}};
  for (const auto &[from, to] :
       {std::pair{0.0, 50.0}, {45.0, 50.0}, {60.0, 70.0}, {64.0, 64.69}, {64.69, 64.7}}) {
    double impulse = 0.0, lost = 0.0, time = v / g, speed = v;
    for (int k = 0; k < 700; ++k, speed *= r, time += 2.0 * speed / g) {
      if (time < from || time > to) continue;
      impulse += (1.0 + r) * speed;
      lost += 0.5 * (1.0 - r * r) * speed * speed;
    }
    const StopTotals stop = totals(scene, from, to).at(0);
    EXPECT_NEAR(stop.taken.impulse, impulse, 1e-12 * 491.3) << from;
    EXPECT_NEAR(stop.taken.energy, lost, 1e-12 * 125.7) << from;
    const std::vector<Event> events = events_of(scene, from, to);
    if (to == 50.0) {
      EXPECT_EQ(events.size(), from == 0.0 ? 29u : 6u);
      EXPECT_EQ(stop.impacts, static_cast<long long>(events.size()));
      EXPECT_NEAR(sum_of(events).impulse, impulse, 1e-12 * 491.3);
    }
  }
}

// 3.41432922 is the sum of all impacts down to rounding, of which the run resolves 53.
TEST(Totals, OfFigure2ContainTheImpactsThatTheLimitsReplace) {
  const Scene scene = paper::figure2();
  for (const RunOptions &options : {RunOptions{}, all_impacts}) {
    const std::vector<Event> events = events_of(scene, 700.0, 750.0, options);
    EXPECT_NEAR(sum_of(events).impulse, 3.41432922, 5e-9);
    const std::vector<StopTotals> stops = totals(scene, 700.0, 750.0, options);
    EXPECT_NEAR(stops[0].taken.impulse + stops[1].taken.impulse, sum_of(events).impulse, 1e-12);
    EXPECT_EQ(stops[0].impacts + stops[1].impacts, 81);
  }
}

// The window begins inside a chatter, whose impacts are slower than 1e-5 there.
TEST(Totals, OfAWindowThatBeginsInsideAChatterLeaveOutItsPast) {
  const Scene scene = paper::figure2();
  const StopTotals stop = totals(scene, 16.2437, 20.0).at(0),
                   resolved = totals(scene, 16.2437, 20.0, all_impacts).at(0);
  EXPECT_NEAR(stop.taken.impulse, 1.8272e-5, 1e-9);
  EXPECT_NEAR(stop.taken.impulse, resolved.taken.impulse, 1e-13);
  EXPECT_NEAR(stop.taken.energy, resolved.taken.energy, 1e-13);
  EXPECT_EQ(totals(scene, 16.2437, 100.0).at(0).impacts,
            totals(scene, 16.2437, 100.0, all_impacts).at(0).impacts);
}

// With r = 0 the first impact is the last: the sticks replace no impacts.
TEST(Totals, WithoutReboundAreThoseOfTheImpacts) {
  const Scene scene{.mass = {1.0},
                    .stiffness = {1.0},
                    .beta = 0.1,
                    .amplitude = {0.5},
                    .omega = 0.47,
                    .restitution = 0.0,
                    .stops = {{1, Side::upper, 0.3}}};
  const StopTotals stop = totals(scene, 0.0, 50.0).at(0);
  double impulse = 0.0;
  for (const Event &event : events_of(scene, 0.0, 50.0)) impulse += event.velocity_before;
  EXPECT_NEAR(stop.taken.impulse, impulse, 1e-14);
  EXPECT_NEAR(stop.taken.impulse, 1.45944, 5e-6);
  EXPECT_NEAR(stop.taken.energy, 0.18606, 5e-6);
}

// After an impact with the rebound speed v, a ball of mass 1 gives its stop the impulse
// v (1 + r) / (1 - r) and loses the energy v^2 / 2. The event at the limit has them to 1e-12, and
// to the rounding of sums over the whole chatter in twice the precision, 1e-30.
TEST(Totals, OfTheEventAtALimitHaveTheirOwnDigits) {
  for (const double r : {0.3, 0.5, 0.7, 0.9})
    for (const double slowest : {1e-6, 1e-8, 1e-10}) {
      const Scene scene{.mass = {1.0},
                        .stiffness = {0.0},
                        .constant = {1.0},
                        .omega = 0.0,
                        .restitution = r,
                        .stops = {{1, Side::upper, 0.5}}};
      EventRecorder events(0.0, infinity);  // asks for no impact behind the latest node
      require_complete(simulate(scene, 3.0 / (1.0 - r), {.limit_below_speed = slowest}, events));
      ASSERT_GE(events.events.size(), 2u);
      const Event &limit = events.events.back(), &last = *(events.events.end() - 2);
      ASSERT_EQ(limit.kind, EventKind::stick);
      const double v = std::abs(last.velocity_after), impulse = v * (1.0 + r) / (1.0 - r);
      EXPECT_NEAR(limit.taken.impulse, impulse, 1e-12 * impulse + 1e-30) << r << " " << slowest;
      EXPECT_NEAR(limit.taken.energy, 0.5 * v * v, 1e-12 * v * v + 1e-30) << r << " " << slowest;
    }
}

}  // namespace
