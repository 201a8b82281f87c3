// How periodic orbits, their events and what is zero at their bifurcations change with parameters.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>

#include "reference/paper_scenes.hpp"
#include "vibro_impact/analysis/analysis.hpp"
#include "vibro_impact/vibro_impact.hpp"

namespace {

using namespace vibro_impact;
using Kind = Parameter::Kind;

// The orbit that the motion from rest settles to.
PeriodicOrbit orbit_of(const Scene &scene, int periods = 1) {
  const MotionState seed = at_quiet_phase(scene, state_after_periods(scene, 200));
  PeriodicOrbit orbit = find_periodic_orbit(scene, seed, periods);
  EXPECT_TRUE(orbit.converged);
  return orbit;
}

// The same orbit in a scene with a parameter moved, at the same phase.
PeriodicOrbit moved_orbit(const Scene &moved, const Scene &scene, const PeriodicOrbit &orbit) {
  MotionState guess = orbit.state;
  guess.instant.phase *= scene.omega / moved.omega;
  const PeriodicOrbit found = find_periodic_orbit(moved, guess, orbit.periods);
  EXPECT_TRUE(found.converged);
  return found;
}

const std::vector<Parameter> lengths{
    {Kind::stop, 1}, {Kind::stop, 2}, {Kind::amplitude, 1}, {Kind::amplitude, 2}};
const std::vector<Parameter> others{{Kind::omega, 0}, {Kind::restitution, 0}, {Kind::beta, 0}};

// Differences of fourth order of values along the family of orbits.
std::vector<double> differences(const std::function<std::vector<double>(double)> &values,
                                double h) {
  const auto a = values(h), b = values(-h), c = values(2 * h), d = values(-2 * h);
  std::vector<double> slope(a.size());
  for (std::size_t i = 0; i < a.size(); ++i)
    slope[i] = (8.0 * (a[i] - b[i]) - (c[i] - d[i])) / (12.0 * h);
  return slope;
}

// Other units of length: stops, amplitudes and the orbit times c; speeds times c, times as they
// were. Exact: rounding and the error of the chatter limits, 1e-12.
TEST(OrbitChange, KeepsTheUnitOfLength) {
  for (const Scene &scene : {paper::figure2(), paper::figure4a(), paper::figure5a(),
                             paper::stops_of_different_sign(0.6)}) {
    const PeriodicOrbit orbit = orbit_of(scene);
    const OrbitChange change = orbit_change(scene, orbit, lengths);
    const auto sum = [&](const std::function<double(std::size_t)> &by) {
      double total = 0.0;
      for (std::size_t k = 0; k < lengths.size(); ++k) total += get(scene, lengths[k]) * by(k);
      return total;
    };
    const std::vector<double> z = coordinates(orbit.state);
    for (std::size_t i = 0; i < z.size(); ++i)
      EXPECT_NEAR(sum([&](std::size_t k) { return change.state(i, k); }), z[i], 1e-12);
    ASSERT_GT(change.events.size(), 5u);
    for (const EventChange &at : change.events) {
      // Late in a chatter the time is divided by the speed, here down to 1e-4.
      EXPECT_NEAR(sum([&](std::size_t k) { return at.time[k]; }), 0.0, 1e-10)
          << at.event.time << name(at.event.kind);
      EXPECT_NEAR(sum([&](std::size_t k) { return at.velocity_before[k]; }),
                  at.event.velocity_before, 1e-11)
          << at.event.time;
    }
  }
}

// Times and speeds of every event of the orbit of Figure 2 - impacts of both masses, the ends of
// their chatters, releases - against differences: of the orbit found anew beside, by Newton's
// method to 1e-13, over h = 1e-5. Late impacts amplify rounding: those slower than 1e-3 are left
// out, the end of the chatter is not.
TEST(OrbitChange, OfEventsEqualsDifferences) {
  const Scene scene = paper::figure2();
  const PeriodicOrbit orbit = orbit_of(scene);
  for (const auto &parameters : {lengths, others}) {
    const OrbitChange change = orbit_change(scene, orbit, parameters);
    int compared = 0, sticks = 0, releases = 0;
    for (std::size_t k = 0; k < parameters.size(); ++k) {
      const auto told = [&](double step) {
        const Scene moved = with(scene, parameters[k], get(scene, parameters[k]) + step);
        EventRecorder recorder;
        const RunOptions options{.resolve_chatter = 1e-3};  // the same impacts whatever the step
        stroboscopic_map(moved, moved_orbit(moved, scene, orbit).state, 1, options, recorder);
        std::vector<double> values;
        for (const Event &event : recorder.events) {
          if (event.kind == EventKind::impact && std::abs(event.velocity_before) < 1e-3) continue;
          values.push_back(event.time);
          values.push_back(event.velocity_before);
        }
        return values;
      };
      const std::vector<double> slope = differences(told, 1e-5);
      std::size_t i = 0;
      for (const EventChange &at : change.events) {
        if (at.event.kind == EventKind::impact && std::abs(at.event.velocity_before) < 1e-3)
          continue;
        ASSERT_LT(i + 1, slope.size() + 1);
        EXPECT_NEAR(at.time[k], slope[i], 1e-6) << name(parameters[k]) << name(at.event.kind);
        EXPECT_NEAR(at.velocity_before[k], slope[i + 1], 1e-6) << name(parameters[k]);
        i += 2;
        ++compared;
        sticks += at.event.kind == EventKind::stick;
        releases += at.event.kind == EventKind::release;
      }
      EXPECT_EQ(i, slope.size());
    }
    EXPECT_GT(compared, 40);
    EXPECT_EQ(sticks, 2 * static_cast<int>(parameters.size()));
    EXPECT_EQ(releases, sticks);
  }
}

// The least force and the least gap in other units of length: times c, a stop that is never met
// moving with the rest. A stop that the scene does not have stands still. Exact.
TEST(BifurcationFunctions, KeepTheUnitOfLength) {
  Scene scene = paper::figure4a();
  const Stop across{1, Side::upper, 0.7}, beyond{1, Side::upper, 0.8};
  scene.stops.push_back(across);
  std::vector<Parameter> by = lengths;
  by.push_back({Kind::stop, 3});
  const PeriodicOrbit orbit = orbit_of(scene);
  const OrbitChange change = orbit_change(scene, orbit, by);
  const auto sum = [&](const ValueChange &of) {
    double total = 0.0;
    for (std::size_t k = 0; k < by.size(); ++k) total += get(scene, by[k]) * of.by[k];
    return total;
  };
  const auto force = least_pressing_force_change(scene, orbit, change, scene.stops[0]).value();
  EXPECT_NEAR(sum(force), force.value, 1e-12);
  const auto gap = least_gap_change(scene, orbit, change, across).value();
  EXPECT_GT(gap.value, 0.0);
  EXPECT_NEAR(sum(gap), gap.value, 1e-12);
  scene.stops.pop_back();
  by.pop_back();
  const PeriodicOrbit without = orbit_of(scene);
  const auto still =
      least_gap_change(scene, without, orbit_change(scene, without, by), beyond).value();
  EXPECT_NEAR(sum(still), still.value - beyond.position, 1e-12);
}

}  // namespace
