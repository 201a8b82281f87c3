// The scenes of Table I before what makes two events coincide has been solved for, and where its
// solution is looked for. All numbers are ours.
#pragma once

#include "reference/paper_scenes.hpp"

namespace vibro_impact::pairs {

struct Bracket {
  double from, to;
};

// The paper's chain from rest without stops.
inline Scene without_stops(double omega) {
  Scene scene = paper::stops_of_different_sign(omega);
  scene.stops.clear();
  return scene;
}

// Dual grazing: the forcing frequency at which the first minima of both masses coincide, and when
// mass 1 has its first one.
constexpr Bracket dual_grazing_omega{0.3, 0.5};
constexpr Bracket dual_grazing_minimum{6.0, 12.0};

// Double impact: mass 1 hits its stop for the first time; that of mass 2 is solved for.
constexpr Bracket double_impact_time{1.0, 3.0};
inline Scene double_impact() {
  return paper::two_masses({1, Side::upper, 0.5}, {2, Side::upper, 0.0}, 0.7,
                           paper::figure5a().omega);
}

// Grazing-sticking: Figure 5(b) from a start near its settled motion, in the middle of a sticking
// phase; the stop of mass 2 is solved for, at its maximum in the next one.
constexpr Bracket grazing_sticking_maximum{17.0, 19.0};
inline Scene grazing_sticking() {
  Scene scene = paper::figure5b();
  scene.displacement = {scene.stops[0].position, 0.17};
  scene.velocity = {0.0, -0.003};
  return scene;
}

// Grazing-impact: mass 1 has its first maximum; both stops are solved for.
constexpr Bracket grazing_impact_maximum{1.0, 3.0};
inline Scene grazing_impact() {
  return paper::two_masses({1, Side::upper, 0.0}, {2, Side::upper, 0.0}, 0.7, 0.5);
}

// Dual sticking: Figure 5(a) with the stop of mass 2 below that of mass 1, begun in this window.
constexpr Bracket dual_sticking_window{30.0, 44.0};
inline Scene dual_sticking() {
  Scene scene = paper::figure5a();
  scene.stops[1].position = 0.25;
  return scene;
}

}  // namespace vibro_impact::pairs
