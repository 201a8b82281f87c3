// Sweeps: results in the order of the points for any number of threads, and errors that end a
// sweep; the points of grids and the rows of their tables.
#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <map>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "reference/paper_scenes.hpp"
#include "tests/refusals.hpp"
#include "vibro_impact/analysis/analysis.hpp"
#include "vibro_impact/vibro_impact.hpp"

namespace {

using namespace vibro_impact;
using vibro_impact::testing::expect_refused;

// Over sticking, incomplete chatter and chaos, where nothing but the same bits stay close.
Grid grid_of_figure3() {
  return {
      paper::figure2(),
      {{{Parameter::Kind::restitution}, 0.5, 0.9, 5}, {{Parameter::Kind::omega}, 0.25, 0.7, 19}}};
}

// An observable of one's own: where the motion stands after thirty periods, and its impacts there.
std::vector<double> observed(const Scene &scene) {
  const double T = Clock(scene.omega).period;
  ImpactSpeedRecorder speeds{1, 29 * T};
  const Outcome end = simulate(scene, 30 * T, {}, speeds);
  std::vector<double> row = end.state.displacement;
  row.insert(row.end(), speeds.velocities.begin(), speeds.velocities.end());
  return row;
}

TEST(Sweep, NeitherThreadsNorWhereItBeginsChangeABit) {
  const Grid grid = grid_of_figure3();
  std::vector<std::vector<double>> alone;
  for (std::size_t point = 0; point < 95; ++point) alone.push_back(observed(grid.scene_at(point)));
  for (const int threads : {1, 2, 4, 4 * available_threads()})
    EXPECT_EQ(sweep(grid, observed, {.threads = threads}), alone) << threads;
  for (const std::size_t first : {1u, 50u, 94u, 95u}) {
    std::size_t next = first;
    sweep(
        grid.points(), [&](std::size_t point) { return observed(grid.scene_at(point)); },
        [&](std::size_t point, const std::vector<double> &row) {
          EXPECT_EQ(point, next++);
          EXPECT_EQ(row, alone[point]);
        },
        {.threads = 2, .first = first});
    EXPECT_EQ(next, 95u);
  }
}

// The error of point 100 is thrown when all points before it have been taken, and ends the sweep
// with its block. Point 100 fails after a later one has been computed, if there is a thread that
// does so.
TEST(Sweep, AnErrorEndsItInTheOrderOfThePoints) {
  for (const int threads : {1, 2, 4}) {
    std::atomic<std::size_t> last = 0;
    std::size_t taken = 0;
    const auto bad_at_100 = [&](std::size_t point) {
      if (point == 100) {
        for (int waits = 0; threads > 1 && last <= 100 && waits < 1'000'000; ++waits)
          std::this_thread::yield();
        throw std::runtime_error("given up at 100");
      }
      last = std::max(last.load(), point);
      return point;
    };
    const SweepOptions options{.threads = threads};
    try {
      sweep(
          100000, bad_at_100, [&](std::size_t point, std::size_t) { taken = point + 1; }, options);
      FAIL();
    } catch (const std::runtime_error &error) {
      EXPECT_EQ(std::string(error.what()), "given up at 100");
    }
    EXPECT_EQ(taken, 100u);
    EXPECT_LT(last, 100u + block_size(100000, options));
  }
  const auto good = [](std::size_t point) { return point; };
  const auto full = [](std::size_t point, std::size_t) {
    if (point == 7) throw std::runtime_error("full");
  };
  EXPECT_THROW(sweep(100, good, full, {.threads = 2}), std::runtime_error);
}

// Cells by the names of their columns, so that another column changes nothing here.
TEST(Sweep, RecordsAreRowsOfATable) {
  Grid grid = grid_of_figure3();
  grid.axes = {{parameter_named("omega"), 0.28, 0.69, 2}};
  RecordOptions options;
  options.pairs = options.lyapunov = true;
  OrbitRecord record;
  record.period = 2;
  record.counts = {4, {1, 2}, {3, 4}, {5, 6}, true};
  record.pairs = {EventPair::dual_sticking, EventPair::sticking_impact};
  Table table = sweep_table(grid, options);
  add_row(table, grid, options, 0, record);
  add_row(table, grid, options, 1, std::nullopt);
  std::vector<std::vector<std::string>> rows;
  std::istringstream text(table.text);
  for (std::string line; std::getline(text, line);) {
    rows.emplace_back();
    std::istringstream cells(line + ",");  // the last cell may be empty, too
    for (std::string cell; std::getline(cells, cell, ',');) rows.back().push_back(cell);
  }
  ASSERT_EQ(rows.size(), 3u);
  std::map<std::string, std::string> cell;
  for (std::size_t k = 0; k < rows[0].size(); ++k) cell[rows[0][k]] = rows[1].at(k);
  const std::map<std::string, std::string> expected = {{"omega", "0.28000000000000003"},
                                                       {"period", "2"},
                                                       {"sticks1", "0.75"},
                                                       {"sticks2", "1"},
                                                       {"impacts1", "0.25"},
                                                       {"impacts2", "0.5"},
                                                       {"dual_sticking", "1"},
                                                       {"lyapunov", ""},
                                                       {"pairs", "DS SI"}};
  for (const auto &[name, value] : expected) EXPECT_EQ(cell.at(name), value) << name;
  std::vector<std::string> empty(rows[0].size());
  empty[0] = "0.68999999999999995";
  EXPECT_EQ(rows[2], empty);
}

TEST(Grid, TheLastAxisIsInnermost) {
  const Grid grid{
      paper::figure2(),
      {{parameter_named("stop1"), -0.4, -0.2, 3}, {parameter_named("omega"), 0.3, 0.6, 4}}};
  check(grid);
  ASSERT_EQ(grid.points(), 12u);
  EXPECT_EQ(grid.values(0), (std::vector{-0.4, 0.3}));
  EXPECT_EQ(grid.values(3), (std::vector{-0.4, 0.6}));
  EXPECT_EQ(grid.values(11), (std::vector{-0.2, 0.6}));
  const Scene scene = grid.scene_at(4);
  EXPECT_DOUBLE_EQ(scene.stops[0].position, -0.3);
  EXPECT_EQ(scene.omega, 0.3);
  EXPECT_EQ((Axis{{}, 2.5, 7.0, 1}.value(0)), 2.5);
}

TEST(BadCalls, OfSweepsAndRecordsAreRefusedWithOneLine) {
  const Scene good = paper::figure2();
  const Parameter omega = parameter_named("omega"), stop3{Parameter::Kind::stop, 3};
  const Axis axis{omega, 0.2, 1.0, 3};
  const Grid grid{good, {axis}};
  const auto axes = [&](const std::vector<Axis> &of) { return [&, of] { check(Grid{good, of}); }; };
  const auto number = [](std::size_t point) { return point; };
  const auto ignore = [](std::size_t, std::size_t) {};
  const auto record = [&](auto set) {
    return [&, set] {
      RecordOptions options;
      set(options);
      record_of(good, options);
    };
  };
  MotionState start = start_of(good), far_out = start;
  far_out.instant.cycle = std::numeric_limits<long long>::max();
  Scene unforced = good;
  unforced.omega = 0.0;
  expect_refused({
      {axes({{omega, 0.0, 1.0, 3}}), "omega = 0"},
      {axes({{omega, 0.2, 1.0, 0}}), "omega: 0 values"},
      {axes({{omega, 0.2, INFINITY, 2}}), "inf"},
      {axes({axis, axis}), "omega: given twice"},
      {axes({{stop3, 0.2, 1.0, 2}}), "stop"},
      {axes({{parameter_named("restitution"), 0.0, 1.1, 2}}), "1.1"},
      {axes({{omega, 0.2, 1.0, std::size_t{1} << 52}, {parameter_named("beta"), 0.1, 0.2, 3}}),
       "more points"},
      {[&] { axis.value(3); }, "value 3 of omega: there are 3"},
      {[&] { grid.values(3); }, "point 3: the grid has 3"},
      {[&] { sweep(3, number, ignore, {.threads = -1}); }, "threads = -1: must lie from 0 to"},
      {[&] { sweep(3, number, ignore, {.first = 4}); }, "first = 4: there are 3 points"},
      {record([](auto &o) { o.settle.longest = 0; }), "longest = 0"},
      {record([](auto &o) { o.settle.most = 2'000'000'000; }), "most = 2000000000"},
      {record([](auto &o) { o.settle.tolerance = NAN; }), "tolerance = nan"},
      {record([](auto &o) { o.counted = 0; }), "counted = 0"},
      {record([](auto &o) { o.slowest = -1.0; }), "slowest = -1"},
      {[&] { record_of(unforced); }, "omega = 0"},
      {[&] { settle(good, far_out); }, "period 9223372036854775807"},
      {[&] { mean_growth(good, start, 0); }, "periods = 0"},
      {[&] { mean_growth(good, MotionState{}, 100); }, "displacement: 0 values"},
  });
}

}  // namespace
