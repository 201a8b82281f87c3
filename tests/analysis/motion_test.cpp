// The record of a motion does not depend on where it begins and ends: counts, pairs, derivatives
// and minima at sections next to events, and orbits of random scenes against other runs.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <utility>
#include <vector>

#include "reference/scenes/extreme_scenes.hpp"
#include "reference/scenes/paper_scenes.hpp"
#include "vibro_impact/analysis/analysis.hpp"
#include "vibro_impact/vibro_impact.hpp"

namespace {

using namespace vibro_impact;

// The phases of the forcing put an impact of each orbit within 1e-11 of the section.
TEST(Motion, AnImpactAtTheSectionIsNeitherLostNorDoubled) {
  const struct {
    double amplitude, sine, omega;
    int impacts;
  } cases[] = {{0.4979081437956029, 0.04568895207834404, 0.9, 1},
               {0.3770805190024089, 0.3283447611716592, 0.8, 2},
               {0.4977208342631836, -0.047686173471568664, 1.1, 1}};
  for (const auto &[amplitude, sine, omega, impacts] : cases) {
    Scene scene = extremes::one_mass(0.1, amplitude, omega, 0.7, 0.2);
    scene.sine = {sine};
    const OrbitRecord record = record_of(scene, {.settle = {.longest = 600}, .impacts = true});
    EXPECT_EQ(record.period, 1) << omega;
    EXPECT_EQ(record.counts.impacts, std::vector{impacts}) << omega;
    EXPECT_EQ(record.impacts[0].size(), static_cast<std::size_t>(impacts)) << omega;
  }
}

// The moduli of the multipliers at sections in the tail of a chatter, between the latest impact
// that the run reports and the stick, are those at a quiet section. A chatter that is carried to
// its limit has tangents good to 1e-12.
TEST(Motion, ASectionInsideAChatterHasTheSameMultipliers) {
  const Scene scene = paper::figure3(0.2);
  const PeriodicOrbit orbit = settle(scene, start_of(scene)).orbit;
  int sections = 0;
  for (std::size_t k = 1; k < orbit.events.size(); ++k) {
    const Event &impact = orbit.events[k - 1], &stick = orbit.events[k];
    if (stick.kind != EventKind::stick || impact.kind != EventKind::impact ||
        stick.stop != impact.stop)
      continue;
    for (const double part : {0.1, 0.5, 0.9}) {
      const double until = std::lerp(impact.time, stick.time, part);
      MotionState inside = Simulation(scene, orbit.state).advance(until).state;
      inside.instant.cycle = 0;
      const StroboscopicImage image = stroboscopic_map_and_derivative(scene, inside, 1);
      ASSERT_TRUE(image.derivative.exists()) << image.derivative.why_not();
      const Multipliers found = floquet_multipliers(scene, *image.derivative, inside.held);
      EXPECT_NEAR(std::abs(found[0]), std::abs(orbit.multipliers[0]), 1e-10) << part;
      ++sections;
    }
  }
  EXPECT_GE(sections, 3);
}

// The impacts of a motion that has not settled are in the order of time, from the section on.
TEST(Motion, HasTheImpactsOfAnIrregularMotionInTheirOrder) {
  const OrbitRecord record =
      record_of(paper::figure3(0.69), {.settle = {.longest = 50}, .impacts = true});
  ASSERT_EQ(record.period, 0);
  ASSERT_GT(record.impacts[0].size(), 40u);
  EXPECT_TRUE(std::ranges::is_sorted(record.impacts[0], {}, &Event::instant));
}

// Two neighbours that a damper joins hit at one instant in every period: the derivative depends on
// which is first, and there is no exponent. Reading it throws.
TEST(Motion, HasNoDerivativeWhereDampedNeighboursHitAtOnce) {
  Scene scene{.mass = {1.0, 0.5},
              .stiffness = {0.0, 0.2},
              .beta = 1.0,
              .amplitude = {0.5, 0.25},
              .ground = {2.0, 1.0},
              .omega = 0.824,
              .restitution = 0.95,
              .stops = {{1, Side::upper, -0.1}, {2, Side::upper, -0.1}},
              .displacement = {-0.1, -0.1}};
  const OrbitRecord record = record_of(scene, {.lyapunov = true});
  EXPECT_FALSE(record.lyapunov.exists());
  EXPECT_NE(record.lyapunov.why_not().find("hit at once"), std::string::npos)
      << record.lyapunov.why_not();
  EXPECT_THROW(record.lyapunov.value(), std::domain_error);
}

// Both masses are held for ever, without an event.
TEST(Motion, PairsMassesThatAreHeldThroughout) {
  Scene scene = paper::two_masses({1, Side::lower, 0.1}, {2, Side::lower, 0.15}, 0.7, 0.3);
  scene.amplitude = {0.01, 0.0};
  scene.displacement = {0.1, 0.15};
  EXPECT_EQ(record_of(scene, {.pairs = true}).pairs, std::vector{EventPair::dual_sticking});
}

// A start at the turning point, and 1e-3 after it: the minimum begins or ends the forcing period.
TEST(Motion, HasItsLeastGapWhereverItBegins) {
  const double amplitude = 0.3 / (1.0 - 0.25);
  const Scene scene{.mass = {1.0}, .stiffness = {1.0}, .amplitude = {0.3}, .omega = 0.5};
  for (const double phase : {0.0, 1e-3}) {
    MotionState start = start_of(scene);
    start.instant.phase = phase;
    start.displacement = {amplitude * std::cos(0.5 * phase)};
    start.velocity = {-0.5 * amplitude * std::sin(0.5 * phase)};
    const auto least = least_gap(scene, start, {1, Side::upper, 0.6});
    ASSERT_TRUE(least.has_value()) << phase;
    EXPECT_NEAR(least->value, 0.6 - amplitude, 1e-14) << phase;
  }
}

// Undamped, every multiplier lies on the unit circle. Rounding once decided between stable and not.
TEST(Orbits, WithoutDampingAreNeutral) {
  for (const double omega : {0.7, 1.1}) {
    const Scene scene{
        .mass = {1.0, 1.0}, .stiffness = {1.0, 1.0}, .amplitude = {0.5, 0.0}, .omega = omega};
    const PeriodicOrbit orbit = find_periodic_orbit(scene, start_of(scene));
    ASSERT_TRUE(orbit.converged) << orbit.why_not;
    EXPECT_EQ(orbit.stability(), Stability::neutral) << omega;
    EXPECT_FALSE(orbit.stable());
  }
}

// A ball on a table: the state at the section is small beside the speed of its impacts, to which
// the rounding of its return belongs.
TEST(Orbits, AreFoundToTheSizeOfTheirMotion) {
  Scene ball = extremes::one_mass(0.0, 1.52903, 1.0, 0.6, 0.0);
  ball.stiffness = {0.0};
  ball.constant = {-1.0};
  ball.stops[0].side = Side::lower;
  ball.displacement = {1.0};
  const OrbitRecord record = record_of(ball);
  ASSERT_EQ(record.period, 8);
  const PeriodicOrbit orbit = find_periodic_orbit(ball, at_quiet_phase(ball, record.state), 8);
  EXPECT_TRUE(orbit.converged) << orbit.why_not;
}

// Two codes have |mu| = 0.452094400(5). The rounding of the orbit, 1e-14, moves it by 1e-8.
TEST(Orbits, GiveTheExponentNextToAGraze) {
  const Scene scene = paper::figure3(0.6745);
  const OrbitRecord record = record_of(scene, {.settle = {.longest = 2000}, .lyapunov = true});
  ASSERT_EQ(record.period, 10);  // after 93 to 442 periods, by last bits
  const auto [exponent, error] = *record.lyapunov;
  EXPECT_NEAR(exponent, std::log(0.4520944) / (10 * Clock(0.6745).period), std::min(error, 2e-9));
}

// A motion that comes near its orbit slowly: by a longer run, period 8 at omega = 0.7.
TEST(Orbits, AreFoundFromASlowMotion) {
  for (const int longest : {300, 400}) {
    const Scene scene = paper::figure3(0.7);
    EXPECT_EQ(settle(scene, start_of(scene), {.longest = longest}).period, 8) << longest;
  }
}

// Adds a mass at the end of the chain.
void add_mass(Scene &scene, double mass, double link, double ground, double amplitude) {
  scene.mass.push_back(mass);
  scene.stiffness.push_back(link);
  scene.ground.push_back(ground);
  scene.amplitude.push_back(amplitude);
}

// One to four masses with stops on either side, symmetric or not, masses without forcing. One chain
// in six has one mass more that nothing moves. One in six has a twin of its last mass that hits
// with it at one instant, with a link between them or without.
Scene random_scene(std::mt19937 &random) {
  const auto number = [&random](double from, double to) {
    return std::lerp(from, to, static_cast<double>(random()) / 0x1p32);
  };
  const bool twins = random() % 6 == 0, idle = !twins && random() % 6 == 0;
  const int masses = twins ? 1 : static_cast<int>(1 + random() % 4);
  Scene scene{
      .beta = number(0.02, 0.5), .omega = number(0.3, 2.0), .restitution = number(0.0, 0.95)};
  if (random() % 4 == 0) scene.restitution = 0.0;
  const bool symmetric = random() % 4 == 0;
  for (int mass = 1; mass <= masses; ++mass) {
    const double size = number(0.5, 2.0), link = number(0.5, 3.0);
    add_mass(scene, size, link, 0.0, random() % 3 == 0 ? 0.0 : number(-1.0, 1.0));
    const double position = number(0.02, 0.6);
    if (symmetric || random() % 2 == 0) scene.stops.push_back({mass, Side::upper, position});
    if (symmetric) scene.stops.push_back({mass, Side::lower, -position});
  }
  if (idle) {
    scene.constant.assign(scene.mass.size() + 1, 0.0);
    scene.constant[scene.mass.size() - 1] = 20.0;
    if (scene.stops.empty() || scene.stops.back().mass != masses)
      scene.stops.push_back({masses, Side::upper, 0.1});
    add_mass(scene, 1.0, 1.0, 0.0, 0.0);
  }
  if (twins) {
    if (random() % 2 == 0) scene.beta = 0.0;
    if (scene.stops.empty()) scene.stops.push_back({1, Side::upper, 0.1});
    scene.amplitude[0] = 1.0;
    scene.ground[0] = std::exchange(scene.stiffness[0], 0.0);
    add_mass(scene, scene.mass[0], 1.0, scene.ground[0], scene.amplitude[0]);
    for (const Stop &stop : std::vector(scene.stops))
      scene.stops.push_back({2, stop.side, stop.position});
  }
  return scene;
}

// The state after `time`, which counts from the state at the phase of `start`.
MotionState moved_on(const Scene &scene, const MotionState &start, double time) {
  const double until = time_of(start.instant, Clock(scene.omega)) + time;
  MotionState state = require_complete(Simulation(scene, start).advance(until)).state;
  state.instant.cycle = 0;
  return state;
}

double distance(const std::vector<double> &a, const std::vector<double> &b) {
  double largest = 0.0;
  for (std::size_t k = 0; k < a.size(); ++k) largest = std::max(largest, std::abs(a[k] - b[k]));
  return largest;
}

double nearest_section(const SettledMotion &motion, const MotionState &state) {
  double nearest = infinity;
  for (const MotionState &section : motion.section)
    nearest = std::min(nearest, distance(coordinates(section), coordinates(state)));
  return nearest;
}

MotionState shifted(MotionState state, std::size_t coordinate, double by) {
  const std::size_t n = state.held.size();
  (coordinate < n ? state.displacement[coordinate] : state.velocity[coordinate - n]) += by;
  return state;
}

// Central differences over 1e-7: their error is the curvature of the map times 1e-14, and its
// rounding over 1e-7. A mass that is nearer to its stop leaves no room for them.
void expect_derivative(const Scene &scene, const MotionState &at, int periods,
                       const Matrix &derivative) {
  const double h = 1e-7;
  for (const Stop &stop : scene.stops)
    if (std::abs(stop.position - at.displacement[static_cast<std::size_t>(stop.mass - 1)]) <= h)
      return;
  double size = 1.0;
  for (const double entry : derivative.values) size = std::max(size, std::abs(entry));
  for (const std::size_t k : free_coordinates(at.held)) {
    const auto right = coordinates(stroboscopic_map(scene, shifted(at, k, h), periods)),
               left = coordinates(stroboscopic_map(scene, shifted(at, k, -h), periods));
    for (std::size_t i = 0; i < right.size(); ++i)
      EXPECT_NEAR((right[i] - left[i]) / (2.0 * h), derivative(i, k), 1e-5 * size) << i << k;
  }
}

// The orbit of a settled motion against the engine run otherwise. The motion from the start run six
// times as long lies on the orbit, and one from next to the orbit settles on it. Counts and
// multipliers at another section are the same. Orbits whose multiplier exceeds 0.9 take longer to
// come that near.
TEST(RandomScenes, SettleOnOrbitsThatTheEngineConfirms) {
  std::mt19937 random(20260401);
  int settled = 0, derivatives = 0, twins = 0;
  for (int k = 0; k < 120; ++k) {
    SCOPED_TRACE(k);
    const Scene scene = random_scene(random);
    const SettledMotion motion = settle(scene, start_of(scene));
    if (motion.period == 0) continue;
    const PeriodicOrbit &orbit = motion.orbit;
    EXPECT_TRUE(orbit.converged && orbit.why_not.empty()) << orbit.why_not;
    ++settled;
    const double period = Clock(scene.omega).period;
    if (orbit.stable() && (orbit.multipliers.empty() || std::abs(orbit.multipliers[0]) < 0.9)) {
      const int periods = 6 * std::max(motion.periods_run, 60);
      EXPECT_LT(nearest_section(motion, state_after_periods(scene, periods)), 1e-9);
      MotionState beside = orbit.state;
      for (const std::size_t row : free_coordinates(beside.held))
        beside = shifted(std::move(beside), row, 1e-6);
      const SettledMotion again = settle(scene, start_near(scene, beside));
      EXPECT_EQ(again.period, motion.period);
      EXPECT_LT(nearest_section(again, orbit.state), 1e-9);
    }
    const MotionState other = moved_on(scene, orbit.state, 0.37 * period);
    const StroboscopicImage image = stroboscopic_map_and_derivative(scene, other, motion.period);
    const EventCounts counts = counts_of(scene, image.events, motion.period, other.held);
    EXPECT_EQ(counts.impacts, motion.counts.impacts);
    EXPECT_EQ(counts.sticks, motion.counts.sticks);
    if (other.held == orbit.state.held) {  // no perturbation passes where all masses are held
      EXPECT_EQ(image.derivative.exists(), orbit.multipliers.exists());
    }
    if (!image.derivative.exists() || !orbit.multipliers.exists()) {
      ++twins;
      continue;
    }
    expect_derivative(scene, other, motion.period, *image.derivative);
    const Multipliers multipliers = floquet_multipliers(scene, *image.derivative, other.held);
    const auto largest = [](const Multipliers &of) { return of.empty() ? 0.0 : std::abs(of[0]); };
    EXPECT_NEAR(largest(multipliers), largest(*orbit.multipliers),
                1e-7 * std::max(1.0, largest(multipliers)));
    ++derivatives;
  }
  EXPECT_GT(settled, 80);
  EXPECT_GT(derivatives, 70);
  EXPECT_GT(twins, 3);
}

}  // namespace
