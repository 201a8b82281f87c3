// Random scenes, seeded, what rounding does to them, and their mirror images.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <limits>
#include <random>

#include "rates.hpp"
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
  int between(int least, int most) {
    return least + static_cast<int>(below(static_cast<unsigned>(most - least + 1)));
  }
  double one_of(std::initializer_list<double> values) {
    return values.begin()[below(static_cast<unsigned>(values.size()))];
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
  const int masses = draw.between(1, 8);
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
  scene.restitution = draw.one_of({0.0, 1e-6, 0.05, 0.3, 0.5, 0.7, 0.8, 0.9, 0.97, 1.0});
  return scene;
}

// The same with every parameter drawn to its ends: links from 1e-4 to 1e4, beta to 100, Omega from
// 1e-2 to 1e2, r as near to 0 and 1 as one likes, stops at equal positions (Figure 5(c)), gaps of
// zero or next to it, masses that start on their stops, at rest there or moving.
inline Scene extreme_scene(unsigned seed) {
  Draw draw{std::mt19937(seed)};
  Scene scene;
  const int masses = draw.between(1, 8);
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
  scene.restitution =
      draw.one_of({0.0, 1e-300, 1e-12, 0.2, 0.6, 0.9, 0.99, 1.0 - 1e-6, 1.0 - 1e-15, 1.0});
  return scene;
}

// Three to twelve masses of 1e-6 to 1e6 on links of 1e-9 to 1e9, tied to the ground or not, damped
// or not; nothing but the start moves them.
inline Scene graded_chain(unsigned seed, double heaviest = 1e6) {
  Draw draw{std::mt19937(seed)};
  Scene scene;
  const int masses = draw.between(3, 12);
  for (int i = 1; i <= masses; ++i) {
    scene.mass.push_back(draw.spread(1.0 / heaviest, heaviest));
    scene.stiffness.push_back(draw.spread(1e-9, 1e9));
    scene.displacement.push_back(draw.uniform(-1.0, 1.0));
    scene.velocity.push_back(draw.uniform(-1.0, 1.0) * 1e-3);
  }
  if (draw.one_in(2)) scene.stiffness[0] = 0.0;
  scene.beta = draw.one_in(2) ? 0.0 : draw.spread(1e-4, 1e2);
  return scene;
}

// Such a chain under a forcing of any frequency and size, at rest at first or moving.
inline Scene forced_chain(unsigned seed) {
  Draw draw{std::mt19937(~seed)};  // independent of the draws for the chain
  Scene scene = graded_chain(seed);
  scene.omega = draw.spread(1e-8, 1e4);
  const double amplitude = draw.spread(1e-9, 1e6);
  for (int i = 1; i <= scene.masses(); ++i)
    scene.amplitude.push_back(amplitude * draw.uniform(-1.0, 1.0));
  if (draw.one_in(2)) scene.displacement = scene.velocity = {};
  return scene;
}

// Such a chain with a stop on some of its masses, any r. Masses are 1e-3 to 1e3 only: the
// displacement of a light mass is known to epsilon sqrt(m_heavy / m_light), which a stiff link at
// it turns into energy. No forcing: epsilon of a steady response would be more than the motion of a
// stiff link.
inline Scene graded_scene(unsigned seed) {
  Draw draw{std::mt19937(seed)};
  Scene scene = graded_chain(seed, 1e3);
  for (int i = 1; i <= scene.masses(); ++i)
    if (draw.one_in(2))
      scene.stops.push_back(
          {i, Side::upper, 1.0 + (draw.one_in(2) ? 0.0 : draw.spread(1e-6, 1.0))});
  scene.restitution = draw.one_of({0.0, 1e-12, 0.2, 0.6, 0.9, 1.0});
  return scene;
}

// Equal masses on equal links where as much as can be is equal or zero, so that events tie and
// forces vanish: stops at one position, which may be where the masses start, the same forcing on
// all or some of them, starts at rest; sometimes a free chain, a constant force, stops of their own
// restitution.
inline Scene degenerate_scene(unsigned seed) {
  Draw draw{std::mt19937(seed)};
  Scene scene;
  const int masses = draw.between(1, 10);
  const auto restitutions = {0.0, 0.3, 0.7, 1.0};
  const double link = draw.one_of({0.25, 1.0, 3.0}), at = draw.one_in(2) ? 0.0 : 0.1;
  const double amplitude = draw.one_in(2) ? 0.5 : -0.5;
  const unsigned forced = draw.below(4), sides = draw.below(4), stopped = draw.below(3),
                 start = draw.below(4);
  const bool own = draw.one_in(4);
  scene.beta = draw.one_in(2) ? 0.0 : 0.5;
  scene.omega = draw.one_of({0.0, 0.3, 0.7, 1.0});
  scene.restitution = draw.one_of(restitutions);
  const auto add_stop = [&](int mass, Side side, double position) {
    Stop stop{mass, side, position};
    if (own && draw.one_in(2)) stop.restitution = draw.one_of(restitutions);
    scene.stops.push_back(stop);
  };
  for (int i = 1; i <= masses; ++i) {
    scene.mass.push_back(1.0);
    scene.stiffness.push_back(link);
    const bool takes_force =
        forced == 0 || (forced == 1 && draw.one_in(2)) || (forced == 2 && i == 1);  // 3: none
    scene.amplitude.push_back(takes_force ? amplitude : 0.0);
    const double upper = at, lower = sides == 3 ? at - 0.2 : at;
    if (stopped == 0 || draw.one_in(2)) {  // on all masses, or some
      if (sides != 1) add_stop(i, Side::upper, upper);
      if (sides == 1 || sides == 3) add_stop(i, Side::lower, lower);
    }
    // Off the stops, at rest; on them at rest, or all with one velocity, or some with it.
    scene.displacement.push_back(start != 0 ? at : sides == 1 ? at + 0.1 : at - 0.1);
    scene.velocity.push_back(start == 2 || (start == 3 && draw.one_in(2)) ? 0.2 : 0.0);
  }
  if (draw.one_in(5)) scene.stiffness[0] = 0.0;
  return scene;
}

// Two to five masses pressed onto their stops that have just left them, so that all chatter at
// once, some a thousand times as fast as others; each by its own restitution, up to 0.99.
inline Scene chattering_scene(unsigned seed) {
  Draw draw{std::mt19937(seed)};
  Scene scene;
  const int masses = draw.between(2, 5);
  for (int i = 1; i <= masses; ++i) {
    const double stop = draw.uniform(0.0, 1.0);
    scene.mass.push_back(draw.uniform(0.5, 2.0));
    scene.stiffness.push_back(draw.uniform(0.5, 2.0));
    scene.amplitude.push_back(draw.uniform(3.0, 6.0));
    scene.displacement.push_back(stop);
    scene.velocity.push_back(-draw.spread(1e-5, 1e-2));
    scene.stops.push_back(
        {i, Side::upper, stop, draw.one_in(2) ? draw.uniform(0.9, 0.99) : draw.uniform(0.1, 0.9)});
  }
  scene.beta = draw.one_in(2) ? 0.0 : draw.uniform(0.0, 1.0);
  scene.omega = 0.1;
  return scene;
}

// Eight forcing periods, or as long as the fastest mode takes for `radians`. One free mass under a
// constant force has no time of its own: its run is `radians` long.
inline double run_length(const Scene &scene, double radians) {
  const double length =
      std::min(8.0 * 2.0 * std::acos(-1.0) / scene.omega, radians / frequency_bound(scene));
  return std::isfinite(length) ? length : radians;
}

// The forcing is known to epsilon of the sum of its amplitudes.
inline double rounding_of_forcing(const Scene &scene) {
  double force = 0.0;
  for (const auto *forces : {&scene.amplitude, &scene.sine, &scene.constant})
    for (const double a : *forces) force += std::abs(a);
  return std::numeric_limits<double>::epsilon() * force;
}

// Displacements are known to epsilon times the steady response, whose static bound this is: all
// forces on a chain of all the links' compliances. Next to a resonance the response may be 32 times
// as large before the library no longer splits it off. The rigid-body mode of a free chain has no
// steady response. On soft links a force is followed by less: it moves the lightest mass by at most
// F t^2 / m.
inline double rounding_of_steady_response(const Scene &scene, double until) {
  double compliance = 0.0;
  for (const double k : scene.stiffness)
    if (k > 0.0) compliance += 1.0 / k;
  const double lightest = *std::min_element(scene.mass.begin(), scene.mass.end());
  return rounding_of_forcing(scene) * std::min(compliance, until * until / lightest);
}

// A scene of one of the distributions with a sine, a constant force and springs to the ground, on
// all or some of its masses.
template <Scene (*draw_scene)(unsigned)>
Scene with_all_forces(unsigned seed) {
  Scene scene = draw_scene(seed);
  Draw draw{std::mt19937(seed + 1)};
  for (const double stiffness : scene.stiffness) {
    scene.sine.push_back(draw.one_in(2) ? 0.0 : draw.uniform(-1.0, 1.0));
    scene.constant.push_back(draw.one_in(2) ? 0.0 : draw.uniform(-1.0, 1.0));
    scene.ground.push_back(draw.one_in(2) ? 0.0 : stiffness * draw.spread(1e-3, 10.0));
  }
  return scene;
}

// Kinetic and elastic energy.
inline double energy_of(const Scene &scene, const MotionState &state) {
  double sum = 0.0;
  for (std::size_t i = 0; i < scene.mass.size(); ++i) {
    const double x = state.displacement[i], v = state.velocity[i];
    sum += 0.5 * (scene.mass[i] * v * v - x * spring_force(scene, i, state.displacement));
  }
  return sum;
}

// The mirror image, x -> -x; of an event likewise.
inline Scene mirrored(Scene scene) {
  for (auto *values :
       {&scene.amplitude, &scene.sine, &scene.constant, &scene.displacement, &scene.velocity})
    for (double &value : *values) value = -value;
  for (Stop &stop : scene.stops) {
    stop.side = stop.side == Side::upper ? Side::lower : Side::upper;
    stop.position = -stop.position;
  }
  return scene;
}

inline Event mirrored(Event event) {
  event.side = event.side == Side::upper ? Side::lower : Side::upper;
  event.velocity_before = -event.velocity_before;
  event.velocity_after = -event.velocity_after;
  for (signed char &held : event.held) held = static_cast<signed char>(-held);
  return event;
}

// A scene in units so many times smaller: its masses, links, lengths and times are so many times
// larger. time^2 = mass / stiffness.
inline Scene in_units(Scene scene, double mass, double stiffness, double length, double time) {
  for (double &m : scene.mass) m *= mass;
  for (auto *springs : {&scene.stiffness, &scene.ground})
    for (double &k : *springs) k *= stiffness;
  for (auto *forces : {&scene.amplitude, &scene.sine, &scene.constant})
    for (double &f : *forces) f *= stiffness * length;
  for (double &x : scene.displacement) x *= length;
  for (double &v : scene.velocity) v *= length / time;
  for (Stop &stop : scene.stops) stop.position *= length;
  scene.beta *= time;
  scene.omega /= time;
  return scene;
}

}  // namespace vibro_impact::testing
