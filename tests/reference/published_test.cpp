// Results of other authors beyond the one number of each row that `make check` compares.
#include "figures/check/published_results.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <iterator>
#include <set>

#include "figures/check/library_engine.hpp"
#include "tests/support/refusals.hpp"

namespace {

using namespace vibro_impact;
using numbers::CheckedNumber;

// The tolerance of a key number is an error of the library and not a distance to the paper's
// number: at most 1e-10 for times and frequencies. An extreme is read off samples every 1e-4, which
// miss it by 1e-8. The exit boundary is a quotient of differences of forces.
double largest_tolerance(const CheckedNumber &row) {
  if (!row.of_the_paper()) return infinity;
  if (row.quantity == "lowest" || row.quantity == "highest") return 1e-8;
  return row.quantity.starts_with("exit") ? 1e-9 : 1e-10;
}

// Key numbers and event tables are two outputs of the generator. 20 digits agree, so that a wrong
// one is seen even where it lies below the tolerance of the library. The tables follow a chatter
// down to a speed of 1e-20 only, which is the error of the time at its end.
TEST(CheckedNumbers, EveryRowIsWhole) {
  std::set<std::string> ids, asked;
  int times = 0;
  for (const CheckedNumber &row : numbers::checked_numbers(REFERENCE_DIR)) {
    EXPECT_TRUE(ids.insert(row.id).second) << row.id;
    asked.insert(row.quantity);
    EXPECT_LE(row.tolerance, largest_tolerance(row)) << row.id;
    if (!row.of_the_paper()) {
      EXPECT_GT(row.tolerance, 0.0) << row.id;
      EXPECT_NE(row.why, "") << row.id;
    } else if (row.quantity == "time") {
      std::ifstream table(REFERENCE_DIR "/" + row.arguments.text("scene") + "_events.csv");
      const std::string text{std::istreambuf_iterator<char>(table), {}};
      EXPECT_NE(text.find("\n" + row.digits.substr(0, 21)), std::string::npos) << row.id;
      ++times;
    }
  }
  EXPECT_GE(times, 6);
  for (const auto &[name, quantity] : figures::library_quantities())
    EXPECT_TRUE(asked.contains(name)) << name << ": no row asks for it";
}

// Beside the speed and the multiplier in the table. Their times end at 1e-10 (bisection); 1e-9
// covers what is left of theirs.
TEST(Vivid, TimeOfTheImpactIsThePrintedOne) {
  int points = 0;
  for (const CheckedNumber &point : numbers::checked_numbers(REFERENCE_DIR)) {
    if (point.source != "vivid" || point.quantity != "doubling_multiplier") continue;
    ++points;
    const published::OneImpactOrbit found = published::one_impact_orbit(point.arguments);
    const double period = Clock(found.scene.omega).period;
    EXPECT_NEAR(std::remainder(found.impact.time - point.arguments.at("time"), period), 0.0, 1e-9)
        << point.id;
  }
  EXPECT_GT(points, 0);
}

// A coefficient of restitution off by 1e-6 moves every number that depends on it by more than its
// tolerance. At the first impact of a ball nothing depends on it yet.
TEST(CheckedNumbers, AnErrorOfAMillionthInTheRestitutionIsSeen) {
  for (const std::string quantity :
       {"doubling_multiplier", "fold_multiplier", "impact_time", "chatter_limit", "impact_speed"}) {
    for (CheckedNumber result : numbers::checked_numbers(REFERENCE_DIR)) {
      numbers::Arguments &p = result.arguments;
      if (result.quantity != quantity || !p.contains("r") || p.at("impact", 0.0) == 1.0) continue;
      p.values["r"] = fmt::format("{}", p.at("r") - 1e-6);
      EXPECT_GT(std::abs(figures::computed(result) - result.value), result.tolerance) << result.id;
    }
  }
}

TEST(CheckedNumbers, ANumberThatIsNoneDiffersFromThePaper) {
  const numbers::Printed value{"0.382", numbers::Claim::stated, 0.3815, 0.3825};
  EXPECT_EQ(value.verdict(0.38197), numbers::Verdict::agrees);
  EXPECT_EQ(value.verdict(std::nan("")), numbers::Verdict::differs);
}

// Each fault is named in one line, with the row where a row is computed.
TEST(CheckedNumbers, UnknownQuantitiesClaimsAndArgumentsAreNamed) {
  using numbers::read_arguments;
  EXPECT_THROW(read_arguments("t.csv", "omega"), std::runtime_error);
  EXPECT_THROW(read_arguments("t.csv", "omega=1 omega=2"), std::runtime_error);
  EXPECT_THROW(truth::word_in("t.csv", "reads", numbers::claim_words), std::runtime_error);
  const auto message = [](const std::string &quantity, const std::string &given) {
    CheckedNumber number;
    number.id = "row";
    number.quantity = quantity;
    number.arguments = read_arguments("t.csv", given);
    return vibro_impact::testing::refusal<std::runtime_error>([&] { figures::computed(number); });
  };
  EXPECT_EQ(message("", ""), "row,  : quantity '': is unknown");
  EXPECT_EQ(message("chatter_limit", ""), "row, chatter_limit : argument 'mass': is missing");
  const std::string count = "scene=figure2 until=10 kind=", start = "row, count : ";
  EXPECT_EQ(message("count", count + "impact form=7").substr(0, 45),
            start + "argument 'form': must be one of ");
  EXPECT_EQ(message("count", count + "bounce"),
            start + "kind: 'bounce' must be impact, stick or release");
  EXPECT_EQ(message("time", count + "impact from=9.9"), "row, time : the run has no such event");
  EXPECT_EQ(message("changing_frequency", "scene=figure2 mass=1 near=0.3 far=0.4 motion=up"),
            "row, changing_frequency : motion: 'up' is none of: settled, from_rest, followed");
  EXPECT_EQ(message("lowest", "scene=figure6 mass=1 from=0 to=1").substr(0, 33),
            "row, lowest : scene 'figure6': mu");
}

}  // namespace
