// The library against orbits of one impact in closed form (reference/tables/one_impact_orbits.csv).
#include "reference/generator/tables.hpp"

#include <gtest/gtest.h>

#include <numeric>

#include "figures/check/published_results.hpp"
#include "reference/numbers/checked_number.hpp"
#include "tests/support/events.hpp"

namespace {

using namespace vibro_impact;

struct KnownOrbit {
  vibro_impact_reference::OneImpactCase given;  // with the stop of the table
  std::vector<double> row;                      // stop, time, velocity before, trace, state after
  MotionState after;
};

std::vector<KnownOrbit> known_orbits() {
  std::vector<KnownOrbit> known;
  const auto rows = truth::read_rows(REFERENCE_DIR "/one_impact_orbits.csv");
  for (auto &given : vibro_impact_reference::one_impact_cases()) {
    std::vector<double> row;
    for (const std::string &cell : rows.at(known.size()).cells())
      if (cell != given.name) row.push_back(truth::number_in(given.name, cell));
    const auto computed = vibro_impact_reference::one_impact_orbit(given);
    EXPECT_DOUBLE_EQ(row[2], static_cast<double>(computed.velocity_before)) << given.name;
    given.scene.stops[given.stop].position = row[0];
    MotionState after = start_of(given.scene);
    after.instant.phase = row[1];
    std::copy_n(row.begin() + 4, given.scene.masses(), after.displacement.begin());
    std::copy_n(row.rbegin(), given.scene.masses(), after.velocity.rbegin());
    known.push_back({given, row, after});
  }
  return known;
}

// Rounding is 1e-12 a return, which the largest multiplier amplifies. A fold has the multiplier 1.
// A nonsmooth mode has it twice, because it belongs to a family in the energy, and rounding moves a
// double eigenvalue by its root.
TEST(OneImpact, MultipliersAndFortyPeriodsAreThoseOfTheClosedForm) {
  for (const auto &[given, row, after] : known_orbits()) {
    SCOPED_TRACE(given.name);
    const MotionState start = at_quiet_phase(given.scene, after);
    const auto map = stroboscopic_map_and_derivative(given.scene, start, given.periods);
    const auto multipliers = floquet_multipliers(map.derivative, start.held);
    const auto trace = std::reduce(multipliers.begin(), multipliers.end());
    EXPECT_NEAR(trace.real(), row[3], 1e-12);
    if (given.branch == 0) {
      EXPECT_NEAR(published::multiplier_near(1.0, multipliers), 1.0,
                  given.scene.forced() ? 1e-12 : 1e-6);
    }
    const double period = Clock(given.scene.omega).period;
    const auto events =
        vibro_impact::testing::events_from(given.scene, after, row[1] + 40.5 * period);
    ASSERT_EQ(events.size(), 40u / static_cast<unsigned>(given.periods));
    const double growth = std::max(1.0, std::abs(multipliers.front()));
    double tolerance = 1e-12, time = row[1];
    for (const Event &event : events) {
      time += given.periods * period;
      tolerance = tolerance * growth + 1e-12;
      if (tolerance > 1e-6) break;
      EXPECT_NEAR(event.time, time, tolerance);
      EXPECT_NEAR(event.velocity_before, row[2], tolerance);
    }
  }
}

// From rest the stop is not reached. Newton's method finds both orbits from 1e-4 away, and
// none when the stop is 1e-4 beyond their fold.
TEST(OneImpact, TwoOrbitsCoexistWithRestUpToTheirFold) {
  for (auto &[given, row, after] : known_orbits()) {
    if (!given.scene.forced()) continue;
    SCOPED_TRACE(given.name);
    for (const int impacts : record_of(given.scene).counts.impacts) EXPECT_EQ(impacts, 0);
    MotionState guess = at_quiet_phase(given.scene, after);
    (given.branch == 0 ? given.scene.stops[given.stop].position : guess.displacement[0]) *= 1.0001;
    const PeriodicOrbit orbit = find_periodic_orbit(given.scene, guess, given.periods);
    EXPECT_EQ(orbit.converged, given.branch != 0);
    EXPECT_TRUE(given.branch == 0 || orbit.stable() == (given.branch == 1));
  }
}

// The printed speed is good to 5e-6. The amplitude is stationary at a fold, and so good to 1e-10. A
// fold at the stop d for an amplitude A is one at the stop 1 for A / d.
TEST(OneImpact, FoldsOfVividAreThoseOfTheClosedForm) {
  for (const auto &printed : numbers::checked_numbers(REFERENCE_DIR)) {
    if (printed.source != "vivid" || printed.quantity != "fold_multiplier") continue;
    const Scene scene = published::after_impact(printed.arguments).first;
    const auto fold = vibro_impact_reference::one_impact_orbit({printed.id, scene, 2, 0});
    const double amplitude = scene.amplitude[0];
    EXPECT_NEAR(amplitude / static_cast<double>(fold.stop), amplitude, 1e-10) << printed.id;
  }
}

}  // namespace
