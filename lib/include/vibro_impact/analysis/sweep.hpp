/// \file
/// Sweeps: something computed at many parameter points, on all threads of the machine. Each point
/// is computed by one of them, and the results stand in the order of the points. So they do not
/// depend on the number of threads.
///
///     #include <vibro_impact/analysis/analysis.hpp>
///     #include <cstdio>
///     int main() {
///       using namespace vibro_impact;
///       const Scene scene{.mass = {1}, .stiffness = {1}, .beta = 0.1, .amplitude = {0.5},
///                         .omega = 0.8, .restitution = 0.7, .stops = {{1, Side::upper, 0.2}}};
///       const Grid grid{scene, {{"omega", 0.5, 1.0, 11}, {"restitution", 0.5, 0.9, 5}}};
///       const auto period = [](const Scene &s) { return settle(s).period; };
///       for (const int periods : sweep(grid, period)) std::printf("%d\n", periods);
///     }
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

#include "orbit_record.hpp"
#include "parameter.hpp"
#include "table.hpp"

namespace vibro_impact {

/// The number of threads that a sweep uses by default: that of OpenMP, or 1 without OpenMP.
int available_threads();

/// Calls `compute` for the points from 0 to `points`, without `points`, on several threads at once.
/// Throws what it throws at the first of the points, in their order, at which it fails, and
/// std::invalid_argument for threads beyond 0 to 1024; 0 stands for available_threads().
void compute_points(std::size_t points, int threads,
                    const std::function<void(std::size_t point)> &compute);

/// The results compute(0), compute(1), ... of so many points. Threads and errors are those of
/// `compute_points`.
template <class Compute>
auto sweep(std::size_t points, const Compute &compute, int threads = 0) {
  using Result = std::invoke_result_t<const Compute &, std::size_t>;
  static_assert(!std::is_same_v<Result, bool>, "threads cannot write into std::vector<bool>");
  std::vector<Result> results(points);
  compute_points(points, threads, [&](std::size_t point) { results[point] = compute(point); });
  return results;
}

/// The values of one parameter at equal distances or equal ratios, both ends included.
struct Axis {
  std::string parameter = {};  ///< its name
  double from = 0.0, to = 0.0;
  std::size_t count = 1;     ///< >= 1; 1: `from` alone
  bool logarithmic = false;  ///< equal ratios; the ends have the same sign, and neither is zero

  double value(std::size_t k) const;  ///< throws std::invalid_argument unless k < count
};

/// The points of a grid in the order of nested loops, the last axis innermost. Its functions throw
/// std::invalid_argument for an axis without values and for a point that it does not have.
struct Grid {
  Scene scene = {};  ///< but for the parameters of the axes
  std::vector<Axis> axes = {};

  std::size_t points() const;
  std::vector<double> values(std::size_t point) const;  ///< one per axis
  Scene scene_at(std::size_t point) const;
};

/// Throws std::invalid_argument with one line for an axis that is empty, not finite or given twice,
/// for a logarithmic axis whose ends have not the same sign, a parameter that the scene does not
/// have, more points than can be counted, and a scene that `check` rejects or that has no forcing
/// period anywhere on the grid. A start beyond a stop is refused at its point, if a displacement or
/// a stop varies.
void check(const Grid &grid);

/// The values of `observable` for the scenes of all points, in the order of the points. A value may
/// be a row of numbers or anything else:
///   sweep(grid, [](const Scene &scene) { return std::vector{energy_of(scene), ...}; })
template <class Observable>
auto sweep(const Grid &grid, const Observable &observable, int threads = 0) {
  check(grid);
  const auto compute = [&](std::size_t point) { return observable(grid.scene_at(point)); };
  return sweep(grid.points(), compute, threads);
}

/// A column of the table of a sweep: its name, what it says, how it writes the cell of a record,
/// and whether its values are continuous, or count or name something.
struct Column {
  std::string name, meaning;
  std::function<void(Table &, const OrbitRecord &)> add_cell;
  bool continuous = false;
};

/// The columns behind those of the axes, for a chain of so many masses. The exponent and the pairs
/// of events have a column where RecordOptions asks for them. Throws std::invalid_argument for
/// masses < 1.
std::vector<Column> record_columns(int masses, const RecordOptions &options);

/// The tables of a sweep, each with one column for each axis and then its own:
///   records   the columns of record_columns, one row for each point;
///   impacts   mass, velocity before, stop, side, phase within the forcing period, impulse: the
///             impacts of the records, mass by mass in the order of time;
///   section   x1, x2, ..., v1, v2, ...: the states of the records at the phase of the start.
struct SweepTables {
  Table records = {}, impacts = {}, section = {};
};

/// The tables without rows.
SweepTables sweep_tables(const Grid &grid, const RecordOptions &options);

/// Adds the rows of a point. A point without a record has a row of `records` alone, whose cells are
/// empty behind its parameters. Throws std::invalid_argument for a record of another number of
/// masses.
void add_rows(SweepTables &tables, const Grid &grid, const RecordOptions &options,
              std::size_t point, const std::optional<OrbitRecord> &record);

}  // namespace vibro_impact
