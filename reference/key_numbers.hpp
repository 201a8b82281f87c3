// The paper's key numbers, those that are derived (from a formula) and computed (by this
// generator). What each means, and the numbers that are printed or reconstructed, stands in the
// table, key_numbers.csv.
#pragma once

#include "event_driven.hpp"
#include "extremes_of_motion.hpp"
#include "filled_table.hpp"
#include "scenes.hpp"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace vibro_impact_reference {

inline std::size_t count(const Run &run, Event::Kind kind, std::optional<std::size_t> mass = {},
                         const Real &from = Real(0), const Real &to = Real("1e9")) {
  return static_cast<std::size_t>(
      std::count_if(run.events.begin(), run.events.end(), [&](const Event &e) {
        return e.kind == kind && (!mass || e.mass == *mass) && e.time >= from && e.time <= to;
      }));
}

/// How often a mass comes to rest while the other one is held.
inline std::size_t dual_sticks(const Run &run) {
  return static_cast<std::size_t>(std::count_if(
      run.events.begin(), run.events.end(),
      [](const Event &e) { return e.kind == Event::Kind::stick && e.stuck[0] && e.stuck[1]; }));
}

/// First event of a kind on a mass in [from, to]; throws std::logic_error if there is none.
inline const Event &first(const Run &run, Event::Kind kind, std::size_t mass, const Real &from,
                          const Real &to) {
  for (const Event &e : run.events) {
    if (e.kind == kind && e.mass == mass && e.time >= from && e.time <= to) return e;
  }
  throw std::logic_error("key numbers: an expected event is missing");
}

/// Runs all six scenes.
inline Numbers key_numbers() {
  using Kind = Event::Kind;
  const std::size_t mass_1 = 0;
  const std::size_t mass_2 = 1;
  const Real root5 = sqrt(Real(5));
  const Real pi = acos(Real(-1));
  const Real zeta = Real("0.05");  // of Figure 5(c): c/(2 sqrt(k m))
  Numbers numbers;
  const auto add = [&](const std::string &symbol, const Real &value) {
    numbers[symbol] = {value.str(30)};
  };
  const auto add_count = [&](const std::string &symbol, std::size_t value) {
    numbers[symbol] = {std::to_string(value)};
  };
  add("lambda1", (3 - root5) / 2);
  add("lambda2", (3 + root5) / 2);
  add("xi1_mass1", sqrt((5 - root5) / 10));
  add("xi1_mass2", sqrt((5 + root5) / 10));
  add("xi2_mass1", -sqrt((5 + root5) / 10));
  add("xi2_mass2", sqrt((5 - root5) / 10));
  add("exit_slope", Real(-10));
  add("exit_intercept", Real(1));
  add("figure5c_bounce_interval", pi / sqrt(1 - zeta * zeta));
  add("figure5c_bounce_ratio", Real("0.7") * exp(-pi * zeta / sqrt(1 - zeta * zeta)));

  const Resolution resolution{Real("1e-20"), {small(36), true}};
  {
    const Scene scene = scene_named("figure2");
    const Run run = simulate(scene, resolution);
    const Extremes shown = extremes(run, Real(700), Real(750));
    add("figure2_x1_min", shown.lowest[mass_1]);
    add("figure2_x1_max", shown.highest[mass_1]);
    add("figure2_x2_min", shown.lowest[mass_2]);
    add("figure2_x2_max", shown.highest[mass_2]);
    add("figure2b_x2_min", extremes(run, Real(715), Real(722)).lowest[mass_2]);
    add("figure2b_chatter_start", first(run, Kind::impact, mass_2, Real(715), Real(722)).time);
    add("figure2b_chatter_end",
        completion(scene, first(run, Kind::stick, mass_2, Real(715), Real(722))));
    add_count("figure2_impacts", count(run, Kind::impact));
    add_count("figure2_sticks", count(run, Kind::stick));
    add_count("figure2_releases", count(run, Kind::release));
  }
  {
    const Scene scene = in_digits(vibro_impact::paper::figure3(0.65), 750);
    const Real ten_periods = 20 * pi / scene.chain.frequency;
    add_count("figure3_sticks_of_mass_1_at_0_65", count(simulate(scene, resolution), Kind::stick,
                                                        mass_1, scene.end_time - ten_periods));
  }
  for (const std::string name : {"figure4a", "figure4b"}) {
    const Scene scene = scene_named(name);
    const Real period = 2 * pi / scene.chain.frequency;
    const Run run = simulate(scene, resolution);
    add_count(name + "_sticks_of_mass_1",
              count(run, Kind::stick, mass_1, scene.end_time - 10 * period));
    if (name == "figure4a")
      add("figure4a_hold_force_peak",
          side_sign(scene.stops[mass_1]) *
              least_pressing(scene, run, mass_1, scene.end_time - 2 * period));
  }
  {
    const Scene scene = scene_named("figure5a");
    const Run run = simulate(scene, resolution);
    const Real stick = completion(scene, first(run, Kind::stick, mass_1, Real(950), Real(964)));
    add("figure5a_stick_time", stick);
    add_count("figure5a_impacts_while_stuck", count(run, Kind::impact, mass_2, stick, Real(964)));
  }
  {
    const Scene scene = scene_named("figure5b");
    const Run run = simulate(scene, resolution);
    const Extremes while_stuck = extremes(run, Real(916), Real(930), mass_1);
    add("figure5b_stick_time",
        completion(scene, first(run, Kind::stick, mass_1, Real(916), Real(930))));
    add("figure5b_nearest_time", while_stuck.highest_at[mass_2]);
    add("figure5b_nearest_gap", scene.stops[mass_2].position - while_stuck.highest[mass_2]);
    add("figure5b_x2_min", extremes(run, Real(916), Real(930)).lowest[mass_2]);
    add_count("figure5b_impacts_of_mass_2", count(run, Kind::impact, mass_2, Real(916), Real(930)));
    add_count("figure5b_dual_sticks", dual_sticks(run));
  }
  {
    const Run run = simulate(scene_named("figure5c"), resolution);
    const Event &release = first(run, Kind::release, mass_1, Real(900), Real(1000));
    std::vector<Event> bounces;
    for (const Event &e : run.events) {
      if (e.kind == Kind::impact && e.mass == mass_2 && e.time < release.time) bounces.push_back(e);
    }
    const Event &last = bounces[bounces.size() - 1];
    const Event &previous = bounces[bounces.size() - 2];
    add("figure5c_release_time", release.time);
    add("figure5c_bounce_interval_computed", last.time - previous.time);
    add("figure5c_bounce_ratio_computed", last.velocity_before / previous.velocity_before);
    add("figure5c_last_bounce_speed", last.velocity_before);
  }
  const Scene reduced = in_digits(vibro_impact::paper::figure5c_reduced(), 1000);
  add_count("figure5c_dual_sticks", dual_sticks(simulate(reduced, resolution)));
  return numbers;
}

}  // namespace vibro_impact_reference
