// Exact motions for the extreme scenes: closed formulas, summed in extended precision. A sum of
// 48,330 flights, the longest one, is off by less than 1e-13.
#pragma once

#include <cmath>
#include <numbers>

#include "case.hpp"

namespace vibro_impact::truth {

using Extended = long double;

// One mass, m = k = 1, undamped and unforced, let go at q0 < 0 before an upper stop at s > q0.
// From the start it needs the angle theta with cos(theta) = s / q0, then leaves the stop with the
// speed u = r^n v_1, v_1^2 = q0^2 - s^2, and is back with the same speed (energy) after
//   T(u) = 2 atan2(u, -s).
// s < 0 presses it: T -> 2 u / |s|, complete chatter, it sticks after the sum of all T. At s = 0
// the force vanishes on the stop: T = pi, no stick ever. s > 0 pulls it away: T -> 2 pi. `masses`
// in step (x2 = 2 x1) hit together, mass p with p times the speed. Impacts slower than 1e-6 of
// the first are left out of a complete chatter.
inline std::vector<Event> bounces(double q0, double s, double r, double until, int masses = 1) {
  std::vector<Event> events;
  const auto together = [&](Extended time, EventKind kind, Extended velocity) {
    for (int p = 1; p <= masses; ++p)
      events.push_back(
          event_at(static_cast<double>(time), p, kind, static_cast<double>(p * velocity)));
  };
  const Extended height = -Extended(q0), stop = s;
  const Extended first = std::sqrt((height - std::abs(stop)) * (height + std::abs(stop)));
  Extended time = std::atan2(first, -stop);
  Extended speed = first;
  while (time <= until) {
    if (stop >= 0.0L || speed >= 1e-6L * first) together(time, EventKind::impact, speed);
    speed *= r;
    if (stop < 0.0L && speed < 1e-21L * first) {
      together(time, EventKind::stick, 0.0L);
      break;
    }
    time += 2.0L * std::atan2(speed, -stop);
  }
  return events;
}

// One mass, m = k = 1, undamped and unforced, started at 0 with speed v between stops at -h and h:
// it arrives first at the upper one after asin(h / v), leaves each with u = r^n v_1, v_1^2 = v^2 -
// h^2, and is at the other one with the same speed after 2 atan2(h, u).
inline std::vector<Event> rattling(double h, double v, double r, double until) {
  std::vector<Event> events;
  const Extended first = std::sqrt((Extended(v) - h) * (Extended(v) + h));
  Extended time = std::atan2(Extended(h), first);
  Extended speed = first;
  for (int side = 1; time <= until; side = -side) {
    events.push_back(event_at(static_cast<double>(time), 1, EventKind::impact,
                              static_cast<double>(side * speed)));
    speed *= r;
    time += 2.0L * std::atan2(Extended(h), speed);
  }
  return events;
}

// The same mass touching a stop at s = a exactly, first at `first` and then every 2 pi, at zero
// speed: the impact law changes nothing there.
inline std::vector<Event> touches(Extended first, double until) {
  std::vector<Event> events;
  for (int n = 0;; ++n) {
    const Extended time = first + 2.0L * std::numbers::pi_v<Extended> * n;
    if (time > until) return events;
    events.push_back(event_at(static_cast<double>(time), 1, EventKind::impact));
  }
}

// The motion of one mass, m = k = 1, undamped, under A cos(Omega t), with one impact per forcing
// period at an upper stop s. With F = A / (1 - Omega^2), T = 2 pi / Omega and tau the time since
// the impact at phase theta = Omega t*,
//   x = F cos(theta + Omega tau) + a cos(tau) + b sin(tau).
// Periodicity (x = s, velocity v before and -r v after) gives a = b cot(T/2), b = -(1 + r) v / 2,
// v = -2 Omega F sin(theta) / (1 - r), and F (cos(theta) + kappa sin(theta)) = s with
// kappa = (1 + r) / (1 - r) Omega cot(T/2).
// The impacts in the forcing periods from `first` to `last`, without `last`.
inline std::vector<Event> periodic_impacts(double amplitude, double omega_of_forcing, double r,
                                           double s, long long first, long long last) {
  const Extended omega = omega_of_forcing, period = 2.0L * std::numbers::pi_v<Extended> / omega;
  const Extended f = amplitude / (1.0L - omega * omega);
  const Extended cotangent = 1.0L / std::tan(period / 2.0L);
  const Extended kappa = (1.0L + r) / (1.0L - r) * omega * cotangent;
  const Extended middle = std::atan2(kappa, 1.0L);
  const Extended width = std::acos(s / (f * std::sqrt(1.0L + kappa * kappa)));
  // The phase with the greater impact speed belongs to the stable motion.
  Extended time = 0.0L, velocity = 0.0L;  // t* in [0, T), v
  for (const Extended theta : {middle + width, middle - width}) {
    const Extended v = -2.0L * omega * f * std::sin(theta) / (1.0L - r);
    if (v <= velocity) continue;
    time = std::fmod(std::fmod(theta / omega, period) + period, period);
    velocity = v;
  }
  std::vector<Event> events;
  for (long long n = first; n < last; ++n) {
    events.push_back(event_at(static_cast<double>(period * static_cast<Extended>(n) + time), 1,
                              EventKind::impact, static_cast<double>(velocity)));
    events.back().instant = {n, static_cast<double>(time)};
  }
  return events;
}

}  // namespace vibro_impact::truth
