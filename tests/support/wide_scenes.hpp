// Random scenes far from the paper's in one respect each, with the time to which they run.
#pragma once

#include <algorithm>
#include <cmath>

#include "events.hpp"
#include "random_scenes.hpp"

namespace vibro_impact::testing {

// The units that the motion of a scene is measured in.
struct Units {
  double length = 1.0, time = 1.0, force = 1.0;
};

struct Trial {
  Scene scene;
  double until = 0.0;
  Units units = {};
  bool completes = false;  // the run is never given up
};

// A scene of one of the distributions of random_scenes.hpp, for at most `radians` of its fastest
// mode.
template <Scene (*draw_scene)(unsigned), long long radians>
Trial run_of(unsigned seed) {
  const Scene scene = draw_scene(seed);
  return {scene, run_length(scene, static_cast<double>(radians))};
}

// Gives a mass an upper stop half of the time, and a lower one every fourth time, near zero.
inline void add_stops_nearby(int mass, Draw &draw, Scene &scene) {
  if (draw.one_in(2)) scene.stops.push_back({mass, Side::upper, draw.spread(1e-3, 0.3)});
  if (draw.one_in(4)) scene.stops.push_back({mass, Side::lower, -draw.spread(1e-3, 0.3)});
}

// Two to five ordinary masses on damped links, of which some are stiff, up to 1e12. A slow forcing
// presses the masses onto their stops and releases them again, four times.
inline Trial stiff_release(unsigned seed) {
  Draw draw{std::mt19937(seed)};
  Scene scene;
  const int masses = draw.between(2, 5);
  for (int i = 1; i <= masses; ++i) {
    scene.mass.push_back(draw.uniform(0.5, 2.0));
    const bool soft = i == 1 || draw.one_in(2);
    scene.stiffness.push_back(soft ? draw.uniform(0.5, 2.0) : draw.spread(1e4, 1e12));
    scene.amplitude.push_back(draw.one_in(2) ? 0.0 : draw.uniform(-1.0, 1.0));
    add_stops_nearby(i, draw, scene);
  }
  if (draw.one_in(2)) scene.amplitude[0] = 0.5;
  scene.beta = draw.spread(0.03, 1.0);
  scene.omega = draw.spread(0.1, 0.5);
  scene.restitution = draw.one_of({0.0, 0.3, 0.5, 0.7});
  return {scene, 4.0 * 2.0 * std::acos(-1.0) / scene.omega};
}

// Twelve to 28 equal masses at rest, of which the first is forced. The last one has a stop where it
// rests, and its force there has no low derivative. One link may be soft or stiff. The run lasts
// until the wave has reached the end of the chain. One of twelve chains has 36 to 40 masses and a
// damped link of 1e9: derivatives of the last force, in units of the fastest rate, are below
// 1e-308.
inline Trial long_chain_at_rest(unsigned seed) {
  Draw draw{std::mt19937(seed)};
  Scene scene;
  const bool longest = draw.one_in(12);
  const int masses = longest ? draw.between(36, 40) : draw.between(12, 28);
  const auto n = static_cast<std::size_t>(masses);
  scene.mass.assign(n, 1.0);
  scene.stiffness.assign(n, 1.0);
  scene.amplitude.assign(n, 0.0);
  scene.velocity.assign(n, 0.0);
  scene.amplitude[0] = draw.one_in(2) ? 1.0 : -1.0;
  if (draw.one_in(2)) scene.velocity[0] = draw.one_in(2) ? 1e-6 : -1e-6;
  if (longest || draw.one_in(3))
    scene.stiffness[draw.below(static_cast<unsigned>(n))] = longest ? 1e9 : draw.spread(1e-9, 1e9);
  scene.beta = longest || draw.one_in(2) ? 0.1 : 0.0;
  scene.omega = draw.uniform(0.5, 1.5);
  scene.restitution = draw.one_of({0.0, 0.3, 0.7});
  const Side side = draw.one_in(2) ? Side::upper : Side::lower;
  for (int i = masses / 2; i < masses; ++i)
    if (draw.one_in(8)) scene.stops.push_back({i, side, 0.0});
  scene.stops.push_back({masses, side, 0.0});
  return {scene, 1.5 * static_cast<double>(masses)};
}

// One to four masses on links that change no more than the last digits, in any unit of mass,
// length and time. They fall from one height onto stops at zero under nearly equal accelerations.
// The force that pulls them is constant, or that of a forcing whose phase hardly changes. The run
// ends after the last of them has come to rest.
inline Trial falling_masses(unsigned seed) {
  Draw draw{std::mt19937(seed)};
  Scene scene;
  const int masses = draw.between(1, 4);
  const double mass = draw.spread(1e-8, 1e8), height = draw.spread(1e-10, 1e10),
               fall = draw.spread(1e-10, 1e10), acceleration = 2.0 * height / (fall * fall);
  const double least = draw.spread(1e-14, 1e-3), soft = draw.spread(1e-40, 1e-20);
  const bool forcing = draw.one_in(2);
  for (int i = 1; i <= masses; ++i) {
    const double own = draw.one_in(3) ? 1.0 : 1.0 + draw.uniform(-least, least);
    scene.mass.push_back(mass);
    scene.stiffness.push_back(soft * mass / (fall * fall));
    scene.constant.push_back(forcing ? 0.0 : -mass * acceleration * own);
    scene.amplitude.push_back(forcing ? -mass * acceleration * own : 0.0);
    scene.displacement.push_back(height);
    scene.stops.push_back({i, Side::lower, 0.0});
  }
  scene.beta = draw.one_in(2) ? 0.0 : 0.1 * fall;
  scene.omega = forcing ? draw.spread(1e-14, 1e-8) / fall : 0.0;
  const double r = draw.one_of({0.0, 1e-7, 3e-5, 0.1, 0.5, 0.8});
  scene.restitution = r;
  return {scene, 1.1 * fall * (1.0 + 2.0 * r / (1.0 - r)), {height, fall, mass * acceleration}};
}

// Two to five masses on equal links with stops at zero, where they rest. Some bounce there, each
// time r times as fast, while the slow forcing of the first ones holds those. At a quarter of its
// period the forcing releases them beside masses whose bounces have died down together.
inline Trial decayed_chatter(unsigned seed) {
  Draw draw{std::mt19937(seed)};
  Scene scene;
  const int masses = draw.between(2, 5);
  const double link = draw.one_of({0.25, 1.0, 2.7});
  const int forced = draw.between(1, masses - 1);
  for (int i = 1; i <= masses; ++i) {
    const bool held = i <= forced;
    scene.mass.push_back(1.0);
    scene.stiffness.push_back(i == 1 && draw.one_in(4) ? 0.004 : link);
    scene.amplitude.push_back(held ? draw.spread(0.01, 1.0) : 0.0);
    scene.velocity.push_back(held || draw.one_in(3) ? 0.0 : -draw.spread(1e-3, 0.3));
    if (held || !draw.one_in(4)) scene.stops.push_back({i, Side::upper, 0.0});
  }
  scene.beta = draw.one_in(2) ? 0.0 : draw.spread(1e-3, 0.1);
  const double half_periods =
      5.0 + draw.below(50) + (draw.one_in(2) ? 0.0 : draw.uniform(0.0, 1.0));
  scene.omega = std::sqrt(link) / (2.0 * half_periods);
  scene.restitution = draw.one_of({1e-12, 1e-4, 0.1, 0.3});
  return {scene, 1.4 * 0.5 * std::acos(-1.0) / scene.omega, {}, true};
}

// A damped chain that a constant force brings to rest before its stops, or on one of them. Its
// links are soft and stiff. It runs for long after that.
inline Trial chain_at_equilibrium(unsigned seed) {
  Draw draw{std::mt19937(seed)};
  Scene scene;
  const int masses = draw.between(1, 4);
  const double clearance = draw.spread(1e-6, 0.1);
  double force = 0.0, at = 0.0;
  for (int i = 1; i <= masses; ++i) {
    scene.mass.push_back(draw.uniform(0.5, 2.0));
    scene.stiffness.push_back(i > 1 && draw.one_in(2) ? draw.spread(1e4, 1e10)
                                                      : draw.uniform(0.5, 2.0));
    scene.constant.push_back(draw.one_in(2) ? 0.0 : draw.uniform(0.1, 1.0));
    force += scene.constant.back();
  }
  for (int i = 1; i <= masses; ++i) {  // the sum of the forces from here on stretches this link
    const auto k = static_cast<std::size_t>(i - 1);
    at += force / scene.stiffness[k];
    force -= scene.constant[k];
    if (draw.one_in(2)) scene.stops.push_back({i, Side::upper, at + clearance});
  }
  scene.beta = draw.spread(0.05, 1.0);
  scene.omega = 0.0;
  scene.restitution = 0.5;
  return {scene, draw.spread(1e3, 1e8)};
}

// Two to ten masses on damped links of which most are soft or stiff, anything from 1e-12 to 1e12,
// with stops close by, for three periods. The masses of a stiff part move along with one another,
// far from their rest positions.
inline Trial any_links(unsigned seed) {
  Draw draw{std::mt19937(seed)};
  Scene scene;
  const int masses = draw.between(2, 10);
  for (int i = 1; i <= masses; ++i) {
    scene.mass.push_back(draw.uniform(0.5, 2.0));
    scene.stiffness.push_back(draw.one_in(3) ? draw.uniform(0.5, 2.0) : draw.spread(1e-12, 1e12));
    scene.amplitude.push_back(draw.one_in(2) ? 0.0 : draw.uniform(-1.0, 1.0));
    add_stops_nearby(i, draw, scene);
  }
  scene.beta = draw.spread(1e-4, 1.0);
  scene.omega = draw.spread(0.1, 1.0);
  scene.restitution = draw.one_of({0.0, 0.3, 0.5, 0.7, 0.9});
  return {scene, 3.0 * 2.0 * std::acos(-1.0) / scene.omega, {}, true};
}

// An ordinary scene with a forcing of any frequency that still moves it.
inline Trial any_frequency(unsigned seed) {
  Draw draw{std::mt19937(~seed)};
  Scene scene = random_scene(seed);
  scene.omega = draw.spread(1e-8, 1e5);
  const double force = std::max(1.0, scene.omega * scene.omega);
  for (double &amplitude : scene.amplitude) amplitude *= force;
  return {scene, std::min(300.0 / frequency_bound(scene), 200.0 / scene.omega), {1.0, 1.0, force}};
}

// One to three masses on links that no spring ties to the ground, driven towards the stop of the
// first by a constant force beside the forcing. They come from far away.
inline Trial free_chain(unsigned seed) {
  Draw draw{std::mt19937(seed)};
  Scene scene;
  const int masses = draw.between(1, 3);
  const double far = draw.spread(0.1, 1e3), force = draw.spread(0.03, 1.0);
  for (int i = 1; i <= masses; ++i) {
    scene.mass.push_back(draw.uniform(0.5, 2.0));
    scene.stiffness.push_back(i == 1 ? 0.0 : draw.uniform(0.3, 3.0));
    scene.amplitude.push_back(draw.one_in(2) ? 0.0 : draw.uniform(-1.0, 1.0) * force);
    scene.constant.push_back(i == 1 ? force : 0.0);
    scene.displacement.push_back(-far);
  }
  scene.beta = draw.one_in(2) ? 0.0 : draw.spread(1e-3, 1.0);
  scene.omega = draw.spread(1e-3, 1.0);
  scene.restitution = draw.one_of({0.0, 0.3, 0.7});
  scene.stops = {{1, Side::upper, 0.0}};
  return {scene, 3.0 * std::sqrt(2.0 * far * masses / force) + 20.0};
}

// Two equal masses on one link, free and unstretched, of which the second hits an elastic stop.
// Half a period of the link later it hits again, and the pair goes on as a rigid body to the other
// stop: the force at that impact is zero but for rounding.
inline Trial rigid_pair(unsigned seed) {
  Draw draw{std::mt19937(seed)};
  const double mass = draw.uniform(0.5, 2.0), at = draw.uniform(-1.0, 1.0),
               speed = draw.spread(0.03, 3.0);
  Scene scene;
  scene.mass = {mass, mass};
  scene.stiffness = {0.0, draw.uniform(0.3, 3.0)};
  scene.displacement = {at, at};
  scene.velocity = {speed, speed};
  scene.omega = 0.0;
  scene.stops = {{2, Side::upper, at},
                 {2, Side::lower, at - draw.spread(0.1, 10.0) * speed, draw.uniform(0.1, 1.0)}};
  return {scene, 30.0, {1.0, 1.0, speed}};
}

// The paper's damped chain of two to four masses under a forcing of period 6e4 to 6e10.
inline Trial slow_forcing(unsigned seed) {
  Draw draw{std::mt19937(seed)};
  Scene scene;
  const int masses = draw.between(2, 4);
  for (int i = 1; i <= masses; ++i) {
    scene.mass.push_back(draw.uniform(0.5, 2.0));
    scene.stiffness.push_back(draw.uniform(0.5, 2.0));
    scene.amplitude.push_back(i == 1 ? 0.5 : 0.0);
    add_stops_nearby(i, draw, scene);
  }
  scene.beta = draw.spread(0.03, 1.0);
  scene.omega = draw.spread(1e-10, 1e-4);
  scene.restitution = draw.one_of({0.0, 0.3, 0.5, 0.7});
  return {scene, Clock(scene.omega).period, {}, true};
}

}  // namespace vibro_impact::testing
