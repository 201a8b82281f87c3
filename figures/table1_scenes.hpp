// One scene for each pair of events of Table I: two masses of the paper's kind (m = k = 1, c = 0.1,
// A = (0.5, 0)) in which the pair occurs.
//
// Sticking takes time, grazing and impact do not: DS and SI occur for open sets of parameters, and
// their scenes are simply chosen. The others need as many parameters as there are conditions beyond
// the unknown time: one for DI (x1 = s1, x2 = s2) and GS (x2 = s2, x2' = 0), two for GI (x1 = s1,
// x1' = 0, x2 = s2), three for DG (x_i = s_i, x_i' = 0). They are solved for, here, to the last
// digits of a double.
// The numbers that are not solved for stand in reference/scenes/pair_scenes.hpp.
#pragma once

#include <stdexcept>
#include <vector>

#include "reference/scenes/pair_scenes.hpp"
#include "vibro_impact/analysis/analysis.hpp"
#include "vibro_impact/vibro_impact.hpp"

namespace vibro_impact::figures {

// A scene, the pair of events it shows, when (about) it first does, and the window it is shown in.
struct PairScene {
  EventPair kind;
  Scene scene;
  double time;      // of the event; where the sticking begins for DS
  double from, to;  // window
};

// The scene without its stops on `mass`.
inline Scene without_stop(Scene scene, int mass) {
  std::erase_if(scene.stops, [mass](const Stop &stop) { return stop.mass == mass; });
  return scene;
}

inline MotionState state_at(const Scene &scene, double time) {
  return require_complete(simulate(scene, time)).state;
}

// The place and the velocity of `mass` (from 1) at `time`.
inline double place_at(const Scene &scene, int mass, double time) {
  return state_at(scene, time).displacement[static_cast<std::size_t>(mass - 1)];
}
inline double velocity_at(const Scene &scene, int mass, double time) {
  return state_at(scene, time).velocity[static_cast<std::size_t>(mass - 1)];
}

// The time in [from, to] at which `mass` turns round.
inline double turning_time(const Scene &scene, int mass, double from, double to) {
  return zero([&](double t) { return velocity_at(scene, mass, t); }, from, to).value;
}

// The mass at its turning point `place` grazes a stop on `side` put a few roundings before it, at a
// speed of about 3e-8: whether it touches a stop at the turning point itself hangs on the rounding.
inline double grazed_at(double place, Side side) {
  return place - sign(side) * 2e-15;
}

// Dual grazing: from rest, the forcing frequency for which the first minima of both masses
// coincide, and lower stops at these minima.
inline PairScene dual_grazing() {
  const auto [earliest, latest] = pairs::dual_grazing_minimum;
  const auto minimum = [&](double omega) {
    return turning_time(pairs::without_stops(omega), 1, earliest, latest);
  };
  const auto other_speed = [&](double omega) {
    return velocity_at(pairs::without_stops(omega), 2, minimum(omega));
  };
  const double omega =
      zero(other_speed, pairs::dual_grazing_omega.from, pairs::dual_grazing_omega.to).value;
  const double time = minimum(omega);
  const MotionState both = state_at(pairs::without_stops(omega), time);
  Scene scene =
      paper::two_masses({1, Side::lower, grazed_at(both.displacement[0], Side::lower)},
                        {2, Side::lower, grazed_at(both.displacement[1], Side::lower)}, 0.7, omega);
  return {EventPair::dual_grazing, scene, time, 0.0, 14.0};
}

// Dual sticking: Figure 5(a) with the stop of mass 2 below that of mass 1.
inline PairScene dual_sticking() {
  const Scene scene = pairs::dual_sticking();
  const auto [from, to] = pairs::dual_sticking_window;
  PressedEventRecorder recorder{scene};
  require_complete(simulate(scene, 40.0, {}, recorder));
  for (const PairedEvents &pair : event_pairs(recorder.events))
    if (pair.kind == EventPair::dual_sticking) return {pair.kind, scene, pair.from, from, to};
  throw std::runtime_error("dual sticking: none before t = 40");
}

// Double impact: from rest, mass 2's stop where mass 2 is when mass 1 first hits its own.
inline PairScene double_impact() {
  Scene scene = pairs::double_impact();
  const Scene free = pairs::without_stops(scene.omega);
  const auto [earliest, latest] = pairs::double_impact_time;
  const double time = zero([&](double t) { return place_at(free, 1, t) - scene.stops[0].position; },
                           earliest, latest)
                          .value;
  scene.stops[1].position = place_at(free, 2, time);
  return {EventPair::double_impact, scene, time, 0.0, 7.0};
}

// Grazing-sticking: mass 2's stop at its greatest displacement while mass 1 sticks.
inline PairScene grazing_sticking() {
  Scene scene = pairs::grazing_sticking();
  const Scene free = without_stop(scene, 2);
  const auto [earliest, latest] = pairs::grazing_sticking_maximum;
  const double time = turning_time(free, 2, earliest, latest);
  scene.stops[1].position = grazed_at(place_at(free, 2, time), Side::upper);
  return {EventPair::grazing_sticking, scene, time, 12.0, 26.0};
}

// Grazing-impact: from rest, mass 1's stop at its first maximum, mass 2's where mass 2 is then.
inline PairScene grazing_impact() {
  Scene scene = pairs::grazing_impact();
  const Scene free = pairs::without_stops(scene.omega);
  const auto [earliest, latest] = pairs::grazing_impact_maximum;
  const double time = turning_time(free, 1, earliest, latest);
  const MotionState both = state_at(free, time);
  scene.stops[0].position = grazed_at(both.displacement[0], Side::upper);
  scene.stops[1].position = both.displacement[1];
  return {EventPair::grazing_impact, scene, time, 0.0, 5.0};
}

// Sticking-impact: Figure 5(a) as it is.
inline PairScene sticking_impact() {
  const auto box = paper::figure5a_box;
  return {EventPair::sticking_impact, paper::figure5a(), 960.0, box.from, box.to};
}

// All six, in the order of Table I.
inline std::vector<PairScene> table1_scenes() {
  return {dual_grazing(),     dual_sticking(),  double_impact(),
          grazing_sticking(), grazing_impact(), sticking_impact()};
}

}  // namespace vibro_impact::figures
