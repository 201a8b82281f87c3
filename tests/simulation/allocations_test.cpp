// No memory is asked for between the first event of a run and the last, but for the entry of a
// contact mode that the run has not been in before.
#include <gtest/gtest.h>

#include <cstdlib>
#include <new>

#include "reference/scenes/extreme_cases.hpp"
#include "vibro_impact/simulate.hpp"

namespace {

long long allocations = 0;

}  // namespace

// Not inlined, so that the compiler does not see that the one calls malloc and the other free.
[[gnu::noinline]] void *operator new(std::size_t size) {
  ++allocations;
  if (void *memory = std::malloc(size)) return memory;
  throw std::bad_alloc();
}
[[gnu::noinline]] void operator delete(void *memory) noexcept {
  std::free(memory);
}
[[gnu::noinline]] void operator delete(void *memory, std::size_t) noexcept {
  std::free(memory);
}

namespace {

using namespace vibro_impact;

// Allocations since the event at `from`, as they stood at the latest event.
struct Allocations {
  double from = 0.0;
  long long at_first = -1, at_latest = 0;
  int events = 0;

  void event(const Event &event, const Moment &) {
    if (event.time < from) return;
    ++events;
    if (at_first < 0) at_first = allocations;
    at_latest = allocations;
  }
};

TEST(Allocations, NoneFromTheFirstEventOfTwoMassesToTheLast) {
  for (const Scene &scene : {paper::figure2(), paper::figure4a(), paper::figure5a()}) {
    // Every contact mode has been entered, and every store has its size.
    Allocations counted{.from = 200.0};
    simulate(scene, 1000.0, {}, counted);
    EXPECT_GT(counted.events, 100);
    EXPECT_EQ(counted.at_latest - counted.at_first, 0);
  }
}

}  // namespace
