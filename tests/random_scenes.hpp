// Random scenes, seeded, and the same scene seen otherwise: mirrored, in other units, as a command.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "vibro_impact/vibro_impact.hpp"

namespace vibro_impact::testing {

// Reproducible: the generator and the mapping to numbers are fixed by the seed alone.
struct Draw {
  std::mt19937 generator;

  unsigned below(unsigned n) {
    return static_cast<unsigned>(generator() % n);
  }
  bool one_in(unsigned n) {
    return below(n) == 0;
  }
  double uniform(double a, double b) {
    return a + (b - a) * (static_cast<double>(generator()) / 4294967296.0);
  }
  double spread(double a, double b) {  // uniform in the logarithm
    return std::exp(uniform(std::log(a), std::log(b)));
  }
};

// A chain of 1 to 8 masses with any stops, any r, damped or not, forced or not, at rest or moving.
inline Scene random_scene(unsigned seed) {
  Draw draw{std::mt19937(seed)};
  Scene scene;
  const int masses = 1 + static_cast<int>(draw.below(8));
  const bool unforced = draw.one_in(8);
  for (int i = 1; i <= masses; ++i) {
    scene.mass.push_back(draw.spread(0.05, 20.0));
    scene.stiffness.push_back(draw.spread(0.05, 20.0));
    scene.amplitude.push_back(unforced ? 0.0 : draw.uniform(-1.0, 1.0));
    scene.displacement.push_back(0.0);
    scene.velocity.push_back(draw.one_in(3) ? 0.0 : draw.uniform(-0.3, 0.3));
    if (!draw.one_in(2))
      scene.stops.push_back({i, Side::upper, draw.one_in(6) ? 0.0 : draw.spread(1e-4, 0.5)});
    if (draw.one_in(3)) scene.stops.push_back({i, Side::lower, -draw.spread(1e-5, 0.5)});
  }
  scene.beta = draw.one_in(4) ? 0.0 : draw.spread(1e-3, 5.0);
  scene.omega = draw.spread(0.05, 5.0);
  const double restitutions[] = {0.0, 1e-6, 0.05, 0.3, 0.5, 0.7, 0.8, 0.9, 0.97, 1.0};
  scene.restitution = restitutions[draw.below(10)];
  return scene;
}

// The same with every parameter drawn to its ends: links from 1e-4 to 1e4, beta to 100, Omega from
// 1e-2 to 1e2, r as near to 0 and 1 as one likes, stops at equal positions (Figure 5(c)), gaps of
// zero or next to it, masses that start on their stops, at rest there or moving.
inline Scene extreme_scene(unsigned seed) {
  Draw draw{std::mt19937(seed)};
  Scene scene;
  const int masses = 1 + static_cast<int>(draw.below(8));
  const bool unforced = draw.one_in(8), equal_links = draw.one_in(3), equal_stops = draw.one_in(3);
  const double common = draw.one_in(4) ? 0.0 : draw.spread(1e-6, 1.0),
               link = draw.spread(1e-4, 1e4);
  for (int i = 1; i <= masses; ++i) {
    scene.mass.push_back(equal_links ? 1.0 : draw.spread(0.1, 10.0));
    scene.stiffness.push_back(equal_links ? link : draw.spread(1e-4, 1e4));
    scene.amplitude.push_back(unforced || draw.one_in(2) ? 0.0 : draw.uniform(-1.0, 1.0));
    double at = draw.one_in(2) ? 0.0 : draw.uniform(-0.5, 0.5);
    const bool upper = !draw.one_in(3), lower = draw.one_in(3);
    const double clearance = draw.one_in(2) ? draw.spread(1e-9, 1e-3) : draw.spread(1e-3, 1.0);
    if (equal_stops) {
      if (upper) scene.stops.push_back({i, Side::upper, common});
      at = draw.one_in(2) ? common : std::min(common, at);
    } else {
      const bool touching = draw.one_in(2);
      if (upper) scene.stops.push_back({i, Side::upper, touching ? at : at + clearance});
      if (lower) scene.stops.push_back({i, Side::lower, at - draw.spread(1e-6, 1.0)});
    }
    scene.displacement.push_back(at);
    scene.velocity.push_back(draw.one_in(2) ? 0.0 : draw.uniform(-0.3, 0.3));
  }
  scene.beta = draw.one_in(4) ? 0.0 : draw.spread(1e-4, 1e2);
  scene.omega = draw.spread(1e-2, 1e2);
  const double restitutions[] = {0.0, 1e-300, 1e-12,      0.2,         0.6,
                                 0.9, 0.99,   1.0 - 1e-6, 1.0 - 1e-15, 1.0};
  scene.restitution = restitutions[draw.below(10)];
  return scene;
}

// The rate of the fastest mode is at most this (Gershgorin).
inline double frequency_bound(const Scene &scene) {
  return std::sqrt(largest_eigenvalue_bound(scene));
}

// Eight forcing periods, or as long as the fastest mode takes for `radians`.
inline double run_length(const Scene &scene, double radians) {
  return std::min(8.0 * 2.0 * std::acos(-1.0) / scene.omega, radians / frequency_bound(scene));
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

// The scene as a command line of the runner.
inline std::string command_of(const Scene &scene, double until) {
  std::string text = fmt::format(
      "vibro-impact run --masses {} --mass {} --stiffness {} --beta {} --amplitude {} --omega {} "
      "--restitution {} --initial-displacement {} --initial-velocity {} --until {}",
      scene.masses(), fmt::join(scene.mass, ","), fmt::join(scene.stiffness, ","), scene.beta,
      fmt::join(scene.amplitude, ","), scene.omega, scene.restitution,
      fmt::join(scene.displacement, ","), fmt::join(scene.velocity, ","), until);
  for (const Stop &stop : scene.stops)
    text += fmt::format(" --stop {}:{}:{}", stop.mass, stop.side == Side::upper ? "upper" : "lower",
                        stop.position);
  return text + (scene.stops.empty() ? " --stop none" : "");
}

}  // namespace vibro_impact::testing
