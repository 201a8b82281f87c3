// The analysis in other units. A unit that is a power of two changes no mantissa, so that what is
// computed in it is the same bit for bit.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <vector>

#include "reference/scenes/paper_scenes.hpp"
#include "reference/scenes/table1_scenes.hpp"
#include "vibro_impact/analysis/analysis.hpp"
#include "vibro_impact/vibro_impact.hpp"

namespace {

using namespace vibro_impact;
using Values = std::vector<double>;

// Powers of two by which the numbers of a scene are multiplied in another unit.
struct Units {
  int length = 0, mass = 0, time = 0;
  int force() const {
    return mass + length - 2 * time;
  }
};

void scale(Values &values, int power) {
  for (double &value : values) value = std::ldexp(value, power);
}

Scene in_units(const Units &units, Scene scene) {
  scale(scene.mass, units.mass);
  scale(scene.stiffness, units.mass - 2 * units.time);
  scale(scene.ground, units.mass - 2 * units.time);
  scene.beta = std::ldexp(scene.beta, units.time);
  scene.omega = std::ldexp(scene.omega, -units.time);
  for (Values *force : {&scene.amplitude, &scene.sine, &scene.constant})
    scale(*force, units.force());
  for (Stop &stop : scene.stops) stop.position = std::ldexp(stop.position, units.length);
  scale(scene.displacement, units.length);
  scale(scene.velocity, units.length - units.time);
  return scene;
}

// Numbers of one quantity, and the power of two of its unit.
class Measured {
 public:
  explicit Measured(const Units &units) : units_(units) {
  }
  void add(double value, int power = 0) {
    values_.push_back(std::ldexp(value, -power));
  }
  void add(const MotionState &state) {
    add(state.instant.phase, units_.time);
    for (const double x : state.displacement) add(x, units_.length);
    for (const double v : state.velocity) add(v, units_.length - units_.time);
    for (const signed char held : state.held) add(held);
  }
  void add(const OrbitRecord &record) {
    add(record.period);
    add(record.approached);
    for (const int count : record.counts.impacts) add(count);
    for (const int count : record.counts.sticks) add(count);
    add(record.lyapunov->exponent, -units_.time);
    add(record.lyapunov->error, -units_.time);
    for (const EventPair pair : record.pairs) add(static_cast<int>(pair));
    if (record.attractor) add(*record.attractor, units_.length);
    for (const std::vector<Event> &impacts : record.impacts)
      for (const Event &impact : impacts) add(impact.velocity_before, units_.length - units_.time);
    for (const Values &state : record.section)
      for (const double x : state) add(x, units_.length);
    add(record.state);
  }
  const Values &values() const {
    return values_;
  }

 private:
  Units units_;
  Values values_ = {};
};

// The measured numbers of a scene whose numbers are in these units.
using Measure = std::function<void(const Scene &, const Units &, Measured &)>;

// The motions of Figure 3: sticking, chatter, impacts of several periods, and chaos (0.69).
void expect_equal_in(const std::vector<Units> &all, const Measure &measure) {
  for (const double omega : {0.28, 0.395, 0.47, 0.6, 0.61, 0.625, 0.65, 0.69}) {
    Values expected;
    for (const Units &units : all) {
      Measured measured(units);
      measure(in_units(units, paper::figure3(omega)), units, measured);
      if (expected.empty()) expected = measured.values();
      EXPECT_EQ(measured.values(), expected)
          << omega << ", length 2^" << units.length << ", mass 2^" << units.mass << ", time 2^"
          << units.time;
    }
  }
}

// Masses are multiplied by even powers of two alone: the modes contain their square roots.
const std::vector<Units> all_units{{0},     {-500},    {-20},      {-10},       {450},
                                   {0, 40}, {0, 0, 1}, {0, 0, -9}, {0, 0, 150}, {-10, 6, -11}};

void measure_record(const Scene &scene, const Units &, Measured &measured) {
  RecordOptions options{.lyapunov = true, .pairs = true};
  options.impacts = options.attractor = true;
  measured.add(record_of(scene, options));
}

void measure_settling(const Scene &scene, const Units &units, Measured &measured) {
  const SettledMotion motion = settle(scene, start_of(scene));
  measured.add(motion.period);
  measured.add(motion.periods_run);
  measured.add(motion.fastest_impact, units.length - units.time);
  measured.add(motion.state);
}

void measure_orbit(const Scene &scene, const Units &units, Measured &measured) {
  const PeriodicOrbit orbit =
      find_periodic_orbit(scene, at_quiet_phase(scene, state_after_periods(scene, 20)));
  measured.add(orbit.converged);
  for (const double residual : orbit.residuals) measured.add(residual, units.length);
  for (const auto &multiplier : orbit.multipliers) {
    measured.add(multiplier.real());
    measured.add(multiplier.imag());
  }
  measured.add(orbit.state);
}

void measure_growth(const Scene &scene, const Units &units, Measured &measured) {
  const MotionState start = at_quiet_phase(scene, state_after_periods(scene, 5));
  const Growth growth = mean_growth(scene, start, {.longest = 400});
  measured.add(growth.exponent, -units.time);
  measured.add(growth.error, -units.time);
}

void measure_places(const Scene &scene, const Units &units, Measured &measured) {
  const double stop = scene.stops[0].position;
  const auto count = [&](double position) {
    return static_cast<int>(
        record_of(with(scene, "stop1", position), {.settle = {.longest = 20}}).counts.impacts[0]);
  };
  if (count(stop) != count(8.0 * stop)) {
    const CountJump jump = bisect(count, 8.0 * stop, stop);
    measured.add(jump.below, units.length);
    measured.add(jump.above, units.length);
  }
  const MotionState start = state_after_periods(scene, 30);
  for (const Stop &of : scene.stops) {
    if (const auto least = least_gap(scene, start, of)) {
      measured.add(least->value, units.length);
      measured.add(least->at);
    }
    if (const auto least = least_pressing_force(scene, start, of)) {
      measured.add(least->value, units.force());
      measured.add(least->at);
    }
  }
}

void measure_pairs(const Scene &scene, const Units &units, Measured &measured, double from,
                   double to) {
  PressedEventRecorder recorder(scene, std::ldexp(from, units.time));
  require_complete(simulate(scene, std::ldexp(to, units.time), recorder));
  for (const PairedEvents &pair : event_pairs(recorder.events)) {
    measured.add(static_cast<int>(pair.kind));
    measured.add(pair.mass);
    measured.add(pair.from, units.time);
    measured.add(pair.to, units.time);
  }
}

void measure_branch(const Scene &scene, const Units &units, Measured &measured) {
  const MotionState guess = at_quiet_phase(scene, record_of(scene).state);
  const double stop = scene.stops[0].position;
  for (const OrbitPoint &point :
       follow_orbit(scene, guess, {"stop1", stop, 1.2 * stop, 10}, {.most_points = 20})) {
    measured.add(point.parameter, units.length);
    measured.add(static_cast<int>(point.kind));
    for (const auto &multiplier : point.orbit.multipliers) measured.add(std::abs(multiplier));
    measured.add(point.orbit.state);
  }
}

TEST(Units, ChangeNoBitOfABranch) {
  expect_equal_in(all_units, measure_branch);
}

// The pairs of the six scenes of Table I.
TEST(Units, ChangeNoBitOfAPair) {
  for (const paper::PairScene &shown : paper::table1_scenes()) {
    Values expected;
    for (const Units &units : all_units) {
      Measured measured(units);
      measure_pairs(in_units(units, shown.scene), units, measured, shown.from, shown.to);
      if (expected.empty()) expected = measured.values();
      EXPECT_FALSE(expected.empty()) << shown.pair;
      EXPECT_EQ(measured.values(), expected) << shown.pair << ", time 2^" << units.time;
    }
  }
}

TEST(Units, ChangeNoBitOfARecord) {
  expect_equal_in(all_units, measure_record);
}

TEST(Units, ChangeNoBitOfWhereAMotionSettles) {
  expect_equal_in(all_units, measure_settling);
}

TEST(Units, ChangeNoBitOfAPeriodicOrbit) {
  expect_equal_in(all_units, measure_orbit);
}

TEST(Units, ChangeNoBitOfAMeanGrowth) {
  expect_equal_in(all_units, measure_growth);
}

TEST(Units, ChangeNoBitOfPlacesThatAreLocated) {
  expect_equal_in(all_units, measure_places);
}

}  // namespace
