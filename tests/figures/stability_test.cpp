// The extreme scenes: every event against its truth, no penetration, bounded work.
#include <gtest/gtest.h>

#include <algorithm>

#include "figures/measures/extreme_verdict.hpp"
#include "reference/scenes/extreme_scenes.hpp"
#include "reference/scenes/paper_scenes.hpp"
#include "reference/truth/event_comparison.hpp"
#include "tests/support/events.hpp"
#include "tests/support/rates.hpp"
#include "tests/support/tables.hpp"
#include "vibro_impact/analysis/analysis.hpp"
#include "vibro_impact/vibro_impact.hpp"

namespace {

using namespace vibro_impact;
using namespace vibro_impact::stability;
using namespace vibro_impact::truth;
using extremes::one_mass;

const EventTables &reference() {
  static const EventTables tables =
      truth::read_event_tables(REFERENCE_DIR "/extreme_events.csv", "case");
  return tables;
}

// Rate of the fastest mode of any contact mode or of the forcing.
double fastest_rate(const Scene &scene) {
  const double stiffest = vibro_impact::testing::largest_eigenvalue_bound(scene);
  return std::max(vibro_impact::testing::root_modulus(scene.beta * stiffest, stiffest),
                  scene.omega);
}

// The longest expansion of a flight, in radians of its fastest rate.
constexpr double max_reach = 2.0;

// The work of a run is bounded by
//   expansions <= rate * until / max_reach + impacts + releases + limits + 1 :
// one per reach of the fastest rate, one per event that ends one early, one to look across the
// limit of a chatter, and
//   root iterations <= 12 * polynomials searched :
// few steps lead to a transversal root, and few over a dip that all but touches zero: stretches
// that are clear grow shorter by powers of two, until one carries over it.
void expect_bounded_work(const Case &extreme, const Counters &counters) {
  const double reaches = fastest_rate(extreme.scene) * extreme.until / max_reach;
  const auto events =
      static_cast<double>(counters.impacts + counters.releases + counters.chatter_limits);
  EXPECT_LE(static_cast<double>(counters.expansions), reaches + events + 1.0) << extreme.name;
  EXPECT_LE(counters.root_iterations, 12 * counters.roots_searched) << extreme.name;
}

// The verdict is that of figures/measures/extreme_verdict.hpp, which says what it allows.
TEST(Extremes, AgreeWithTheTruthWithinRounding) {
  for (const Case &extreme : extreme_cases()) {
    const ExtremeErrors measured = measure(extreme, reference());
    EXPECT_TRUE(passes(measured, extreme.truth))
        << extreme.name << ": " << measured.difference << " time " << measured.error.time
        << ", sensitivity " << measured.sensitivity.time << ", velocity " << measured.error.velocity
        << ", sensitivity " << measured.sensitivity.velocity << ", penetration "
        << measured.penetration << ", finite " << measured.finite;
    expect_bounded_work(extreme, measured.counters);
    // One impact in each period, of which the last ones are compared. None is missing or spurious.
    if (extreme.name == "1e+06 periods") {
      EXPECT_EQ(measured.counters.impacts, 1'000'000);
    }
  }
}

// The chains with all forces, and those whose hold forces are zero together, to bounds of their
// own, with limits of chatter and with every impact. 1e-12 is some hundred roundings of a time
// of 40. Measured times are off by less than 7e-13, but for 5e-12 and 1.3e-12 in two undamped
// chains where a mass that is hardly pressed bounces ever more slowly without coming to rest.
TEST(Extremes, WithZeroOrAllForcesAgreeHoweverChatterIsResolved) {
  int compared = 0;
  for (const Case &extreme : extreme_cases()) {
    const bool zero = extreme.group == "zero hold force";
    if ((!zero && extreme.group != "forces") || extreme.truth != Truth::digits) continue;
    ++compared;
    for (const RunOptions &options : {RunOptions{}, vibro_impact::testing::all_impacts}) {
      const Differences result = truth::compare(
          vibro_impact::testing::events_of(extreme.scene, 0.0, extreme.until, options),
          reference().at(extreme.name), extreme.scene,
          {.reach = 1e-3 * Clock(extreme.scene.omega).period});
      EXPECT_EQ(result.first, "") << extreme.name;
      EXPECT_LT(result.time, zero ? 1e-11 : 1e-12) << extreme.name;
      EXPECT_LT(result.velocity, 1e-12) << extreme.name;
      EXPECT_GE(result.matched, zero ? 6u : 8u) << extreme.name;
    }
  }
  EXPECT_EQ(compared, 30);
}

// The columns of the driver's table are what their names say. 1e-15 is the rounding of a cell.
TEST(Extremes, TheTableHasTheMeasuresOfItsColumns) {
  const truth::Rows rows = truth::read_rows(
      vibro_impact::testing::tables_of("stability", "stability_cells") + "/stability.csv");
  const std::vector<Case> cases = extreme_cases();
  ASSERT_EQ(rows.size(), cases.size());
  for (std::size_t i = 0; i < cases.size(); ++i) {
    const ExtremeErrors measured = measure(cases[i], reference());
    const auto expect = [&](const char *column, double value) {
      EXPECT_NEAR(rows[i].number(column), value, 1e-15 * std::abs(value)) << column;
    };
    SCOPED_TRACE(cases[i].name);
    EXPECT_EQ(rows[i].cell("case"), cases[i].name);
    EXPECT_EQ(rows[i].cell("group"), cases[i].group);
    expect("events", static_cast<double>(measured.events));
    expect("time_error", measured.error.time);
    expect("time_sensitivity", measured.sensitivity.time);
    expect("velocity_error", measured.error.velocity);
    expect("velocity_sensitivity", measured.sensitivity.velocity);
    expect("penetration", measured.penetration);
  }
}

Case case_named(const std::string &name) {
  for (const Case &extreme : extreme_cases())
    if (extreme.name == name) return extreme;
  throw std::invalid_argument(name);
}

// The verdict is tried on a chain with chatter, sticks and releases, and on a touch.
const char *const ordinary = "c = 0.1", *const touching = "touching exactly";

// Whether the case still passes when its true events are others.
template <class Spoil>
bool passes_with(const std::string &name, const Spoil &spoil) {
  Case extreme = case_named(name);
  EventTables tables = reference();
  std::vector<Event> &truth = extreme.truth == Truth::digits ? tables.at(name) : extreme.events;
  spoil(truth);
  return passes(measure(extreme, tables), extreme.truth);
}

// The sensitivity of the ordinary case is 2: its times and velocities must be right to 1e-10. The
// events are compared as in reference_test.
TEST(Verdict, FailsForAWrongTimeVelocityOrSequence) {
  using Events = std::vector<Event>;
  EXPECT_TRUE(passes_with(ordinary, [](Events &) {}));
  EXPECT_FALSE(passes_with(ordinary, [](Events &truth) { truth[3].instant.phase += 1e-8; }));
  EXPECT_FALSE(passes_with(ordinary, [](Events &truth) { truth[3].velocity_before *= 1 + 1e-8; }));
  EXPECT_FALSE(passes_with(ordinary, [](Events &truth) { truth.erase(truth.begin() + 3); }));
  EXPECT_FALSE(passes_with(touching, [](Events &truth) { truth[0].time += 1e-6; }));
}

// A stop that is nearer by d is hit with a speed of sqrt(2 d), which no touch is.
TEST(Verdict, FailsForAnImpactWhereThereIsATouch) {
  Case nearer = case_named(touching);
  EXPECT_TRUE(passes(measure(nearer, reference()), nearer.truth));
  nearer.scene.stops[0].position *= 1.0 - 1e-13;
  EXPECT_FALSE(passes(measure(nearer, reference()), nearer.truth));
  std::vector<Event> fast = nearer.events;
  EXPECT_EQ(compare_grazing(fast, nearer.events, nearer.scene).first, "");
  fast[0].velocity_before = 6e-8;
  EXPECT_NE(compare_grazing(fast, nearer.events, nearer.scene).first, "");
}

TEST(Verdict, FailsForAPenetrationAndForANumberThatIsNotFinite) {
  EXPECT_TRUE(passes({}, Truth::grazing));
  ExtremeErrors deep, infinite;
  deep.penetration = 1e-11;
  infinite.finite = false;
  EXPECT_FALSE(passes(deep, Truth::grazing));
  EXPECT_FALSE(passes(infinite, Truth::grazing));
}

// The motion penetrates the stop of another scene, which is nearer by 0.01.
TEST(Verdict, MeasuresAPenetration) {
  const Scene scene = one_mass(0.0, 0.0, 1.0, 1.0, 0.5, -1.0);
  Scene nearer = scene;
  nearer.stops[0].position = 0.49;
  Samples samples(nearer, 10.0);
  require_complete(simulate(scene, 10.0, samples));
  EXPECT_NEAR(samples.penetration, 0.01, 5e-3);  // half a spacing of the samples at speed 0.87
}

// A field that a scene gains must be in a case: its truth is one that the library did not make.
TEST(Forces, AndAllOtherFieldsOfASceneAreInACase) {
  const auto some_case = [](const auto &holds) {
    return std::ranges::any_of(extreme_cases(), holds, &Case::scene);
  };
  for (const auto &field : list_fields)
    EXPECT_TRUE(some_case([&](const Scene &scene) { return !(scene.*field.value).empty(); }))
        << field.name;
  for (const auto &field : scalar_fields)
    EXPECT_TRUE(some_case([&](const Scene &scene) {
      return scene.*field.value != Scene{}.*field.value;
    })) << field.name;
}

// Forces that a scene leaves out cost nothing: the work is the same to the last operation, and so
// is the motion.
TEST(Forces, OfZeroChangeNothing) {
  Scene zero = paper::figure2();
  zero.sine = zero.constant = zero.ground = {0.0, 0.0};
  const Outcome without = simulate(paper::figure2(), 200.0), with = simulate(zero, 200.0);
  EXPECT_EQ(without.counters.coefficients, with.counters.coefficients);
  EXPECT_EQ(without.counters.expansions, with.counters.expansions);
  EXPECT_NEAR(without.state.displacement[0], with.state.displacement[0], 1e-13);
}

}  // namespace
