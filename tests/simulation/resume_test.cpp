// A run that ended, wherever that was, goes on: bit for bit from the state of the run, to rounding
// from its motion. The state of a run of another scene is refused.
#include <gtest/gtest.h>

#include <limits>
#include <vector>

#include "reference/paper_scenes.hpp"
#include "tests/events.hpp"
#include "tests/refusals.hpp"

namespace {

using namespace vibro_impact;
using namespace vibro_impact::testing;

// Ends the run at an event.
struct NextEvent {
  bool met = false;
  void event(const Event &, const Moment &) {
    met = true;
  }
  bool done() const {
    return met;
  }
};

// The parts end between two events and, by a recorder, at an event, and so inside every chatter
// too.
TEST(Resume, ARunInPartsGoesOnBitForBit) {
  const Scene scene = paper::figure2();
  EventRecorder whole, parts;
  const Outcome outcome = simulate(scene, 100.0, {}, whole);
  ASSERT_GT(whole.events.size(), 100u);
  Simulation simulation(scene);
  int inside = 0;  // a chatter
  for (std::size_t k = 1; k < whole.events.size(); ++k) {
    const double before = whole.events[k - 1].time, here = whole.events[k].time;
    require_complete(simulation.advance((before + here) / 2, parts));
    simulation = Simulation(simulation);  // a copy goes on
    inside += whole.events[k].falling > 0;
    NextEvent next;
    const Outcome part = simulation.advance(100.0, parts, next);
    EXPECT_EQ(part.ending, Ending::stopped);
    EXPECT_EQ(part.time, here);
  }
  const Outcome last = simulation.advance(100.0, parts);
  ASSERT_EQ(parts.events.size(), whole.events.size());
  for (std::size_t k = 0; k < parts.events.size(); ++k)
    EXPECT_EQ(parts.events[k].time, whole.events[k].time);
  EXPECT_EQ(last.state.displacement, outcome.state.displacement);
  EXPECT_EQ(last.state.velocity, outcome.state.velocity);
  EXPECT_GT(inside, 20);
}

// Keeps the first sample from a time on, and asks for the end there.
struct FirstSample {
  double at = 0.0;
  std::vector<double> displacement = {};
  double next_time() const {
    return displacement.empty() ? at : std::numeric_limits<double>::infinity();
  }
  void sample(const Moment &moment) {
    displacement = {moment.displacement(1), moment.displacement(2)};
  }
  bool done() const {
    return !displacement.empty();
  }
};

// Wherever that is, also inside a chatter that is carried to its limit: the outcome is the state
// at the sample, to the rounding of a gap that is carried beside the displacement.
TEST(Resume, ARunEndedAtASampleEndsAtThatSample) {
  for (int k = 0; k < 800; ++k) {
    FirstSample sample{700.0 + 0.0617 * (k / 2)};
    const double until = k % 2 == 0 ? 750.0 : sample.at;
    const Outcome outcome = simulate(paper::figure2(), until, {}, sample);
    ASSERT_EQ(outcome.ending, Ending::stopped);
    EXPECT_EQ(outcome.time, sample.at);
    for (std::size_t i = 0; i < 2; ++i)
      EXPECT_NEAR(outcome.state.displacement[i], sample.displacement[i], 1e-14) << sample.at;
  }
}

// To its own time, which rounding may put before it, from where it has just been hit; and from
// where it ended, after 61 periods that, divided by one, are less than 61.
TEST(Resume, ARunToTheTimeOfItsStartEndsAsItStarts) {
  Scene scene = paper::figure2();
  const MotionState left{{7, 1.0}, {0.0, 0.1}, {0.1, -0.5}, {0, 0}};
  const Outcome same = simulate(scene, left, time_of(left.instant, Clock(scene.omega)));
  EXPECT_NEAR(same.state.velocity[1], -0.5, 1e-15);
  scene.omega = 1.4456159370241128;
  const double until = 61.0 * Clock(scene.omega).period;
  EXPECT_EQ(simulate(scene, simulate(scene, until).state, until).ending, Ending::reached);
}

// 1e-11: the rounding of the state at the restart, passed on by some twenty events.
TEST(Resume, AMotionGoesOnFromAnyInstantFreeOrHeld) {
  const Scene scene = paper::figure2();
  const std::vector<Event> whole = events_of(scene, 0.0, 300.0);
  int held = 0;
  for (double t = 200.0; t < 223.0; t += 0.31) {
    const MotionState half = simulate(scene, t).state;
    held += half.held != Held{0, 0};
    const std::vector<Event> after = events_from(scene, half, 300.0);
    for (const EventKind kind : {EventKind::stick, EventKind::release}) {  // impacts may be more
      const auto found = select(after, kind), expected = select(whole, kind, any_mass, t);
      ASSERT_EQ(found.size(), expected.size()) << t;
      for (std::size_t i = 0; i < found.size(); ++i)
        EXPECT_NEAR(found[i].time, expected[i].time, 1e-11) << t;
    }
  }
  EXPECT_GE(held, 5);
}

// A copy inside a chatter goes its own way, and leaves the original where it stands.
TEST(Resume, ACopyDoesNotMoveTheOriginal) {
  Simulation original(paper::figure2());
  require_complete(original.advance(716.0));  // inside the chatter of Figure 2(b)
  Simulation copy = original;
  const Outcome other = copy.advance(750.0);
  const Outcome end = original.advance(750.0);
  EXPECT_EQ(other.state.displacement, end.state.displacement);
  EXPECT_EQ(other.state.velocity, end.state.velocity);
  expect_refused(
      {{[&copy] { require_complete(copy.advance(700.0)); }, "until = 700: lies before the start"}});
}

}  // namespace
