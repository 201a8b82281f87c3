// What a bifurcation point is; the grazing of mass 2 in the scene of Figure 5(b), and the motion
// with impacts that lives on beside the one without.
#pragma once

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

#include "reference/paper_scenes.hpp"
#include "vibro_impact/analysis/analysis.hpp"

namespace vibro_impact::figures {

// A bifurcation point found in two ways.
struct BifurcationPoint {
  std::string symbol;
  Located omega;
  std::string method;
  double check = 0.0;  // the same by bisection on a count of events
  std::string checked_by;
};

// Forcing periods left out before the motion from rest counts as settled, and those then counted
// over: sticking motions of period 1, 2 and 4 give the same count in every window.
constexpr int settling = 150, counted = 4;

inline Scene figure5b_at(double omega) {
  Scene scene = paper::figure5b();
  scene.omega = omega;
  return scene;
}

// The motion of mass 2 that does not touch its stop, with that stop taken away: it goes on
// existing, and its least gap passes smoothly through zero, where the real motion grazes.
inline MotionState motion_without_second_stop(double omega) {
  Scene scene = figure5b_at(omega);
  scene.stops.pop_back();
  const MotionState seed = at_quiet_phase(scene, state_after_periods(scene, settling));
  return orbit_near(scene, seed, 1).value();
}

// Velocities of the impacts of mass 2 in some periods from `state` on, which is brought to their
// end.
inline std::vector<double> impacts_of_mass_2(const Scene &scene, MotionState &state, int periods) {
  ImpactSpeedRecorder impacts{2, -1.0};
  state = stroboscopic_map(scene, state, periods, {}, impacts).state;
  return impacts.velocities;
}

inline bool mass_2_hits(double omega, MotionState &state) {
  return !impacts_of_mass_2(figure5b_at(omega), state, counted).empty();
}

// Speed of the last impact of mass 2 in the two periods from `state` on (0: it does not reach its
// stop); the state is brought to their end. The motion may have period two.
inline double last_speed(const Scene &scene, MotionState &state) {
  const std::vector<double> impacts = impacts_of_mass_2(scene, state, 2);
  return impacts.empty() ? 0.0 : impacts.back();
}

inline BifurcationPoint grazing() {
  const Stop second = paper::figure5b().stops[1];
  const auto gap = [&](double omega) {
    Scene scene = figure5b_at(omega);
    scene.stops.pop_back();
    return least_gap(scene, motion_without_second_stop(omega), second).value().value;
  };
  const CountJump change = bisect(
      [](double omega) {
        MotionState state = motion_without_second_stop(omega);
        return int{mass_2_hits(omega, state)};
      },
      0.2995, 0.2996);
  return {"grazing_mass_2_figure5b", zero(gap, 0.2995, 0.2996),
          "gap of mass 2 on the periodic orbit without impact touches zero",
          0.5 * (change.below + change.above), "bisection on impacts from that orbit"};
}

// Below the grazing the motion with impacts of mass 2 lives on beside the one without. From rest it
// is reached from here on.
inline BifurcationPoint impacts_from_rest() {
  const auto located = [](int periods) {
    const CountJump change = bisect(
        [periods](double omega) {
          MotionState state = state_after_periods(figure5b_at(omega), periods);
          return int{mass_2_hits(omega, state)};
        },
        0.2995, 0.2996);
    return 0.5 * (change.below + change.above);
  };
  return {"impacts_of_mass_2_from_rest_figure5b",
          {located(settling), 1e-16},
          "bisection on impacts from rest",
          located(4 * settling),
          "the same after four times as many periods"};
}

// Followed downwards by ever smaller steps of 300 periods each, the motion with impacts is lost in
// a fold, where the approach to it slows down: the error falls as the square of the periods only.
// At the fold a Floquet multiplier mu reaches 1, as the square root of the distance to it:
// (1 - mu)^2 is smooth and falls to zero there.
inline BifurcationPoint end_of_impacts() {
  double followed = 0.2996;
  MotionState last = state_after_periods(figure5b_at(followed), settling);
  for (double step = 1e-5; step > 1e-12;) {
    MotionState next = stroboscopic_map(figure5b_at(followed - step), last, 300).state;
    if (mass_2_hits(followed - step, next)) {
      followed -= step;
      last = next;
    } else {
      step /= 2;
    }
  }
  const MotionState seed = at_quiet_phase(figure5b_at(followed), last);
  const auto distance = [&](double omega) {
    const PeriodicOrbit orbit = find_periodic_orbit(figure5b_at(omega), seed, 2);
    if (!orbit.converged)
      throw std::runtime_error(
          fmt::format("omega = {}: the motion with impacts of mass 2 was not found", omega));
    return std::pow(1.0 - orbit.multipliers.at(0).real(), 2);
  };
  return {"impacts_of_mass_2_end_figure5b",
          zero_from_one_side(distance, followed + 4e-8, followed + 2e-8),
          "multiplier of the orbit with impacts reaches 1", followed,
          "motion with impacts followed downwards by 300 periods a step"};
}

}  // namespace vibro_impact::figures
