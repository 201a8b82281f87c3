// The chain of two masses with one stop each as a first-order system, and what a careful user does
// at its events. Every method that is given a right-hand side shares this.
//
// The coordinates are the gaps g_i and the gap speeds u_i. A mass at its stop then has g_i = 0
// exactly, and a chatter does not drown in the rounding of x_i - s_i, which helps these methods.
#pragma once

#include <array>
#include <cmath>

#include "method.hpp"

namespace vibro_impact::comparison {

using Vec = std::array<double, 4>;  // g1, u1, g2, u2

// u_i' = gap[0] g_1 + speed[0] u_1 + gap[1] g_2 + speed[1] u_2 + constant + drive cos(Omega t)
// (Eqs. 1 and 2 in gap coordinates). The same expression for a held mass is minus the force that
// presses it into its stop, per mass (Eq. 12, rebuilt, and Eq. 13).
struct GapEquation {
  std::array<double, 2> gap, speed;
  double constant, drive;
};

struct TwoMasses {
  std::array<GapEquation, 2> equation;
  std::array<double, 2> side, stop;  // +1 for an upper stop
  double omega, restitution;

  double acceleration(std::size_t i, const Vec &y, double cosine) const {
    const GapEquation &e = equation[i];
    return e.gap[0] * y[0] + e.speed[0] * y[1] + e.gap[1] * y[2] + e.speed[1] * y[3] + e.constant +
           e.drive * cosine;
  }
};

// The methods other than this library know two masses with stops[i] on mass i + 1, and no external
// force but A cos(Omega t). Throws std::invalid_argument for any other scene.
TwoMasses two_masses(const Scene &scene);

// The state of a run in gap coordinates. A held mass has the gap and the gap speed zero.
struct GapState {
  double time = 0.0;
  Vec y = {};
  std::array<bool, 2> held = {};
};
GapState gap_state(const TwoMasses &chain, double time, const MotionState &state);

template <class State, class Derivative>
void right_hand_side(const TwoMasses &chain, const std::array<bool, 2> &held, const State &y,
                     Derivative &dydt, double t) {
  const double cosine = std::cos(chain.omega * t);
  for (std::size_t i = 0; i < 2; ++i) {
    dydt[2 * i] = held[i] ? 0.0 : y[2 * i + 1];
    dydt[2 * i + 1] = held[i] ? 0.0 : chain.acceleration(i, y, cosine);
  }
}

// The gap of mass i + 1, or the force that holds it: positive until the next event of the mass.
template <class State>
double guard(const TwoMasses &chain, const std::array<bool, 2> &held, std::size_t i, const State &y,
             double t) {
  return held[i] ? -chain.acceleration(i, y, std::cos(chain.omega * t)) : y[2 * i];
}

// Two zeros of a guard closer than this, a sixteenth of a cycle of the fastest mode of two masses
// (w = 1.618), may be jumped over. In a chain of many masses w is below 2.
constexpr double longest_unseen = 0.25;

// Speed below which a chattering mass is held, for a run of the given tolerance. The error in the
// time of a stick is up to 1e4 times the square of this speed where the mass is pressed weakly, and
// a decade in speed costs seven impacts (r = 0.7). With the exponent 2/3, DOP853 takes 7 percent
// more time for the same errors in Figure 2.
inline double stick_below(double tolerance) {
  return std::pow(tolerance, 0.6);
}

// Makes the event of mass i + 1 at the present state: an impact, or the release of a held mass.
// After an impact slower than `slowest` a mass that is pressed into its stop sticks. Its stick is
// recorded when the rest of the chatter, a geometric series of flights 2 u / a, would be over. The
// error in the time of the stick is of the order of `slowest` squared, the error in the motion
// behind it of the order of `slowest` cubed. A neighbour whose hold force the impact turns round
// leaves at once.
void apply_event(const TwoMasses &chain, GapState &state, std::size_t i, double slowest,
                 Result &result);

// Duration 2 u / a of the flight that begins at the present state with speed u and acceleration -a,
// which decides on the length of a first step. Infinite when no mass has just hit.
double flight_ahead(const TwoMasses &chain, const GapState &state);

}  // namespace vibro_impact::comparison
