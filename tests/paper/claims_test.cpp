// Claims of the paper that hold otherwise than printed, or that no key number decides
// (reference/tables/claims.csv).
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <string>

#include "figures/measures/runs.hpp"
#include "reference/truth/table_reader.hpp"
#include "tests/support/events.hpp"
#include "vibro_impact/analysis/analysis.hpp"

namespace {

using namespace vibro_impact;
using vibro_impact::testing::events_of, vibro_impact::testing::select;

// Section 2.2: "in order to reach a sticking solution ... chatter must be complete". Without
// restitution, which the paper admits, an impact with a pressing force begins a sticking phase.
TEST(Claims, AtRestitutionZeroAMassSticksWithoutChatter) {
  const Scene scene = with(paper::figure5b(), "restitution", 0.0);
  EventRecorder recorder(0.0);
  const Outcome outcome = require_complete(simulate(scene, 930.0, recorder));
  EXPECT_EQ(outcome.counters.chatter_limits, 0);
  const auto sticks = select(recorder.events, EventKind::stick, 1);
  EXPECT_GE(sticks.size(), 40u) << "once a period";
  for (const Event &stick : sticks) {
    const auto impacts = std::ranges::count_if(recorder.events, [&](const Event &event) {
      return event.kind == EventKind::impact && event.mass == 1 && event.time == stick.time;
    });
    EXPECT_EQ(impacts, 1) << stick.time;
  }
}

// Section 3.2: "chatter peaks diminish approximately exponentionally" [sic]. A flight of duration d
// after an impact at the speed v rises by v d / 4 under a constant force, and both fall by r.
// The peaks fall by r^2 from impact to impact, but the impacts follow each other ever faster.
TEST(Claims, PeaksOfAChatterFallByTheSquareOfTheRestitution) {
  const auto impacts =
      select(events_of(paper::figure2(), 716.0, 722.1, figures::all_visible_chatter),
             EventKind::impact, 2);
  const auto peak = [&](std::size_t k) {
    return std::abs(impacts[k].velocity_after) * (impacts[k + 1].time - impacts[k].time) / 4;
  };
  const std::size_t last = impacts.size() - 2;
  ASSERT_GE(last, 10u);
  // The force changes by a thousandth in the last flights.
  EXPECT_NEAR(peak(last) / peak(last - 1), 0.49, 1e-3);
  const auto rate_in_time = [&](std::size_t k) {  // -d ln(peak) / dt
    return -std::log(peak(k) / peak(k - 1)) / (impacts[k].time - impacts[k - 1].time);
  };
  EXPECT_GT(rate_in_time(last), 20 * rate_in_time(1));
}

// Section 3.2: "impact velocities for mass 1 are all less than zero", for mass 2 "greater than
// zero".
TEST(Claims, ImpactVelocitiesHaveTheSignOfTheSide) {
  for (const double omega : {0.25, 0.4, 0.55, 0.7})
    for (const Event &event : events_of(paper::figure3(omega), 0.0, 200.0)) {
      if (event.kind != EventKind::impact) continue;
      EXPECT_GT(sign(event.side) * event.velocity_before, 0.0) << omega << " " << event.time;
    }
}

// Section 3.2: the exit boundary of mass 1 "is now dependent of the forcing frequency Omega". By
// Eq. 20 the force on mass 1 has the phase Omega t, and at a given phase no Omega.
TEST(Claims, TheExitBoundaryOfMass1HasThePhaseAndNoFrequency) {
  const auto force = [](double omega, double part_of_period) {
    const Scene scene = paper::figure3(omega);
    MotionState state = start_of(scene);
    state.displacement = {-0.3, 0.05};
    state.velocity = {0.0, 0.2};
    state.instant.phase = part_of_period * Clock(omega).period;
    return pressing_force(scene, scene.stops[0], state);
  };
  EXPECT_NEAR(force(0.2, 0.3), force(0.6, 0.3), 1e-14);  // rounding
  EXPECT_GT(std::abs(force(0.2, 0.3) - force(0.2, 0.4)), 0.1);
}

// Our text has the labels of Figure 1: masses, springs, dampers, stops, displacements and forces of
// two masses in (a) and (b), and those of mass N in (a). The drawing has them in its digest, where
// the force is A cos(Omega t), on mass 1 alone in (b).
TEST(Claims, Figure1HasTheLabelsOfTheText) {
  std::ifstream file = truth::opened(SOURCE_DIR "/tests/pictures/figure1.txt");
  const std::string digest{std::istreambuf_iterator<char>(file), {}};
  const auto times_drawn = [&](const std::string &label) {
    int count = 0;
    for (auto at = digest.find(label); at != std::string::npos; at = digest.find(label, at + 1))
      ++count;
    return count;
  };
  for (const char quantity : {'m', 'k', 'c', 's', 'x'})
    for (const char mass : {'1', '2'})
      EXPECT_EQ(times_drawn(std::string{'"', '/', quantity, '/', '_', mass}), 2)
          << quantity << mass;
  for (const std::string quantity : {"m", "s", "x"})
    EXPECT_EQ(times_drawn("\"/" + quantity + "/_N"), 1) << quantity;
  EXPECT_EQ(times_drawn("\"/A/_1^ cos"), 2);
  EXPECT_EQ(times_drawn("\"/A/_2^ cos") + times_drawn("\"/A/_N^ cos"), 2);
}

}  // namespace
