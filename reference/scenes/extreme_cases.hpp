// The matrix of extreme cases, group by group, in the order of the stability figure.
#pragma once

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "extreme_truths.hpp"

namespace vibro_impact::extremes {

// Restitution from 0 to 1: Figure 2's scene, and one mass pressed onto its stop, whose chatter is
// known exactly, to its completion.
inline void add_restitution(std::vector<Case> &cases) {
  for (const auto &[r, until] : {std::pair{0.0, 60.0},
                                 {1e-12, 60.0},
                                 {1e-3, 60.0},
                                 {0.3, 60.0},
                                 {0.9, 60.0},
                                 {0.99, 60.0},
                                 {0.999, 60.0},
                                 {1.0, 60.0}})
    cases.push_back({fmt::format("Figure 2: r = {:g}", r), "restitution", figure2_with(r), until});
  for (const double r : {0.0, 1e-12, 1e-3, 0.3, 0.9, 0.99, 0.999, 1.0}) {
    const double until = r < 0.95 ? 100.0 : r == 0.99 ? 500.0 : r == 0.999 ? 5000.0 : 400.0;
    cases.push_back({fmt::format("pressed: r = {:g}", r), "restitution",
                     one_mass(0.0, 0.0, 1.0, r, -0.5, -1.0), until, Truth::exact,
                     [r, until] { return bounces(-1.0, -0.5, r, until); }});
  }
}

// Damping c = beta k; the modes of Figure 2's chain are critical at beta = 2 / sqrt(lambda_j).
inline void add_damping(std::vector<Case> &cases) {
  const auto figure2 = [&](const std::string &damping, double beta, double until) {
    Case result{fmt::format("c = {}", damping), "damping", figure2_with(0.7), until};
    result.scene.beta = beta;
    cases.push_back(result);
  };
  figure2("0", 0.0, 60.0);
  figure2("1e-8", 1e-8, 60.0);
  figure2("0.1", 0.1, 60.0);
  const double golden =
      (1.0 + std::sqrt(5.0)) / 2.0;  // sqrt(lambda_2); sqrt(lambda_1) = 1 / golden
  figure2("critical in mode 2", 2.0 / golden, 60.0);
  figure2("critical in mode 1", 2.0 * golden, 60.0);
  figure2("10", 10.0, 60.0);
  // So damped a chain creeps: 1e-4 in a period. The stops are as near.
  figure2("1e4", 1e4, 60.0);
  cases.back().scene.stops = {{1, Side::lower, -1e-5}, {2, Side::upper, 1e-5}};
  cases.push_back({"one mass: critical", "damping", one_mass(2.0, 0.5, 0.28, 0.7, 0.1), 60.0});
}

// Stiffnesses and masses of the two links and masses, apart by 1e6 either way.
inline void add_stiffness(std::vector<Case> &cases) {
  const auto add = [&](const std::string &what, std::vector<double> mass,
                       std::vector<double> stiffness, double beta, double until, double slowest) {
    Case result{what, "stiffness", figure2_with(0.7), until};
    result.scene.mass = std::move(mass);
    result.scene.stiffness = std::move(stiffness);
    result.scene.beta = beta;
    result.slowest_impact = slowest;
    cases.push_back(result);
  };
  add("k2/k1 = 1e6", {1, 1}, {1, 1e6}, 0.1, 40.0, 1e-20);
  add("k2/k1 = 1e-6", {1, 1}, {1, 1e-6}, 0.1, 60.0, 1e-20);
  cases.back().scene.amplitude = {0.5, 0.5};
  add("k1 = 1e6 k2", {1, 1}, {1e6, 1}, 0.1, 40.0, 1e-20);
  cases.back().scene.amplitude = {0.5, 0.5};
  cases.back().scene.stops[0].position = -3e-7;
  add("m2/m1 = 1e6", {1, 1e6}, {1, 1}, 0.1, 60.0, 1e-22);
  cases.back().scene.velocity = {0.0, 0.01};
  add("m2/m1 = 1e-6", {1, 1e-6}, {1, 1}, 0.1, 40.0, 1e-19);
  add("k2/k1 = 1e6: undamped", {1, 1}, {1, 1e6}, 0.0, 6.0, 1e-20);
  add("m2/m1 = 1e-6: undamped", {1, 1e-6}, {1, 1}, 0.0, 6.0, 1e-19);
}

// Forcing frequencies, and undamped modes driven at their own frequency.
inline void add_frequency(std::vector<Case> &cases) {
  // Held from the start until cos(Omega t) = 0.6, back on the stop most of a period later.
  cases.push_back({"Omega = 1e-4", "frequency", one_mass(0.1, 0.5, 1e-4, 0.7, 0.3, 0.3), 6.3e4});
  Case slow{"Omega = 1e-4: Figure 2", "frequency", figure2_with(0.7), 200.0};
  slow.scene.omega = 1e-4;
  cases.push_back(slow);
  Case fast{"Omega = 1e3", "frequency", figure2_with(0.7), 8.0};
  fast.scene.omega = 1e3;
  fast.scene.displacement = {1.0, -1.0};
  cases.push_back(fast);
  Case constant{"Omega = 0", "frequency", figure2_with(0.7), 60.0};
  constant.scene.omega = 0.0;
  cases.push_back(constant);
  cases.push_back({"resonance: one mass", "frequency", one_mass(0.0, 0.5, 1.0, 0.7, 2.0), 60.0});
  for (const int mode : {1, 2}) {
    Case resonance{fmt::format("resonance of mode {}", mode), "frequency", figure2_with(0.7), 60.0};
    resonance.scene.beta = 0.0;
    resonance.scene.omega = (std::sqrt(5.0) + (mode == 1 ? -1.0 : 1.0)) / 2.0;
    cases.push_back(resonance);
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
  Case moving{"A = 0: moving", "amplitude", figure2_with(0.7), 60.0};
  moving.scene.amplitude = {0.0, 0.0};
  moving.scene.velocity = {-1.0, 1.0};
  cases.push_back(moving);
  Case tiny{"A = 1e-9", "amplitude", figure2_with(0.7), 60.0};
  tiny.scene.amplitude = {1e-9, 0.0};
  tiny.scene.stops = {{1, Side::lower, -6e-10}, {2, Side::upper, 2e-10}};
  tiny.slowest_impact = 1e-27;
  cases.push_back(tiny);
  tiny.name = "A = 1e-9: stop at 0";
  tiny.scene.stops = {{1, Side::lower, 0.0}, {2, Side::upper, 0.0}};
  cases.push_back(tiny);
  Case huge{"A = 1e6", "amplitude", figure2_with(0.7), 60.0};
  huge.scene.amplitude = {1e6, 0.0};
  huge.slowest_impact = 1e-16;
  cases.push_back(huge);
}

inline void add_masses(std::vector<Case> &cases) {
  cases.push_back({"N = 1", "masses", one_mass(0.1, 0.5, 0.28, 0.7, 0.1), 60.0});
  cases.push_back({"N = 2", "masses", figure2_with(0.7), 60.0});
  for (const auto &[n, until] : {std::pair{3, 50.0}, {10, 40.0}, {50, 12.0}, {200, 9.0}})
    cases.push_back({fmt::format("N = {}", n), "masses", long_chain(n, 0.7), until});
}

inline void add_gaps(std::vector<Case> &cases) {
  for (const double gap : {0.0, 1e-14, 1e-6}) {
    Case result{fmt::format("gaps of {:g}", gap), "gaps", figure2_with(0.7), 60.0};
    result.scene.stops = {{1, Side::lower, -gap}, {2, Side::upper, gap}};
    cases.push_back(result);
  }
  Case across{"stops across the origin", "gaps", figure2_with(0.7), 60.0};
  across.scene.stops = {{1, Side::lower, 0.25}, {2, Side::upper, -0.1}};
  across.scene.displacement = {0.25 + 1e-14, -0.1 - 1e-14};
  cases.push_back(across);
  Case narrow{"clearance of 1e-9: forced", "gaps", figure2_with(0.7), 60.0};
  narrow.scene.stops = {{1, Side::lower, -5e-10}, {1, Side::upper, 5e-10}, {2, Side::upper, 0.1}};
  cases.push_back(narrow);
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
  cases.push_back({"on the stop: pulled", "starts", started(-0.3, 0.0, 0.0, 0.0), 60.0});
  cases.push_back({"on both stops: pulled", "starts", started(-0.3, 0.0, 0.1, 0.0), 60.0});
  cases.push_back({"on the stop: moving away", "starts", started(-0.3, 0.5, 0.0, 0.0), 60.0});
  cases.push_back({"on the stop: moving in", "starts", started(-0.3, -0.5, 0.0, 0.0), 60.0});
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
  cases.push_back(
      {"force zero: about to pull", "starts", one_mass(0.1, 0.5, 0.28, 0.7, 0.5, 0.5), 60.0});
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
  cases.push_back({"two stick and part at once", "simultaneous",
                   in_step(0.1, 0.5, 0.28, 0.7, 0.25, 0.0), 60.0});
  cases.push_back(
      {"the same: r = 0", "simultaneous", in_step(0.1, 0.5, 0.28, 0.0, 0.25, 0.0), 60.0});
  cases.push_back(
      {"both moving in at the start", "simultaneous", started(-0.3, -0.5, 0.1, 0.5), 60.0});
  cases.push_back({"the same: r = 0: pressed", "simultaneous", paper::figure5a(), 60.0});
  Scene &pressed = cases.back().scene;
  pressed.restitution = 0.0;
  pressed.stops = {{1, Side::upper, 0.2}, {2, Side::upper, 0.1}};  // s2 < s1: both stay
  pressed.displacement = {0.2, 0.1};
  pressed.velocity = {0.5, 0.5};
}

inline void add_grazing(std::vector<Case> &cases) {
  constexpr double pi = std::numbers::pi, infinity = std::numeric_limits<double>::infinity();
  const auto add = [&](const std::string &what, double stop, Truth truth) {
    Case result{what, "grazing", one_mass(0.0, 0.0, 1.0, 0.7, stop, -1.0), 40.0, truth, {}};
    if (truth == Truth::grazing)
      result.events = [] { return touches(std::numbers::pi_v<Extended>, 40.0); };
    else if (stop < 1.0)
      result.events = [stop] { return bounces(-1.0, stop, 0.7, 40.0); };
    else
      result.events = [] { return std::vector<TrueEvent>{}; };
    cases.push_back(result);
  };
  static_cast<void>(pi);
  add("touching exactly", 1.0, Truth::grazing);
  add("one ulp apart", std::nextafter(1.0, infinity), Truth::grazing);
  add("one ulp deep", std::nextafter(1.0, 0.0), Truth::grazing);
  for (const double depth : {1e-12, 1e-6}) {
    add(fmt::format("{:g} apart", depth), 1.0 + depth, Truth::exact);
    add(fmt::format("{:g} deep", depth), 1.0 - depth, Truth::exact);
  }
  cases.push_back({"from the stop back to it", "grazing", one_mass(0.0, 0.0, 1.0, 0.7, 1.0, 1.0),
                   40.0, Truth::grazing,
                   [] { return touches(2.0L * std::numbers::pi_v<Extended>, 40.0); }});
}

inline void add_zero_force(std::vector<Case> &cases) {
  cases.push_back({"Figure 5(c)", "zero hold force", paper::figure5c(), 120.0});
  Case constant{"Figure 5(c): Omega = 0", "zero hold force", paper::figure5c(), 120.0};
  constant.scene.omega = 0.0;  // mass 1 stays
  cases.push_back(constant);
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
