// Runs share nothing: many of them at once, on any number of threads, give the bits of one after
// another.
#include <gtest/gtest.h>
#include <omp.h>

#include <algorithm>
#include <cstring>
#include <vector>

#include "random_scenes.hpp"

namespace {

using namespace vibro_impact;
using namespace vibro_impact::testing;

struct Record {
  std::vector<Event> events = {};
  Outcome outcome = {};
};

Record run_scene(unsigned seed) {
  const Scene scene = random_scene(seed);
  RunOptions options;
  options.max_impacts_per_period = 1000;
  EventRecorder recorder;
  Record run;
  run.outcome = simulate(scene, run_length(scene, 1e9), options, recorder);
  run.events = recorder.events;
  return run;
}

std::vector<Record> run_scenes(int count, int threads) {
  std::vector<Record> runs(static_cast<std::size_t>(count));
#pragma omp parallel for num_threads(threads) schedule(dynamic, 1)
  for (int k = 0; k < count; ++k)
    runs[static_cast<std::size_t>(k)] = run_scene(static_cast<unsigned>(k) + 1);
  return runs;
}

bool same_bits(double a, double b) {
  return std::memcmp(&a, &b, sizeof a) == 0;
}

bool same_bits(const std::vector<double> &a, const std::vector<double> &b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](double x, double y) { return same_bits(x, y); });
}

bool same(const Event &a, const Event &b) {
  return a.kind == b.kind && a.stop == b.stop && a.mass == b.mass && a.side == b.side &&
         a.held == b.held && a.falling == b.falling && a.by_a_jump == b.by_a_jump &&
         a.instant.cycle == b.instant.cycle && same_bits(a.instant.phase, b.instant.phase) &&
         same_bits(a.time, b.time) && same_bits(a.velocity_before, b.velocity_before) &&
         same_bits(a.velocity_after, b.velocity_after);
}

TEST(ParallelRuns, GiveTheBitsOfRunsOneAfterAnother) {
  constexpr int count = 120;
  std::vector<Record> alone;
  for (int k = 0; k < count; ++k) alone.push_back(run_scene(static_cast<unsigned>(k) + 1));
  for (const int threads : {1, 2, 4}) {
    const std::vector<Record> runs = run_scenes(count, threads);
    for (std::size_t k = 0; k < runs.size(); ++k) {
      const Record &run = runs[k], &expected = alone[k];
      ASSERT_EQ(run.events.size(), expected.events.size())
          << threads << " threads, scene " << k + 1;
      for (std::size_t i = 0; i < run.events.size(); ++i)
        ASSERT_TRUE(same(run.events[i], expected.events[i]))
            << threads << " threads, scene " << k + 1 << ", event " << i;
      EXPECT_EQ(run.outcome.ending, expected.outcome.ending);
      EXPECT_EQ(run.outcome.reason, expected.outcome.reason);
      EXPECT_TRUE(same_bits(run.outcome.state.displacement, expected.outcome.state.displacement));
      EXPECT_TRUE(same_bits(run.outcome.state.velocity, expected.outcome.state.velocity));
      EXPECT_EQ(std::memcmp(&run.outcome.counters, &expected.outcome.counters, sizeof(Counters)), 0)
          << threads << " threads, scene " << k + 1;
    }
  }
}

}  // namespace
