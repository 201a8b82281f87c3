// A run that ended, wherever that was, goes on: in full from the state of the run, to rounding from
// its motion; a state as text that is damaged or of another scene is refused.
#include <gtest/gtest.h>

#include <boost/crc.hpp>
#include <limits>
#include <string>
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

// In parts that end between two events and, by a recorder, at one, so in every chatter too; the
// state goes through text and back.
TEST(Resume, ARunInPartsSavedAndLoadedGoesOnBitForBit) {
  const Scene scene = paper::figure2();
  EventRecorder whole, parts;
  const Outcome outcome = simulate(scene, 100.0, {}, whole);
  ASSERT_GT(whole.events.size(), 100u);
  RunState state = simulate(scene, 0.0, {}, parts).resume;
  int inside = 0;  // a chatter
  for (std::size_t k = 1; k < whole.events.size(); ++k) {
    const double before = whole.events[k - 1].time, here = whole.events[k].time;
    state = resume(scene, state, (before + here) / 2, {}, parts).resume;
    const std::string text = save(state);
    state = load(scene, text);
    ASSERT_EQ(save(state), text);
    inside += whole.events[k].falling > 0;
    NextEvent next;
    const Outcome part = resume(scene, state, 100.0, {}, parts, next);
    EXPECT_EQ(part.ending, Ending::stopped);
    EXPECT_EQ(part.time, here);
    state = part.resume;
  }
  const Outcome last = resume(scene, state, 100.0, {}, parts);
  ASSERT_EQ(parts.events.size(), whole.events.size());
  for (std::size_t k = 0; k < parts.events.size(); ++k)
    EXPECT_EQ(parts.events[k].time, whole.events[k].time);
  EXPECT_EQ(last.state.displacement, outcome.state.displacement);
  EXPECT_EQ(last.state.velocity, outcome.state.velocity);
  EXPECT_EQ(save(last.resume), save(outcome.resume));
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
  const Outcome same = simulate_from(scene, left, time_of(left.instant, Clock(scene.omega)));
  EXPECT_NEAR(same.state.velocity[1], -0.5, 1e-15);
  scene.omega = 1.4456159370241128;
  const double until = 61.0 * Clock(scene.omega).period;
  EXPECT_EQ(simulate_from(scene, simulate(scene, until).state, until).ending, Ending::reached);
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

// These numbers under a checksum that fits.
std::string with_checksum(const std::string &numbers) {
  boost::crc_32_type checksum;
  checksum.process_bytes(numbers.data(), numbers.size());
  return "vibro-impact run state 4, checksum " + std::to_string(checksum.checksum()) + "\n" +
         numbers;
}

// The text of a state at the last impact of a chatter before its limit, whose nodes it is taken by.
std::string saved_in_a_chatter(const Scene &scene) {
  EventRecorder events;
  simulate(scene, 38.0, {}, events);
  std::size_t k = 0;
  while (events.events[k].falling < 4 || events.events[k + 1].kind != EventKind::stick) ++k;
  return save(simulate(scene, (events.events[k].time + events.events[k + 1].time) / 2).resume);
}

TEST(Resume, ATextThatIsDamagedOrOfAnotherSceneIsRefused) {
  const Scene scene = paper::figure2();
  const std::string good = saved_in_a_chatter(scene);
  load(scene, good);
  const auto refused = [&](const std::string &text) {
    const std::string why = refusal([&] { load(scene, text); });
    return why.find("cut short or changed") != why.npos && why.find('\n') == why.npos;
  };
  for (std::size_t length = 0; length < good.size(); ++length)
    ASSERT_TRUE(refused(good.substr(0, length))) << length;
  for (std::size_t at = 0; at < good.size(); ++at) {
    std::string changed = good;
    changed[at] = changed[at] == '7' ? '8' : '7';
    ASSERT_TRUE(refused(changed)) << at;
  }
  EXPECT_TRUE(refused(good + "more\n"));
  // Under a checksum that fits: no numbers, too few, too many, a list that cannot be so long.
  const std::string body = good.substr(good.find('\n') + 1);
  for (const std::string &other : {std::string(), body.substr(0, body.find('\n') + 1), body + "1\n",
                                   std::string("0\n0\n9999999999999\n")})
    EXPECT_TRUE(refused(with_checksum(other)));

  Scene one = scene, unforced = scene, faster = scene, moved = scene, three = scene;
  one.stops.pop_back();
  unforced.amplitude = {0.0, 0.0};
  faster.omega *= 1.01;
  moved.stops[1].position += 0.01;
  three.mass.push_back(1.0);
  three.stiffness.push_back(1.0);
  three.amplitude.push_back(0.0);
  expect_refused({
      {[&] { load(one, good); }, "2 stops given, the scene has 1"},
      {[&] { load(unforced, good); }, "modal coordinates given"},
      {[&] { load(faster, good); }, "the forcing has another phase"},
      {[&] { load(moved, good); }, "at stop 2"},
      {[&] { load(three, good); }, "the contact mode of 2 masses"},
      {[] { save({}); }, "state of a run: none"},
      {[&] { resume(scene, {}, 1.0); }, "state of a run: none"},
  });
}

// One number after another replaced, under a checksum that fits: refused, or a state that a run
// goes on from without looking beyond what is stored (the sanitizers watch).
TEST(Resume, FromNumbersThatContradictEachOtherLeadsNowhereElse) {
  const Scene scene = paper::figure2();
  const std::string good = saved_in_a_chatter(scene);
  int refused = 0, taken = 0;
  for (std::size_t at = good.find('\n') + 1; at < good.size(); at = good.find('\n', at) + 1)
    for (const char *number : {"-1", "0", "3", "1e300", "nan", "2000000000"}) {
      std::string numbers = good.substr(good.find('\n') + 1);
      const std::size_t here = at - (good.size() - numbers.size());
      numbers.replace(here, numbers.find('\n', here) - here, number);
      const std::string text = with_checksum(numbers);
      SCOPED_TRACE(::testing::Message() << number << " in place of the number at " << here);
      const std::string why = refusal(
          [&] { resume(scene, load(scene, text), 40.0, {.max_impacts_per_period = 1000}); });
      EXPECT_EQ(why.find('\n'), why.npos);
      ++(why == "accepted" ? taken : refused);
    }
  EXPECT_GT(refused, 100);
  EXPECT_GT(taken, 50);
}

}  // namespace
