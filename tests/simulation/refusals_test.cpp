// The border of the simulation: every public function refuses bad input, with one line that names
// the value and the rule. A change of what is accepted belongs into these tables.
#include <gtest/gtest.h>

#include <limits>
#include <span>
#include <type_traits>

#include "reference/scenes/paper_scenes.hpp"
#include "tests/support/events.hpp"
#include "tests/support/refusals.hpp"
#include "vibro_impact/vibro_impact.hpp"

namespace {

using namespace vibro_impact;
using vibro_impact::testing::AtEvents;
using vibro_impact::testing::BadCall;
using vibro_impact::testing::expect_refused;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr long long most = std::numeric_limits<long long>::max();

// Starts from the scene of Figure 2 (mass 1 above -0.3, mass 2 below 0.1) and makes one number of
// it wrong.
BadCall bad_scene(void (*change)(Scene &), const char *says) {
  return {[change] {
            Scene scene = paper::figure2();
            change(scene);
            require_complete(simulate(scene, 1.0));
          },
          says};
}

TEST(Refusals, OfScenes) {
  const Scene without_links{.mass = {1.0, 1.0}},
      two_starts{.mass = {1.0}, .stiffness = {1.0}, .displacement = {1.0, 2.0}};
  expect_refused({
      bad_scene([](Scene &s) { s = {}; }, "masses = 0: a chain has at least one mass"),
      bad_scene([](Scene &s) { s.mass[1] = -2.5; }, "mass = -2.5: must be positive and finite"),
      bad_scene([](Scene &s) { s.stiffness = {1.0}; }, "1 values given, the chain has 2 masses"),
      bad_scene([](Scene &s) { s.stiffness[0] = -1.0; }, "link 1 = -1: must be non-negative"),
      bad_scene([](Scene &s) { s.stiffness[1] = 0.0; }, "link 2 = 0: must be positive"),
      bad_scene([](Scene &s) { s.beta = -0.1; }, "beta = -0.1: must be non-negative"),
      bad_scene([](Scene &s) { s.omega = -0.1; }, "omega = -0.1: must be non-negative"),
      bad_scene([](Scene &s) { s.stops[1].restitution = -0.1; }, "restitution = -0.1: must lie"),
      bad_scene([](Scene &s) { s.amplitude = {1.0}; }, "amplitude: 1 values given"),
      bad_scene([](Scene &s) { s.sine = {1.0}; }, "sine: 1 values given, the chain has 2"),
      bad_scene([](Scene &s) { s.ground.assign(2, -1.0); }, "ground = -1: must be non-negative"),
      bad_scene([](Scene &s) { s.displacement.assign(2, 0.2); }, "beyond its upper stop at 0.1"),
      bad_scene([](Scene &s) { s.stops[0].mass = 0; }, "stop on mass 0: the chain has masses 1"),
      bad_scene([](Scene &s) { s.stops[0].side = Side{9}; }, "side = 9: must be lower (-1) or"),
      bad_scene([](Scene &s) { s.stops.push_back(s.stops[0]); }, "two stops on the same side"),
      bad_scene(
          [](Scene &s) {
            s.stops[1] = {1, Side::upper, -0.4};
          },
          "the lower must lie below"),
      bad_scene(
          [](Scene &s) {
            s.stops[1] = {1, Side::upper, -0.3};  // where the lower one is
          },
          "the lower must lie below"),
      bad_scene([](Scene &s) { s.mass[0] = 1e-310; }, "rate = inf"),
      bad_scene([](Scene &s) { s.beta = 1e200; }, "and its square, must be finite"),
      {[&] { check(without_links); }, "0 values given, the chain has 2"},
      {[&] { start_of(two_starts); }, "displacement: 2 values given"},
  });
  Scene free_chain = paper::figure2();
  free_chain.stiffness[0] = 0.0;
  free_chain.stops[1].restitution = 0.25;
  EXPECT_NO_THROW(check(free_chain));
}

BadCall bad_start(void (*change)(MotionState &), const char *says) {
  return {[change] {
            MotionState start = start_of(paper::figure2());
            change(start);
            require_complete(Simulation(paper::figure2(), start).advance(10.0));
          },
          says};
}

TEST(Refusals, OfStarts) {
  expect_refused({
      bad_start([](MotionState &s) { s.displacement.pop_back(); }, "displacement: 1 values given"),
      bad_start([](MotionState &s) { s.velocity.push_back(0.0); }, "velocity: 3 values given"),
      bad_start([](MotionState &s) { s.velocity[1] = nan; }, "velocity = nan: must be finite"),
      bad_start([](MotionState &s) { s.displacement[0] = -0.31; },
                "mass 1 at -0.31, beyond its lower stop"),
      bad_start([](MotionState &s) { s.held[0] = 1; }, "mass 1 held as 1: it has no such stop"),
      bad_start([](MotionState &s) { s.held.pop_back(); }, "contact mode of 1 masses given"),
      bad_start([](MotionState &s) { s.held[0] = -1; }, "held at its lower stop at -0.3, and"),
      bad_start(
          [](MotionState &s) {
            s.displacement[0] = -0.3;
            s.velocity[0] = 1.0;
            s.held[0] = -1;
          },
          "held at its lower stop at -0.3, and stands at -0.3 with velocity 1"),
      bad_start([](MotionState &s) { s.instant.phase = 1e3; }, "phase = 1000 in period 0: must"),
      bad_start([](MotionState &s) { s.instant.phase = nan; }, "phase = nan in period 0: must"),
      bad_start([](MotionState &s) { s.instant.cycle = -1; }, "in period -1: must lie in"),
      bad_start([](MotionState &s) { s.instant.cycle = most; }, "more forcing periods than"),
  });
}

TEST(Refusals, OfTimesAndOptions) {
  const Scene scene = paper::figure2();
  const Scene undamped{.mass = {1.0}, .stiffness = {0.5}};  // the bound of its rate is 1
  const Scene hardly_damped{.mass = {1.0}, .stiffness = {0.5}, .beta = 1e-30};
  const char *const swings_on = "rate = 1 of a chain that swings on";
  const Instant last_period{most, 0.0};
  const MotionState at_fifty = simulate(scene, 50.0).state;
  const auto until = [&scene](double end) {
    return [&scene, end] { require_complete(simulate(scene, end)); };
  };
  const auto with = [&scene](RunOptions options) {
    return [&scene, options] { require_complete(simulate(scene, 1.0, options)); };
  };
  expect_refused({
      {until(infinity), "until = inf: must be finite"},
      {until(-1.0), "until = -1: lies before the start at 0"},
      {until(1e300), "time 1e+300: more forcing periods than double precision can count"},
      {[&] { require_complete(Simulation(scene, at_fifty).advance(49.0)); },
       "until = 49: lies before the start"},
      {[&] { require_complete(simulate(undamped, 1.001e12)); }, swings_on},
      {[&] { require_complete(simulate(hardly_damped, 1.001e12)); }, swings_on},
      {with({.limit_below_speed = nan}), "limit_below_speed = nan: must be non-negative"},
      {with({.chatter_tolerance = nan}), "chatter_tolerance = nan: must lie between"},
      {with({.flight_tolerance = 1.0}), "flight_tolerance = 1: must lie between 0 and 1"},
      {with({.flight_tolerance = 1e-22}), "flight_tolerance = 1e-22: must be at least 1e-21"},
      {with({.max_steps = 0}), "max_steps = 0: must be positive"},
      {[] { Clock(-1.0); }, "omega = -1: must be non-negative and finite"},
      {[] { Clock(1e-320); }, "with a finite period"},
      {[&] { later(last_period, 20.0, Clock(1.0)); }, "time 20: more forcing periods than"},
      {[] { later({}, infinity, Clock(0.0)); }, "time inf: more forcing periods than"},
  });
  EXPECT_EQ(simulate(scene, 1.0, {.max_steps = most}).ending, Ending::reached);
  // Its amplitude falls by e^-37 in 8.6e11 radians.
  const Scene damped{.mass = {1.0}, .stiffness = {0.5}, .beta = 2e-10};
  EXPECT_EQ(simulate(damped, 2e12).ending, Ending::reached);
}

static_assert(!std::is_reference_v<decltype(require_complete(simulate(Scene{}, 0.0)))>);

TEST(Refusals, OfMotionsBeyondTheRangeOfDoubles) {
  const Scene leaving{.mass = {1.0}, .stiffness = {0.0}, .velocity = {1e304}};
  Scene hitting = leaving, faster = leaving;
  hitting.stops = {{1, Side::upper, 1e200}};
  faster.velocity = {1e306};
  for (const Scene &scene : {leaving, hitting}) {
    EXPECT_EQ(simulate(scene, 5.0).ending, Ending::reached);
    EXPECT_EQ(simulate(scene, 1e5).ending, Ending::given_up);
  }
  EXPECT_EQ(simulate(faster, 1.0).ending, Ending::given_up);
  // The first impact follows after 1e-156 of the first step, whose square underflows.
  const Scene struck{.mass = {1.9e-143},
                     .stiffness = {6.7e-153},
                     .amplitude = {2.35e104},
                     .omega = 3e-16,
                     .restitution = 0.11,
                     .stops = {{1, Side::upper, 6.2e-56}}};
  EXPECT_EQ(simulate(struck, 100.0).ending, Ending::given_up);
}

// Asks at an event for a time before it.
struct GoesBack : Recorder {
  double to;
  double at = 10.0;
  explicit GoesBack(double time) : to(time) {
  }
  double next_time() const override {
    return at;
  }
  void sample(const Moment &) override {
    at += 1.0;
  }
  void event(const Event &event, const Moment &) override {
    if (event.time > 15.0) at = to;
  }
};

template <class OneRecorder>
BadCall recorded_by(const OneRecorder &recorder, const char *says) {
  return {[recorder] {
            OneRecorder mine = recorder;
            require_complete(simulate(paper::figure2(), 60.0, mine));
          },
          says};
}

TEST(Refusals, OfRecorders) {
  const Scene scene = paper::figure2();
  const MotionState later = simulate(scene, 50.0).state;
  SampleRecorder early{10.0, 60.0, 1.0};
  const AtEvents asks_for_mass_five(
      [](const Event &, const Moment &moment) { return moment.hold_force(5) > 0.0; });
  expect_refused({
      recorded_by(EventRecorder{nan}, "from = nan: must be a time"),
      recorded_by(SampleRecorder{0.0, 10.0, -1.0}, "every = -1: must be positive and finite"),
      recorded_by(SampleRecorder{0.0, infinity, 1.0}, "samples from 0 to inf: must be finite"),
      recorded_by(SampleRecorder{-1.0, 10.0, 1.0}, "sample at t = -1: the run begins at 0"),
      recorded_by(SampleRecorder{0.1, 10.0, 1e-300}, "every = 1e-300: must exceed the spacing"),
      recorded_by(SampleRecorder{5e9, 5e9 + 1e-6, 1e-7}, "every = 1e-07: must exceed the spacing"),
      recorded_by(GoesBack(12.0), "next_time = 12: lies before the motion"),
      recorded_by(GoesBack(nan), "next_time = nan: must be a time"),
      recorded_by(asks_for_mass_five, "mass 5: the chain has masses 1 to 2"),
      {[&] { require_complete(Simulation(scene, later).advance(60.0, early)); },
       "sample at t = 10: the run begins at 5"},
  });
  EXPECT_FALSE(std::is_copy_constructible_v<Moment>);
  EXPECT_FALSE(std::is_move_constructible_v<Moment>);
}

}  // namespace
