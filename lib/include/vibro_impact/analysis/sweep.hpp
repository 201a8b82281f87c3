// Sweeps: something computed at many parameter points, on all threads of the machine.
//
// The points are computed in blocks. The threads share the points of a block, each computed by one
// of them, and its results are handed over in the order of the points before the next block begins.
// So neither the results nor their order depend on the number of threads.
#pragma once

#include <algorithm>
#include <cstddef>
#include <exception>
#include <functional>
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

#include "orbit_record.hpp"
#include "parameter.hpp"
#include "vibro_impact/table.hpp"

namespace vibro_impact {

struct SweepOptions {
  int threads = 0;        // 0 to 1024; 0: available_threads()
  std::size_t first = 0;  // point to begin with: those before it have been taken already
};

// The threads that a sweep uses unless it is told: those of OpenMP, or 1 without OpenMP.
int available_threads();

// The number of points in a block, so many for each thread that the wait for the last of them is
// short beside the work. Throws std::invalid_argument for threads beyond 0 to 1024 and for a first
// point beyond `points`.
std::size_t block_size(std::size_t points, const SweepOptions &options);

// Calls `compute` for the points from `begin` to `end`, without `end`, on several threads at once.
// Returns the error of the first point that failed, or null; all points before it are computed.
std::exception_ptr compute_block(std::size_t begin, std::size_t end, int threads,
                                 const std::function<void(std::size_t point)> &compute);

// Calls take(point, compute(point)) for the points from SweepOptions::first to `points`: `compute`
// on several threads at once, `take` on the calling thread in the order of the points. The sweep
// ends with what either throws; an error of `compute` is thrown when all points before it have been
// taken. Throws std::invalid_argument as `block_size` does.
template <class Compute, class Take>
void sweep(std::size_t points, const Compute &compute, const Take &take,
           const SweepOptions &options = {}) {
  using Result = std::invoke_result_t<const Compute &, std::size_t>;
  const std::size_t block = block_size(points, options);
  for (std::size_t begin = options.first; begin < points; begin += block) {
    const std::size_t end = std::min(points, begin + block);
    std::vector<std::optional<Result>> results(end - begin);
    const std::exception_ptr failure =
        compute_block(begin, end, options.threads,
                      [&](std::size_t point) { results[point - begin].emplace(compute(point)); });
    for (std::size_t point = begin; point < end && results[point - begin]; ++point)
      take(point, *results[point - begin]);
    if (failure) std::rethrow_exception(failure);
  }
}

// The values of one parameter at equal distances, both ends included.
struct Axis {
  Parameter parameter;
  double from = 0.0, to = 0.0;
  std::size_t count = 1;  // >= 1; 1: `from` alone

  double value(std::size_t k) const;  // throws std::invalid_argument unless k < count
};

// The points of a grid in the order of nested loops, the last axis innermost. Its functions throw
// std::invalid_argument for an axis without values and for a point that it does not have.
struct Grid {
  Scene scene;  // but for the parameters of the axes
  std::vector<Axis> axes = {};

  std::size_t points() const;
  std::vector<double> values(std::size_t point) const;  // one per axis
  Scene scene_at(std::size_t point) const;
};

// Throws std::invalid_argument with one line for an axis that is empty, not finite or given twice,
// a parameter that the scene does not have, more points than can be counted, and a scene that
// `check` rejects or that has no forcing period anywhere on the grid.
void check(const Grid &grid);

// What `observable` makes of the scene of every point, in the order of the points. The result may
// be a row of numbers or anything else:
//   sweep(grid, [](const Scene &scene) { return std::vector{energy_of(scene), ...}; })
template <class Observable>
auto sweep(const Grid &grid, const Observable &observable, const SweepOptions &options = {}) {
  using Result = std::invoke_result_t<const Observable &, const Scene &>;
  check(grid);
  std::vector<Result> results;
  sweep(
      grid.points(), [&](std::size_t point) { return observable(grid.scene_at(point)); },
      [&](std::size_t, const Result &result) { results.push_back(result); }, options);
  return results;
}

// A column of the table of a sweep: its name, what it says, and how it writes the cell of a record.
struct Column {
  std::string name, meaning;
  std::function<void(Table &, const OrbitRecord &)> add_cell;
};

// The columns behind those of the axes, for a chain of so many masses. The exponent and the pairs
// of events have a column where RecordOptions asks for them.
std::vector<Column> record_columns(int masses, const RecordOptions &options);

// The table of a sweep without its rows: one column for each axis, then the columns of the records.
Table sweep_table(const Grid &grid, const RecordOptions &options);

// Adds the row of a point. The cells of a point without a record are empty behind the values of its
// parameters.
void add_row(Table &table, const Grid &grid, const RecordOptions &options, std::size_t point,
             const std::optional<OrbitRecord> &record);

}  // namespace vibro_impact
