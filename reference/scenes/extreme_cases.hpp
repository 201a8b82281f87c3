// The matrix of extreme cases, group by group, in the order of the stability figure.
#pragma once

#include <fmt/format.h>

#include <cmath>
#include <string>
#include <vector>

#include "extreme_truths.hpp"

namespace vibro_impact::extremes {

// A case against the generator's events, to be changed by the caller: Figure 2's scene if none is
// given.
inline Case &add(std::vector<Case> &cases, const std::string &group, const std::string &name,
                 double until = 60.0, const Scene &scene = figure2_with(0.7)) {
  return cases.emplace_back(Case{name, group, scene, until});
}

// Restitution from 0 to 1: Figure 2's scene, and one mass pressed onto its stop, whose chatter is
// known exactly, to its completion.
inline void add_restitution(std::vector<Case> &cases) {
  constexpr double restitutions[] = {0.0, 1e-12, 1e-3, 0.3, 0.9, 0.99, 0.999, 1.0};
  for (const double r : restitutions)
    add(cases, "restitution", fmt::format("Figure 2: r = {:g}", r), 60.0, figure2_with(r));
  for (const double r : restitutions) {
    const double until = r < 0.95 ? 100.0 : r == 0.99 ? 500.0 : r == 0.999 ? 5000.0 : 400.0;
    cases.push_back({fmt::format("pressed: r = {:g}", r), "restitution",
                     one_mass(0.0, 0.0, 1.0, r, -0.5, -1.0), until, Truth::exact,
                     [r, until] { return bounces(-1.0, -0.5, r, until); }});
  }
}

// Damping c = beta k; the modes of Figure 2's chain are critical at beta = 2 / sqrt(lambda_j).
inline void add_damping(std::vector<Case> &cases) {
  // sqrt(lambda_2); sqrt(lambda_1) = 1 / golden
  const double golden = (1.0 + std::sqrt(5.0)) / 2.0;
  for (const auto &[damping, beta] : {std::pair{"0", 0.0},
                                      {"1e-8", 1e-8},
                                      {"0.1", 0.1},
                                      {"critical in mode 2", 2.0 / golden},
                                      {"critical in mode 1", 2.0 * golden},
                                      {"10", 10.0},
                                      {"1e4", 1e4}})
    add(cases, "damping", fmt::format("c = {}", damping)).scene.beta = beta;
  // So damped a chain creeps: 1e-4 in a period. The stops are as near.
  cases.back().scene.stops = {{1, Side::lower, -1e-5}, {2, Side::upper, 1e-5}};
  add(cases, "damping", "one mass: critical", 60.0, one_mass(2.0, 0.5, 0.28, 0.7, 0.1));
}

// Stiffnesses and masses of the two links and masses, apart by 1e6 either way.
inline void add_stiffness(std::vector<Case> &cases) {
  const auto chain = [&](const std::string &what, const std::vector<double> &mass,
                         const std::vector<double> &stiffness, double beta, double until,
                         double slowest) {
    Case &result = add(cases, "stiffness", what, until);
    result.scene.mass = mass;
    result.scene.stiffness = stiffness;
    result.scene.beta = beta;
    result.slowest_impact = slowest;
  };
  chain("k2/k1 = 1e6", {1, 1}, {1, 1e6}, 0.1, 40.0, 1e-20);
  chain("k2/k1 = 1e-6", {1, 1}, {1, 1e-6}, 0.1, 60.0, 1e-20);
  cases.back().scene.amplitude = {0.5, 0.5};
  chain("k1 = 1e6 k2", {1, 1}, {1e6, 1}, 0.1, 40.0, 1e-20);
  cases.back().scene.amplitude = {0.5, 0.5};
  cases.back().scene.stops[0].position = -3e-7;
  chain("m2/m1 = 1e6", {1, 1e6}, {1, 1}, 0.1, 60.0, 1e-22);
  cases.back().scene.velocity = {0.0, 0.01};
  chain("m2/m1 = 1e-6", {1, 1e-6}, {1, 1}, 0.1, 40.0, 1e-19);
  chain("k2/k1 = 1e6: undamped", {1, 1}, {1, 1e6}, 0.0, 6.0, 1e-20);
  chain("m2/m1 = 1e-6: undamped", {1, 1e-6}, {1, 1}, 0.0, 6.0, 1e-19);
}

// Forcing frequencies, and undamped modes driven at their own frequency.
inline void add_frequency(std::vector<Case> &cases) {
  // Held from the start until cos(Omega t) = 0.6, back on the stop most of a period later.
  add(cases, "frequency", "Omega = 1e-4", 6.3e4, one_mass(0.1, 0.5, 1e-4, 0.7, 0.3, 0.3));
  add(cases, "frequency", "Omega = 1e-4: Figure 2", 200.0).scene.omega = 1e-4;
  Scene &fast = add(cases, "frequency", "Omega = 1e3", 8.0).scene;
  fast.omega = 1e3;
  fast.displacement = {1.0, -1.0};
  add(cases, "frequency", "Omega = 0").scene.omega = 0.0;
  add(cases, "frequency", "resonance: one mass", 60.0, one_mass(0.0, 0.5, 1.0, 0.7, 2.0));
  for (const int mode : {1, 2}) {
    Scene &resonance = add(cases, "frequency", fmt::format("resonance of mode {}", mode)).scene;
    resonance.beta = 0.0;
    resonance.omega = (std::sqrt(5.0) + (mode == 1 ? -1.0 : 1.0)) / 2.0;
  }
}

inline void add_amplitude(std::vector<Case> &cases) {
  Case none{"A = 0: at rest",  "amplitude",
            figure2_with(0.7), 60.0,
            Truth::exact,      [] { return std::vector<TrueEvent>{}; }};
  none.scene.amplitude = {0.0, 0.0};
  cases.push_back(none);
  none.name = "A = 0: at rest on stops at 0";  // hold force zero, no motion
  none.scene.stops = {{1, Side::lower, 0.0}, {2, Side::upper, 0.0}};
  cases.push_back(none);
  Scene &moving = add(cases, "amplitude", "A = 0: moving").scene;
  moving.amplitude = {0.0, 0.0};
  moving.velocity = {-1.0, 1.0};
  Case tiny{"A = 1e-9", "amplitude", figure2_with(0.7), 60.0};
  tiny.scene.amplitude = {1e-9, 0.0};
  tiny.scene.stops = {{1, Side::lower, -6e-10}, {2, Side::upper, 2e-10}};
  tiny.slowest_impact = 1e-27;
  cases.push_back(tiny);
  tiny.name = "A = 1e-9: stop at 0";
  tiny.scene.stops = {{1, Side::lower, 0.0}, {2, Side::upper, 0.0}};
  cases.push_back(tiny);
  Case &huge = add(cases, "amplitude", "A = 1e6");
  huge.scene.amplitude = {1e6, 0.0};
  huge.slowest_impact = 1e-16;
}

inline void add_masses(std::vector<Case> &cases) {
  add(cases, "masses", "N = 1", 60.0, one_mass(0.1, 0.5, 0.28, 0.7, 0.1));
  add(cases, "masses", "N = 2");
  for (const auto &[n, until] : {std::pair{3, 50.0}, {10, 40.0}, {50, 12.0}, {200, 9.0}})
    add(cases, "masses", fmt::format("N = {}", n), until, long_chain(n, 0.7));
}

inline void add_gaps(std::vector<Case> &cases) {
  for (const double gap : {0.0, 1e-14, 1e-6})
    add(cases, "gaps", fmt::format("gaps of {:g}", gap)).scene.stops = {{1, Side::lower, -gap},
                                                                        {2, Side::upper, gap}};
  Scene &across = add(cases, "gaps", "stops across the origin").scene;
  across.stops = {{1, Side::lower, 0.25}, {2, Side::upper, -0.1}};
  across.displacement = {0.25 + 1e-14, -0.1 - 1e-14};
  add(cases, "gaps", "clearance of 1e-9: forced").scene.stops = {
      {1, Side::lower, -5e-10}, {1, Side::upper, 5e-10}, {2, Side::upper, 0.1}};
  for (const auto &[r, until] : {std::pair{0.9, 100.0}, {1.0, 1e-6}}) {
    Case rattle{fmt::format("clearance of 1e-9: r = {:g}", r),
                "gaps",
                one_mass(0.0, 0.0, 1.0, r, 5e-10, 0.0, 1.0),
                until,
                Truth::exact,
                [r, until] { return rattling(5e-10, 1.0, r, until); }};
    rattle.scene.stops.push_back({1, Side::lower, -5e-10});
    cases.push_back(rattle);
  }
}

// Starts with mass 1 or both on their stops at -0.3 (lower) and 0.1 (upper). The springs push mass
// 1 off its stop; Figure 5's upper stops at 0.3 press instead.
inline void add_starts(std::vector<Case> &cases) {
  add(cases, "starts", "on the stop: pulled", 60.0, started(-0.3, 0.0, 0.0, 0.0));
  add(cases, "starts", "on both stops: pulled", 60.0, started(-0.3, 0.0, 0.1, 0.0));
  add(cases, "starts", "on the stop: moving away", 60.0, started(-0.3, 0.5, 0.0, 0.0));
  add(cases, "starts", "on the stop: moving in", 60.0, started(-0.3, -0.5, 0.0, 0.0));
  Case pressed{"on the stop: pressed", "starts", paper::figure5b(), 60.0};
  pressed.scene.omega = 0.2996;
  pressed.scene.displacement = {0.3, 0.0};
  cases.push_back(pressed);
  pressed.name = "pressed: moving away at 1e-9";
  pressed.scene.restitution = 0.7;
  pressed.scene.velocity = {-1e-9, 0.0};
  cases.push_back(pressed);
  pressed.name = "pressed: moving in at 1e-9";
  pressed.scene.velocity = {1e-9, 0.0};
  cases.push_back(pressed);
  // A cos(Omega t) = k s at t = 0: the force on the mass is zero and falls, or grows, from there.
  add(cases, "starts", "force zero: about to pull", 60.0, one_mass(0.1, 0.5, 0.28, 0.7, 0.5, 0.5));
  cases.push_back({"force zero: about to press", "starts",
                   one_mass(0.1, -0.5, 0.28, 0.7, -0.5, -0.5), 20.0, Truth::exact, [] {
                     return std::vector<TrueEvent>{{0, 0.0, 1, "stick", 0.0, "1"}};
                   }});
}

inline void add_simultaneous(std::vector<Case> &cases) {
  for (const double r : {0.0, 0.3, 0.9, 1.0}) {
    const double until = r == 1.0 ? 20.0 : 100.0;
    cases.push_back({fmt::format("two in step: r = {:g}", r), "simultaneous",
                     in_step(0.0, 0.0, 1.0, r, -0.5, -1.0), until, Truth::exact,
                     [r, until] { return bounces(-1.0, -0.5, r, until, 2); }});
  }
  // Both stick and are let go at the same instants, period after period.
  add(cases, "simultaneous", "two stick and part at once", 60.0,
      in_step(0.1, 0.5, 0.28, 0.7, 0.25, 0.0));
  add(cases, "simultaneous", "the same: r = 0", 60.0, in_step(0.1, 0.5, 0.28, 0.0, 0.25, 0.0));
  add(cases, "simultaneous", "both moving in at the start", 60.0, started(-0.3, -0.5, 0.1, 0.5));
  Scene &pressed =
      add(cases, "simultaneous", "the same: r = 0: pressed", 60.0, paper::figure5a()).scene;
  pressed.restitution = 0.0;
  pressed.stops = {{1, Side::upper, 0.2}, {2, Side::upper, 0.1}};  // s2 < s1: both stay
  pressed.displacement = {0.2, 0.1};
  pressed.velocity = {0.5, 0.5};
}

inline void add_grazing(std::vector<Case> &cases) {
  const auto touch = [&](const std::string &what, double stop, Truth truth) {
    Case result{what, "grazing", one_mass(0.0, 0.0, 1.0, 0.7, stop, -1.0), 40.0, truth, {}};
    if (truth == Truth::grazing)
      result.events = [] { return touches(std::numbers::pi_v<Extended>, 40.0); };
    else if (stop < 1.0)
      result.events = [stop] { return bounces(-1.0, stop, 0.7, 40.0); };
    else
      result.events = [] { return std::vector<TrueEvent>{}; };
    cases.push_back(result);
  };
  touch("touching exactly", 1.0, Truth::grazing);
  touch("one ulp apart", std::nextafter(1.0, 2.0), Truth::grazing);
  touch("one ulp deep", std::nextafter(1.0, 0.0), Truth::grazing);
  for (const double depth : {1e-12, 1e-6}) {
    touch(fmt::format("{:g} apart", depth), 1.0 + depth, Truth::exact);
    touch(fmt::format("{:g} deep", depth), 1.0 - depth, Truth::exact);
  }
  cases.push_back({"from the stop back to it", "grazing", one_mass(0.0, 0.0, 1.0, 0.7, 1.0, 1.0),
                   40.0, Truth::grazing,
                   [] { return touches(2.0L * std::numbers::pi_v<Extended>, 40.0); }});
}

inline void add_zero_force(std::vector<Case> &cases) {
  add(cases, "zero hold force", "Figure 5(c)", 120.0, paper::figure5c());
  add(cases, "zero hold force", "Figure 5(c): Omega = 0", 120.0, paper::figure5c()).scene.omega =
      0.0;  // mass 1 stays
  for (const double r : {0.3, 0.99})
    cases.push_back({fmt::format("stop at 0: r = {:g}", r), "zero hold force",
                     one_mass(0.0, 0.0, 1.0, r, 0.0, -1.0), 600.0, Truth::exact,
                     [r] { return bounces(-1.0, 0.0, r, 600.0); }});
}

// One impact per forcing period, stable (multiplier modulus r): what is lost in the count of
// periods or in cos(Omega t) would show as a drift.
inline void add_long_runs(std::vector<Case> &cases) {
  constexpr double omega = 2.5, r = 0.8, stop = 0.05;
  const PeriodicImpact impact = periodic_impact(1.0, omega, r, stop);
  for (const long long periods : {1'000LL, 1'000'000LL}) {
    const long long shown = periods - 100;
    const double period = 2.0 * std::numbers::pi / omega;
    Case result{fmt::format("{:g} periods", static_cast<double>(periods)),
                "long runs",
                one_mass(0.0, 1.0, omega, r, stop, static_cast<double>(impact.x0),
                         static_cast<double>(impact.v0)),
                period * static_cast<double>(periods),
                Truth::exact,
                [=] { return periodic_impacts(impact, shown, periods); },
                period * static_cast<double>(shown)};
    cases.push_back(result);
  }
}

inline std::vector<Case> all_cases() {
  std::vector<Case> cases;
  add_restitution(cases);
  add_damping(cases);
  add_stiffness(cases);
  add_frequency(cases);
  add_amplitude(cases);
  add_masses(cases);
  add_gaps(cases);
  add_starts(cases);
  add_simultaneous(cases);
  add_grazing(cases);
  add_zero_force(cases);
  add_long_runs(cases);
  return cases;
}

}  // namespace vibro_impact::extremes
