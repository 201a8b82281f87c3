// Both engines give the same answer to every question of the key numbers, and the generator still
// makes the stored digits.
#include <gtest/gtest.h>

#include <set>
#include <sstream>
#include <stdexcept>

#include "figures/check/library_engine.hpp"
#include "reference/generator/tables.hpp"

namespace {

using namespace vibro_impact;
namespace reference = vibro_impact_reference;
using reference::Real, reference::DigitsEngine;

struct Question {
  std::string quantity, arguments;
  double tolerance;
};

// Short runs. 1e-10 is the tolerance of event times. Extremes are read off samples every 1e-4,
// which miss (1e-4)^2 x'' / 8, at most 1e-8 by the accelerations here. A turning point is as good
// as rounding, and so is its time to the root of rounding over x''.
const std::vector<Question> questions{
    {"count", "scene=figure2 until=60 kind=release", 0.0},
    {"count", "scene=figure5c omega=0.2 until=60 kind=stick contact_mode=1", 0.0},
    {"count", "scene=figure2 until=100 kind=stick mass=2 periods=2", 0.0},
    {"count", "scene=figure5a until=60 kind=impact mass=2 from=10 while_sticking=1", 0.0},
    {"count", "scene=figure5a until=60 kind=impact mass=2 from=10 release_of=1 before=5", 0.0},
    {"time", "scene=figure2 until=60 kind=stick mass=2 from=15", 1e-10},
    {"time", "scene=figure2 until=60 kind=release mass=1 from=15", 1e-10},
    {"interval", "scene=figure2 until=60 kind=release mass=1", 1e-10},
    {"lowest", "scene=figure2 until=60 mass=2 from=30 to=50", 1e-8},
    {"highest", "scene=figure2 until=60 mass=1 from=30 to=50", 1e-8},
    {"hold_force_peak", "scene=figure4a until=750 mass=1", 1e-12},
    {"turning_time", "scene=figure5b until=30 mass=2 from=17 to=19", 1e-10},
    {"turning_gap", "scene=figure5b until=30 mass=2 from=17 to=19", 1e-13}};

TEST(TwoEngines, GiveTheSameAnswers) {
  figures::LibraryEngine library;
  DigitsEngine digits;
  const auto in_digits = numbers::common_quantities<DigitsEngine>();
  std::set<std::string> left;
  for (const auto &[name, quantity] : in_digits) left.insert(name);
  for (const auto &[quantity, given, tolerance] : questions) {
    numbers::CheckedNumber asked;
    asked.quantity = quantity;
    asked.arguments = numbers::read_arguments("questions", given);
    const auto ours = answer(library, figures::library_quantities(), asked);
    const auto exact = answer(digits, in_digits, asked);
    EXPECT_NEAR(ours, static_cast<double>(exact), tolerance) << quantity << ' ' << given;
    left.erase(quantity);
  }
  // A bisection in 50 digits takes minutes for two masses.
  EXPECT_EQ(left, (std::set<std::string>{"changing_frequency", "grazing_frequency"}));
}

// Two versions of Boost may round the last of 30 digits differently, which is at most 1e-29 of the
// number. Ten times that is allowed. The slowest impacts, of 1e-20, come out of motions of size
// one: Boost 1.74 and 1.83 differ there by 2e-32, of which fifty times as much is allowed.
void expect_stored(const std::string &name, const std::string &computed_table) {
  std::istringstream table(computed_table);
  const truth::Rows computed = truth::read_rows(table, "the computed table"),
                    stored = truth::read_rows(REFERENCE_DIR "/" + name + "_events.csv");
  ASSERT_EQ(computed.size(), stored.size());
  for (std::size_t row = 0; row < stored.size(); ++row) {
    for (const char *column : {"time", "velocity_before", "velocity_after"}) {
      const Real value(computed[row].cell(column)), expected(stored[row].cell(column));
      EXPECT_LE(abs(value - expected), Real("1e-28") * abs(expected) + Real("1e-30"))
          << stored[row].place() << ": " << value.str(30);
    }
    for (const char *column : {"mass", "event", "contact_mode"})
      EXPECT_EQ(computed[row].cell(column), stored[row].cell(column)) << stored[row].place();
  }
}

TEST(Generator, ComputesTheStoredEventsOfFigure5cAgain) {
  const auto [name, scene, until, inferred] = paper::scene_named("figure5c");
  expect_stored(name, reference::events_table(
                          reference::simulate(reference::in_digits(scene, until)).events, 2));
}

// The chain of 200 masses takes a quarter of an hour.
TEST(Generator, ComputesTheStoredEventsOfAChainOfTenMassesAgain) {
  expect_stored("chain10", reference::chain_table(10));
}

// When the first chatter is complete, followed down to a speed.
Real end_of_chatter(const char *speed) {
  const auto scene = reference::in_digits(paper::figure2(), 25.0);
  const auto resolution = reference::resolution_down_to(Real(speed));
  for (const auto &event : reference::simulate(scene, resolution).events)
    if (event.left_out > 0) return event.time + event.left_out;
  return 0;
}

// The flights that are left out below a speed of 1e-18 last as long. Of such a speed some ten
// digits are known (event_driven.hpp).
TEST(Generator, KnowsTheTimeOfTheFlightsThatItLeavesOut) {
  const Real sooner = end_of_chatter("1e-18"), later = end_of_chatter("1e-20");
  EXPECT_GT(later, 0);
  EXPECT_LE(abs(sooner - later), Real("1e-27"));
}

// The steady motion of one mass just reaches a stop s where (1 - omega^2)^2 + (beta omega)^2 =
// 1 / s^2. The bracket of a frequency is 1e-18 wide.
TEST(Generator, FindsAGrazingFrequencyToAllStoredDigits) {
  const Scene scene{.mass = {1.0},
                    .stiffness = {1.0},
                    .beta = 1.0,
                    .amplitude = {1.0},
                    .stops = {{1, Side::upper, 0.8}}};
  const Real stop(0.8), square = (1 + sqrt(1 - 4 * (1 - 1 / (stop * stop)))) / 2;
  const auto near = static_cast<double>(sqrt(square));  // few steps of the bisection are left
  DigitsEngine engine;
  engine.settling_from_rest = 50;  // they leave exp(-25 T) < 1e-50 of the start
  const Real found = engine.grazing_frequency(scene, 1, near + 1e-14, near - 1e-14);
  EXPECT_LE(abs(found - sqrt(square)), Real("1e-18"));
}

// The same mass reaches a stop at 1.1 between the frequencies 0.473 and 0.881. The motion of 0.6
// does not reach down to 0.3, where the extrapolation to the upper one would begin.
TEST(Generator, RefusesAFrequencyThatIsNotFollowedFromOneMotion) {
  const Scene scene{.mass = {1.0},
                    .stiffness = {1.0},
                    .beta = 1.0,
                    .amplitude = {1.0},
                    .stops = {{1, Side::upper, 1.1}}};
  DigitsEngine engine;
  engine.settling_from_rest = 20;  // they leave exp(-10 T) < 1e-27 of the start
  EXPECT_THROW(engine.grazing_frequency(scene, 1, 0.6, 0.9), std::logic_error);
}

// Formulas, and all that is read off the run of Figure 5(c), the shortest one. Two versions of
// Boost may differ in the last of 30 digits.
TEST(Generator, ComputesTheStoredKeyNumbersAgain) {
  DigitsEngine engine;
  int computed = 0;
  for (const auto &number : numbers::checked_numbers(REFERENCE_DIR)) {
    if (!number.of_the_paper() ||
        (number.kind != numbers::Kind::formula && !number.given.starts_with("scene=figure5c kind")))
      continue;
    const Real stored(number.digits), again(reference::digits_of(engine, number));
    EXPECT_LE(abs(again - stored), Real("1e-28") * abs(stored))
        << number.id << ": " << again.str(30);
    ++computed;
  }
  EXPECT_EQ(computed, 11);
}

}  // namespace
