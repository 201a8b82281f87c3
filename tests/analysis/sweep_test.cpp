// Sweeps: the same records for any number of threads and processes, in the order of the points, and
// errors that end them.
#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <cmath>
#include <condition_variable>
#include <mutex>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "analysis/sweep/packed_record.hpp"
#include "reference/scenes/paper_scenes.hpp"
#include "vibro_impact/analysis/analysis.hpp"
#include "vibro_impact/vibro_impact.hpp"

namespace {

using namespace vibro_impact;

// Over sticking, incomplete chatter and chaos, where nothing but the same bits stay close.
Grid grid_of_figure3() {
  return {
      paper::figure2(),
      {{{Parameter::Kind::restitution}, 0.5, 0.9, 5}, {{Parameter::Kind::omega}, 0.25, 0.7, 19}}};
}

RecordOptions everything() {
  RecordOptions options;
  options.settle.longest = 60;
  options.counted = 10;
  options.lyapunov = options.impact_velocities = options.pairs = true;
  return options;
}

// Every number of the records, bit by bit.
std::string bytes_of(const std::vector<OrbitRecord> &records) {
  std::string bytes;
  for (const OrbitRecord &record : records) pack(record, bytes);
  return bytes;
}

// One after another, by nothing but `record_of`.
const std::vector<OrbitRecord> &alone() {
  static const std::vector<OrbitRecord> records = [] {
    std::vector<OrbitRecord> found;
    for (const double r : {0.5, 0.6, 0.7, 0.8, 0.9})
      for (int k = 0; k < 19; ++k) {
        Scene scene = paper::figure2();
        scene.restitution = r;
        scene.omega = std::lerp(0.25, 0.7, k / 18.0);
        found.push_back(record_of(scene, everything()));
      }
    return found;
  }();
  return records;
}

TEST(Sweep, ThreadsDoNotChangeABit) {
  int settled = 0;
  for (const OrbitRecord &record : alone()) settled += record.period > 0 ? 1 : 0;
  EXPECT_GT(settled, 50);
  EXPECT_LT(settled, 95);
  for (const int threads : {1, 2, 4})
    for (const std::size_t block : {1u, 7u, 1000u}) {
      SweepOptions options;
      options.threads = threads;
      options.block = block;
      const std::vector<OrbitRecord> found = sweep(grid_of_figure3(), everything(), options);
      ASSERT_EQ(found.size(), 95u);
      EXPECT_TRUE(bytes_of(found) == bytes_of(alone())) << threads << " threads by " << block;
    }
}

// Processes as threads of this one: a letter box carries what they say.
class LetterBox {
 public:
  std::size_t ask(Ranks::Note note, std::size_t block, std::string_view text) {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [&] { return !waiting_; });  // one at a time
    waiting_ = true;
    answered_ = false;
    note_ = note;
    block_ = block;
    text_ = text;
    changed_.wait(lock, [&] { return answered_; });
    const std::size_t answer = answer_;
    waiting_ = answered_ = false;
    changed_.notify_all();
    return answer;
  }
  bool serve(const Ranks::Answer &answer) {
    const std::lock_guard lock(mutex_);
    if (!waiting_ || answered_) return false;
    answer_ = answer(note_, block_, text_);
    answered_ = true;
    changed_.notify_all();
    return true;
  }

 private:
  std::mutex mutex_;
  std::condition_variable changed_;
  bool waiting_ = false, answered_ = false;
  Ranks::Note note_ = Ranks::Note::ready;
  std::size_t block_ = 0, answer_ = 0;
  std::string text_;
};

using Compute = std::function<OrbitRecord(std::size_t)>;

// The records that rank 0 of `size` processes of two threads each gets, others computing by
// `compute` of their rank.
std::vector<OrbitRecord> among_processes(int size, std::size_t points,
                                         const std::function<Compute(int)> &compute) {
  LetterBox box;
  SweepOptions options;
  options.threads = 2;
  options.block = 4;
  options.ranks.size = size;
  options.ranks.ask = [&](auto... told) { return box.ask(told...); };
  options.ranks.serve = [&](const Ranks::Answer &answer) { return box.serve(answer); };
  std::vector<std::thread> others;
  for (int rank = 1; rank < size; ++rank)
    others.emplace_back([=, &compute] {
      SweepOptions there = options;
      there.ranks.rank = rank;
      sweep(
          points, compute(rank), [](std::size_t, const OrbitRecord &) { FAIL(); }, there);
    });
  std::vector<OrbitRecord> found;
  std::exception_ptr failure;
  try {
    sweep(
        points, compute(0),
        [&](std::size_t point, const OrbitRecord &record) {
          EXPECT_EQ(point, found.size());
          found.push_back(record);
        },
        options);
  } catch (...) {
    failure = std::current_exception();
  }
  for (std::thread &other : others) other.join();
  if (failure) std::rethrow_exception(failure);
  return found;
}

TEST(Sweep, ProcessesDoNotChangeABit) {
  const Grid grid = grid_of_figure3();
  for (const int size : {1, 2, 4}) {
    std::vector<std::atomic<int>> computed(static_cast<std::size_t>(size));
    const auto found = among_processes(size, grid.points(), [&](int rank) -> Compute {
      return [&, rank](std::size_t point) {
        // Rank 0 leaves the first point to the others, so that every process gets its turn.
        while (rank == 0 && size > 1 && computed[1] == 0) std::this_thread::yield();
        ++computed[static_cast<std::size_t>(rank)];
        return record_of(grid.scene_at(point), everything());
      };
    });
    EXPECT_TRUE(bytes_of(found) == bytes_of(alone())) << size;
    int sum = 0;
    for (const auto &by_one : computed) sum += by_one;
    EXPECT_EQ(sum, 95) << "no point is computed twice";
  }
}

TEST(Sweep, AnErrorOfAnotherProcessEndsAll) {
  const Compute good =
                    [](std::size_t) {  // slow, so that every process gets its turn
                      std::this_thread::sleep_for(std::chrono::milliseconds(1));
                      return OrbitRecord{};
                    },
                bad = [](std::size_t point) -> OrbitRecord {
                  throw std::runtime_error("given up at point " + std::to_string(point));
                };
  for (const int failing : {0, 1, 2}) {
    try {
      among_processes(3, 100000, [&](int rank) { return rank == failing ? bad : good; });
      FAIL() << failing;
    } catch (const std::runtime_error &error) {
      EXPECT_EQ(std::string(error.what()).rfind("given up at point ", 0), 0u) << error.what();
    }
  }
}

TEST(Sweep, GoesOnFromAnyPoint) {
  const Grid grid = grid_of_figure3();
  for (const std::size_t first : {0u, 1u, 50u, 94u, 95u}) {
    SweepOptions options;
    options.threads = 2;
    options.first = first;
    std::vector<OrbitRecord> found(alone().begin(),
                                   alone().begin() + static_cast<std::ptrdiff_t>(first));
    std::size_t told = first;
    options.progress = [&](std::size_t done) { told = done; };
    sweep(
        grid.points(),
        [&](std::size_t point) {
          EXPECT_GE(point, first);
          return record_of(grid.scene_at(point), everything());
        },
        [&](std::size_t point, const OrbitRecord &record) {
          EXPECT_EQ(point, found.size());
          found.push_back(record);
        },
        options);
    EXPECT_TRUE(bytes_of(found) == bytes_of(alone())) << first;
    EXPECT_EQ(told, 95u);
  }
}

TEST(Sweep, ErrorsLeaveTheParallelLoop) {
  SweepOptions options;
  options.threads = 2;
  const auto good = [](std::size_t) { return OrbitRecord{}; };
  const auto ignore = [](std::size_t, const OrbitRecord &) {};
  EXPECT_THROW(sweep(
                   100, [](std::size_t) -> OrbitRecord { throw std::invalid_argument("bad"); },
                   ignore, options),
               std::invalid_argument);
  EXPECT_THROW(
      sweep(
          100, good, [](std::size_t, const OrbitRecord &) { throw std::runtime_error("full"); },
          options),
      std::runtime_error);
  options.block = 0;
  EXPECT_THROW(sweep(100, good, ignore, options), std::invalid_argument);
  options.block = 1;
  options.threads = -1;
  EXPECT_THROW(sweep(100, good, ignore, options), std::invalid_argument);
}

TEST(Sweep, ARecordCutShortIsRefused) {
  std::string bytes;
  pack(alone().front(), bytes);
  std::string_view whole = bytes;
  const OrbitRecord again = unpack(whole);
  EXPECT_TRUE(whole.empty());
  EXPECT_TRUE(bytes_of({again}) == bytes);
  for (std::size_t length = 0; length < bytes.size(); ++length) {
    std::string_view part(bytes.data(), length);
    EXPECT_THROW(unpack(part), std::runtime_error) << length;
  }
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

TEST(Grid, WhatMakesNoSenseIsRefused) {
  const auto refused = [](const std::vector<Axis> &axes, const std::string &names) {
    try {
      check(Grid{paper::figure2(), axes});
      ADD_FAILURE() << names;
    } catch (const std::invalid_argument &error) {
      EXPECT_NE(std::string(error.what()).find(names), std::string::npos) << error.what();
      EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
    }
  };
  const Parameter omega = parameter_named("omega"), stop3{Parameter::Kind::stop, 3};
  refused({{omega, 0.0, 1.0, 3}}, "omega = 0");
  refused({{omega, -1.0, 1.0, 3}}, "omega = -1");
  refused({{omega, 0.2, 1.0, 0}}, "omega: 0 values");
  refused({{omega, 0.2, INFINITY, 2}}, "inf");
  refused({{omega, NAN, 1.0, 2}}, "nan");
  refused({{omega, 0.2, 1.0, 2}, {omega, 0.2, 1.0, 2}}, "omega: given twice");
  refused({{stop3, 0.2, 1.0, 2}}, "stop");
  refused({{parameter_named("restitution"), 0.0, 1.1, 2}}, "1.1");
  refused({{parameter_named("stop1"), -0.3, 0.1, 2}}, "beyond");
  refused({{omega, 0.2, 1.0, std::size_t{1} << 52}, {parameter_named("beta"), 0.1, 0.2, 3}},
          "more points");
}

}  // namespace
