// When the storage of a run has its size, no memory is asked for between its events, samples and
// listed impacts, but for a contact mode that it has not been in before.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <new>

#include "reference/scenes/extreme_scenes.hpp"
#include "reference/scenes/paper_scenes.hpp"
#include "vibro_impact/simulate.hpp"

namespace {

long long allocations = 0;

}  // namespace

// The linker puts this in place of malloc (--wrap), which Eigen calls, and below it operator new.
extern "C" {
void *__real_malloc(std::size_t size);
void *__wrap_malloc(std::size_t size) {
  ++allocations;
  return __real_malloc(size);
}
}

// Without inlining, the compiler does not see that one calls malloc and the other free.
[[gnu::noinline]] void *operator new(std::size_t size) {
  if (void *memory = std::malloc(size)) return memory;
  throw std::bad_alloc();
}
[[gnu::noinline]] void *operator new(std::size_t size, const std::nothrow_t &) noexcept {
  return std::malloc(size);
}
[[gnu::noinline]] void operator delete(void *memory) noexcept {
  std::free(memory);
}
[[gnu::noinline]] void operator delete(void *memory, std::size_t) noexcept {
  std::free(memory);
}

namespace {

using namespace vibro_impact;

// Allocations between events from time `from` on, with samples and with the impacts of chatters;
// unless `all`, not up to the first event in another contact mode, for which the stores get another
// size.
struct Allocations : Recorder {
  double from;
  bool all;
  long long found = 0, at_latest = -1;
  int events = 0, in_this_mode = 0, samples = 0;
  Held held = {};

  Allocations(double from_time, bool of_all) : from(from_time), all(of_all) {
  }
  double slowest_impact(double first, double) const override {
    return slowest_listed({}, first);
  }
  double next_time() const override {
    return from + 0.37 * samples;
  }
  void sample(const Moment &) override {
    ++samples;
  }
  void event(const Event &event, const Moment &) override {
    if (event.time < from) return;
    ++events;
    in_this_mode = event.held == held ? in_this_mode + 1 : 0;
    if (at_latest >= 0 && (all || in_this_mode > 1)) found += allocations - at_latest;
    held = event.held;
    at_latest = allocations;
  }
};

TEST(Allocations, NoneFromTheFirstEventToTheLast) {
  Scene damped = paper::figure2(), resonant = paper::figure2();
  damped.beta = 5.0;
  resonant.beta = 0.0;
  resonant.omega = std::sqrt(0.5 * (3.0 - std::sqrt(5.0)));
  for (const Scene &scene : {paper::figure2(), paper::figure4a(), paper::figure5a(), resonant,
                             damped, extremes::long_chain()}) {
    // Every contact mode has been entered, and every store has its size. Two masses have two modal
    // coordinates in every contact mode, with padding, unless they are strongly damped. Other
    // chains have as many as the contact mode needs.
    Allocations counted(200.0, scene.masses() == 2 && scene.beta < 1.0);
    require_complete(simulate(scene, 1000.0, counted));
    EXPECT_GT(counted.events, 100);
    EXPECT_GT(counted.samples, 2000);
    EXPECT_EQ(counted.found, 0);
  }
}

// Lists of up to four entries ask for no memory of their own. A run of two masses asks 29 times.
TEST(Allocations, FewBeforeTheFirstStepEnds) {
  const Scene scene = paper::figure2();
  const long long before = allocations;
  require_complete(simulate(scene, 0.001));
  EXPECT_LE(allocations - before, 32);
}

}  // namespace
