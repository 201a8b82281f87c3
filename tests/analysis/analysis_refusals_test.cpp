// Every public function of the analysis refuses bad input, with one line that names the value and
// the rule. A bisection does what it promises.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "reference/scenes/paper_scenes.hpp"
#include "tests/support/refusals.hpp"
#include "vibro_impact/analysis/analysis.hpp"
#include "vibro_impact/vibro_impact.hpp"

namespace {

using namespace vibro_impact;
using vibro_impact::testing::expect_refused;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr int largest_int = std::numeric_limits<int>::max();

const Scene good_scene = paper::figure2();
const MotionState good_start = start_of(good_scene);

template <class Change>
MotionState changed(const Change &change) {
  MotionState at = good_start;
  change(at);
  return at;
}

const Scene unforced = with(good_scene, "omega", 0.0);

// The start with a displacement too few, and in the last period that can be counted.
const MotionState short_of_one = changed([](auto &at) { at.displacement.pop_back(); }),
                  far = changed(
                      [](auto &at) { at.instant.cycle = std::numeric_limits<long long>::max(); });

const auto line = [](double x) { return x - 0.5; };
const auto step = [](double x) { return x > 0.5 ? 1 : 0; };

TEST(Refusals, OfOrbits) {
  const Stop none{5, Side::upper, 0.1}, on_no_side{1, Side{9}, 0.1}, nowhere{1, Side::upper, nan};
  const Scene stiff = with(good_scene, "stiffness1", 1e30);
  const Held too_few{0}, wrong{0, 9}, free{0, 0};
  Scene free_chain = good_scene;
  free_chain.stops.clear();
  PressedEventRecorder without_stops(free_chain), of_no_chain({});
  expect_refused({
      {[&] { natural_modes(good_scene, too_few); }, "held: 1 values given, the chain has 2 masses"},
      {[&] { natural_modes(good_scene, wrong); }, "held = 9: must be -1, 0 or 1"},
      {[&] { acceleration(good_scene, short_of_one); }, "displacement: 1 values given"},
      {[&] { acceleration({}, good_start); }, "masses = 0"},
      {[&] { acceleration(good_scene, changed([](auto &at) { at.displacement[1] = nan; })); },
       "nan"},
      {[&] { acceleration(good_scene, changed([](auto &at) { at.velocity[0] = infinity; })); },
       "inf"},
      {[&] { acceleration(good_scene, changed([](auto &at) { at.instant.phase = -1.0; })); },
       "phase = -1"},
      {[&] { acceleration(good_scene, changed([](auto &at) { at.instant.phase = nan; })); },
       "phase = nan"},
      {[&] { acceleration(good_scene, changed([](auto &at) { at.instant.cycle = -1; })); },
       "in period -1"},
      {[&] {
         pressing_force(good_scene, good_scene.stops[0], changed([](auto &at) { at.held[0] = 1; }));
       },
       "it has no such stop"},
      {[&] { pressing_force(good_scene, none, good_start); },
       "mass 5: the chain has masses 1 to 2"},
      {[&] { pressing_force(good_scene, on_no_side, good_start); },
       "side = 9: must be lower (-1) or"},
      {[&] { pressing_force(good_scene, nowhere, good_start); }, "at nan: must be finite"},
      {[&] { least_pressing_force(good_scene, good_start, none); }, "mass 5: the chain has"},
      {[&] { least_gap(good_scene, good_start, on_no_side); }, "side = 9: must be lower (-1) or"},
      {[&] { least_gap(stiff, good_start, good_scene.stops[1]); },
       "too fast to look at a whole forcing"},
      {[] { zero(line, nan, 1.0); }, "interval from nan to 1: must be finite"},
      {[] { zero(line, 1.0, 0.0); }, "interval from 1 to 0: must be finite and not empty"},
      {[] { zero(line, -1.7e308, 1.7e308); }, "wider than the range of double precision"},
      {[] { zero(line, 1.0, 2.0); }, "no change of sign"},
      {[] { zero([](double x) { return x == 0.5 ? nan : line(x); }, 0.0, 1.0); }, "f = nan at 0.5"},
      {[] { bisect(step, 0.0, infinity); }, "interval from 0 to inf: must be finite"},
      {[] { bisect(step, 0.0, 1.0, nan); }, "width = nan: must be non-negative"},
      {[] { bisect(step, 0.6, 1.0); }, "no change to locate"},
      {[] { sticking_phases(good_scene, 3, 1, 1); }, "mass 3: the chain has masses 1 to 2"},
      {[] { sticking_phases(good_scene, 1, -1, 1); }, "period -1: must lie in"},
      {[] { sticking_phases(good_scene, 1, 1, 0); }, "periods = 0: must be at least 1"},
      {[] { time_after(unforced, good_start, 1); },
       "omega = 0: a stroboscopic map needs a forcing"},
      {[] { time_after(good_scene, good_start, -largest_int); },
       "periods = -2147483647: must be at least 1"},
      {[] { time_after(good_scene, far, largest_int); }, "period 9223372036854775807: must lie in"},
      {[] { stroboscopic_map(good_scene, short_of_one, 1); }, "displacement: 1 values given"},
      {[] { stroboscopic_map_and_derivative(good_scene, short_of_one, 1); }, "1 values given"},
      {[] { state_after_periods(good_scene, 0); }, "periods = 0: must be at least 1"},
      {[] { at_quiet_phase(unforced, good_start); }, "omega = 0: a stroboscopic map needs"},
      {[] { find_periodic_orbit(good_scene, good_start, 0); }, "periods = 0: must be at least 1"},
      {[] { find_periodic_orbit(good_scene, good_start, 1, -1); }, "= -1: must be"},
      {[] { find_periodic_orbit(good_scene, short_of_one); }, "displacement: 1 values given"},
      {[&] {
         floquet_multipliers(good_scene, {3, 4, {}}, free);
       },
       "derivative: 0 values of 3 x 4"},
      {[] { name(Stability{4}); }, "stability = 4: there are 0 to 3"},
      {[] { abbreviation(EventPair{9}); }, "pair of events = 9: there are 0 to 5"},
      {[&] { require_complete(simulate(good_scene, 60.0, without_stops)); },
       "recorder: its scene has 2 masses and 0 stops, that of the run 2 and 2"},
      {[&] { require_complete(simulate(good_scene, 60.0, of_no_chain)); }, "masses = 0"},
  });
}

TEST(Refusals, OfBranches) {
  const auto follow = [](const Axis &range, const FollowOptions &options = {}) {
    return [range, options] { follow_orbit(good_scene, good_start, range, options); };
  };
  expect_refused({{follow({"omega", 0.1, 0.3, 1}), "1 values: must have a finite width"},
                  {follow({"omega", 0.2, 0.2, 5}), "omega from 0.2 to 0.2"},
                  {follow({"omega", 0.3, 0.4, 5}), "omega = 0.2: must lie in the range from 0.3"},
                  {follow({"velocity2", -1.0, 1.0, 5}), "velocity2: is an initial state"},
                  {follow({"omega", 0.1, 0.3, 5}, {.most_points = 0}), "most_points = 0"},
                  {follow({"omega", 0.1, 0.3, 5}, {.periods = 0}), "periods = 0"},
                  {[] { name(BranchPoint{15}); }, "kind of a point = 15"}});
}

TEST(Refusals, OfSweepsAndRecords) {
  const std::string omega = "omega", stop3 = "stop3";
  const Axis axis{omega, 0.2, 1.0, 3};
  const Grid grid{good_scene, {axis}};
  const auto axes = [&](const std::vector<Axis> &of) {
    return [&, of] { check(Grid{good_scene, of}); };
  };
  const auto number = [](std::size_t point) { return point; };
  const auto record = [&](auto set) {
    return [&, set] {
      RecordOptions options;
      set(options);
      record_of(good_scene, options);
    };
  };
  // Counts the events of a run of the scene that has one impact, of this mass and stop.
  const auto counted = [](int mass, int stop, int periods = 1, const Held &held = {0, 0}) {
    return [mass, stop, periods, held] {
      Event event;
      event.mass = mass;
      event.stop = stop;
      counts_of(good_scene, {event}, periods, held);
    };
  };
  expect_refused({
      {axes({{omega, 0.0, 1.0, 3}}), "omega = 0"},
      {axes({{omega, 0.2, 1.0, 0}}), "omega: 0 values"},
      {axes({{omega, 0.2, INFINITY, 2}}), "inf"},
      {axes({axis, axis}), "omega: given twice"},
      {axes({{stop3, 0.2, 1.0, 2}}), "stop"},
      {axes({{"restitution", 0.0, 1.1, 2}}), "1.1"},
      {axes({{omega, 0.2, 1.0, std::size_t{1} << 52}, {"beta", 0.1, 0.2, 3}}), "more points"},
      {[&] { axis.value(3); }, "value 3 of omega: there are 3"},
      {[&] { grid.values(3); }, "point 3: the grid has 3"},
      {[&] { sweep(3, number, -1); }, "threads = -1: must lie from 0 to"},
      {record([](auto &o) { o.settle.longest = 0; }), "longest = 0"},
      {record([](auto &o) { o.slowest = -1.0; }), "slowest = -1"},
      {record([](auto &o) { o.settle.largest_period = 0; }), "largest_period = 0: must lie from 1"},
      {[&] { mean_growth(good_scene, good_start, {.error = -1.0}); },
       "error = -1: must be non-negative"},
      {[&] { same_attractor(good_scene, {.section = {{0.0}}}, {}); }, "a state of 1 coordinates"},
      {[&] { record_of(with(good_scene, "omega", 0.0)); }, "omega = 0"},
      {[&] { settle(good_scene, far); }, "period 9223372036854775807"},
      {[&] { mean_growth(good_scene, good_start, {.longest = 0}); }, "longest = 0"},
      {counted(0, 1), "mass 0: the chain has"},
      {counted(3, 1), "mass 3: the chain has"},
      {counted(1, 3), "stop 3: the scene has 2"},
      {counted(1, 1, 0), "periods = 0"},
      {counted(1, 1, 1, {0}), "held: 1 values"},
      {[&] {
         counts_of(with(good_scene, "restitution", 1.5), {}, 1, {0, 0});
       },
       "restitution = 1.5"},
      {[&] { record_columns(-1, {}); }, "masses = -1"},
      {[&] {
         SweepTables tables;
         add_rows(tables, grid, {}, 0, OrbitRecord{});
       },
       "record: counts of 0 masses"},
      {[&] { start_near(good_scene, {}); }, "displacement: 0 values"},
      {[&] { mean_growth(good_scene, MotionState{}, {}); }, "displacement: 0 values"},
  });
}

TEST(Refusals, OfParameters) {
  for (const char *word :
       {"", "Omega", "omega1", "beta2", "stop", "stop0", "stop01", "stop-1", "stop1x", "mass",
        "mass-1", "1", "stop99999999999999999999", "restitution0"})
    expect_refused({{[&] { get(good_scene, word); }, "': must be beta, omega"}});
  for (const char *word : {"stop3", "restitution3", "amplitude3", "mass3", "velocity3"})
    expect_refused({{[&] { get(good_scene, word); }, "3: the "}});
}

// The first of two jumps between the ends is located, between neighbouring numbers.
TEST(Bisection, FindsWhereTheCountFirstDiffers) {
  const CountJump jump = bisect([](double x) { return (x > 0.3) + (x > 0.6); }, 0.0, 1.0);
  EXPECT_EQ(jump.below, 0.3);
  EXPECT_EQ(jump.above, std::nextafter(0.3, 1.0));
  EXPECT_EQ(jump.count_below, 0);
  EXPECT_EQ(jump.count_above, 1);
}

// Down to a width, halving the interval; and a zero to within four roundings of it (TOMS 748).
TEST(Bisection, StopsAtItsWidth) {
  const CountJump jump = bisect([](double x) { return x > 0.3 ? 1 : 0; }, 0.0, 1.0, 0.1);
  EXPECT_EQ(jump.below, 0.25);
  EXPECT_EQ(jump.above, 0.3125);
  EXPECT_NEAR(zero([](double x) { return x * x * x - 2.0; }, 1.0, 2.0), std::cbrt(2.0), 0x1p-50);
}

// The middle of two numbers next to the largest double does not overflow.
TEST(Bisection, WorksNextToTheLargestNumber) {
  const auto huge = [](double x) { return x > 1.5e308 ? 1 : 0; };
  EXPECT_NEAR(bisect(huge, 1e308, 1.7e308).below / 1.5e308, 1.0, 1e-15);
}

}  // namespace
