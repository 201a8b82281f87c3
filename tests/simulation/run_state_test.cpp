// The state of a run as text: what `save` writes, `load` gives back, and a text that is damaged or
// of another scene is refused with one line.
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
    inside += whole.events[k].falling > 0;
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

TEST(RunState, ATextThatIsDamagedOrOfAnotherSceneIsRefused) {
  const Scene scene = paper::figure2();
  EventRecorder events;
  simulate(scene, 38.0, {}, events);
  // Half way between two impacts of a chatter.
  std::size_t k = 0;
  while (events.events[k].falling < 4) ++k;
  const double between = (events.events[k - 1].time + events.events[k].time) / 2;
  const std::string good = save(simulate(scene, between).resume);
  ASSERT_EQ(refusal([&] { load(scene, good); }), "");
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

  Scene one = scene, faster = scene, moved = scene, three = scene;
  one.stops.pop_back();
  faster.omega *= 1.01;
  moved.stops[1].position += 0.01;
  three.mass.push_back(1.0);
  three.stiffness.push_back(1.0);
  three.amplitude.push_back(0.0);
  for (const auto &[other, names] : {std::pair{one, "2 stops given, the scene has 1"},
                                     {faster, "the forcing has another phase"},
                                     {moved, "at stop 2"},
                                     {three, "the contact mode of 2 masses"}}) {
    const std::string why = refusal([&] { load(other, good); });
    EXPECT_NE(why.find(names), why.npos) << names << ": '" << why << "'";
  }
  EXPECT_NE(refusal([&] { save({}); }), "");
  EXPECT_NE(refusal([&] { resume(scene, {}, 1.0); }), "");
}

}  // namespace
