// A run ends where a recorder asks for it, and goes on from there. (That a run in parts is the same
// bit for bit is tested by random_scenes_test.)
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>
#include <vector>

#include "reference/scenes/paper_scenes.hpp"
#include "tests/support/events.hpp"
#include "tests/support/random_scenes.hpp"
#include "tests/support/refusals.hpp"

namespace {

using namespace vibro_impact;
using namespace vibro_impact::testing;

// Asks for the end at the event with this number.
AtEvents until_event(std::size_t number) {
  return AtEvents([number, met = std::size_t{0}](const Event &, const Moment &) mutable {
    return ++met == number;
  });
}

// Some of these events lie inside a chatter, also beyond the impact from which its limit is taken.
TEST(Resume, ARunEndsAtTheEventThatARecorderNamesAndGoesOnFromThere) {
  const Scene scene = paper::figure2();
  const std::vector<Event> whole = events_of(scene, 0.0, 100.0);
  for (std::size_t number = 1; number < whole.size(); ++number) {
    AtEvents until = until_event(number);
    Simulation simulation(scene);
    const Outcome part = simulation.advance(100.0, until);
    EXPECT_EQ(part.ending, Ending::stopped);
    EXPECT_EQ(part.time, whole[number - 1].time);
    EventRecorder rest(-infinity);
    require_complete(simulation.advance(100.0, rest));
    ASSERT_EQ(rest.events.size(), whole.size() - number);
    EXPECT_TRUE(std::ranges::equal(rest.events, std::span(whole).subspan(number))) << number;
  }
}

// The copy is made inside the chatter of Figure 2(b). A simulation that was moved from can be
// assigned to.
TEST(Resume, ACopyGoesOnAsTheOriginalAndDoesNotMoveIt) {
  Simulation original(paper::figure2());
  require_complete(original.advance(716.0));
  Simulation copy = original;
  const Outcome other = copy.advance(750.0), end = original.advance(750.0);
  EXPECT_EQ(other.state.displacement, end.state.displacement);
  EXPECT_EQ(other.state.velocity, end.state.velocity);
  expect_refused({{[&] { require_complete(copy.advance(700.0)); },
                   "until = 700: lies before the start at 750"}});
  Simulation moved = std::move(original);
  original = copy;
  EXPECT_EQ(moved.advance(760.0).state, original.advance(760.0).state);
}

// Keeps the first sample from a time on, and asks for the end there.
struct FirstSample : Recorder {
  double at;
  std::vector<double> displacement = {}, velocity = {};
  explicit FirstSample(double time) : at(time) {
  }
  double next_time() const override {
    return displacement.empty() ? at : infinity;
  }
  void sample(const Moment &moment) override {
    for (int mass = 1; mass <= moment.masses(); ++mass) {
      displacement.push_back(moment.displacement(mass));
      velocity.push_back(moment.velocity(mass));
    }
  }
  bool done() const override {
    return !displacement.empty();
  }
};

// A ball falls from 1/2 under a weight of 1 and hits the stop at t = 1, with the velocity -1. A
// sample there has the velocity before the impact. A run that starts at the impact has the velocity
// after it.
TEST(Resume, ASampleAtAnImpactHasTheVelocityBeforeAndAStartTheVelocityAfter) {
  Scene scene{.mass = {1.0},
              .stiffness = {0.0},
              .constant = {-1.0},
              .restitution = 0.5,
              .stops = {{1, Side::lower, 0.0}},
              .displacement = {0.5}};
  FirstSample falling(1.0), starting(0.0);
  EXPECT_EQ(simulate(scene, 1.5, falling).ending, Ending::stopped);
  EXPECT_EQ(falling.velocity, std::vector{-1.0});
  scene.displacement = {0.0};
  scene.velocity = {-1.0};
  EXPECT_EQ(simulate(scene, 0.5, starting).ending, Ending::stopped);
  EXPECT_EQ(starting.velocity, std::vector{0.5});
}

// The time of an impact is rounded, to either side. A sample there has the velocity before it, and
// one at the next double has the velocity after it. These masses do not stick.
TEST(Resume, ASampleAtTheRoundedTimeOfAnImpactHasTheVelocityBeforeIt) {
  Scene scene = paper::figure2();
  scene.restitution = 1.0;
  for (const Event &impact : events_of(scene, 0.0, 100.0)) {
    FirstSample at(impact.time), next(std::nextafter(impact.time, infinity));
    EXPECT_EQ(simulate(scene, 100.0, at).ending, Ending::stopped);
    EXPECT_EQ(simulate(scene, 100.0, next).ending, Ending::stopped);
    const auto mass = static_cast<std::size_t>(impact.mass - 1);
    EXPECT_NEAR(at.velocity[mass], impact.velocity_before, 1e-12) << impact.time;
    EXPECT_NEAR(next.velocity[mass], impact.velocity_after, 1e-12) << impact.time;
  }
}

// A double of this time stands for 1e-6, and the rounded time of an impact may lie so far behind
// it.
TEST(Resume, ASampleAtAnImpactAfterABillionPeriodsIsNotBeyondTheStop) {
  for (int k = 1; k <= 20; ++k) {
    const Scene scene{
        .mass = {1.0}, .stiffness = {1.0}, .restitution = 0.5, .stops = {{1, Side::upper, 0.5}}};
    const MotionState start{{1'000'000'000, 0.0}, {0.0}, {1.0 + 0.01 * k}, {0}};
    const double time =
        events_from(scene, start, time_of({1'000'000'000, 1.0}, Clock(1.0))).at(0).time;
    FirstSample at(time);
    EXPECT_EQ(Simulation(scene, start).advance(time + 1.0, at).ending, Ending::stopped);
    EXPECT_LE(at.displacement[0], 0.5);
    EXPECT_NEAR(at.displacement[0], 0.5, 1e-6);
    EXPECT_GT(at.velocity[0], 0.0);
  }
}

// The mass is slow where it hits: its root is found to some hundred doubles, and corrected. The
// call looks for its end among these.
TEST(Resume, ACallReportsAnEventBeforeItsEndAndNoneAfterIt) {
  constexpr double spacing = 0x1p-52;
  for (int k = 1; k <= 300; ++k) {
    const Scene scene{.mass = {1.0},
                      .stiffness = {1.0},
                      .restitution = 0.5,
                      .stops = {{1, Side::upper, 1.0 - 1e-9 * k}},
                      .velocity = {1.0}};
    const double time = events_of(scene, 0.0, 1.6).at(0).time;
    for (const double doubles : {2.0, 100.0}) {
      EXPECT_EQ(events_of(scene, 0.0, time - doubles * spacing).size(), 0u) << k;
      EXPECT_EQ(events_of(scene, 0.0, time + doubles * spacing).size(), 1u) << k;
    }
  }
}

// A multiple of the rounded period may lie just before the whole period.
TEST(Resume, ARunGoesOnFromAMultipleOfThePeriod) {
  Scene scene = paper::figure2();
  for (const double omega : {0.7, 0.07, 0.256})
    for (const int periods : {1, 2, 3, 7}) {
      scene.omega = omega;
      const double time = periods * Clock(omega).period;
      SampleRecorder last(0.0, time, time / 2.0), first(time, time + 1.0, 0.5);
      Simulation simulation(scene);
      EXPECT_EQ(simulation.advance(time, last).time, time);
      EXPECT_EQ(simulation.advance(time).time, time);
      EXPECT_EQ(simulation.advance(time + 1.0, first).ending, Ending::reached);
      EXPECT_EQ(last.times.back(), time);
      EXPECT_EQ(first.times.front(), time);
    }
}

// A flight that ends at the time of an impact passes the stop by a rounding in one of a thousand
// cases. The state at its end lies on the stop, so that a run can start from it.
TEST(Resume, ARunThatEndsAtAnImpactEndsNoFurtherThanTheStop) {
  for (unsigned seed = 1; seed <= 40; ++seed) {
    const Scene scene = random_scene(seed);
    for (const Event &impact : select(events_of(scene, 0.0, 3.0), EventKind::impact))
      EXPECT_NO_THROW(check(scene, simulate(scene, impact.time).state)) << seed;
  }
}

// The simulation leaves the chatter that it was in. A start that does not fit leaves it as it was.
TEST(Resume, AnotherStartGivesTheEventsOfANewSimulation) {
  const Scene scene = paper::figure2();
  const MotionState start = simulate(scene, 716.0).state;
  Simulation moved(scene);
  require_complete(moved.advance(740.0));
  moved.start_from(start);
  EventRecorder events, of_new;
  require_complete(moved.advance(750.0, events));
  require_complete(Simulation(scene, start).advance(750.0, of_new));
  EXPECT_TRUE(events.events == of_new.events);
  MotionState beyond = start;
  beyond.displacement[1] = 1.0;
  expect_refused(
      {{[&] { moved.start_from(beyond); }, "start: mass 2 at 1, beyond its upper stop"}});
  EXPECT_EQ(require_complete(moved.advance(760.0)).time, 760.0);
}

// Pressed onto its stop by a constant force, the mass chatters up to the limit. A recorder ends the
// first call inside the chatter; the next call has one sample, and goes on to its end.
TEST(Resume, ACallAfterASampleThatEndedInsideAChatterEndsAtItsTime) {
  const Scene scene{.mass = {1.0},
                    .stiffness = {1.0},
                    .constant = {1.0},
                    .restitution = 0.7,
                    .stops = {{1, Side::upper, 0.0}},
                    .displacement = {-1.0}};
  struct EndsAtASample : SampleRecorder {
    using SampleRecorder::SampleRecorder;
    bool done() const override {
      return !times.empty();
    }
  };
  const double inside = time_inside_chatter(scene, 30.0);
  EndsAtASample first(inside, inside, 1.0);
  Simulation simulation(scene);
  EXPECT_EQ(simulation.advance(30.0, first).time, inside);
  SampleRecorder second(inside + 1.0, inside + 1.0, 1.0);  // after the limit
  EXPECT_EQ(simulation.advance(30.0, second).time, 30.0);
}

// Wherever that is, also inside a chatter that is carried to its limit: the outcome is the state
// at the sample, to the rounding of a gap that is carried in addition to the displacement.
TEST(Resume, ARunEndedAtASampleEndsAtThatSample) {
  for (int k = 0; k < 800; ++k) {
    FirstSample sample(700.0 + 0.0617 * (k / 2));
    const double until = k % 2 == 0 ? 750.0 : sample.at;
    const Outcome outcome = simulate(paper::figure2(), until, sample);
    ASSERT_EQ(outcome.ending, Ending::stopped);
    EXPECT_EQ(outcome.time, sample.at);
    for (std::size_t i = 0; i < 2; ++i)
      EXPECT_NEAR(outcome.state.displacement[i], sample.displacement[i], 1e-14) << sample.at;
  }
}

// The time of an event is rounded: as an instant, it lies before every second event.
TEST(Resume, ARunGoesOnWithASampleAtItsStart) {
  const Scene scene = paper::figure2();
  for (std::size_t number = 100; number < 130; ++number) {
    AtEvents until = until_event(number);
    const Outcome end = simulate(scene, 300.0, until);
    SampleRecorder sample(end.time, end.time, 1.0);
    require_complete(Simulation(scene, end.state).advance(end.time + 1.0, sample));
    ASSERT_EQ(sample.displacements.size(), 2u);
    for (std::size_t i = 0; i < 2; ++i)  // the rounding of a time up to 300
      EXPECT_NEAR(sample.displacements[i], end.state.displacement[i], 1e-13) << number;
  }
}

// Two recorders ask for the same sample: each gets it, whichever is done there.
TEST(Resume, ASampleReachesEveryRecorderBeforeTheRunEnds) {
  for (const bool first : {false, true}) {
    FirstSample stopper(1.0);
    SampleRecorder samples(1.0, 1.0, 1.0);
    std::vector<Recorder *> recorders{&stopper, &samples};
    if (!first) std::swap(recorders[0], recorders[1]);
    const Outcome outcome = Simulation(paper::figure2()).advance(10.0, recorders);
    EXPECT_EQ(outcome.ending, Ending::stopped);
    EXPECT_EQ(samples.times.size(), 1u) << first;
  }
}

// To its own time, which rounding may put before it, from where it has just been hit; and from
// where it ended, after 61 periods that, divided by one, are less than 61.
TEST(Resume, ARunToTheTimeOfItsStartEndsAsItStarts) {
  Scene scene = paper::figure2();
  const MotionState left{{7, 1.0}, {0.0, 0.1}, {0.1, -0.5}, {0, 0}};
  const Outcome same = Simulation(scene, left).advance(time_of(left.instant, Clock(scene.omega)));
  EXPECT_NEAR(same.state.velocity[1], -0.5, 1e-15);
  scene.omega = 1.4456159370241128;
  const double until = 61.0 * Clock(scene.omega).period;
  EXPECT_EQ(Simulation(scene, simulate(scene, until).state).advance(until).ending, Ending::reached);
}

}  // namespace
