// A run that ended, wherever that was, goes on: in full from the state of the run, to rounding from
// its motion.
#include <gtest/gtest.h>

#include <limits>
#include <vector>

#include "reference/scenes/paper_scenes.hpp"
#include "tests/events.hpp"

namespace {

using namespace vibro_impact;
using namespace vibro_impact::testing;

// Ends the run at the n-th event.
struct FirstEvents {
  std::size_t wanted;
  std::vector<double> times = {};

  void event(const Event &event, const Moment &) {
    times.push_back(event.time);
  }
  bool done() const {
    return times.size() >= wanted;
  }
};

// Wherever a recorder ends it, also in the middle of a chatter and of an instant.
TEST(Resume, ARunThatARecorderEndsGoesOnAsIfItHadNot) {
  const Scene scene = paper::figure2();
  FirstEvents all{100000};
  simulate(scene, 100.0, {}, all);
  ASSERT_GT(all.times.size(), 100u);
  for (std::size_t n = 1; n < all.times.size(); n += 3) {
    FirstEvents first{n}, rest{100000};
    const Outcome stopped = simulate(scene, 100.0, {}, first);
    EXPECT_EQ(stopped.ending, Ending::stopped);
    EXPECT_EQ(stopped.time, first.times.back());
    resume(scene, stopped.resume, 100.0, {}, rest);
    first.times.insert(first.times.end(), rest.times.begin(), rest.times.end());
    EXPECT_EQ(first.times, all.times) << n;
  }
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
  for (int k = 0; k < 400; ++k) {
    FirstSample sample{700.0 + 0.0617 * k};
    const Outcome outcome = simulate(paper::figure2(), 750.0, {}, sample);
    ASSERT_EQ(outcome.ending, Ending::stopped);
    EXPECT_EQ(outcome.time, sample.at);
    for (std::size_t i = 0; i < 2; ++i)
      EXPECT_NEAR(outcome.state.displacement[i], sample.displacement[i], 1e-14) << sample.at;
  }
}

// 1e-11: the rounding of the state at the restart, passed on by some twenty events.
TEST(Resume, AMotionGoesOnFromAnyInstantFreeOrHeld) {
  const Scene scene = paper::figure2();
  // Sticks and releases: a restart may resolve more impacts.
  const auto holds = [](const std::vector<Event> &events, double from) {
    std::vector<Event> found = select(events, EventKind::stick, any_mass, from);
    for (const Event &event : select(events, EventKind::release, any_mass, from))
      found.push_back(event);
    return found;
  };
  const std::vector<Event> whole = events_of(scene, 0.0, 300.0);
  int held = 0;
  for (double t = 200.0; t < 223.0; t += 0.31) {
    const MotionState half = simulate(scene, t).state;
    held += half.held != Held{0, 0};
    const auto found = holds(events_from(scene, half, 300.0), 0.0), expected = holds(whole, t);
    ASSERT_EQ(found.size(), expected.size()) << t;
    for (std::size_t i = 0; i < found.size(); ++i)
      EXPECT_NEAR(found[i].time, expected[i].time, 1e-11) << t;
  }
  EXPECT_GE(held, 5);
}

}  // namespace
