// Nothing is computed that a scene does not need: shown by the counters of work.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

#include "reference/scenes/extreme_scenes.hpp"
#include "reference/scenes/paper_scenes.hpp"
#include "tests/support/events.hpp"
#include "vibro_impact/vibro_impact.hpp"

namespace {

using namespace vibro_impact;
using namespace vibro_impact::testing;

// The longest expansion of a flight, two radians of its fastest rate, is of order 23.
constexpr long long most_coefficients = 24;

// Every contact mode a run was in: the free one and those its events led to.
long long modes_entered(const std::vector<Event> &events, int masses) {
  std::set<Held> modes{Held(static_cast<std::size_t>(masses), 0)};
  for (const Event &event : events) modes.insert(event.held);
  return static_cast<long long>(modes.size());
}

// A chain of n with stops near both ends, forced at its first mass.
Scene long_chain(int n, double restitution) {
  Scene scene = extremes::chain(n, 0.1);
  scene.amplitude.assign(static_cast<std::size_t>(n), 0.0);
  scene.amplitude.front() = 0.5;
  scene.omega = 0.28;
  scene.restitution = restitution;
  scene.stops = {{1, Side::lower, -0.1}, {2, Side::upper, 0.25}, {n, Side::upper, 0.0}};
  scene.velocity.assign(static_cast<std::size_t>(n), 0.0);
  scene.velocity.back() = -0.2;
  return scene;
}

Scene without_stops(Scene scene) {
  scene.stops.clear();
  return scene;
}

TEST(Economy, AContactModeIsBuiltWhenItIsFirstEntered) {
  for (const Scene &scene : {paper::figure2(), paper::figure5a(), paper::figure5b(),
                             long_chain(10, 0.7), without_stops(paper::figure2())}) {
    EventRecorder events;
    SampleRecorder samples(0.0, 300.0, 0.01);  // and so inside chatters
    const Outcome outcome = simulate(scene, 300.0, events, samples);
    EXPECT_EQ(outcome.counters.modes_built, modes_entered(events.events, scene.masses()));
  }
}

// Eight heavy masses swing, each at a rate of its own. The links press the light masses between
// them onto their stops, and the contact modes are nearly all of 2^7. The 64 latest are kept, and
// others are built again when the run comes back to them.
TEST(Economy, TheLatestContactModesAreKept) {
  Scene scene{.restitution = 0.0};
  for (int i = 1; i <= 15; ++i) {
    const bool heavy = i % 2 == 1;
    const double rate = 0.1 + 0.01 * i;
    scene.mass.push_back(heavy ? 1e4 : 1.0);
    scene.stiffness.push_back(1.0);
    scene.ground.push_back(heavy ? 1e4 * rate * rate : 0.0);
    scene.displacement.push_back(heavy ? 1.0 : 0.0);
    if (!heavy) scene.stops.push_back({i, Side::upper, 0.0});
  }
  EventRecorder recorder;
  const Counters counters = require_complete(simulate(scene, 1000.0, recorder)).counters;
  std::vector<Held> kept{Held(15)};
  long long built = 1;
  for (const Event &event : recorder.events) {
    const auto known = std::ranges::find(kept, event.held);
    if (known == kept.end())
      ++built;
    else
      kept.erase(known);
    kept.push_back(event.held);
    if (kept.size() > 64) kept.erase(kept.begin());
  }
  EXPECT_EQ(counters.modes_built, built);
  EXPECT_GT(built, modes_entered(recorder.events, 15));
}

// A mass pressed onto its stop: an impact takes one expansion of its flight, as long as it lasts,
// and one root. Further expansions are those of the first flight, and of the time after the limit:
// nothing moves there, and each is as long as the time before.
TEST(Economy, AnImpactCostsOneExpansion) {
  for (const double r : {0.001, 0.3, 0.7, 0.9, 0.95}) {
    const Counters counters =
        simulate(extremes::one_mass(0.0, 0.0, 1.0, r, -0.5, -0.51), 30.0).counters;
    EXPECT_EQ(counters.sticks, 1) << r;
    EXPECT_EQ(counters.roots_searched, counters.impacts) << r;
    EXPECT_LE(counters.expansions, counters.impacts + 2 + std::ilogb(30.0) + 2) << r;
  }
}

// The order of an expansion does not grow with the number of masses, and an expansion
// searches each stop at most once.
TEST(Economy, AnExpansionOfALongChainHasNoMoreOrdersThanThatOfAShortOne) {
  for (const int masses : {10, 50, 200}) {
    for (const std::size_t stops : {1u, 3u}) {
      Scene scene = long_chain(masses, 0.7);
      scene.stops.resize(stops);
      const Counters counters = simulate(scene, 40.0).counters;
      EXPECT_GE(counters.expansions, 40) << masses << " " << stops;
      EXPECT_LE(counters.coefficients, most_coefficients * counters.expansions);
      EXPECT_LE(counters.roots_searched, static_cast<long long>(stops) * counters.expansions);
    }
  }
}

// With r = 0 a mass stops at once. With r = 1 it rebounds at the same speed for ever, however hard
// a force presses it.
TEST(Economy, ALimitOnlyWhereChatterCanBe) {
  const auto counters_of = [](double r) {
    const Scene scene = extremes::one_mass(0.0, 0.0, 1.0, r, -0.5, -0.51);  // flights of 0.4
    return simulate(scene, 30.0).counters;
  };
  for (const double r : {0.0, 1.0}) {
    EXPECT_GT(counters_of(r).impacts, 0) << r;
    EXPECT_EQ(counters_of(r).chatter_limits, 0) << r;
  }
  EXPECT_EQ(counters_of(0.7).chatter_limits, 1);
  // Also where every mass comes to rest, and the state at the limit is nothing but a position: 60
  // impacts, 337 when each is resolved until the rest lies below rounding.
  const Counters all_motion =
      simulate(extremes::one_mass(0.0, 0.0, 1.0, 0.9, -0.5, -1.0), 100.0).counters;
  EXPECT_EQ(all_motion.chatter_limits, 1);
  EXPECT_LE(all_motion.impacts, 63);
}

// If nothing can happen, without stops or out of their reach for ever, there is one closed-form
// evaluation per sample and one for the state at the end. Expansions come before it, as many as
// cost what the modes do. With stops nothing is evaluated that nobody asked for.
TEST(Economy, ASampleIsOneEvaluation) {
  Scene swings = extremes::one_mass(0.0, 0.5, 0.0, 0.7, 1.25);  // swings about 0.5
  swings.stops.push_back({1, Side::lower, -0.25});
  for (const Scene &scene :
       {without_stops(long_chain(2, 0.7)), without_stops(long_chain(50, 0.7)), swings}) {
    const double begin = 2.0 * scene.masses() * scene.masses();
    SampleRecorder samples(begin, begin + 89.0, 0.37);
    const Counters counters = simulate(scene, 1e6, samples).counters;
    EXPECT_EQ(samples.times.size(), 241u);
    EXPECT_EQ(counters.states_computed, 242);
    EXPECT_LE(counters.expansions, 16 + scene.masses() * scene.masses() / 8);
    for (std::size_t i = 0; i < samples.times.size() && scene.masses() == 1; ++i)
      EXPECT_NEAR(samples.displacements[i], 0.5 * (1.0 - std::cos(samples.times[i])), 1e-15);
  }
  EventRecorder events;
  EXPECT_EQ(simulate(paper::figure2(), 300.0, events).counters.states_computed, 0);
}

// A mass that is pressed onto its stop by a constant force. From the impact at which the limit of
// its chatter is taken, a hundred impacts more would be resolved until the limit, for which these
// steps do not suffice; up to the sample it is a few.
TEST(Economy, ImpactsOfAChatterAreResolvedUpToTheLastSample) {
  const Scene scene{.mass = {1.0},
                    .stiffness = {0.0},
                    .constant = {1.0},
                    .restitution = 0.7,
                    .stops = {{1, Side::upper, 0.0}},
                    .displacement = {-1.0}};
  const RunOptions options{.max_steps = 60};
  const double inside = time_inside_chatter(scene, 10.0, options);
  SampleRecorder sample(inside, inside, 1.0);
  EXPECT_EQ(simulate(scene, 10.0, options, sample).reason, "");
  EXPECT_EQ(sample.times.size(), 1u);
}

// The expansions of a run before it is clear that nothing will happen: as many as its motion needs
// to come to that, and none of them for the time that is left.
void expect_the_same_work(const Scene &scene, double soon, double late, long long expansions) {
  const Counters early = simulate(scene, soon).counters, all = simulate(scene, late).counters;
  EXPECT_EQ(all.expansions, early.expansions);
  EXPECT_EQ(all.impacts, early.impacts);
  EXPECT_EQ(all.sticks, early.sticks);
  EXPECT_LE(all.expansions, expansions);
}

// The steady motion A / (k - m Omega^2 + i c Omega) of one mass, after a million periods from any
// start; also in resonance, where what is left of it is the damping. The time is a whole number of
// periods and a phase, and is not rounded.
TEST(WithoutEvents, AMillionForcingPeriodsAreFewSteps) {
  const double force = 0.5;
  for (const auto &[beta, omega] :
       {std::pair{0.1, 0.28}, {0.1, 1.0}, {0.01, 0.28}, {0.01, 1.001}, {0.01, 1.0}}) {
    Scene scene = extremes::one_mass(beta, force, omega, 0.7, 200.0);
    scene.stops.push_back({1, Side::lower, -200.0});
    for (const long long cycle : {0LL, 1LL, 1'000'000LL, 10'000'000'000LL}) {
      const double until = time_of({cycle + 1'000'000, 2.0}, Clock(omega));
      const Outcome outcome = Simulation(scene, {{cycle, 1.0}, {0.1}, {0.0}, {0}}).advance(until);
      EXPECT_LE(outcome.counters.expansions, 20) << omega;
      EXPECT_EQ(outcome.state.instant.cycle, cycle + 1'000'000);
      EXPECT_NEAR(outcome.state.instant.phase, 2.0, 4e-16 * until);  // rounding of the time
      const double stiff = 1.0 - omega * omega, drag = beta * omega,
                   rigid = std::hypot(stiff, drag), amplitude = force / rigid,
                   angle = omega * outcome.state.instant.phase, lag = std::atan2(drag, stiff);
      // The rounding of Omega^2 is a share of the rigidity that is left of 1.
      const double rounding = 8e-16 * amplitude / std::min(1.0, rigid);
      EXPECT_NEAR(outcome.state.displacement[0], amplitude * std::cos(angle - lag), rounding)
          << beta << " " << omega << " " << cycle;
      EXPECT_NEAR(outcome.state.velocity[0], -omega * amplitude * std::sin(angle - lag), rounding)
          << beta << " " << omega << " " << cycle;
    }
  }
}

// A chain whose swing has died down between its stops, one that rests on them, one that has left
// them for good (not tied to the ground), and a mode next to resonance whose stop is out of its
// reach. After an event come some sixteen steps.
TEST(WithoutEvents, TheStepsAreThoseAfterTheLastEvent) {
  Scene dying = paper::figure2();
  dying.amplitude.clear();
  dying.velocity = {-1.0, 1.0};
  EXPECT_GT(simulate(dying, 200.0).counters.impacts, 5);
  expect_the_same_work(dying, 200.0, 1e9, 100);

  const Scene resting = extremes::one_mass(0.1, 0.5, 0.0, 0.7, 0.1);
  EXPECT_EQ(simulate(resting, 30.0).counters.sticks, 1);
  expect_the_same_work(resting, 1e6, 1e9, 40);

  Scene leaving = extremes::one_mass(0.0, 0.0, 0.0, 0.7, 1.0, 0.0, 0.5);
  leaving.stiffness = {0.0};
  expect_the_same_work(leaving, 1e6, 1e9, 20);
  const MotionState end = simulate(leaving, 1e9).state;
  EXPECT_DOUBLE_EQ(end.displacement[0], 1.0 - 0.35 * (1e9 - 2.0));
  EXPECT_DOUBLE_EQ(end.velocity[0], -0.35);

  const double steady = 0.01 / (1.0 - 1.0 / 1.025);  // and twice that until it has settled
  const Scene resonant = extremes::one_mass(1e-5, 0.01, std::sqrt(1.0 / 1.025), 1.0, 2.2 * steady);
  EXPECT_LT(simulate(resonant, 1e5).counters.expansions, 100);
}

// Two masses whose modes, with frequencies in the golden ratio, swing on below a stop that they
// reach only together. The search within one long flight has steps of a radian and is given up,
// too.
TEST(Work, OfALongFlightIsBounded) {
  Scene scene;
  scene.mass = scene.stiffness = {1.0, 1.0};
  scene.velocity = {0.0, 1.0};
  scene.stops = {{2, Side::upper, 1.34164}};  // 3 / sqrt(5) = 1.341641 would be the largest x2
  constexpr long long most = 2500;
  const Outcome outcome = simulate(scene, 1e5, {.max_steps = most});
  EXPECT_EQ(outcome.ending, Ending::given_up);
  EXPECT_GE(outcome.counters.search_steps, most / 2);
  EXPECT_LE(outcome.counters.search_steps, 2 * most);
}

}  // namespace
