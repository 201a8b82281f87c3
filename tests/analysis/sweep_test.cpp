// Sweeps: results in the order of the points for any number of threads, and errors that end a
// sweep; the points of grids and the rows of their tables.
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "reference/scenes/extreme_scenes.hpp"
#include "reference/scenes/paper_scenes.hpp"
#include "tests/support/tables.hpp"
#include "vibro_impact/analysis/analysis.hpp"
#include "vibro_impact/vibro_impact.hpp"

namespace {

using namespace vibro_impact;

// Over sticking, incomplete chatter and chaos, where nothing but the same bits stay close.
Grid grid_of_figure3() {
  return {paper::figure2(), {{"restitution", 0.5, 0.9, 5}, {"omega", 0.25, 0.7, 19}}};
}

// An observable of one's own: where the motion stands after thirty periods, and the velocities
// before its last events.
std::vector<double> observed(const Scene &scene) {
  const double T = Clock(scene.omega).period;
  EventRecorder recorder(29 * T, infinity);
  const Outcome end = simulate(scene, 30 * T, recorder);
  std::vector<double> row = end.state.displacement;
  for (const Event &event : recorder.events) row.push_back(event.velocity_before);
  return row;
}

TEST(Sweep, TheThreadsChangeNoBit) {
  const Grid grid = grid_of_figure3();
  std::vector<std::vector<double>> alone;
  for (std::size_t point = 0; point < 95; ++point) alone.push_back(observed(grid.scene_at(point)));
  for (const int threads : {1, 2, 4, 4 * available_threads()})
    EXPECT_EQ(sweep(grid, observed, threads), alone) << threads;
}

// The error of point 100 is thrown although a later point fails as well, before point 100 or after
// it, if there is a thread that does so. Points behind those that are under way are not computed.
TEST(Sweep, ThrowsTheErrorOfItsFirstPoint) {
  for (const int threads : {1, 2, 4})
    for (const bool later_fails_first : {true, false}) {
      std::atomic<bool> failed_at_100 = false, failed_later = false;
      std::atomic<int> computed = 0;
      const auto bad_from_100 = [&](std::size_t point) {
        ++computed;
        if (point < 100) return point;
        const bool waits = threads > 1 && (point == 100) == later_fails_first;
        const std::atomic<bool> &other = point == 100 ? failed_later : failed_at_100;
        for (int k = 0; waits && !other && k < 1'000'000; ++k) std::this_thread::yield();
        (point == 100 ? failed_at_100 : failed_later) = true;
        throw std::runtime_error("given up at " + std::to_string(point));
      };
      try {
        sweep(100000, bad_from_100, threads);
        FAIL();
      } catch (const std::runtime_error &error) {
        EXPECT_EQ(std::string(error.what()), "given up at 100");
      }
      EXPECT_LE(computed, 100 + threads);
    }
}

TEST(Sweep, RecordsAreRowsOfATable) {
  Grid grid = grid_of_figure3();
  grid.axes = {{"omega", 0.28, 0.69, 2}};
  RecordOptions options;
  options.pairs = options.lyapunov = options.attractor = true;
  OrbitRecord record;
  record.lyapunov = Growth{0.0123456, 0.00123};
  record.period = 2;
  record.attractor = 3;
  record.counts = {4, {1, 2}, {3, 4}, true};
  record.pairs = {EventPair::dual_sticking, EventPair::sticking_impact};
  SweepTables tables = sweep_tables(grid, options);
  add_rows(tables, grid, options, 0, record);
  add_rows(tables, grid, options, 1, std::nullopt);
  const truth::Rows table = vibro_impact::testing::rows_in(tables.records.text);
  ASSERT_EQ(table.size(), 2u);
  const std::map<std::string, std::string> expected = {{"omega", "0.28000000000000003"},
                                                       {"period", "2"},
                                                       {"sticks1", "0.75"},
                                                       {"sticks2", "1"},
                                                       {"impacts1", "0.25"},
                                                       {"impacts2", "0.5"},
                                                       {"dual_sticking", "1"},
                                                       {"lyapunov", "0.0123"},
                                                       {"lyapunov_error", "0.0012"},
                                                       {"attractor", "3"},
                                                       {"pairs", "DS SI"}};
  for (const auto &[name, value] : expected) {
    EXPECT_EQ(table.at(0).cell(name), value) << name;
    EXPECT_EQ(table.at(1).cell(name), name == "omega" ? "0.68999999999999995" : "") << name;
  }
}

TEST(Grid, TheLastAxisIsInnermost) {
  const Grid grid{paper::figure2(), {{"stop1", -0.4, -0.2, 3}, {"omega", 0.3, 0.6, 4}}};
  check(grid);
  ASSERT_EQ(grid.points(), 12u);
  EXPECT_EQ(grid.values(0), (std::vector{-0.4, 0.3}));
  EXPECT_EQ(grid.values(3), (std::vector{-0.4, 0.6}));
  EXPECT_EQ(grid.values(11), (std::vector{-0.2, 0.6}));
  const Scene scene = grid.scene_at(4);
  EXPECT_DOUBLE_EQ(scene.stops[0].position, -0.3);
  EXPECT_EQ(scene.omega, 0.3);
  EXPECT_EQ((Axis{{}, 2.5, 7.0, 1}.value(0)), 2.5);
  const Axis ratios{{}, -4.0, -0.04, 3, true};  // within the rounding of a logarithm
  EXPECT_EQ(ratios.value(0), -4.0);
  EXPECT_NEAR(ratios.value(1), -0.4, 1e-15);
  EXPECT_EQ(ratios.value(2), -0.04);
}

// The attractors of the motions from starts x, v of one mass, each by its first record.
std::vector<OrbitRecord> attractors_of(Scene scene, int starts, double x, double v) {
  std::vector<OrbitRecord> attractors;
  for (int k = 0; k < starts; ++k) {
    scene.displacement = {x * (2.0 * k / (starts - 1) - 1.0)};
    scene.velocity = {v * (k % 3 - 1)};
    const OrbitRecord record = record_of(scene, {.attractor = true});
    EXPECT_GT(record.period, 0) << k;
    if (std::ranges::none_of(attractors, [&](const OrbitRecord &attractor) {
          return same_attractor(scene, attractor, record);
        }))
      attractors.push_back(record);
  }
  return attractors;
}

// The two orbits of a symmetric oscillator have equal counts, and are mirror images. An orbit of
// period two is the same from either of its forcing periods, as is the rest of an unforced mass,
// which motions of other sizes have come to.
TEST(Sweep, AttractorsAreToldApartByTheirOrbits) {
  Scene symmetric = extremes::one_mass(0.1, 2.0, 2.0, 0.5, 0.5);
  symmetric.stops.push_back({1, Side::lower, -0.5});
  const std::vector<OrbitRecord> mirrored = attractors_of(symmetric, 21, 0.5, 1.5);
  ASSERT_EQ(mirrored.size(), 2u);
  EXPECT_EQ(mirrored[0].counts.impacts, mirrored[1].counts.impacts);
  const Scene resting{.mass = {1.0}, .stiffness = {1.0}, .beta = 0.5};
  EXPECT_EQ(attractors_of(resting, 9, 1.0, 1e3).size(), 1u);

  OrbitRecord doubled = record_of(paper::figure3(0.688), {.attractor = true});
  ASSERT_EQ(doubled.period, 2);
  OrbitRecord other = doubled;
  std::swap(other.section[0], other.section[1]);
  const Scene scene = paper::figure3(0.688);
  EXPECT_TRUE(same_attractor(scene, doubled, other));
  const double shift = 1e-9 * doubled.size;
  other.section[1][0] += 0.9 * shift;
  EXPECT_TRUE(same_attractor(scene, doubled, other));
  other.section[1][0] += 0.2 * shift;
  EXPECT_FALSE(same_attractor(scene, doubled, other));
  EXPECT_FALSE(same_attractor(scene, {}, {})) << "neither has settled";
}

}  // namespace
