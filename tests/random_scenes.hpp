// Random scenes, seeded, and the properties every run must have whatever the scene.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "vibro_impact/vibro_impact.hpp"

namespace vibro_impact::testing {

// A chain of 1 to 8 masses with any stops, any r, damped or not, forced or not, at rest or moving.
// Reproducible: the generator and the mapping to numbers are fixed by the seed alone.
inline Scene random_scene(unsigned seed) {
  std::mt19937 generator(seed);
  const auto uniform = [&](double a, double b) {
    return a + (b - a) * (static_cast<double>(generator()) / 4294967296.0);
  };
  const auto spread = [&](double a, double b) {
    return std::exp(uniform(std::log(a), std::log(b)));
  };
  const auto one_in = [&](unsigned n) { return generator() % n == 0; };
  Scene scene;
  const int masses = 1 + static_cast<int>(generator() % 8);
  const bool unforced = one_in(8);
  for (int i = 1; i <= masses; ++i) {
    scene.mass.push_back(spread(0.05, 20.0));
    scene.stiffness.push_back(spread(0.05, 20.0));
    scene.amplitude.push_back(unforced ? 0.0 : uniform(-1.0, 1.0));
    scene.displacement.push_back(0.0);
    scene.velocity.push_back(one_in(3) ? 0.0 : uniform(-0.3, 0.3));
    if (!one_in(2)) scene.stops.push_back({i, Side::upper, one_in(6) ? 0.0 : spread(1e-4, 0.5)});
    if (one_in(3)) scene.stops.push_back({i, Side::lower, -spread(1e-5, 0.5)});
  }
  scene.beta = one_in(4) ? 0.0 : spread(1e-3, 5.0);
  scene.omega = spread(0.05, 5.0);
  const double restitutions[] = {0.0, 1e-6, 0.05, 0.3, 0.5, 0.7, 0.8, 0.9, 0.97, 1.0};
  scene.restitution = restitutions[generator() % 10];
  return scene;
}

// Mirror image: x -> -x.
inline Scene mirrored(Scene scene) {
  for (auto *values : {&scene.amplitude, &scene.displacement, &scene.velocity})
    for (double &value : *values) value = -value;
  for (Stop &stop : scene.stops) {
    stop.side = stop.side == Side::upper ? Side::lower : Side::upper;
    stop.position = -stop.position;
  }
  return scene;
}

// The scene in other units: lengths times `length`, masses times `mass` (times unchanged). With
// a power of two for the length and of four for the mass (its root is taken) every operation of the
// library scales exactly.
inline Scene rescaled(Scene scene, double length, double mass) {
  for (double &m : scene.mass) m *= mass;
  for (double &k : scene.stiffness) k *= mass;
  for (double &a : scene.amplitude) a *= mass * length;
  for (double &x : scene.displacement) x *= length;
  for (double &v : scene.velocity) v *= length;
  for (Stop &stop : scene.stops) stop.position *= length;
  return scene;
}

// Deepest penetration and most negative pressing force over dense samples.
struct Watch {
  const Scene *scene;
  double until, every;
  long long asked = 0;
  double penetration = 0.0, pull = 0.0, size = 0.0;
  bool finite = true;

  double next_time() const {
    const double next = every * static_cast<double>(asked);
    return next <= until ? next : std::numeric_limits<double>::infinity();
  }
  void sample(const Moment &moment) {
    ++asked;
    for (const Stop &stop : scene->stops) {
      const double x = moment.displacement(stop.mass), force = moment.hold_force(stop.mass);
      finite = finite && std::isfinite(x);
      size = std::max(size, std::abs(x));
      penetration = std::max(penetration, sign(stop.side) * (x - stop.position));
      if (!std::isnan(force) && x == stop.position) pull = std::max(pull, -sign(stop.side) * force);
    }
  }
};

// Empty when every property holds, else what failed. `gave_up` is set where the run ended at the
// documented limit of impacts per period.
inline std::string broken_property(const Scene &scene, bool &gave_up) {
  const double until = 8.0 * 2.0 * std::acos(-1.0) / scene.omega;
  RunOptions options;
  options.max_impacts_per_period = 20000;
  EventRecorder events, mirror, scaled;
  Watch watch{&scene, until, until / 701.3};
  gave_up = false;
  Outcome outcome;
  try {
    outcome = simulate(scene, until, options, events, watch);
  } catch (const std::runtime_error &) {
    gave_up = true;
    // Endless impacts are possible only where almost no energy is lost in them, or where a mass
    // rattles in a small clearance.
    return scene.restitution < 0.97 && scene.stops.size() < 2 ? "gave up" : "";
  }
  if (!watch.finite || !outcome.state.displacement.allFinite()) return "not finite";
  const double scale = std::max(1.0, watch.size);
  if (watch.penetration > 1e-12 * scale)
    return fmt::format("penetration {:.3g}", watch.penetration);
  if (watch.pull > 1e-11 * scale) return fmt::format("hold force pulls {:.3g}", watch.pull);
  for (std::size_t i = 1; i < events.events.size(); ++i)
    if (events.events[i].time < events.events[i - 1].time) return "events out of order";
  for (const Event &event : events.events) {
    const double sigma = sign(event.side);
    if (event.kind == EventKind::impact &&
        (sigma * event.velocity_before < 0.0 ||
         event.velocity_after != -scene.restitution * event.velocity_before))
      return "impact law";
  }

  // Samples make a run resolve a chatter up to the sample, so the three runs compared take none.
  events.events.clear();
  simulate(scene, until, options, events);
  simulate(mirrored(scene), until, options, mirror);
  simulate(rescaled(scene, 0x1p-7, 0x1p6), until, options, scaled);
  if (mirror.events.size() != events.events.size()) return "mirror image: other events";
  if (scaled.events.size() != events.events.size()) return "rescaled units: other events";
  for (std::size_t i = 0; i < events.events.size(); ++i) {
    const Event &e = events.events[i], &m = mirror.events[i], &s = scaled.events[i];
    if (m.time != e.time || m.mass != e.mass || m.kind != e.kind ||
        m.velocity_before != -e.velocity_before)
      return fmt::format("mirror image differs at event {} of {}", i, events.events.size());
    if (s.time != e.time || s.mass != e.mass || s.kind != e.kind ||
        s.velocity_before != 0x1p-7 * e.velocity_before)
      return fmt::format("rescaled units differ at event {} of {}", i, events.events.size());
  }
  return "";
}

}  // namespace vibro_impact::testing
