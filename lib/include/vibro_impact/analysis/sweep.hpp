// Sweeps: records of many parameter points, shared out among the threads of one machine (OpenMP)
// and among the processes of many (MPI, or whatever carries texts between them).
//
// Both levels take the next few points whenever they are ready for more. Every point is computed on
// its own and the records are handed over in the order of the points, so that nothing depends on
// the number of threads or processes.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "orbit_record.hpp"
#include "parameter.hpp"
#include "vibro_impact/table.hpp"

namespace vibro_impact {

// The processes of a sweep. Rank 0 hands out the work and gets the records.
struct Ranks {
  // What a process tells rank 0 when it asks for more: the work handed in (nothing yet, the text of
  // a block of points, an error that ends the sweep), or that it needs no more.
  enum class Note { ready, done, failed, leaving };
  // The answer: a block of points to work on, or none.
  using Answer = std::function<std::size_t(Note, std::size_t block, std::string_view text)>;
  static constexpr std::size_t none = static_cast<std::size_t>(-1);

  int rank = 0, size = 1;
  // On ranks above 0: what rank 0 answers. Called by one thread at a time.
  Answer ask = {};
  // On rank 0: lets `answer` answer one process that asks; false when none is waiting.
  std::function<bool(const Answer &answer)> serve = {};
};

struct SweepOptions {
  int threads = 0;         // of this process, >= 0; 0: as many as OpenMP offers
  std::size_t first = 0;   // point to begin with: those before it have been taken already
  std::size_t block = 16;  // points handed out at once, >= 1
  Ranks ranks = {};
  std::function<void(std::size_t done)> progress = {};  // points taken so far, on rank 0
};

// The threads that a sweep uses if it is not told: 1 without OpenMP.
int available_threads();

// The values of one parameter at equal distances, both ends included.
struct Axis {
  Parameter parameter;
  double from = 0.0, to = 0.0;
  std::size_t count = 1;  // >= 1; 1: `from` alone

  double value(std::size_t k) const;
};

// The points of a grid in the order of nested loops, the last axis innermost.
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

// Computes the records of the points from SweepOptions::first on, each by `compute`, and hands them
// to `take` in the order of the points: on rank 0, one at a time. Throws what either throws
// (of several errors, one; from another process a std::runtime_error with its message).
void sweep(std::size_t points, const std::function<OrbitRecord(std::size_t)> &compute,
           const std::function<void(std::size_t, const OrbitRecord &)> &take,
           const SweepOptions &options = {});

// The records of all points of a grid, of the motions from the scene's own initial state; empty on
// ranks above 0.
std::vector<OrbitRecord> sweep(const Grid &grid, const RecordOptions &records = {},
                               const SweepOptions &options = {});

// The table of a sweep: the parameters of the axes, then period, sticks1 .., impacts1 .. (per
// forcing period), dual_sticking (0 or 1) and, where RecordOptions asks for them, lyapunov and
// pairs
// ("DS SI", "-" for none). The cells of a record of no periods, of a point that was given up, are
// empty.
Table sweep_table(const Grid &grid, const RecordOptions &records);
void add_row(Table &table, const Grid &grid, const RecordOptions &records, std::size_t point,
             const OrbitRecord &record);

}  // namespace vibro_impact
