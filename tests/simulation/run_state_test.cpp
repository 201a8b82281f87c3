// The state of a run as text: what `save` writes, `load` gives back, and a text that is damaged or
// contradicts itself or its scene is refused with one line.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "reference/scenes/paper_scenes.hpp"
#include "vibro_impact/simulate.hpp"

namespace {

using namespace vibro_impact;

std::vector<double> times_of(const EventRecorder &recorder) {
  std::vector<double> times;
  for (const Event &event : recorder.events) times.push_back(event.time);
  return times;
}

// Between any two events, so in every chatter too, the state goes through text and back.
TEST(RunState, ARunSavedAndLoadedAnywhereGoesOnBitForBit) {
  const Scene scene = paper::figure2();
  EventRecorder whole, parts;
  const Outcome outcome = simulate(scene, 60.0, {}, whole);
  ASSERT_GT(whole.events.size(), 80u);
  RunState state = simulate(scene, 0.0, {}, parts).resume;
  int inside = 0;  // a chatter
  for (std::size_t k = 1; k < whole.events.size(); ++k) {
    const double between = (whole.events[k - 1].time + whole.events[k].time) / 2;
    state = resume(scene, state, between, {}, parts).resume;
    const std::string text = save(state);
    state = load(scene, text);
    ASSERT_EQ(save(state), text);
    inside += text.find("chatter_times 0") != text.npos;
  }
  const Outcome last = resume(scene, state, 60.0, {}, parts);
  EXPECT_EQ(times_of(parts), times_of(whole));
  EXPECT_EQ(last.state.displacement, outcome.state.displacement);
  EXPECT_EQ(last.state.velocity, outcome.state.velocity);
  EXPECT_EQ(save(last.resume), save(outcome.resume));
  EXPECT_GT(inside, 20);
}

// What `load` or another call says of it, or "" where it takes it.
template <class Call>
std::string refusal(const Call &call) {
  try {
    call();
  } catch (const std::invalid_argument &error) {
    return error.what();
  }
  return "";
}

// The text with the line that begins with `key` replaced.
std::string with_line(const std::string &text, const std::string &key, const std::string &line) {
  const std::size_t begin = key.empty() ? 0 : text.find("\n" + key) + 1;
  return text.substr(0, begin) + line + text.substr(text.find('\n', begin));
}

TEST(RunState, ATextThatIsDamagedOrContradictsItselfIsRefused) {
  const Scene scene = paper::figure2();
  EventRecorder events;
  simulate(scene, 38.0, {}, events);
  // Half way between two impacts of a chatter.
  std::size_t k = 0;
  while (events.events[k].falling < 4) ++k;
  const double between = (events.events[k - 1].time + events.events[k].time) / 2;
  const std::string good = save(simulate(scene, between).resume);
  ASSERT_EQ(refusal([&] { load(scene, good); }), "");
  for (std::size_t length = 0; length < good.size(); ++length)
    ASSERT_NE(refusal([&] { load(scene, good.substr(0, length)); }), "") << length;
  const std::pair<std::string, const char *> cases[] = {
      {"", "line 1: cut short"},
      {good + "more\n", "something follows its last line"},
      {with_line(good, "", "vibro-impact run state 9"), "'vibro-impact run state"},
      {with_line(good, "instant", "instant 0.5 0"), "'0.5' is not a number of its kind"},
      {with_line(good, "instant", "instant 0"), "line 2: fewer numbers than expected"},
      {with_line(good, "instant", "instant 0 0 0"), "line 2: more than expected"},
      {with_line(good, "instant", "instant -1 0"), "period -1"},
      {with_line(good, "instant", "instant 0 1"), "the forcing has another phase"},
      {with_line(good, "held", "held 0 2"), "mass 2 held as 2"},
      {with_line(good, "held", "held 1 1"), "it has no such stop"},
      {with_line(good, "held", "held 0"), "the contact mode of 1 masses"},
      {with_line(good, "values", "values 1"), "1 and 4 modal coordinates given"},
      {with_line(good, "values", "values 1 inf 0 0"), "not finite"},
      {with_line(good, "stops", "stops 0 0.04 0 1 2 0 0 0 0.4 0 0 0 0 0 0 0"), "2 zeros"},
      {with_line(good, "stops", "stops 0 0.04 0 0 0 0 -1 0 0.4 0 0 0 0 0 0 0"), "the latest at -1"},
      {with_line(good, "stops", "stops 0 0.04 0 0 0 0 1 -1 0.4 0 0 0 0 0 0 0"), "-1 falling"},
      {with_line(good, "stops", "stops 0 0.04 0 0 0 0 0 0 0.2 0 0 0 0 0 0 0"),
       "gap = 0.2 at stop 2"},
      {with_line(good, "stops", "stops 0 0 0 0 0 0 0 0"), "1 stops given, the scene has 2"},
      {with_line(good, "next_flight", "next_flight -1"), "next flight -1"},
      {with_line(good, "next_flight", "next_flight nan"), "next flight nan"},
      {with_line(good, "clear", "clear 2"), "2 is neither 0 nor 1"},
      {with_line(good, "window", "window 0 0 -1"), "-1 impacts"},
      {with_line(good, "window", "window 99 0 0"), "counted from a later time"},
      {with_line(good, "chatter_contacts", "chatter_contacts 7"), "no free mass comes to"},
      {with_line(good, "chatter_times", "chatter_times"), "the impacts of a chatter"},
      {with_line(good, "chatter_jumps", "chatter_jumps -1"), "the impacts of a chatter"},
      {with_line(good, "chatter_flight", "chatter_flight 1 -1"), "the impacts of a chatter"},
      {with_line(good, "chatter_nodes", "chatter_nodes 1 1"), "fewer numbers"},
      {with_line(good, "chatter_nodes", "chatter_nodes 1 1 99"), "the impacts of a chatter"},
  };
  for (const auto &[text, names] : cases) {
    const std::string refused = refusal([&] { load(scene, text); });
    EXPECT_NE(refused.find(names), std::string::npos) << names << ": '" << refused << "'\n" << text;
    EXPECT_EQ(refused.find('\n'), std::string::npos);
  }
  EXPECT_NE(refusal([&] { save({}); }), "");
  EXPECT_NE(refusal([&] { resume(scene, {}, 1.0); }), "");
}

}  // namespace
