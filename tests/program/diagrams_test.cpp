// The diagrams of the program: impacts, sections, branches, and their pictures.
#include <cmath>
#include <cstdio>
#include <string>
#include <utility>
#include <vector>

#include "figures/measures/runs.hpp"
#include "program/map.hpp"
#include "tests/support/runner_program.hpp"

namespace {

using namespace vibro_impact::testing;
using namespace vibro_impact;

// Figure 3 by one command: the impacts of the driver, to the bit, on every twentieth of its
// frequencies.
TEST_F(Runner, FigureThreeIsOneCommand) {
  const Grid grid = figures::grid_of_figure3(91);
  std::string command = "sweep --vary omega=0.25:0.7:91 --slowest 1e-4 --impacts i.csv";
  if (there_is_gnuplot()) command += " --plot f.png";
  const Result result = run(command);
  ASSERT_EQ(result.status, 0) << result.err;
  EXPECT_EQ(contents(folder / "f.png").empty(), !there_is_gnuplot());
  const RecordOptions &options = figures::recorded_of_figure3;
  const auto records = sweep(grid, [&](const Scene &scene) { return record_of(scene, options); });
  SweepTables tables = sweep_tables(grid, options);
  for (std::size_t point = 0; point < records.size(); ++point)
    add_rows(tables, grid, options, point, records[point]);
  EXPECT_GT(lines(tables.impacts.text).size(), 800u);
  EXPECT_EQ(lines(contents(folder / "i.csv")), lines(tables.impacts.text));
}

// The oscillator whose free motion grazes its stop at omega = 0.822788525650785 and
// 1.145870429873032, where |1 - omega^2 + 0.1 i omega| = 1/3: the gap is three times A.
const std::string oscillator = " --masses 1 --beta 0.1 --amplitude 0.1 --stop 1:upper:0.3 ";
constexpr double upper_graze = 1.145870429873032;

// On the way up the orbit with impacts lives on above the graze; on the way down the free motion
// does not leave its stop before the graze.
TEST_F(Runner, ABranchIsFollowedUpAndDown) {
  const Result there_and_back =
      run("sweep --vary omega=1.1:1.5:81 --back --table t.csv" + oscillator);
  ASSERT_TRUE(there_and_back.err.starts_with("162 points; 0 were")) << there_and_back.err;
  const truth::Rows rows = table("t.csv");
  ASSERT_EQ(rows.size(), 162u);
  double last_up = 0.0, first_down = 0.0;
  for (std::size_t k = 0; k < rows.size(); ++k) {
    const bool up = k < 81;
    const double omega = rows.at(k).number("omega");
    EXPECT_EQ(omega, rows.at(161 - k).number("omega")) << "there and back";
    if (!(rows.at(k).number("impacts1") > 0.0)) continue;
    if (up) last_up = omega;
    if (!up && first_down == 0.0) first_down = omega;
  }
  EXPECT_GT(last_up, 1.3);
  EXPECT_LT(first_down, upper_graze);
  EXPECT_GT(first_down, upper_graze - 0.0051) << "the distance of the frequencies is 0.005";
  // A range that goes down, alone, is the second half but for its start.
  ASSERT_EQ(run("sweep --vary omega=1.5:1.1:81 --follow --table d.csv" + oscillator).status, 0);
  const truth::Rows down = table("d.csv");
  ASSERT_EQ(down.size(), 81u);
  EXPECT_EQ(down.at(0).number("omega"), 1.5);
  for (std::size_t k = 0; k < down.size(); ++k)
    EXPECT_EQ(down.at(k).number("impacts1") > 0.0, rows.at(81 + k).number("impacts1") > 0.0) << k;
}

// The start of the scene may lie beyond a stop at the points that are followed.
TEST_F(Runner, AFollowedPointNeedsNoStartWithinItsStops) {
  const Result moved = run("sweep --vary stop1=-0.3:0.1:9 --follow --table t.csv");
  EXPECT_TRUE(moved.err.starts_with("9 points; 0 were")) << moved.err;
}

// The states of --section are those of a run at whole forcing periods, and every tenth period is
// every 10P. The impacts of --impacts are those of the run, with the impulse m (1 + r) v. The
// motion counts as settled at 1e-10.
TEST_F(Runner, ASweepHasTheStatesAndImpactsOfARun) {
  const std::string heavy =
      " --masses 1 --mass 2 --stiffness 2 --beta 0.1 --amplitude 0.2 --stop 1:upper:0.3 ";
  ASSERT_EQ(run("sweep --vary omega=1.1:1.12:2 --section s.csv --impacts i.csv" + heavy).status, 0);
  ASSERT_EQ(run("run --omega 1.1 --from 400P --until 420P --every 10P --velocities --samples r.csv "
                "--events e.csv" +
                heavy)
                .status,
            0);
  EXPECT_EQ(lines(contents(folder / "s.csv"))[0], "omega,x1,v1");
  EXPECT_EQ(lines(contents(folder / "r.csv"))[0], "time,x1,v1");
  const truth::Rows section = table("s.csv"), samples = table("r.csv");
  ASSERT_EQ(section.size(), 2u);
  ASSERT_EQ(samples.size(), 3u);
  for (std::size_t k = 0; k < samples.size(); ++k)
    for (const char *coordinate : {"x1", "v1"})
      EXPECT_NEAR(samples.at(k).number(coordinate), section.at(0).number(coordinate), 1e-9);
  EXPECT_EQ(lines(contents(folder / "i.csv"))[0], "omega,mass,velocity,stop,side,phase,impulse");
  const truth::Rows impacts = table("i.csv"), events = table("e.csv");
  ASSERT_EQ(impacts.size(), 2u);
  ASSERT_EQ(events.size(), 20u);
  for (std::size_t k = 0; k < events.size(); ++k) {
    const double velocity = events.at(k).number("velocity_before");
    EXPECT_NEAR(velocity, impacts.at(0).number("velocity"), 1e-9);
    EXPECT_EQ(events.at(k).cell("stop"), impacts.at(0).cell("stop"));
    EXPECT_NEAR(events.at(k).number("phase"), impacts.at(0).number("phase"), 1e-9);
    EXPECT_NEAR(events.at(k).number("impulse"), 2.0 * 1.7 * velocity, 1e-15);
    EXPECT_NEAR(events.at(k).number("impulse"), impacts.at(0).number("impulse"), 1e-9);
  }
}

// Each picture has the panels of the masses that it shall show, by the names of their ordinates,
// and no others. Masses without a stop have none in a diagram, and a panel without points has its
// axes. The digests of tests/pictures show what every kind of picture draws.
TEST_F(Runner, APictureHasThePanelsOfItsMasses) {
  if (!there_is_gnuplot()) GTEST_SKIP() << "gnuplot is not there";
  const std::string run_files = " --velocities --samples s.csv --events e.csv ",
                    impacts = "impact velocity of mass ", ten = " --masses 10 --stop 10:upper:0.1 ";
  const struct {
    std::string command, name;
    int panels;
    std::vector<std::string> shown = {};
  } pictures[] = {
      {"run --until 50 --panels 1,10 --plot p.svg" + run_files + ten, ">x<", 2},
      {"sweep --vary omega=0.3:0.5:3 --impacts i.csv --plot p.svg" + ten, impacts, 1, {"10"}},
      {"sweep --vary omega=0.3:0.5:3 --impacts i.csv --plot p.svg --stop 1:lower:-0.3",
       impacts,
       1,
       {"1"}},
      {"sweep --vary omega=0.3:0.5:3 --impacts i.csv --plot p.svg --stop 2:upper:50",
       impacts,
       1,
       {"2"}},
      {"sweep --vary omega=0.3:0.5:3 --impacts i.csv --plot p.svg --max-steps 1", impacts, 2},
      {"sweep --vary omega=0.3:0.5:3 --impacts i.csv --plot p.svg --panels 2", impacts, 1, {"2"}},
      {"orbit --plot p.svg" + run_files, ">x<", 2},
      {"orbit --omega 0.6 --vary omega=0.57:0.61:21 --table t.csv --plot p.svg", impacts, 2},
      {"orbit --omega 0.6 --vary omega=0.57:0.61:21 --table t.csv --plot p.svg --column x2 "
       "--diagram s.csv",
       ">x<", 1},
      {"sweep --vary omega=0.3:0.5:3 --vary beta=0.1:0.2:2 --table t.csv --plot p.svg "
       "--max-steps 1",
       ">period<", 1}};
  ASSERT_EQ(run("sweep --vary omega=0.57:0.61:3 --section s.csv").status, 0);
  for (const auto &[command, name, panels, shown] : pictures) {
    SCOPED_TRACE(command);
    fs::remove(folder / "p.svg");
    const Result result = run(command);
    EXPECT_EQ(result.status, command.ends_with("--max-steps 1") ? 1 : 0) << result.err;
    const std::string picture = contents(folder / "p.svg");
    EXPECT_GT(picture.size(), 8000u) << "nearly empty";
    int found = 0;
    for (std::size_t at = 0; (at = picture.find(name, at)) != std::string::npos; at += name.size())
      ++found;
    EXPECT_EQ(found, panels);
    for (const std::string &mass : shown)
      EXPECT_NE(picture.find(name + mass + "<"), std::string::npos) << mass;
  }
}

// Points without a record and motions without a period have colours of their own.
TEST_F(Runner, AMapNamesTheClassOfEveryPoint) {
  if (!there_is_gnuplot()) GTEST_SKIP() << "gnuplot is not there";
  const std::string sweep = "sweep --table t.csv --plot p.svg --vary displacement1=-0.6:0:2 ";
  for (const auto &[options, names] : std::vector<std::pair<std::string, std::vector<std::string>>>{
           {"--vary restitution=0.1:0.9:2 --max-steps 400 --longest 20 --omega 0.3",
            {"1", "refused", "given up"}},
           {"--vary omega=0.688:0.69:2", {"2", "refused", "irregular"}}}) {
    EXPECT_EQ(run(sweep + options).status, 0);
    for (const std::string &name : names)
      EXPECT_NE(contents(folder / "p.svg").find(">" + name + "<"), std::string::npos) << name;
  }
  runner::Map map;
  for (int period = 14; period > 0; --period)
    for (int points = 0; points < (period == 3 ? 1 : 2); ++points)
      map.add({0.0, 0.0}, std::to_string(period));
  map.add({0.0, 0.0}, "none found");
  EXPECT_EQ(map.classes(), "2 4 5 6 7 8 9 10 11 12 13 14 other 'none found'");
}

// Without stops the response is that of the linear oscillator, |X| = A / |1 - Omega^2 + i Omega
// beta|. With stops it is that of the samples of a run, which miss an extreme by at most x'' h^2
// / 8.
TEST_F(Runner, ASweepHasTheResponseOfEachMass) {
  ASSERT_EQ(run("sweep --masses 1 --amplitude 0.1 --stop none --vary omega=0.5:1.5:2 --longest 900 "
                "--response --table t.csv")
                .status,
            0);
  for (const truth::Row &row : table("t.csv")) {
    const double omega = row.number("omega"),
                 x = 0.1 / std::hypot(1.0 - omega * omega, 0.1 * omega);
    EXPECT_NEAR(row.number("lowest1"), -x, 3e-8 * x);
    EXPECT_NEAR(row.number("highest1"), x, 3e-8 * x);
    EXPECT_NEAR(row.number("rms1"), x / std::sqrt(2.0), 3e-8 * x);
  }
  ASSERT_EQ(run("sweep --vary omega=0.256:0.625:2 --response --table t.csv").status, 0);
  const truth::Rows rows = table("t.csv");
  for (std::size_t k = 0; k < rows.size(); ++k) {
    const std::string omega = rows.at(k).cell("omega");
    EXPECT_EQ(rows.at(k).number("lowest1"), -0.3);
    EXPECT_EQ(rows.at(k).number("highest2"), 0.1);
    const Result orbit =
        run("orbit --omega " + omega + " --samples s.csv --every 0.0005P --summary -");
    ASSERT_EQ(orbit.status, 0);
    for (const std::string mass : {"1", "2"}) {
      const std::string begin = "mass " + mass + ": displacement from ";
      const std::size_t at = orbit.err.find(begin);
      ASSERT_LT(at, orbit.err.size()) << orbit.err;
      double lowest = 0.0, highest = 0.0, rms = 0.0;
      ASSERT_EQ(std::sscanf(orbit.err.c_str() + at + begin.size(),
                            "%lf to %lf, root mean square %lf", &lowest, &highest, &rms),
                3);
      EXPECT_NEAR(lowest, rows.at(k).number("lowest" + mass), 1e-7);
      EXPECT_NEAR(highest, rows.at(k).number("highest" + mass), 1e-7);
      EXPECT_NEAR(rms, rows.at(k).number("rms" + mass), 1e-7);
    }
    for (const std::string mass : {"1", "2"}) {
      double lowest = infinity, highest = -infinity, sum = 0.0;
      const truth::Rows samples = table("s.csv");
      for (std::size_t j = 1; j < samples.size(); ++j) {
        const double x = samples.at(j).number("x" + mass);
        lowest = std::min(lowest, x);
        highest = std::max(highest, x);
        sum += x * x;
      }
      const std::string extreme = mass == "1" ? "highest1" : "lowest2";
      EXPECT_NEAR(rows.at(k).number(extreme), mass == "1" ? highest : lowest, 2e-5) << omega;
      EXPECT_NEAR(rows.at(k).number("rms" + mass),
                  std::sqrt(sum / static_cast<double>(samples.size() - 1)), 2e-5);
    }
  }
}

}  // namespace
