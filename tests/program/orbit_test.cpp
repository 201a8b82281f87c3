// Orbits of the program: the row of the table is that of the library, the samples of one period
// close, and an unstable orbit is found from a start near it.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "reference/scenes/paper_scenes.hpp"
#include "tests/support/runner_program.hpp"
#include "vibro_impact/analysis/analysis.hpp"

namespace {

using namespace vibro_impact::testing;
using namespace vibro_impact;

// The orbit of Figure 3 at Omega = 0.625 has no sticking and |mu| = 0.634608739113, computed
// independently to twelve digits.
TEST_F(Runner, AnOrbitIsThatOfTheLibraryAndItsSamplesClose) {
  const std::string files = " --table t.csv --velocities --samples s.csv --every 0.125P";
  const Result result = run("orbit --omega 0.625" + files);
  ASSERT_EQ(result.status, 0) << result.err;
  const truth::Row row = table("t.csv").at(0);
  for (const char *column : {"period", "residual", "stability", "x1", "v2", "impacts1",
                             "multiplier1_re", "multiplier4_im"})
    EXPECT_NE(result.out.find(std::string(column) + " = " + row.cell(column) + "\n"),
              std::string::npos)
        << column << " is not in " << result.out;
  EXPECT_NEAR(std::hypot(row.number("multiplier1_re"), row.number("multiplier1_im")),
              0.634608739113, 1e-12);
  const Scene scene = paper::figure3(0.625);
  const PeriodicOrbit orbit =
      find_periodic_orbit(scene, at_quiet_phase(scene, record_of(scene).state));
  EXPECT_EQ(row.cell("period"), "1");
  EXPECT_EQ(row.number("x1"), orbit.state.displacement[0]);
  EXPECT_EQ(row.number("v2"), orbit.state.velocity[1]);
  EXPECT_EQ(row.number("multiplier1_re"), orbit.multipliers[0].real());
  EXPECT_EQ(row.number("multiplier4_im"), orbit.multipliers[3].imag());
  EXPECT_EQ(row.cell("impacts1"), "6");
  double fastest = 0.0;  // of mass 1, whose stop is the lower one
  for (const Event &event : orbit.events)
    if (event.mass == 1) fastest = std::min(fastest, event.velocity_before);
  EXPECT_EQ(row.number("fastest1"), fastest);
  const truth::Rows samples = table("s.csv");
  ASSERT_EQ(samples.size(), 9u);
  for (const char *coordinate : {"x1", "x2", "v1", "v2"})  // the orbit is known to 1e-13
    EXPECT_NEAR(samples.at(0).number(coordinate), samples.at(8).number(coordinate), 1e-12);
}

// The number of samples is bounded by the periods that are looked for: a thousand would be too
// many.
TEST_F(Runner, SamplesOfAnOrbitMayBeDense) {
  const Result result = run("orbit --omega 0.625 --samples s.csv --every 5e-5P");
  ASSERT_EQ(result.status, 0) << result.err;
  EXPECT_EQ(table("s.csv").size(), 20001u);
}

// At Omega = 0.69 the motion is chaotic. At 0.688 it settles to period 2, which period 1 has lost
// its stability to: a multiplier is below -1.
TEST_F(Runner, OrbitsAreFoundNextToChaosOrRefusedWithTheReason) {
  expect_message(run("orbit --omega 0.69"), "--period N looks for an orbit", 1);
  expect_message(run("orbit --omega 0.65 --period 1 --near-start --displacement=-0.2,-0.3 "
                     "--velocity 5,-2"),
                 "no orbit of period 1 was found: iterate 1: a mass is beyond its stop", 1);
  const std::string samples = " --samples s.csv --every 0.5P";
  EXPECT_NE(run("orbit --omega 0.688" + samples).out.find("\nperiod = 2\n"), std::string::npos);
  EXPECT_EQ(table("s.csv").size(), 5u) << "over both periods";
  ASSERT_EQ(run("orbit --omega 0.688 --period 1 --table t.csv").status, 0);
  EXPECT_EQ(table("t.csv").at(0).cell("stability"), "unstable");
  EXPECT_LT(table("t.csv").at(0).number("multiplier1_re"), -1.0);
}

// One mass at omega = 1.3 settles without impacts. Downwards its branch ends where the free motion
// grazes the stop: |1 - omega^2 + 0.1 i omega| = 1/3. Both multipliers of the free motion have the
// modulus exp(-0.1 T / 2). The graze is located to 1e-12 of the range.
TEST_F(Runner, ABranchHasARowForEachPointAndEndsAtTheGrazeInClosedForm) {
  const Result result =
      run("orbit --masses 1 --beta 0.1 --amplitude 0.1 --stop 1:upper:0.3 --omega 1.3 "
          "--vary omega=1:1.5:21 --table t.csv");
  ASSERT_EQ(result.status, 0) << result.err;
  EXPECT_TRUE(result.out.ends_with("end of range at omega = 1.5\n")) << result.out;
  const truth::Rows branch = table("t.csv");
  const std::size_t last = branch.size() - 1;
  ASSERT_GT(last, 14u);  // steps of at most 0.025
  EXPECT_EQ(branch.at(0).cell("kind"), "graze");
  EXPECT_NEAR(branch.at(0).number("omega"), 1.145870429873032, 1e-12);
  for (std::size_t row = 0; row <= last; ++row) {
    const double omega = branch.at(row).number("omega");
    EXPECT_NEAR(std::hypot(branch.at(row).number("multiplier1_re"),
                           branch.at(row).number("multiplier1_im")),
                std::exp(-0.1 * std::numbers::pi / omega), 1e-13)
        << omega;
    EXPECT_EQ(branch.at(row).cell("stability"), "stable");
    if (row == 0) continue;
    EXPECT_GT(omega, branch.at(row - 1).number("omega"));
    EXPECT_EQ(branch.at(row).cell("kind"), row < last ? "orbit" : "end of range");
  }
}

}  // namespace
