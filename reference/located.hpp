// Parameters at which something happens exactly, located with 50 digits: the multi-sliding
// bifurcations, the grazing of Figure 5(b), and the scenes of Table I.
#pragma once

#include "event_driven.hpp"
#include "key_numbers.hpp"
#include "scenes.hpp"

#include <functional>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace vibro_impact_reference {

/// The zero of a function by plain bisection between two arguments of different sign of it.
inline Real zero_between(const std::function<Real(const Real &)> &f, const Real &a, const Real &b) {
  const bool positive = f(a) > 0;
  if (positive == (f(b) > 0)) throw std::logic_error("zero_between: no change of sign");
  return bisect([&](const Real &x) { return (f(x) > 0) == positive; }, a, b, small(36));
}

/// x as a polynomial in f through the given points (f, x), at f = 0.
inline Real inverse_interpolation(const std::vector<std::pair<Real, Real>> &points) {
  Real x = 0;
  for (const auto &point : points) {
    Real weight = 1;
    for (const auto &other : points)
      if (other.first != point.first) weight *= other.first / (other.first - point.first);
    x += weight * point.second;
  }
  return x;
}

/// The hold force on a mass of the Figure 2 scene where it comes closest to zero inside its
/// sticking phase, in the last two of `periods` forcing periods from rest. What is left of the
/// start is 0.16 to the number of periods.
inline Real closest_hold(std::size_t mass, const Real &frequency, int periods) {
  Scene scene = scene_named("figure2");
  scene.chain.frequency = frequency;
  const Real period = 2 * acos(Real(-1)) / frequency;
  scene.end_time = periods * period;
  std::optional<Real> closest;
  simulate(scene, [&](const Flow &flow, const Real &duration) {
    extend_closest_hold(closest, scene, mass, flow, duration, scene.end_time - 2 * period);
  });
  if (!closest) throw std::logic_error("closest_hold: no extremum inside a sticking phase");
  return *closest;
}

/// The frequency at which that force reaches zero: inverse interpolation through four frequencies
/// below it. The force is smooth there, but for the (square root of rounding of the) tangency
/// itself, which no point touches. Error: the product of the four distances times the fourth
/// derivative of the frequency by the force over 24, below 1e-15.
inline Real multi_sliding_frequency(std::size_t mass, const std::vector<Real> &below) {
  std::vector<std::pair<Real, Real>> points;
  for (const Real &frequency : below)
    points.push_back({closest_hold(mass, frequency, 22), frequency});
  return inverse_interpolation(points);
}

/// The largest displacement of mass 2 in the Figure 5(b) scene without the stop of mass 2, in the
/// last of `periods` periods from rest, above where that stop stood.
inline Real overshoot_of_mass_2(const Real &frequency, int periods) {
  Scene scene = scene_named("figure5b");
  const Real place = scene.stops.back().position;
  scene.stops.pop_back();
  scene.chain.frequency = frequency;
  const Real period = 2 * acos(Real(-1)) / frequency;
  scene.end_time = periods * period;
  Extremes extremes;
  simulate(scene, [&](const Flow &flow, const Real &duration) {
    extend_extremes(extremes, flow, duration, scene.end_time - period, scene.end_time);
  });
  return extremes.highest[1] - place;
}

/// The two-mass chain of the paper from rest, without stops, as one flow.
inline Flow free_flow(const Real &frequency) {
  const Scene scene = scene_named("figure2");
  Chain chain = scene.chain;
  chain.frequency = frequency;
  Eigensystems known;
  return flow_from(chain, Real(0), Vector(2), Vector(2), {false, false}, known);
}

/// The scenes of Table I that are solved for: the same conditions and brackets as in
/// figures/table1_scenes.hpp, on the closed form of the motion before the event.
inline std::vector<KeyNumber> table1_numbers() {
  std::vector<KeyNumber> rows;
  const auto add = [&](const char *symbol, const Real &value, const char *meaning) {
    rows.push_back({symbol, value.str(20), "computed", "Table I", meaning});
  };
  const auto turning = [](const Flow &flow, std::size_t mass, double from, double to) {
    return zero_between([&](const Real &t) { return motion_at(flow, t).v[mass]; }, Real(from),
                        Real(to));
  };
  {
    const auto other_speed = [&](const Real &frequency) {
      const Flow flow = free_flow(frequency);
      return motion_at(flow, turning(flow, 0, 6, 12)).v[1];
    };
    const Real frequency = zero_between(other_speed, Real(0.3), Real(0.5));
    const Flow flow = free_flow(frequency);
    const Real time = turning(flow, 0, 6, 12);
    const Motion motion = motion_at(flow, time);
    add("DG_Omega", frequency, "dual grazing: frequency at which both first minima coincide");
    add("DG_time", time, "dual grazing: time of the minima");
    add("DG_s1", motion.x[0], "dual grazing: lowest x1, where its stop stands");
    add("DG_s2", motion.x[1], "dual grazing: lowest x2, where its stop stands");
  }
  {
    const Flow flow = free_flow(Real(0.1769));
    const Real time = zero_between(
        [&](const Real &t) { return motion_at(flow, t).x[0] - Real(0.5); }, Real(1), Real(3));
    add("DI_time", time, "double impact: x1 = 0.5 for the first time");
    add("DI_s2", motion_at(flow, time).x[1], "double impact: x2 then, where its stop stands");
  }
  {
    const Flow flow = free_flow(Real(0.5));
    const Real time = turning(flow, 0, 1, 3);
    add("GI_time", time, "grazing-impact: first maximum of x1");
    add("GI_s1", motion_at(flow, time).x[0], "grazing-impact: x1 then, where its stop stands");
    add("GI_s2", motion_at(flow, time).x[1], "grazing-impact: x2 then, where its stop stands");
  }
  {
    Scene scene = scene_named("figure5b");
    scene.stops.pop_back();
    scene.initial_positions = {Real(0.3), Real(0.17)};
    scene.initial_velocities = {Real(0), Real(-0.003)};
    scene.end_time = Real(19);
    std::optional<Real> time, place;
    simulate(scene, [&](const Flow &flow, const Real &duration) {
      if (flow.start_time + duration < Real(18.5)) return;
      time = flow.start_time + turning(flow, 1, 17.0 - static_cast<double>(flow.start_time),
                                       19.0 - static_cast<double>(flow.start_time));
      place = motion_at(flow, *time - flow.start_time).x[1];
    });
    add("GS_time", *time, "grazing-sticking: maximum of x2 while mass 1 sticks");
    add("GS_s2", *place, "grazing-sticking: x2 then, where its stop stands");
  }
  {
    Scene scene = scene_named("figure5a");
    scene.stops[1].position = Real(0.25);
    scene.end_time = Real(44);
    const auto events = simulate(scene);
    const Real from = first(events, Event::Kind::stick, 1, Real(30), Real(44)).time;
    add("DS_from", from, "dual sticking: mass 2 sticks while mass 1 does");
    add("DS_to", first(events, Event::Kind::release, 0, from, Real(44)).time,
        "dual sticking: mass 1 is let go");
  }
  {
    const auto events = simulate(scene_named("figure5a"));
    const Real stick = first(events, Event::Kind::stick, 0, Real(950), Real(964)).time;
    const Event &hit = first(events, Event::Kind::impact, 1, stick, Real(964));
    add("SI_time", hit.time, "sticking-impact: first impact of mass 2 after mass 1 has stuck");
    add("SI_speed", hit.velocity_before, "sticking-impact: speed of that impact");
  }
  return rows;
}

/// The table located.csv.
inline std::string located_table() {
  std::vector<KeyNumber> rows;
  const auto add = [&](const char *symbol, const Real &value, const char *meaning) {
    rows.push_back({symbol, value.str(20), "computed", "scene of Figure 2 or 5(b)", meaning});
  };
  add("multi_sliding_mass_1",
      multi_sliding_frequency(
          0, {Real("0.255994"), Real("0.256"), Real("0.256004"), Real("0.256006")}),
      "Omega at which the hold force on mass 1 touches zero inside its sticking phase");
  add("multi_sliding_mass_2",
      multi_sliding_frequency(
          1, {Real("0.268088"), Real("0.268092"), Real("0.268094"), Real("0.2680955")}),
      "Omega at which the hold force on mass 2 touches zero inside its sticking phase");
  std::vector<std::pair<Real, Real>> touches;
  for (const char *frequency : {"0.29950", "0.29951", "0.29952", "0.29953"})
    touches.push_back({overshoot_of_mass_2(Real(frequency), 40), Real(frequency)});
  add("grazing_mass_2_figure5b", inverse_interpolation(touches),
      "Omega at which mass 2 touches its stop in the motion without impacts of it");
  for (const KeyNumber &row : table1_numbers()) rows.push_back(row);
  return table_of(rows);
}

}  // namespace vibro_impact_reference
