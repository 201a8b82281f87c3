// The border of the library: every public input is checked, with one line that names the value and
// the rule; a run that ends early says why and can be taken up again.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <type_traits>

#include "reference/scenes/paper_scenes.hpp"
#include "vibro_impact/vibro_impact.hpp"

namespace {

using namespace vibro_impact;

// The message of the refusal; empty where there is none.
std::string refusal(const std::function<void()> &call) {
  try {
    call();
  } catch (const std::invalid_argument &bad) {
    return bad.what();
  }
  return "";
}

void expect_refused(const std::function<void()> &call, const std::string &part) {
  const std::string message = refusal(call);
  EXPECT_NE(message.find(part), std::string::npos) << "'" << message << "' for '" << part << "'";
  EXPECT_EQ(message.find('\n'), std::string::npos);
}

TEST(Border, ARunNeedsNoMoreThanASceneAndATime) {
  EXPECT_EQ(simulate(paper::figure2(), 30.0).ending, Ending::reached);
}

TEST(Border, AMomentCannotBeKept) {
  EXPECT_FALSE(std::is_copy_constructible_v<Moment>);
  EXPECT_FALSE(std::is_move_constructible_v<Moment>);
}

TEST(Border, StartsAreChecked) {
  const Scene scene = paper::figure2();  // stops: mass 1 lower at -0.3, mass 2 upper at 0.1
  const auto refused = [&](const std::function<void(MotionState &)> &spoil, const char *part) {
    MotionState start = start_of(scene);
    spoil(start);
    expect_refused([&] { simulate_from(scene, start, 10.0); }, part);
  };
  refused([](MotionState &s) { s.displacement.pop_back(); }, "1 values of the displacement, not 2");
  refused([](MotionState &s) { s.velocity.push_back(0.0); }, "3 values of the velocity, not 2");
  refused([](MotionState &s) { s.velocity[1] = NAN; }, "velocity = nan: must be finite");
  refused([](MotionState &s) { s.displacement[0] = -0.31; },
          "mass 1 at -0.31, beyond its lower stop");
  refused([](MotionState &s) { s.held = {1, 0}; }, "mass 1 held as 1: it has no such stop");
  refused([](MotionState &s) { s.held = {0}; }, "contact mode of 1 masses given");
  refused(
      [](MotionState &s) {
        s.held = {-1, 0};
      },
      "held at its lower stop at -0.3, and stands at 0");
  refused([](MotionState &s) { s.instant.phase = 1e3; }, "phase = 1000 in period 0: must lie in");
}

TEST(Border, TimesAreChecked) {
  const Scene scene = paper::figure2();
  const double infinity = std::numeric_limits<double>::infinity();
  for (const double until : {infinity, -infinity, std::numeric_limits<double>::quiet_NaN()})
    expect_refused([&] { simulate(scene, until); }, "must be finite");
  expect_refused([&] { simulate(scene, -1.0); }, "until = -1: lies before the start at 0");
  expect_refused([&] { simulate(scene, 1e300); }, "more forcing periods than");
  const MotionState later = simulate(scene, 50.0).state;
  expect_refused([&] { simulate_from(scene, later, 49.0); }, "until = 49: lies before the start");
}

TEST(Border, RecordersAreChecked) {
  const Scene scene = paper::figure2();
  ImpactSpeedRecorder third{3, 0.0};
  expect_refused([&] { simulate(scene, 10.0, {}, third); }, "mass 3: the chain has masses 1 to 2");
  HoldForceRecorder none{0, 0.0, 10.0, 0.1};
  expect_refused([&] { simulate(scene, 10.0, {}, none); }, "mass 0: the chain has masses 1 to 2");
  for (const double every : {0.0, -1.0, std::nan("")}) {
    SampleRecorder samples{0.0, 10.0, every};
    expect_refused([&] { simulate(scene, 10.0, {}, samples); }, "must be positive and finite");
  }
  const MotionState later = simulate(scene, 50.0).state;
  SampleRecorder early{10.0, 60.0, 1.0};
  expect_refused([&] { simulate_from(scene, later, 60.0, {}, early); }, "sample at t = 10");
  struct AsksForMassFive {
    void event(const Event &, const Moment &moment) {
      moment.displacement(5);
    }
  } asks;
  expect_refused([&] { simulate(scene, 10.0, {}, asks); }, "mass 5: the chain has masses 1 to 2");
}

TEST(Border, OptionsAreChecked) {
  const Scene scene = paper::figure2();
  expect_refused([&] { simulate(scene, 1.0, {.resolve_chatter = -1.0}); }, "resolve_chatter = -1");
  expect_refused([&] { simulate(scene, 1.0, {.max_impacts_per_period = 0}); }, "must be positive");
}

TEST(Border, StopsInTheWrongOrderAreNamedBeforeTheStart) {
  Scene scene = paper::figure2();
  scene.stops = {{1, Side::lower, 0.1}, {1, Side::upper, -0.1}};
  expect_refused([&] { check(scene); }, "the lower must lie below the upper");
}

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
TEST(Border, ARunThatARecorderEndsGoesOnAsIfItHadNot) {
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

TEST(Border, AStateOfAnotherSceneIsRefused) {
  const RunState state = simulate(paper::figure2(), 50.0).resume;
  Scene other = paper::figure2();
  other.stops.pop_back();
  expect_refused([&] { resume(other, state, 60.0); }, "2 stops given, the scene has 1");
  other = paper::figure2();
  other.amplitude = {0.0, 0.0};
  expect_refused([&] { resume(other, state, 60.0); }, "modal coordinates given");
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
TEST(Border, ARunEndedAtASampleEndsAtThatSample) {
  for (int k = 0; k < 400; ++k) {
    FirstSample sample{700.0 + 0.0617 * k};
    const Outcome outcome = simulate(paper::figure2(), 750.0, {}, sample);
    ASSERT_EQ(outcome.ending, Ending::stopped);
    EXPECT_EQ(outcome.time, sample.at);
    for (std::size_t i = 0; i < 2; ++i)
      EXPECT_NEAR(outcome.state.displacement[i], sample.displacement[i], 1e-14) << sample.at;
  }
}

// A plastic stop and an elastic one in the same scene; the law is that of the stop that is hit.
TEST(Border, EveryStopHasItsOwnRestitution) {
  Scene scene = paper::figure2();
  scene.stops[0].restitution = 0.0;
  scene.stops[1].restitution = 0.9;
  EventRecorder recorder;
  simulate(scene, 100.0, {}, recorder);
  int impacts = 0;
  for (const Event &event : recorder.events) {
    EXPECT_EQ(scene.stops[event.stop].mass, event.mass);
    if (event.kind != EventKind::impact) continue;
    ++impacts;
    EXPECT_EQ(event.velocity_after, -(event.mass == 1 ? 0.0 : 0.9) * event.velocity_before);
  }
  EXPECT_GT(impacts, 20);
  scene.stops[1].restitution = 1.1;
  expect_refused([&] { check(scene); }, "restitution = 1.1: must lie in [0, 1]");
}

// A ball of mass 2 dropped from h: impacts at sqrt(2 h / g) (1 + r) / (1 - r) in the limit.
TEST(Border, AFreeMassUnderAConstantForceBouncesToRest) {
  for (const double r : {0.2, 0.5, 0.9}) {
    Scene ball;
    ball.mass = {2.0};
    ball.stiffness = {0.0};
    ball.amplitude = {-2.0 * 9.81};
    ball.omega = 0.0;
    ball.restitution = r;
    ball.displacement = {1.5};
    ball.stops = {{1, Side::lower, 0.0}};
    EventRecorder recorder;
    const Outcome outcome = simulate(ball, 1e9, {}, recorder);
    const double exact = std::sqrt(3.0 / 9.81) * (1.0 + r) / (1.0 - r);
    EXPECT_EQ(recorder.events.back().kind, EventKind::stick);
    EXPECT_NEAR(recorder.events.back().time / exact, 1.0, 1e-14);  // rounding of thirty impacts
    EXPECT_LT(outcome.counters.expansions, 60);
  }
  Scene chain = paper::figure2();
  chain.stiffness = {1.0, 0.0};
  expect_refused([&] { check(chain); }, "stiffness of link 2 = 0: must be positive");
}

}  // namespace
