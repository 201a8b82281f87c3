// Sweeps: what the user wants to know of many parameter points, on all threads of the machine.
//
// Every point is computed on its own by whichever thread is free, and the results are handed over
// in the order of the points: nothing depends on the number of threads.
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <type_traits>
#include <vector>

#include "orbit_record.hpp"
#include "parameter.hpp"
#include "vibro_impact/table.hpp"

namespace vibro_impact {

struct SweepOptions {
  int threads = 0;        // 0 to 1024; 0: available_threads()
  std::size_t first = 0;  // point to begin with: those before it have been taken already
  std::function<void(std::size_t done)> progress = {};  // told the number of points taken so far
};

// The threads that a sweep uses if it is not told: those of OpenMP, or 1 without it.
int available_threads();

// Calls `compute` for the points from SweepOptions::first to `points`, on several threads at once,
// and what it returns in the order of the points, one at a time. The sweep ends with what either
// throws: of several errors that of the first point, when all before it have been taken. Throws
// std::invalid_argument for threads beyond 0 to 1024, a first point beyond the last, no function.
void sweep_in_order(std::size_t points,
                    const std::function<std::function<void()>(std::size_t point)> &compute,
                    const SweepOptions &options = {});

// The same with a result of any type: take(point, compute(point)).
template <class Compute, class Take>
void sweep(std::size_t points, const Compute &compute, const Take &take,
           const SweepOptions &options = {}) {
  using Result = std::invoke_result_t<const Compute &, std::size_t>;
  const std::function<Result(std::size_t)> computed(compute);
  const std::function<void(std::size_t, const Result &)> taken(take);
  if (!computed || !taken) return sweep_in_order(points, nullptr, options);
  sweep_in_order(
      points,
      [&](std::size_t point) -> std::function<void()> {
        return [&taken, point, result = computed(point)] { taken(point, result); };
      },
      options);
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

// What `observable` makes of the scene of every point, be it a row of numbers or anything else:
//   sweep(grid, [](const Scene &scene) { return std::vector{energy_of(scene), ...}; })
// in the order of the points.
template <class Observable>
auto sweep(const Grid &grid, const Observable &observable, const SweepOptions &options = {}) {
  using Result = std::invoke_result_t<const Observable &, const Scene &>;
  check(grid);
  const std::function<Result(const Scene &)> observed(observable);
  std::function<Result(std::size_t)> compute;
  if (observed) compute = [&](std::size_t point) { return observed(grid.scene_at(point)); };
  std::vector<Result> found;
  sweep(
      grid.points(), compute,
      [&found](std::size_t, const Result &result) { found.push_back(result); }, options);
  return found;
}

// The row of numbers of a record: period, sticks of every mass, impacts of every mass (both per
// forcing period), dual_sticking (0 or 1) and, where RecordOptions asks for them, the Lyapunov
// exponent (NaN: not decided) and the pairs (2^k for the k-th of Table I, added up).
std::vector<double> row_of(const OrbitRecord &record, const RecordOptions &records);

// The table of such rows behind the parameters of the axes: period, sticks1 .., impacts1 ..,
// dual_sticking, lyapunov, pairs ("DS SI", "-" for none). A cell that is NaN is empty; an empty row
// stands for a point that was given up, and leaves all its cells empty.
Table sweep_table(const Grid &grid, const RecordOptions &records);
void add_row(Table &table, const Grid &grid, const RecordOptions &records, std::size_t point,
             std::span<const double> row);

}  // namespace vibro_impact
