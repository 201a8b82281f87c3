// The generator still makes what is stored: it computes the shortest event table again.
#include <gtest/gtest.h>

#include "reference/generator/event_table.hpp"
#include "reference/truth/table_reader.hpp"

namespace {

using namespace vibro_impact::truth;
namespace reference = vibro_impact_reference;

// The columns of an event table that hold a number of 30 digits: time and both velocities.
constexpr std::size_t number_columns[] = {0, 3, 4};

// Two versions of Boost may round the last of 30 digits differently, which is at most 1e-29 of the
// number. Ten times that is allowed. The slowest impacts, of 1e-20, come out of motions of size
// one: Boost 1.74 and 1.83 differ there by 2e-32, of which fifty times as much is allowed.
TEST(Generator, ComputesTheStoredEventsOfFigure5cAgain) {
  const std::string name = REFERENCE_DIR "/figure5c_events.csv";
  std::istringstream table(
      reference::events_table(reference::simulate(reference::scene_named("figure5c")).events, 2));
  Rows computed = read_rows(table, "the computed table", 6), stored = read_rows(name, 6);
  ASSERT_EQ(computed.size(), stored.size());
  for (std::size_t row = 0; row < stored.size(); ++row) {
    for (const std::size_t column : number_columns) {
      std::string &digits = computed[row][column], &stored_digits = stored[row][column];
      const reference::Real value(digits), expected(stored_digits);
      EXPECT_LE(abs(value - expected),
                reference::Real("1e-28") * abs(expected) + reference::Real("1e-30"))
          << "row " << row + 1 << ": " << digits << " instead of " << stored_digits;
      digits = stored_digits;
    }
    EXPECT_EQ(computed[row], stored[row]) << "row " << row + 1;
  }
}

// When the first chatter is complete, followed down to a speed.
reference::Real end_of_chatter(const char *speed) {
  const auto scene = reference::in_digits(vibro_impact::paper::figure2(), 25.0);
  const auto resolution = reference::resolution_down_to(reference::Real(speed));
  for (const auto &event : reference::simulate(scene, resolution).events)
    if (event.left_out > 0) return event.time + event.left_out;
  return 0;
}

// The flights that are left out below a speed of 1e-18 last as long. Of such a speed some ten
// digits are known (event_driven.hpp).
TEST(Generator, KnowsTheTimeOfTheFlightsThatItLeavesOut) {
  const reference::Real sooner = end_of_chatter("1e-18"), later = end_of_chatter("1e-20");
  EXPECT_GT(later, 0);
  EXPECT_LE(abs(sooner - later), reference::Real("1e-27"));
}

}  // namespace
