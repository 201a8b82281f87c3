// The border of the analysis of orbits: every public function refuses bad input, with one line that
// names the value and the rule.
#include <gtest/gtest.h>

#include <limits>

#include "reference/paper_scenes.hpp"
#include "tests/refusals.hpp"
#include "vibro_impact/analysis/analysis.hpp"
#include "vibro_impact/vibro_impact.hpp"

namespace {

using namespace vibro_impact;
using vibro_impact::testing::expect_refused;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr int most = std::numeric_limits<int>::max();

const Scene scene = paper::figure2();

// At rest, and spoilt.
MotionState start(void (*spoil)(MotionState &) = [](MotionState &) {}) {
  MotionState at = start_of(scene);
  spoil(at);
  return at;
}

TEST(Refusals, OfForcesAndModes) {
  const Stop none{5, Side::upper, 0.1}, on_no_side{1, Side{9}, 0.1}, nowhere{1, Side::upper, nan};
  const auto two_values = [](MotionState &at) { at.velocity = {1.0, 2.0, 3.0}; };
  expect_refused({
      {[] { natural_modes(scene, {0}); }, "held: 1 values given, the chain has 2 masses"},
      {[] {
         natural_modes(scene, {0, 9});
       },
       "held = 9: must be -1, 0 or 1"},
      {[&] { acceleration(scene, start(two_values)); }, "velocity: 3 values given"},
      {[&] { acceleration({}, start()); }, "masses = 0"},
      {[&] { pressing_force(scene, none, start()); }, "mass 5: the chain has masses 1 to 2"},
      {[&] { pressing_force(scene, on_no_side, start()); }, "side = 9: must be lower (-1) or"},
      {[&] { pressing_force(scene, nowhere, start()); }, "at nan: must be finite"},
      {[&] { pressing_force_rate(scene, none, start()); }, "mass 5: the chain has"},
      {[&] { pressing_force_rate(scene, scene.stops[0], start(two_values)); }, "3 values given"},
      {[&] { least_pressing_force(scene, start(), none); }, "mass 5: the chain has"},
      {[&] { least_gap(scene, start(), on_no_side); }, "side = 9: must be lower (-1) or"},
      {[] {
         least_gap(with(scene, {Parameter::Kind::stiffness, 1}, 1e30), start(), scene.stops[1]);
       },
       "too fast to look at a whole forcing period"},
  });
}

TEST(Refusals, OfParameters) {
  using Kind = Parameter::Kind;
  const auto value_of = [](Kind kind, int index) { return [=] { get(scene, {kind, index}); }; };
  expect_refused({
      {value_of(Kind{99}, 1), "kind of parameter = 99: there are kinds 0 to 8"},
      {[] {
         name(Parameter{Kind{-1}, 0});
       },
       "kind of parameter = -1: there are kinds 0 to 8"},
      {value_of(Kind::mass, -1), "mass-1: no such number of it"},
      {value_of(Kind::mass, 0), "needs the number of a mass, link or stop"},
      {[] {
         with(scene, Parameter{Kind::stop, most}, 0.1);
       },
       "the scene has 2 stops"},
  });
  for (const char *word : {"", "Omega", "omega1", "beta2", "stop", "stop0", "stop01", "stop-1",
                           "stop1x", "mass", "1", "stop99999999999", "restitution0"})
    expect_refused({{[&] { parameter_named(word); }, "': must be omega"}});
  for (const char *word : {"stop3", "restitution3", "amplitude3", "mass3", "velocity3"})
    expect_refused({{[&] { get(scene, parameter_named(word)); }, "3: the "}});
}

TEST(Refusals, OfWhatIsLocated) {
  const auto line = [](double x) { return x - 0.5; };
  const auto steps = [](double x) { return x > 0.5 ? 1 : 0; };
  expect_refused({
      {[&] { zero(line, nan, 1.0); }, "interval from nan to 1: must be finite"},
      {[&] { zero(line, 1.0, 0.0); }, "interval from 1 to 0: must be finite and not empty"},
      {[&] { zero(line, -1.7e308, 1.7e308); }, "wider than the range of double precision"},
      {[&] { zero(line, 1.0, 2.0); }, "no change of sign"},
      {[] { zero([](double x) { return x == 0.5 ? nan : x - 0.5; }, 0.0, 1.0); }, "f = nan at 0.5"},
      {[] { zero({}, 0.0, 1.0); }, "f: no function given"},
      {[&] { bisect(steps, 0.0, infinity); }, "interval from 0 to inf: must be finite"},
      {[&] { bisect(steps, 0.0, 1.0, nan); }, "width = nan: must be non-negative"},
      {[&] { bisect(steps, 0.6, 1.0); }, "no change to locate"},
      {[] { bisect({}, 0.0, 1.0); }, "count: no function given"},
      {[] { sticking_phases(scene, 3, 1, 1); }, "mass 3: the chain has masses 1 to 2"},
      {[] { sticking_phases(scene, 1, -1, 1); }, "settling = -1: must be non-negative"},
      {[] { sticking_phases(scene, 1, 1, 0); }, "periods = 0: must be at least 1"},
      {[] { sticking_phases(scene, 1, most, most); }, "more than an int can count"},
  });
  // Next to the largest double: the middle does not overflow.
  const auto huge = [](double x) { return x > 1.5e308 ? 1 : 0; };
  EXPECT_NEAR(bisect(huge, 1e308, 1.7e308).below / 1.5e308, 1.0, 1e-15);
}

TEST(Refusals, OfOrbits) {
  Scene unforced = scene;
  unforced.omega = 0.0;
  const auto far = [](MotionState &at) {
    at.instant.cycle = std::numeric_limits<long long>::max();
  };
  const auto finish = [](TangentRecorder &tangents, const MotionState &at) {
    const Outcome end = simulate_from(scene, at, 10.0, {}, tangents);
    tangents.finish(end.state.instant);
  };
  const auto short_of_one = [](MotionState &at) { at.displacement.pop_back(); };
  Matrix huge(4, 0);
  huge.columns = std::size_t{1} << 62;
  Scene with_one_stop = scene;
  with_one_stop.stops.pop_back();
  expect_refused({
      {[&] { time_after(unforced, start(), 1); }, "omega = 0: a stroboscopic map needs a forcing"},
      {[&] { time_after(scene, start(), -most); }, "periods = -2147483647: must be at least 1"},
      {[&] { time_after(scene, start(far), most); }, "period 9223372036854775807: must lie in"},
      {[&] { stroboscopic_map(scene, start(short_of_one), 1); }, "displacement: 1 values given"},
      {[&] { stroboscopic_map_and_derivative(scene, start(short_of_one), 1); }, "1 values given"},
      {[&] { state_after_periods(scene, 0); }, "periods = 0: must be at least 1"},
      {[&] { at_quiet_phase(unforced, start()); }, "omega = 0: a stroboscopic map needs"},
      {[&] { find_periodic_orbit(scene, start(), 0); }, "periods = 0: must be at least 1"},
      {[&] { find_periodic_orbit(scene, start(), 1, {.max_iterations = -1}); }, "= -1: must be"},
      {[&] { find_periodic_orbit(scene, start(), 1, {.tolerance = nan}); }, "tolerance = nan"},
      {[&] { find_periodic_orbit(scene, start(short_of_one)); }, "displacement: 1 values given"},
      {[] {
         floquet_multipliers(Matrix(3, 4), {0, 0});
       },
       "derivative: 3 x 4 values given"},
      {[&] { TangentRecorder(scene, start(), Matrix(3, 1)); }, "columns"},
      {[&] {
         TangentRecorder tangents(scene, start(), Matrix(4, 1));
         finish(tangents, start());
         finish(tangents, start());
       },
       "tangents: an event after the end"},
      {[&] {
         TangentRecorder tangents(scene, start(), Matrix(4, 1));
         finish(tangents, start());
         tangents.finish({0, 10.0});
       },
       "tangents: finished already"},
      {[&] { TangentRecorder(scene, start(), huge); }, "columns: 4 rows given"},
      {[&] {
         TangentRecorder tangents(with_one_stop, start(), Matrix(4, 1));
         simulate(scene, 50.0, {}, tangents);
       },
       "tangents: an event at stop 1 of mass 2 of 2: not of the scene"},
      {[&] {
         TangentRecorder tangents(scene, start(), Matrix(4, 1));
         tangents.finish({-1, 0.0});
       },
       "in period -1: must not lie before the start"},
  });
}

TEST(Refusals, OfPairsOfEvents) {
  expect_refused({
      {[] { abbreviation(EventPair{9}); }, "pair of events = 9: there are 0 to 5"},
      {[] {
         PressedEventRecorder recorder{{}};
         simulate(scene, 60.0, {}, recorder);
       },
       "the scene has 0 stops"},
  });
}

}  // namespace
