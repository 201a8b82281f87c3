// The first chatter limit of a run, held against all its impacts.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "random_scenes.hpp"

namespace vibro_impact::testing {

// A recorder of the first mass to stick after the start, of the motion of all there, and of where
// its chatter began.
struct FirstStick {
  int mass = 0;
  double time = 0.0;
  std::vector<double> displacement = {}, velocity = {};
  double speed = 0.0, lasted = 0.0;  // of its first impact, and since then

  struct Beginning {
    double time = 0.0, speed = 0.0;
  };
  std::vector<Beginning> beginnings = {};  // by mass, of the impacts that fall

  void event(const Event &event, const Moment &moment) {
    const auto i = static_cast<std::size_t>(event.mass - 1);
    beginnings.resize(static_cast<std::size_t>(moment.masses()));
    if (event.kind == EventKind::impact && event.falling == 0)
      beginnings[i] = {event.time, std::abs(event.velocity_before)};
    if (event.kind != EventKind::stick || event.time == 0.0) return;
    mass = event.mass;
    time = event.time;
    speed = beginnings[i].speed;
    lasted = time - beginnings[i].time;
    for (int k = 1; k <= moment.masses(); ++k) {
      displacement.push_back(moment.displacement(k));
      velocity.push_back(moment.velocity(k));
    }
  }
  bool done() const {
    return mass > 0;
  }
};

// What two runs differ by at their first stick, one with limits and one without, in what is allowed
// for. They are the same to the last bit until the first limit is taken.
struct LimitError {
  bool compared = false;  // one did take a limit where the other resolved impacts
  double largest = 0.0;   // 1: as much as may be
};

// Allowed for are ten times the error at which a limit is accepted, of the displacements and, by
// the rate of the fastest mode, of velocities and time; the rounding of the displacements, of the
// times of all the impacts that only one run resolves, and of a chatter so slow that its speeds are
// hardly more than that of the motion; and that the motions are told at times so far apart.
inline LimitError first_limit_error(const Scene &scene, double until, RunOptions options) {
  FirstStick stick, truth;
  const Counters few = simulate(scene, until, options, stick).counters;
  if (few.chatter_limits == 0 || !stick.done()) return {};
  options.resolve_chatter = 0.0;
  options.max_impacts_per_period = 100'000;
  const Counters all = simulate(scene, until, options, truth).counters;
  if (!truth.done() || few.impacts == all.impacts || !(truth.speed > 0.0)) return {};
  const double rate = frequency_bound(scene), allowed = 10.0 * options.chatter_tolerance;
  double size = 1.0, speed = 0.0;
  for (const double x : truth.displacement) size = std::max(size, std::abs(x));
  for (const double v : truth.velocity) speed = std::max(speed, std::abs(v));
  const double rounded = std::numeric_limits<double>::epsilon() * rate * size / truth.speed;
  const double late = allowed / rate + 1e-16 * static_cast<double>(all.impacts) * truth.time +
                      4.0 * rounded * truth.lasted;
  const double displaced = (allowed + rounding_of_frequencies(scene)) * size +
                           64.0 * rounding_of_steady_response(scene) + speed * late;
  LimitError error{true, std::abs(stick.time - truth.time) / late};
  if (stick.mass != truth.mass) error.largest = INFINITY;
  for (std::size_t i = 0; i < truth.displacement.size(); ++i)
    error.largest = std::max(
        {error.largest, std::abs(stick.displacement[i] - truth.displacement[i]) / displaced,
         std::abs(stick.velocity[i] - truth.velocity[i]) / (rate * displaced)});
  return error;
}

}  // namespace vibro_impact::testing
