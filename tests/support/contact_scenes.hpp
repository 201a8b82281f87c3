// Random scenes with a contact that is rare elsewhere: a hit just after a release, a slot without
// width, no loss at an impact, a short hop, and a hold force that touches zero.
#pragma once

#include <utility>
#include <vector>

#include "wide_scenes.hpp"

namespace vibro_impact::testing {

// Two or three masses, of which one is pressed onto its stop until its neighbours pull it off. The
// next mass hits a stop of its own 1e-9 to 1e-2 later. Its damper pushes the released mass back,
// which has then gone less than the rounding of its neighbour's displacement.
inline Trial hit_after_a_release(unsigned seed) {
  for (Draw draw{std::mt19937(seed)};;) {
    Scene scene;
    const int masses = draw.between(2, 3), held = draw.between(1, masses - 1);
    for (int i = 1; i <= masses; ++i) {
      scene.mass.push_back(draw.spread(0.3, 3.0));
      scene.stiffness.push_back(draw.uniform(0.3, 3.0));
      scene.amplitude.push_back(draw.uniform(-1.0, 1.0));
      scene.constant.push_back(i == held ? draw.uniform(0.1, 1.0) : 0.0);
      scene.displacement.push_back(i == held ? 0.0 : draw.uniform(-1.0, 1.0));
      scene.velocity.push_back(i == held ? 0.0 : draw.uniform(-1.0, 1.0));
    }
    scene.beta = draw.spread(1e-3, 0.3);
    scene.omega = draw.uniform(0.2, 1.0);
    scene.restitution = draw.one_of({0.0, 0.5, 0.7, 0.9});
    scene.stops = {{held, Side::upper, 0.0}};
    const std::vector<Event> releases = select(events_of(scene, 0.0, 6.0), EventKind::release);
    if (releases.empty()) continue;
    const double release = releases[0].time;
    const MotionState hit = simulate(scene, release + draw.spread(1e-9, 1e-2)).state;
    const auto next = static_cast<std::size_t>(held);  // the mass after the held one, from 0
    const double position = hit.displacement[next], start = scene.displacement[next];
    const Side side = hit.velocity[next] > 0.0 ? Side::upper : Side::lower;
    if (!(sign(side) * (position - start) > 0.0)) continue;
    scene.stops.push_back({held + 1, side, position});
    const std::vector<Event> impacts =
        select(events_of(scene, 0.0, release + 0.1), EventKind::impact, held + 1);
    if (!impacts.empty() && impacts[0].time > release) return {scene, release + 1.0};
  }
}

// Two or three ordinary masses, of which one is between two stops at zero whose distance lies below
// the rounding of every motion.
inline Trial narrow_slot(unsigned seed) {
  Draw draw{std::mt19937(seed)};
  Scene scene;
  const int masses = draw.between(2, 3), narrow = draw.between(1, masses);
  for (int i = 1; i <= masses; ++i) {
    scene.mass.push_back(draw.uniform(0.5, 2.0));
    scene.stiffness.push_back(draw.uniform(0.5, 2.0));
    scene.amplitude.push_back(draw.uniform(-1.0, 1.0));
    if (i != narrow) add_stops_nearby(i, draw, scene);
  }
  scene.stops.push_back({narrow, Side::lower, 0.0});
  scene.stops.push_back({narrow, Side::upper, draw.spread(1e-300, 1e-30)});
  scene.beta = draw.spread(1e-3, 0.3);
  scene.omega = draw.uniform(0.1, 1.0);
  scene.restitution = draw.one_of({0.0, 0.5, 0.9});
  return {scene, 2.0 * Clock(scene.omega).period};
}

// One to six masses without damping and forcing between stops of r = 1. One run in ten is ten times
// as long, in which a drift of the energy shows that is a tenth of a rounding in each step.
inline Trial elastic_chain(unsigned seed) {
  Draw draw{std::mt19937(seed)};
  Scene scene{.omega = 0.0, .restitution = 1.0};
  const int masses = draw.between(1, 6);
  for (int i = 1; i <= masses; ++i) {
    scene.mass.push_back(draw.uniform(0.5, 2.0));
    scene.stiffness.push_back(draw.uniform(0.5, 2.0));
    scene.velocity.push_back(draw.uniform(-1.0, 1.0));
    if (i == 1 || draw.one_in(2)) scene.stops.push_back({i, Side::upper, draw.uniform(0.1, 0.4)});
    if (draw.one_in(2)) scene.stops.push_back({i, Side::lower, -draw.uniform(0.1, 0.4)});
  }
  return {scene, draw.one_in(10) ? 20'000.0 : 2'000.0};
}

// Three masses, the last on a link of 1e8 to 1e13, of which the force presses the first onto its
// stop but for a short time in each of four periods. Steps are then too short to show its gap, and
// it is back soon.
inline Trial short_hop(unsigned seed) {
  Draw draw{std::mt19937(seed)};
  Scene scene;
  for (int i = 1; i <= 3; ++i) {
    scene.mass.push_back(draw.uniform(0.5, 2.0));
    scene.stiffness.push_back(i == 3 ? draw.spread(1e8, 1e13) : draw.uniform(0.5, 2.0));
  }
  const double force = draw.uniform(0.1, 1.0);
  scene.amplitude = {force, 0.0, 0.0};
  scene.constant = {force * (1.0 - draw.spread(1e-6, 0.1)), 0.0, 0.0};
  scene.beta = draw.spread(0.01, 0.3);
  scene.omega = draw.uniform(0.1, 0.7);
  scene.restitution = draw.one_of({0.0, 0.3, 0.5});
  scene.stops = {{1, Side::upper, 0.0}};
  return {scene, 4.0 * Clock(scene.omega).period};
}

// One to three masses that rest at their stops under forces a (cos(Omega t) - 1), which touch zero
// after each of twenty periods.
inline Trial touching_forces(unsigned seed) {
  Draw draw{std::mt19937(seed)};
  Scene scene;
  const int masses = draw.between(1, 3);
  for (int i = 1; i <= masses; ++i) {
    scene.mass.push_back(draw.spread(0.3, 3.0));
    scene.stiffness.push_back(draw.uniform(0.3, 3.0));
    scene.amplitude.push_back(draw.uniform(0.1, 1.0));
    scene.constant.push_back(-scene.amplitude.back());
    scene.stops.push_back({i, Side::lower, 0.0});
  }
  scene.beta = draw.one_in(2) ? 0.0 : draw.spread(1e-3, 0.3);
  scene.omega = draw.uniform(0.1, 1.0);
  scene.restitution = draw.one_of({0.0, 0.5, 0.7, 0.9});
  return {scene, 20.0 * Clock(scene.omega).period};
}

// The same with forces that fall below zero once in each period, by 4e-15 to 1e-8 of their
// amplitudes, which is at least twice the depth of a touch. Half of them are next to it.
inline Trial dipping_forces(unsigned seed) {
  Trial trial = touching_forces(seed);
  Draw draw{std::mt19937(~seed)};
  for (double &constant : trial.scene.constant)
    constant *= 1.0 - (draw.one_in(2) ? draw.spread(4e-15, 1e-13) : draw.spread(1e-14, 1e-8));
  trial.until = 19.5 * Clock(trial.scene.omega).period;
  return trial;
}

// The same with forces a (sin(Omega t) - 1 + d), whose dips have at most an eighth of the depth of
// a touch, which is eight roundings of the sum of the two forces. At the start they press.
inline Trial touching_below_zero(unsigned seed) {
  Trial trial = touching_forces(seed);
  Draw draw{std::mt19937(~seed)};
  trial.scene.sine = std::exchange(trial.scene.amplitude, {});
  for (double &constant : trial.scene.constant) constant *= 1.0 - draw.uniform(0.0, 0x1p-52);
  return trial;
}

}  // namespace vibro_impact::testing
