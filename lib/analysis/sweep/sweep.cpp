#include "vibro_impact/analysis/sweep.hpp"

#ifdef _OPENMP
#include <omp.h>
#endif

#include <algorithm>
#include <chrono>
#include <exception>
#include <map>
#include <mutex>
#include <stdexcept>
#include <thread>
#include <utility>

#include "packed_record.hpp"
#include "simulation/for_analysis.hpp"

namespace vibro_impact {

namespace {

using Note = Ranks::Note;

// Where the blocks are handed out and their records handed in: on rank 0.
class Desk {
 public:
  Desk(std::size_t points, const std::function<void(std::size_t, const OrbitRecord &)> &take,
       const SweepOptions &options)
      : points_(points), take_(take), options_(options), taken_(options.first) {
    next_ = std::min(points, options.first);
  }

  // Enters what is told, and gives the next block.
  std::size_t answer(Note note, std::size_t block, std::string_view text) {
    const std::lock_guard lock(mutex_);
    if (note == Note::leaving) ++left_;
    if (note == Note::failed) fail(std::make_exception_ptr(std::runtime_error(std::string(text))));
    if (note == Note::done && !failure_) hand_in(block, text);
    return next_block();
  }
  void end_with(std::exception_ptr failure) {
    const std::lock_guard lock(mutex_);
    fail(std::move(failure));
  }
  // Processes that need no more.
  int left() {
    const std::lock_guard lock(mutex_);
    return left_;
  }
  void rethrow() const {
    if (failure_) std::rethrow_exception(failure_);
  }

 private:
  std::mutex mutex_;
  std::size_t points_;
  const std::function<void(std::size_t, const OrbitRecord &)> &take_;
  const SweepOptions &options_;
  std::size_t next_, taken_;
  std::map<std::size_t, std::string> waiting_ = {};  // for blocks before them, by the first point
  int left_ = 0;
  std::exception_ptr failure_ = nullptr;

  void fail(std::exception_ptr failure) {
    if (!failure_) failure_ = std::move(failure);
  }
  std::size_t next_block() {
    if (failure_ || next_ >= points_) return Ranks::none;
    return std::exchange(next_, next_ + std::min(options_.block, points_ - next_));
  }
  void hand_in(std::size_t block, std::string_view text) {
    waiting_.emplace(block, text);
    try {
      while (!waiting_.empty() && waiting_.begin()->first == taken_) {
        std::string_view records = waiting_.begin()->second;
        for (; !records.empty(); ++taken_) take_(taken_, unpack(records));
        waiting_.erase(waiting_.begin());
        if (options_.progress) options_.progress(taken_);
      }
    } catch (...) {
      fail(std::current_exception());
    }
  }
};

// One thread of any process: block after block, until there is none.
void work(std::size_t points, std::size_t block_size,
          const std::function<OrbitRecord(std::size_t)> &compute, const Ranks::Answer &ask) {
  std::string records;
  for (std::size_t block = ask(Note::ready, 0, {}); block != Ranks::none;
       block = ask(Note::done, block, records)) {
    records.clear();
    const std::size_t end = block + std::min(block_size, points - block);
    for (std::size_t point = block; point < end; ++point) pack(compute(point), records);
  }
}

// Rank 0 answers the others until all have left.
void serve(Desk &desk, const Ranks &ranks) {
  const Ranks::Answer answer = [&desk](Note note, std::size_t block, std::string_view text) {
    return desk.answer(note, block, text);
  };
  while (desk.left() < ranks.size - 1)
    if (!ranks.serve(answer)) std::this_thread::sleep_for(std::chrono::microseconds(100));
}

void sweep_as_rank_0(std::size_t points, const std::function<OrbitRecord(std::size_t)> &compute,
                     const std::function<void(std::size_t, const OrbitRecord &)> &take,
                     const SweepOptions &options, [[maybe_unused]] int threads) {
  Desk desk(points, take, options);
  const Ranks::Answer answer = [&desk](Note note, std::size_t block, std::string_view text) {
    return desk.answer(note, block, text);
  };
  bool serving = options.ranks.size > 1;  // by one thread more, which sleeps most of the time
  [[maybe_unused]] const int team = threads + (serving ? 1 : 0);
#pragma omp parallel num_threads(team)
  {
    bool serves = false;
#pragma omp critical(vibro_impact_sweep)
    serves = std::exchange(serving, false);
    try {
      if (serves)
        serve(desk, options.ranks);
      else
        work(points, options.block, compute, answer);
    } catch (...) {
      desk.end_with(std::current_exception());
    }
  }
  desk.rethrow();
}

void sweep_as_another(std::size_t points, const std::function<OrbitRecord(std::size_t)> &compute,
                      const SweepOptions &options, [[maybe_unused]] int threads) {
  std::mutex mutex;
  const Ranks::Answer ask = [&](Note note, std::size_t block, std::string_view text) {
    const std::lock_guard lock(mutex);
    return options.ranks.ask(note, block, text);
  };
#pragma omp parallel num_threads(threads)
  try {
    work(points, options.block, compute, ask);
  } catch (const std::exception &error) {
    ask(Note::failed, 0, error.what());
  }
  ask(Note::leaving, 0, {});
}

}  // namespace

int available_threads() {
#ifdef _OPENMP
  return omp_get_max_threads();
#else
  return 1;
#endif
}

void sweep(std::size_t points, const std::function<OrbitRecord(std::size_t)> &compute,
           const std::function<void(std::size_t, const OrbitRecord &)> &take,
           const SweepOptions &options) {
  require(options.threads >= 0, "threads = ", options.threads, ": must be non-negative");
  require(options.block >= 1, "block = ", options.block, ": must be at least 1");
  const int threads = options.threads > 0 ? options.threads : available_threads();
  if (options.ranks.rank == 0)
    sweep_as_rank_0(points, compute, take, options, threads);
  else
    sweep_as_another(points, compute, options, threads);
}

std::vector<OrbitRecord> sweep(const Grid &grid, const RecordOptions &records,
                               const SweepOptions &options) {
  check(grid);
  require(options.first == 0, "first = ", options.first, ": all points are asked for");
  std::vector<OrbitRecord> found;
  sweep(
      grid.points(), [&](std::size_t point) { return record_of(grid.scene_at(point), records); },
      [&](std::size_t, const OrbitRecord &record) { found.push_back(record); }, options);
  return found;
}

}  // namespace vibro_impact
