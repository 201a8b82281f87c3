// The paper's key numbers, from formulas and from runs. What each means stands in the table,
// key_numbers.csv.
#pragma once

#include "event_driven.hpp"
#include "filled_table.hpp"
#include "frequencies.hpp"
#include "in_digits.hpp"
#include "turning_points.hpp"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <stdexcept>
#include <string>

namespace vibro_impact_reference {

using Kind = Event::Kind;

/// Masses 1 and 2 of the paper.
constexpr std::size_t mass_1 = 0, mass_2 = 1;

/// How far, and how exactly, a chatter is followed for a key number.
inline Resolution key_number_resolution() {
  return {Real("1e-20"), {Real("1e-36"), true}};
}

inline Run run_of(const Scene &scene) {
  return simulate(scene, key_number_resolution());
}

/// Events of a kind in [from, to], of one mass if one is given.
inline std::size_t count(const Run &run, Kind kind, std::optional<std::size_t> mass = {},
                         const Real &from = Real(0), const Real &to = Real("1e9")) {
  return static_cast<std::size_t>(
      std::count_if(run.events.begin(), run.events.end(), [&](const Event &e) {
        return e.kind == kind && (!mass || e.mass == *mass) && e.time >= from && e.time <= to;
      }));
}

/// How often a mass comes to rest while the other one sticks.
inline std::size_t dual_sticks(const Run &run) {
  return static_cast<std::size_t>(std::count_if(
      run.events.begin(), run.events.end(),
      [](const Event &e) { return e.kind == Kind::stick && e.stuck[mass_1] && e.stuck[mass_2]; }));
}

/// First event of a kind on a mass in [from, to]. Throws std::logic_error if there is none.
inline const Event &first(const Run &run, Kind kind, std::size_t mass, const Real &from,
                          const Real &to) {
  for (const Event &e : run.events) {
    if (e.kind == kind && e.mass == mass && e.time >= from && e.time <= to) return e;
  }
  throw std::logic_error("key numbers: an expected event is missing");
}

inline void add(Numbers &numbers, const std::string &symbol, const Real &value) {
  numbers[symbol] = value.str(30);
}
inline void add_count(Numbers &numbers, const std::string &symbol, std::size_t value) {
  numbers[symbol] = std::to_string(value);
}

/// Of two masses with m = k = 1: the eigenvalues and modes of E, and the line x1' = (k/c)(s2 - x1)
/// of Eq. 23. Mass 2 of Figure 5(c) bounces about its equilibrium at the stop, with the damping
/// ratio zeta = c/(2 sqrt(k m)), at half periods of its damped motion.
inline void add_formulas(Numbers &numbers) {
  const Real root5 = sqrt(Real(5)), zeta = Real("0.05");
  add(numbers, "lambda1", (3 - root5) / 2);
  add(numbers, "lambda2", (3 + root5) / 2);
  add(numbers, "xi1_mass1", sqrt((5 - root5) / 10));
  add(numbers, "xi1_mass2", sqrt((5 + root5) / 10));
  add(numbers, "xi2_mass1", -sqrt((5 + root5) / 10));
  add(numbers, "xi2_mass2", sqrt((5 - root5) / 10));
  add(numbers, "exit_slope", Real(-10));
  add(numbers, "exit_intercept", Real(1));
  add(numbers, "figure5c_bounce_interval", acos(Real(-1)) / sqrt(1 - zeta * zeta));
}

inline void add_figure2(Numbers &numbers) {
  const Scene scene = scene_named("figure2");
  const Run run = run_of(scene);
  const Extremes shown = extremes(run, Real(700), Real(750));
  const Real from(715), to(722);  // Figure 2(b)
  add(numbers, "figure2_x1_max", shown.highest[mass_1]);
  add(numbers, "figure2_x2_min", shown.lowest[mass_2]);
  add(numbers, "figure2b_x2_min", extremes(run, from, to).lowest[mass_2]);
  add(numbers, "figure2b_chatter_start", first(run, Kind::impact, mass_2, from, to).time);
  add(numbers, "figure2b_chatter_end",
      completion(scene, first(run, Kind::stick, mass_2, from, scene.end_time)));
  add_count(numbers, "figure2_sticks", count(run, Kind::stick));
  add_count(numbers, "figure2_releases", count(run, Kind::release));
}

inline std::size_t sticks_in_last_ten_periods(const Scene &scene, const Run &run) {
  const Real ten_periods = 20 * acos(Real(-1)) / scene.chain.frequency;
  return count(run, Kind::stick, mass_1, scene.end_time - ten_periods);
}

inline void add_figures_3_and_4(Numbers &numbers) {
  const Scene figure3 = in_digits(vibro_impact::paper::figure3(0.65), 750),
              figure4a = scene_named("figure4a"), figure4b = scene_named("figure4b");
  const Run run3 = run_of(figure3), run4a = run_of(figure4a), run4b = run_of(figure4b);
  add_count(numbers, "figure3_sticks_of_mass_1_at_0_65", sticks_in_last_ten_periods(figure3, run3));
  add_count(numbers, "figure4a_sticks_of_mass_1", sticks_in_last_ten_periods(figure4a, run4a));
  add_count(numbers, "figure4b_sticks_of_mass_1", sticks_in_last_ten_periods(figure4b, run4b));
  const Real two_periods = 4 * acos(Real(-1)) / figure4a.chain.frequency;
  add(numbers, "figure4a_hold_force_peak",
      side_sign(figure4a.stops[mass_1]) *
          least_pressing(figure4a, run4a, mass_1, figure4a.end_time - two_periods));
  for (const auto &change : vibro_impact::paper::sticking_changes())
    numbers[change.symbol] = changing_frequency(change).str(18);
  const auto beyond = vibro_impact::paper::border_beyond_the_jump();
  numbers[beyond.symbol] = changing_frequency(beyond).str(18);
}

inline void add_figure5(Numbers &numbers) {
  const Scene a = scene_named("figure5a"), b = scene_named("figure5b"), c = scene_named("figure5c"),
              reduced = in_digits(vibro_impact::paper::figure5c_reduced(), 1000);
  const Run run_a = run_of(a), run_b = run_of(b), run_c = run_of(c);
  const Real stick = completion(a, first(run_a, Kind::stick, mass_1, Real(950), Real(964)));
  add(numbers, "figure5a_stick_time", stick);
  const Real end_of_stick = first(run_a, Kind::release, mass_1, stick, Real(964)).time;
  add(numbers, "figure5a_release_time", end_of_stick);
  add(numbers, "figure5a_first_impact_while_stuck",
      first(run_a, Kind::impact, mass_2, stick, end_of_stick).time);
  add_count(numbers, "figure5a_impacts_while_stuck",
            count(run_a, Kind::impact, mass_2, stick, end_of_stick));
  const Extremes while_stuck = extremes(run_b, Real(916), Real(930), mass_1);
  add(numbers, "figure5b_nearest_time", while_stuck.highest_at[mass_2]);
  add(numbers, "figure5b_nearest_gap", b.stops[mass_2].position - while_stuck.highest[mass_2]);
  add(numbers, "figure5b_x2_min", extremes(run_b, Real(916), Real(930)).lowest[mass_2]);
  add_count(numbers, "figure5b_dual_sticks", dual_sticks(run_b));
  numbers["grazing_mass_2_figure5b"] = grazing_frequency().str(18);
  const Real release = first(run_c, Kind::release, mass_1, Real(900), Real(1000)).time;
  add(numbers, "figure5c_release_time", release);
  add_count(numbers, "figure5c_impacts_before_release",
            count(run_c, Kind::impact, mass_2, release - 10, release));
  add_count(numbers, "figure5c_dual_sticks", dual_sticks(run_of(reduced)));
}

inline Numbers key_numbers() {
  Numbers numbers;
  add_formulas(numbers);
  add_figure2(numbers);
  add_figures_3_and_4(numbers);
  add_figure5(numbers);
  return numbers;
}

}  // namespace vibro_impact_reference
