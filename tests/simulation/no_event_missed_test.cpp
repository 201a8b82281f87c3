// No event is missed, and none is told too early or too late: a witness, which carries the motion
// between the events of a run in extended precision, looks at every stop closely. (In random
// motion: random_scenes_test.)
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "reference/scenes/extreme_scenes.hpp"
#include "tests/events.hpp"
#include "witness.hpp"

namespace {

using namespace vibro_impact;
using namespace vibro_impact::testing;

Witness witness_of(const Scene &scene, double until) {
  Witness witness(scene);
  witness.close(require_complete(simulate(scene, until, all_impacts, witness)).state);
  return witness;
}

// The time of the first event of this kind, at which the run ends.
struct First {
  EventKind kind;
  double time = 0.0;

  void event(const Event &event, const Moment &) {
    if (event.kind == kind) time = event.time;
  }
  bool done() const {
    return time > 0.0;
  }
};

double time_of_first(EventKind kind, const Scene &scene) {
  First first{kind};
  EXPECT_EQ(simulate(scene, 1e5, {}, first).ending, Ending::stopped);
  return first.time;
}

// How far one mass of two on unit springs ever gets, from zero with these speeds: where the two
// modes, which are not in step, both take it.
double farthest(Eigen::Index mass, double first_speed, double second_speed) {
  const FreeModes modes = free_modes(extremes::chain(2, 0.0), {0, 0});
  Real sum = 0;
  for (Eigen::Index j = 0; j < 2; ++j)
    sum += std::abs(modes.shape(mass, j) *
                    (modes.inverse(j, 0) * first_speed + modes.inverse(j, 1) * second_speed)) /
           std::sqrt(modes.lambda(j));
  return static_cast<double>(sum);
}

// A stop short of there by a share that falls from run to run, down to one in a million: the
// flights to the first impact last up to thousands of radians, with many near misses.
TEST(NoEventMissed, OnLongFlights) {
  double longest = 0;
  long long near_misses = 0;
  for (const double share : {0.1, 0.01, 1e-3, 1e-4, 1e-5, 1e-6}) {
    SCOPED_TRACE(share);
    Scene scene = extremes::chain(2, 0.0);
    scene.velocity = {0.1, 0.3};
    scene.stops = {{2, Side::upper, farthest(1, 0.1, 0.3) * (1.0 - share)}};
    const double first = time_of_first(EventKind::impact, scene);
    const Witness witness = witness_of(scene, first + 1.0);
    // Every span rounds the lanes, and the time.
    const Real tolerance = 1e-15L + 1e-16L * first;
    EXPECT_LE(witness.deepest, tolerance);
    EXPECT_LE(witness.off_the_stop, tolerance);
    EXPECT_LE(witness.off_in_speed, tolerance);
    longest = std::max(longest, first);
    near_misses += witness.near_misses;
  }
  EXPECT_GT(longest, 1000.0);
  EXPECT_GT(near_misses, 10);
}

// The same of the force on a mass that is held, by a constant force that two others pull it off
// with once both modes do.
TEST(NoEventMissed, InLongHolds) {
  double longest = 0;
  for (const double share : {0.1, 0.01, 1e-3, 1e-4, 1e-5, 1e-6}) {
    SCOPED_TRACE(share);
    Scene scene = extremes::chain(3, 0.0);
    scene.velocity = {0.0, 0.2, -0.3};
    scene.omega = 0.0;
    scene.amplitude = {farthest(0, 0.2, -0.3) * (1.0 - share), 0.0, 0.0};
    scene.stops = {{1, Side::upper, 0.0}};
    const double first = time_of_first(EventKind::release, scene);
    const Witness witness = witness_of(scene, first + 1e-3);
    const Real tolerance = 1e-15L + 1e-16L * first;
    EXPECT_EQ(witness.releases, 1);
    EXPECT_LE(witness.weakest, tolerance);
    EXPECT_LE(witness.not_zero, tolerance);
    longest = std::max(longest, first);
  }
  EXPECT_GT(longest, 500.0);
}

// In resonance x = t sin(t) / 20: the stop stands a little below or above one of the peaks, and is
// hit there, or at the next one.
TEST(NoEventMissed, AtTheRightPeakOfAResonance) {
  const auto x = [](long double t) { return t * std::sin(t) / 20.0L; };
  const long double pi = std::acos(-1.0L);
  for (const int peak : {0, 1, 3, 10, 30})
    for (const double off : {1e-3, 1e-6, 1e-9, 1e-12, -1e-12, -1e-9, -1e-6, -1e-3}) {
      SCOPED_TRACE(::testing::Message() << peak << " " << off);
      long double top = (2 * peak + 0.5L) * pi;  // tan t = -t, a little after
      for (int i = 0; i < 60; ++i) top = 2 * peak * pi + pi - std::atan(top);
      const auto stop = static_cast<double>(x(top) * (1.0L - off));
      // The first t with x = stop, between a valley and a peak.
      long double from = 2 * (peak + (off < 0.0)) * pi, to = from + pi / 2.0L;
      if (off > 0.0) to = top;
      for (int i = 0; i < 80; ++i) {
        const long double half = (from + to) / 2.0L;
        (x(half) < stop ? from : to) = half;
      }
      Scene scene = extremes::one_mass(0.0, 0.1, 1.0, 0.5, stop);
      const double time = time_of_first(EventKind::impact, scene);
      const long double speed = (std::sin(from) + from * std::cos(from)) / 20.0L;
      // Every span of two radians rounds x, and the time is rounded to its digits.
      const long double rounding = 5e-17L * from * (stop + 1) / speed + 2e-16L * from;
      EXPECT_NEAR(time, static_cast<double>(from), static_cast<double>(rounding));
    }
}

}  // namespace
