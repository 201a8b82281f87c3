// Orbits of the program: the row of the table is that of the library, the samples of one period
// close, and an unstable orbit is found from a start near it.
#include <cmath>
#include <string>
#include <vector>

#include "reference/scenes/paper_scenes.hpp"
#include "reference/truth/table_reader.hpp"
#include "tests/support/runner_program.hpp"
#include "vibro_impact/analysis/analysis.hpp"

namespace {

using namespace vibro_impact::testing;
using namespace vibro_impact;

// A row of a table by the names of its columns.
std::string cell(const fs::path &table, const std::string &column, std::size_t row = 0) {
  const truth::Row header = truth::header_of(table);
  const auto at = std::find(header.begin(), header.end(), column) - header.begin();
  return truth::read_rows(table, header.size()).at(row).at(static_cast<std::size_t>(at));
}

// The orbit of Figure 3 at Omega = 0.625 has no sticking and |mu| = 0.634608739113, computed
// independently to twelve digits.
TEST_F(Runner, AnOrbitIsThatOfTheLibraryAndItsSamplesClose) {
  const std::string files = " --table t.csv --velocities --samples s.csv --every 0.125P";
  const Result result = run("orbit --omega 0.625" + files);
  ASSERT_EQ(result.status, 0) << result.err;
  EXPECT_NE(result.out.find("modulus 0.634608739113\n"), std::string::npos) << result.out;
  EXPECT_TRUE(result.out.ends_with("\nstable\n")) << result.out;
  const Scene scene = paper::figure3(0.625);
  const PeriodicOrbit orbit =
      find_periodic_orbit(scene, at_quiet_phase(scene, record_of(scene).state));
  const fs::path table = folder / "t.csv";
  EXPECT_EQ(cell(table, "period"), "1");
  EXPECT_EQ(std::stod(cell(table, "x1")), orbit.state.displacement[0]);
  EXPECT_EQ(std::stod(cell(table, "v2")), orbit.state.velocity[1]);
  EXPECT_EQ(std::stod(cell(table, "re1")), orbit.multipliers[0].real());
  EXPECT_EQ(std::stod(cell(table, "im4")), orbit.multipliers[3].imag());
  EXPECT_EQ(cell(table, "impacts1"), "6");
  const truth::Rows rows = truth::read_rows(folder / "s.csv", 5);
  ASSERT_EQ(rows.size(), 9u);
  for (std::size_t k = 1; k < 5; ++k)  // the orbit is known to 1e-13
    EXPECT_NEAR(std::stod(rows[0][k]), std::stod(rows[8][k]), 1e-12);
}

// At Omega = 0.69 the motion is chaotic; the orbits of period 1 and 2 near its end are not.
TEST_F(Runner, OrbitsAreFoundNextToChaosOrRefusedWithTheReason) {
  expect_message(run("orbit --omega 0.69"), "--period N looks for an orbit", 1);
  expect_message(run("orbit --omega 0.69 --period 5"), "no orbit of period 5 was found: ", 1);
  EXPECT_TRUE(run("orbit --omega 0.69 --period 1").out.ends_with("\nstable\n"));
  ASSERT_EQ(run("orbit --omega 0.69 --period 2 --table t.csv").status, 0);
  EXPECT_EQ(cell(folder / "t.csv", "stable"), "0");
  EXPECT_LT(std::stod(cell(folder / "t.csv", "re1")), -1.0);
}

}  // namespace
