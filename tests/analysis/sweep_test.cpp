// Sweeps: whatever the callable makes of the points, in their order, for any number of threads, and
// errors that end them; the points of grids and the rows of their tables.
#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <stdexcept>
#include <string>
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
    std::vector<std::vector<double>> found(alone.begin(),
                                           alone.begin() + static_cast<std::ptrdiff_t>(first));
    std::size_t told = first;
    sweep(
        grid.points(),
        [&](std::size_t point) {
          EXPECT_GE(point, first);
          return observed(grid.scene_at(point));
        },
        [&](std::size_t point, const std::vector<double> &row) {
          EXPECT_EQ(point, found.size());
          found.push_back(row);
        },
        {.threads = 2, .first = first, .progress = [&](std::size_t done) { told = done; }});
    EXPECT_EQ(found, alone) << first;
    EXPECT_EQ(told, 95u);
  }
}

// The first error is thrown when all points before it have been taken; none far behind it is begun.
TEST(Sweep, AnErrorEndsItInTheOrderOfThePoints) {
  for (const int threads : {1, 2, 4}) {
    std::atomic<std::size_t> last = 0;
    std::size_t taken = 0;
    const auto bad_from_100 = [&](std::size_t point) {
      last = std::max(last.load(), point);
      if (point >= 100) throw std::runtime_error("given up at " + std::to_string(point));
      return point;
    };
    try {
      sweep(100000, bad_from_100, [&](std::size_t point, std::size_t) { taken = point + 1; },
            {.threads = threads});
      FAIL();
    } catch (const std::runtime_error &error) {
      EXPECT_EQ(std::string(error.what()), "given up at 100");
    }
    EXPECT_EQ(taken, 100u);
    EXPECT_LT(last, 200u);
  }
  const auto good = [](std::size_t point) { return point; };
  const auto full = [](std::size_t point, std::size_t) {
    if (point == 7) throw std::runtime_error("full");
  };
  EXPECT_THROW(sweep(100, good, full, {.threads = 2}), std::runtime_error);
}

TEST(Sweep, RowsOfRecordsStandInATable) {
  Grid grid = grid_of_figure3();
  grid.axes = {{parameter_named("omega"), 0.28, 0.69, 2}};
  RecordOptions options;
  options.pairs = options.lyapunov = true;
  OrbitRecord record;
  record.period = 2;
  record.counts = {4, {1, 2}, {3, 4}, {5, 6}, true};
  record.pairs = {EventPair::dual_sticking, EventPair::sticking_impact};
  const std::vector<double> row = row_of(record, options);
  EXPECT_EQ(std::vector(row.begin(), row.begin() + 6),
            (std::vector{2.0, 0.75, 1.0, 0.25, 0.5, 1.0}));
  EXPECT_TRUE(std::isnan(row[6])) << "the exponent is not decided";
  Table table = sweep_table(grid, options);
  add_row(table, grid, options, 0, row);
  add_row(table, grid, options, 1, {});  // given up
  EXPECT_EQ(table.text,
            "omega,period,sticks1,sticks2,impacts1,impacts2,dual_sticking,lyapunov,pairs\n"
            "0.28000000000000003,2,0.75,1,0.25,0.5,1,,DS SI\n"
            "0.68999999999999995,,,,,,,,\n");
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
  const auto record = [&](auto change) {
    return [&, change] {
      RecordOptions options;
      change(options);
      record_of(good, options);
    };
  };
  const MotionState start = start_of(good);
  const auto far_out = [&](long long cycle) {
    return [&, cycle] {
      MotionState state = start;
      state.instant.cycle = cycle;
      settle(good, state);
    };
  };
  Scene unforced = good;
  unforced.omega = 0.0;
  constexpr long long most = std::numeric_limits<long long>::max();
  expect_refused({
      {axes({{omega, 0.0, 1.0, 3}}), "omega = 0"},
      {axes({{omega, -1.0, 1.0, 3}}), "omega = -1"},
      {axes({{omega, 0.2, 1.0, 0}}), "omega: 0 values"},
      {axes({{omega, 0.2, INFINITY, 2}}), "inf"},
      {axes({{omega, NAN, 1.0, 2}}), "nan"},
      {axes({axis, axis}), "omega: given twice"},
      {axes({{stop3, 0.2, 1.0, 2}}), "stop"},
      {axes({{parameter_named("restitution"), 0.0, 1.1, 2}}), "1.1"},
      {axes({{parameter_named("stop1"), -0.3, 0.1, 2}}), "beyond"},
      {axes({{omega, 0.2, 1.0, std::size_t{1} << 52}, {parameter_named("beta"), 0.1, 0.2, 3}}),
       "more points"},
      {[&] { axis.value(3); }, "value 3 of omega: there are 3"},
      {[&] { grid.values(3); }, "point 3: the grid has 3"},
      {[&] { grid.scene_at(99); }, "point 99"},
      {[&] {
         Grid{good, {{omega, 0.2, 1.0, 0}}}.points();
       },
       "omega: 0 values"},
      {[&] { sweep(3, number, ignore, {.threads = -1}); }, "threads = -1"},
      {[&] { sweep(3, number, ignore, {.threads = 100'000}); }, "threads = 100000: must lie from"},
      {[&] { sweep(3, number, ignore, {.first = 4}); }, "first = 4: there are 3 points"},
      {[] { sweep_in_order(1, [](std::size_t) { return nullptr; }); }, "that takes point 0"},
      {[&] {
         const RecordOptions pairs{.settle = {}, .pairs = true};
         Table table = sweep_table(grid, pairs);
         add_row(table, grid, pairs, 0, std::vector<double>(7, -1.0));
       },
       "pairs = -1: must be a sum of 2^k"},
      {[&] { sweep_in_order(3, nullptr); }, "a function is missing"},
      {[&] { sweep(3, std::function<int(std::size_t)>{}, [](std::size_t, int) {}); }, "a function"},
      {[&] { sweep(3, number, std::function<void(std::size_t, std::size_t)>{}); }, "a function"},
      {[&] { sweep(grid, std::function<int(const Scene &)>{}); }, "a function is missing"},
      {[&] {
         Table table("");
         add_row(table, grid, {}, 0, std::vector{1.0});
       },
       "a row of 1 numbers"},
      {record([](auto &o) { o.settle.longest = 0; }), "longest = 0"},
      {record([](auto &o) { o.settle.longest = 2'000'000'000; }), "longest = 2000000000"},
      {record([](auto &o) { o.settle.most = 0; }), "most = 0"},
      {record([](auto &o) { o.settle.most = 2'000'000'000; }), "most = 2000000000"},
      {record([](auto &o) { o.settle.tolerance = 0.0; }), "tolerance = 0"},
      {record([](auto &o) { o.settle.tolerance = NAN; }), "tolerance = nan"},
      {record([](auto &o) { o.counted = 0; }), "counted = 0"},
      {record([](auto &o) { o.counted = 2'000'000'000; }), "counted = 2000000000"},
      {record([](auto &o) { o.slowest = -1.0; }), "slowest = -1"},
      {record([](auto &o) { o.longest_if_stable = 1; }), "longest_if_stable = 1"},
      {[&] { record_of(unforced); }, "omega = 0"},
      {[&] { settle(unforced, start); }, "omega = 0"},
      {far_out(most), "period 9223372036854775807"},
      {far_out(-most), "period -9223372036854775807"},
      {[&] { mean_growth(unforced, start, 100); }, "omega = 0"},
      {[&] { mean_growth(good, start, 0); }, "periods = 0"},
      {[&] { mean_growth(good, MotionState{}, 100); }, "displacement: 0 values"},
  });
}

}  // namespace
