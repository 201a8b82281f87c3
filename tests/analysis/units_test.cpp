// The analysis in other units. A unit that is a power of two changes no mantissa, so that what is
// computed in it is the same bit for bit.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "reference/scenes/paper_scenes.hpp"
#include "reference/scenes/table1_scenes.hpp"
#include "tests/support/random_scenes.hpp"
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

Scene in_units(const Units &units, const Scene &scene) {
  const auto power = [](int exponent) { return std::ldexp(1.0, exponent); };
  return vibro_impact::testing::in_units(scene, power(units.mass),
                                         power(units.mass - 2 * units.time), power(units.length),
                                         power(units.time));
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
    if (record.lyapunov.exists()) {
      add(record.lyapunov->exponent, -units_.time);
      add(record.lyapunov->error, -units_.time);
    }
    for (const EventPair pair : record.pairs) add(static_cast<int>(pair));
    add(record.size, units_.length);
    for (const std::vector<Event> &impacts : record.impacts)
      for (const Event &impact : impacts) add(impact.velocity_before, units_.length - units_.time);
    for (const Values &state : record.section)
      for (std::size_t k = 0; k < state.size(); ++k)
        add(state[k], units_.length - (k < state.size() / 2 ? 0 : units_.time));
    add(record.state);
  }
  const Values &values() const {
    return values_;
  }

 private:
  Units units_;
  Values values_ = {};
};

// Masses are multiplied by even powers of two alone: the modes contain their square roots.
const std::vector<Units> all_units{{0},     {-500},    {-20},      {-10},       {450},
                                   {0, 40}, {0, 0, 1}, {0, 0, -9}, {0, 0, 150}, {-10, 6, -11}};

void measure_record(const Scene &scene, const Units &units, Measured &measured) {
  RecordOptions options{.lyapunov = true, .pairs = true};
  options.impacts = options.section = true;
  measured.add(record_of(scene, options));
  const SettledMotion motion = settle(scene);
  measured.add(motion.periods_run);
  measured.add(motion.orbit.state);
  measured.add(mean_growth(scene, start_of(scene), {.longest = 100})->exponent, -units.time);
}

void measure_minima(const Scene &scene, const Units &units, Measured &measured) {
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

void measure_branch(const Scene &scene, const Units &units, Measured &measured) {
  const MotionState guess = at_quiet_phase(scene, record_of(scene).state);
  const double stop = scene.stops[0].position;
  for (const OrbitPoint &point :
       follow_orbit(scene, guess, {"stop1", stop, 1.2 * stop, 10}, {.most_points = 20})) {
    measured.add(point.parameter, units.length);
    measured.add(static_cast<int>(point.kind));
    if (point.orbit.multipliers.exists())  // not at a graze
      for (const auto &multiplier : point.orbit.multipliers) measured.add(std::abs(multiplier));
    measured.add(point.orbit.residuals.back(), units.length);
    measured.add(point.orbit.state);
  }
}

// The measured numbers of a scene whose numbers are in these units.
using Measure = std::function<void(const Scene &, const Units &, Measured &)>;

void expect_equal_in_all_units(const std::string &name, const Scene &scene,
                               const Measure &measure) {
  Values expected;
  for (const Units &units : all_units) {
    Measured measured(units);
    measure(in_units(units, scene), units, measured);
    if (expected.empty()) expected = measured.values();
    EXPECT_EQ(measured.values(), expected) << name << ", length 2^" << units.length << ", mass 2^"
                                           << units.mass << ", time 2^" << units.time;
  }
}

// The motions of Figure 3: sticking, chatter, impacts of several periods, and chaos (0.69). A
// branch begins with a periodic orbit, and the exponent of the record of a motion that has not
// settled is a mean growth.
TEST(Units, ChangeNoBitOfTheMotionsOfFigure3) {
  const std::pair<std::string, Measure> measures[] = {
      {"record", measure_record}, {"minima", measure_minima}, {"branch", measure_branch}};
  for (const double omega : {0.28, 0.395, 0.47, 0.6, 0.61, 0.625, 0.65, 0.69})
    for (const auto &[name, measure] : measures)
      expect_equal_in_all_units(fmt::format("{} at {}", name, omega), paper::figure3(omega),
                                measure);
}

TEST(Units, ChangeNoBitOfThePairsOfTableI) {
  for (const paper::PairScene &shown : paper::table1_scenes())
    expect_equal_in_all_units(
        shown.pair, shown.scene,
        [&shown](const Scene &scene, const Units &units, Measured &measured) {
          PressedEventRecorder recorder(scene, std::ldexp(shown.from, units.time));
          require_complete(simulate(scene, std::ldexp(shown.to, units.time), recorder));
          const std::vector<PairedEvents> pairs = event_pairs(recorder.events);
          EXPECT_FALSE(pairs.empty()) << shown.pair;
          for (const PairedEvents &pair : pairs) {
            measured.add(static_cast<int>(pair.kind));
            measured.add(pair.mass);
            measured.add(pair.from, units.time);
            measured.add(pair.to, units.time);
          }
        });
}

}  // namespace
