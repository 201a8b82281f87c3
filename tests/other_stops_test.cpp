// What else may happen while a mass chatters: another mass arrives at its stop, a held one is
// released. The chatter is followed up to there, whether that was near or out of reach at first.
#include <gtest/gtest.h>

#include "followed_chatter.hpp"
#include "random_scenes.hpp"

namespace {

using namespace vibro_impact;
using vibro_impact::testing::dynamic, vibro_impact::testing::Followed,
    vibro_impact::testing::Pressed;

// The third mass on its way to its stop, `gap` off, at this speed.
Pressed with_a_mass_under_way(double restitution, double gap, double speed) {
  Pressed at(0.1, 0.3, restitution);
  at.scene.stops[1].position = 0.6 + gap;
  at.mode = build_contact_mode<dynamic>(at.scene, Held(3, 0));
  MotionState motion = start_of(at.scene);
  motion.displacement << 0.7, 0.1, 0.6;
  motion.velocity << 0.05, -0.06, speed;
  motion.instant.phase = 0.3;
  set_lanes(at.state, at.scene, at.mode, motion);
  at.state.stops = {{0.0, 0.06, 1, 0.06}, {gap, -speed, 0, 0.0}};
  return at;
}

// Impacts before the other stop is looked at, -1 where it never is.
int follow_to_the_end(Followed &followed) {
  int first_look = -1;
  for (int k = 0; followed.find(); ++k) {
    if (k > 200) {
      ADD_FAILURE() << "no end";
      break;
    }
    if (first_look < 0 && !followed.bounces.near.empty()) {
      first_look = k;
      const auto &near = followed.bounces.near[0];
      const State<dynamic> &now = followed.at.state;
      EXPECT_NEAR(near.gap.coefficient[0], near.open->gap(now.value, now.slope), 2e-14);
    }
    followed.apply();
  }
  return first_look;
}

// The next event after the last impact followed is the arrival, and it lies before the next impact.
void expect_the_arrival(Pressed &at, const Followed &followed) {
  refresh_stops(followed.bounces, at.state);
  EXPECT_NEAR(at.state.stops[1].gap, at.mode.open[1].gap(at.state.value, at.state.slope), 2e-14);
  Flight<dynamic> flight;
  expand(at.mode, at.state.value, at.state.slope, 1.0 / at.mode.fastest, flight.expansion,
         at.counters);
  find_first_event(at.state, at.scene, Clock(at.scene.omega), flight, at.counters);
  EXPECT_EQ(flight.event.kind, Happening::impact);
  EXPECT_EQ(flight.event.stops, std::vector<std::size_t>{1});
}

TEST(OtherStops, EndAChatterWhereAMassArrives) {
  int limits = 0, looked_at = 0;
  for (const double gap : {0.0001, 0.005, 0.01, 0.02, 0.025, 0.03, 0.035}) {
    SCOPED_TRACE(gap);
    Pressed at = with_a_mass_under_way(0.7, gap, 0.2);
    Followed followed(at);
    looked_at += follow_to_the_end(followed) >= 0;
    expect_the_arrival(at, followed);
    // The limit lies beyond, and is not taken however well it is known.
    if (const auto limit = extrapolate(followed.table, at.mode.fastest, 1e9)) {
      Tail<dynamic> tail;
      find_tail(followed.bounces, at.state, followed.table, *limit, tail, at.counters);
      EXPECT_FALSE(undisturbed(followed.bounces, at.state, tail, at.counters));
      ++limits;
    }
  }
  EXPECT_GE(limits, 2);
  EXPECT_GE(looked_at, 4);
}

// With r = 0.95 a chatter lasts twenty flights: the stop is out of reach for some of them, its gap
// not carried on, and then comes near.
TEST(OtherStops, AreReadAfreshWhenTheyComeNear) {
  int late = 0;
  for (const double gap : {0.1, 0.15, 0.2, 0.25, 0.3, 0.35}) {
    SCOPED_TRACE(gap);
    Pressed at = with_a_mass_under_way(0.95, gap, 0.6);
    Followed followed(at);
    late += follow_to_the_end(followed) > 0;
    expect_the_arrival(at, followed);
  }
  EXPECT_GE(late, 3);
}

// The third mass held, by a force of `slack` that the forcing reduces; every impact of the second
// one takes a jump off it, which the damper between them passes on.
Pressed with_a_held_mass(double beta, double restitution, double slack) {
  Pressed at(beta, 1.2, restitution);
  at.scene.amplitude[2] = 1.0;
  const double stiffness = at.scene.stiffness[2];
  const double pulled = std::cos(1.2 * 0.3) - beta * stiffness * at.speed - slack;
  const double position = 0.1 + pulled / stiffness;
  at.scene.stops[1].position = position;
  Held held(3, 0);
  held[2] = 1;
  at.mode = build_contact_mode<dynamic>(at.scene, held);
  MotionState motion = start_of(at.scene);
  motion.displacement << 0.7, 0.1, position;
  motion.velocity << 0.05, -at.speed, 0.0;
  motion.instant.phase = 0.3;
  set_lanes(at.state, at.scene, at.mode, motion);
  at.state.stops = {{0.0, at.speed, 1, at.speed}, {}};
  return at;
}

// The chatter goes on as long as the hold force stays positive, at impacts as well as between them:
// sampled in closed form.
TEST(OtherStops, AChatterEndsWhereAHoldForceFalls) {
  int released_by_a_jump = 0, released_between = 0, held = 0;
  for (const double beta : {0.1, 0.5, 2.0, 30.0})
    for (double slack = 1e-5; slack < 1.0; slack *= 1.3) {
      SCOPED_TRACE(::testing::Message() << beta << " " << slack);
      Pressed at = with_a_held_mass(beta, 0.9, slack);
      const Reading<dynamic> &press = at.mode.closed[0].press;
      const auto force = [&](const State<dynamic> &state) {
        return press(state.value, state.slope);
      };
      ASSERT_NEAR(force(at.state), slack, 1e-13);
      Followed followed(at);
      State<dynamic> from = at.state, between = from;
      int impacts = 0;
      for (; impacts < 60 && followed.find(); ++impacts) {
        for (const double u : {0.25, 0.5, 0.75, 1.0}) {
          flow(at.mode, at.scene, from.value, from.slope, u * followed.bounces.flight,
               between.value, between.slope);
          EXPECT_GT(force(between), -1e-13) << "impact " << impacts;
        }
        followed.apply();
        from = at.state;
        EXPECT_EQ(followed.goes_on, force(at.state) > 0.0) << "impact " << impacts;
      }
      released_by_a_jump += !followed.goes_on;
      released_between += followed.goes_on && impacts < 60;
      held += impacts == 60;
    }
  EXPECT_GE(released_by_a_jump, 10);
  EXPECT_GE(released_between, 10);
  EXPECT_GE(held, 10);
}

// The smallest value of a reading now at which `clear` holds, by its offset.
template <class Stop, class Clear>
double margin(Stop &stop, Reading<dynamic> Stop::*reading, const State<dynamic> &state,
              Clear clear) {
  double &offset = (stop.*reading).offset, low = -1e3, high = 1e3;
  for (int k = 0; k < 80; ++k) {
    offset = 0.5 * (low + high);
    (clear() ? high : low) = offset;
  }
  offset = high;
  return (stop.*reading)(state.value, state.slope);
}

// A stop found clear of impacts to come stays so, whenever they come: here all at once. The bounds
// are not idle: some are used up by a tenth, or by half where they need not wait for the motion.
TEST(OtherStops, AreClearWheneverTheImpactsCome) {
  double most_used = 0.0, most_used_at_once = 0.0;
  int hits = 0;
  for (unsigned seed = 1; seed <= 300; ++seed) {
    Scene scene = vibro_impact::testing::random_scene(seed);
    if (scene.stops.size() < 2 || scene.stops[0].mass == scene.stops[1].mass) continue;
    if (seed % 5 == 0) scene.beta = 30.0;  // modes split in two decays, which jump in value
    Held held(scene.mass.size(), 0);
    if (seed % 2 == 0)
      held[static_cast<std::size_t>(scene.stops[1].mass - 1)] =
          static_cast<signed char>(scene.stops[1].side);
    auto mode = build_contact_mode<dynamic>(scene, held);
    State<dynamic> state;
    set_lanes(state, scene, mode, start_of(scene));
    state.value.head(mode.modal_lanes()) *= seed % 3;
    state.slope.head(mode.modal_lanes()) *= seed % 3;
    state.stops.assign(scene.stops.size(), StopState{1.0, 0.0, 0, 0.0});
    state.stops[0] = {0.0, 1.0, 1, 1.0};
    Bounces<dynamic> bounces;
    Counters counters;
    if (!follow(bounces, state, scene, {0}, 0.1 / mode.fastest, counters)) continue;
    ++hits;
    const double jumps = 0.7;
    State<dynamic> pushed = state, there = state;
    pushed.value += jumps * bounces.hits[0].jump_value;
    pushed.slope += jumps * bounces.hits[0].jump_slope;
    for (const double reach : {1e-9, 0.3, 2.0}) {
      const double time = reach / mode.fastest;
      const auto speeds = speed_bounds(state, bounces.push, jumps, time);
      flow(mode, scene, pushed.value, pushed.slope, time, there.value, there.slope);
      const auto expect_clear = [&](auto &stop, auto reading, auto clear) {
        const double before = margin(stop, reading, state, clear);
        const double after = (stop.*reading)(there.value, there.slope);
        EXPECT_GT(after, 0.0) << seed << " " << reach;
        double &used = reach == 1e-9 ? most_used_at_once : most_used;
        if (std::abs(before) < 100.0) used = std::max(used, (before - after) / before);
      };
      for (auto &open : mode.open)
        if (open.stop != 0)
          expect_clear(open, &OpenStop<dynamic>::gap,
                       [&] { return stays_clear(state, open, speeds, time); });
      for (auto &closed : mode.closed)
        expect_clear(closed, &ClosedStop<dynamic>::press,
                     [&] { return stays_clear(state, closed, bounces.push, jumps, speeds, time); });
    }
  }
  EXPECT_GT(hits, 50);
  EXPECT_GT(most_used, 0.1);
  EXPECT_GT(most_used_at_once, 0.5);
}

// What others were found clear of is a sum of jumps; beyond it they are looked at again.
TEST(OtherStops, AreClearOfTheJumpsCountedOnly) {
  Pressed at(0.1, 0.3, 0.7);
  Followed followed(at);
  ASSERT_EQ(followed.go_on(3), 3);
  ASSERT_GT(followed.bounces.clear_until, followed.bounces.time);
  const double counted = followed.bounces.clear_jumps;
  ASSERT_EQ(followed.go_on(1), 1);
  EXPECT_EQ(followed.bounces.clear_jumps, counted - followed.bounces.latest_jump());
  EXPECT_GT(followed.bounces.clear_until, followed.bounces.time);
  followed.bounces.clear_jumps = 0.5 * at.scene.restitution * followed.bounces.latest_jump();
  ASSERT_TRUE(followed.find());
  fly(followed.bounces, at.state, at.scene,
      later(at.state.now, followed.bounces.flight, Clock(at.scene.omega)));
  bounce(followed.bounces, at.state, at.scene, followed.closing);
  EXPECT_EQ(followed.bounces.clear_until, 0.0);
}

}  // namespace
