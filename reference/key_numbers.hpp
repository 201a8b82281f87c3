// The paper's key numbers in one table, each with its kind: printed (in the paper), derived (from a
// formula), reconstructed (missing in the paper's text, inferred from it and from its figures),
// computed (by this generator). The printed and the reconstructed ones are the table stated.csv.
#pragma once

#include "completion.hpp"
#include "event_driven.hpp"
#include "extremes_of_motion.hpp"
#include "scenes.hpp"

#include <algorithm>
#include <cstddef>
#include <fstream>
#include <iterator>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace vibro_impact_reference {

struct KeyNumber {
  std::string symbol, value, kind, source, meaning;
};

/// A field of a table.
inline std::string quoted(const std::string &field) {
  return field.find(',') == std::string::npos ? field : '"' + field + '"';
}

inline std::size_t count(const std::vector<Event> &events, Event::Kind kind,
                         std::optional<std::size_t> mass = {}, const Real &from = Real(0),
                         const Real &to = Real("1e9")) {
  return static_cast<std::size_t>(std::count_if(events.begin(), events.end(), [&](const Event &e) {
    return e.kind == kind && (!mass || e.mass == *mass) && e.time >= from && e.time <= to;
  }));
}

/// How often a mass comes to rest while the other one is held.
inline std::size_t dual_sticks(const std::vector<Event> &events) {
  return static_cast<std::size_t>(std::count_if(events.begin(), events.end(), [](const Event &e) {
    return e.kind == Event::Kind::stick && e.stuck[0] && e.stuck[1];
  }));
}

/// First event of a kind on a mass in [from, to]; throws std::logic_error if there is none.
inline const Event &first(const std::vector<Event> &events, Event::Kind kind, std::size_t mass,
                          const Real &from, const Real &to) {
  for (const Event &e : events) {
    if (e.kind == kind && e.mass == mass && e.time >= from && e.time <= to) return e;
  }
  throw std::logic_error("key numbers: an expected event is missing");
}

/// What follows from a formula.
inline std::vector<KeyNumber> derived_numbers() {
  const Real root5 = sqrt(Real(5));
  const Real pi = acos(Real(-1));
  const Real zeta = Real("0.05");
  const auto row = [](const char *symbol, const Real &value, const char *source,
                      const char *meaning) {
    return KeyNumber{symbol, value.str(30), "derived", source, meaning};
  };
  return {
      row("lambda1", (3 - root5) / 2, "(3 - sqrt 5)/2", "smaller eigenvalue of E for two masses"),
      row("lambda2", (3 + root5) / 2, "(3 + sqrt 5)/2", "larger eigenvalue of E for two masses"),
      row("xi1_mass1", sqrt((5 - root5) / 10), "sqrt((5 - sqrt 5)/10)",
          "first eigenvector, entry of mass 1"),
      row("xi1_mass2", sqrt((5 + root5) / 10), "sqrt((5 + sqrt 5)/10)",
          "first eigenvector, entry of mass 2"),
      row("xi2_mass1", -sqrt((5 + root5) / 10), "-sqrt((5 + sqrt 5)/10)",
          "second eigenvector, entry of mass 1"),
      row("xi2_mass2", sqrt((5 - root5) / 10), "sqrt((5 - sqrt 5)/10)",
          "second eigenvector, entry of mass 2"),
      row("exit_slope", Real(-10), "-k/c from Eq. 23",
          "slope of the exit boundary of mass 2's sticking region"),
      row("exit_intercept", Real(1), "(k/c) s2 from Eq. 23",
          "x1' of that exit boundary at x1 = 0, with s2 = 0.1"),
      row("figure5c_bounce_interval", pi / sqrt(1 - zeta * zeta),
          "pi/omega_d with zeta = c/(2 sqrt(k m)) = 0.05",
          "time between bounces of mass 2 about its equilibrium at the stop, while mass 1 is "
          "stuck"),
      row("figure5c_bounce_ratio", Real("0.7") * exp(-pi * zeta / sqrt(1 - zeta * zeta)),
          "r exp(-zeta pi/sqrt(1 - zeta^2))",
          "ratio of the impact speeds of consecutive such bounces"),
  };
}

/// What the generator finds; runs all six scenes.
inline std::vector<KeyNumber> computed_numbers() {
  using Kind = Event::Kind;
  const std::size_t mass_1 = 0;
  const std::size_t mass_2 = 1;
  std::vector<KeyNumber> rows;
  const auto add = [&](const std::string &symbol, const Real &value, const char *source,
                       const char *meaning) {
    rows.push_back({symbol, value.str(30), "computed", source, meaning});
  };
  const auto add_count = [&](const std::string &symbol, std::size_t value, const char *source,
                             const char *meaning) {
    rows.push_back({symbol, std::to_string(value), "computed", source, meaning});
  };

  const Resolution resolution = resolution_down_to(Real("1e-20"), small(36));
  {
    const Scene figure2 = scene_named("figure2");
    Extremes extremes, close_up;
    Completion completion{figure2, mass_2, Real(715)};
    const auto observe = [&](const Flow &flow, const Real &duration) {
      extend_extremes(extremes, flow, duration, Real(700), Real(750));
      extend_extremes(close_up, flow, duration, Real(715), Real(722));
      completion.observe(flow);
    };
    const auto events = simulate(figure2, observe, resolution);
    const char *scene = "scene figure2";
    add("figure2_x1_min", extremes.lowest[0], scene,
        "smallest x1 for t in 700-750 (the stop of mass 1)");
    add("figure2_x1_max", extremes.highest[0], scene, "largest x1 for t in 700-750");
    add("figure2_x2_min", extremes.lowest[1], scene, "smallest x2 for t in 700-750");
    add("figure2_x2_max", extremes.highest[1], scene,
        "largest x2 for t in 700-750 (the stop of mass 2)");
    add("figure2b_x2_min", close_up.lowest[1], scene, "smallest x2 for t in 715-722");
    add("figure2b_chatter_start", first(events, Kind::impact, mass_2, Real(715), Real(722)).time,
        scene, "first impact of mass 2 in Figure 2(b)");
    add_count("figure2_impacts", count(events, Kind::impact), scene,
              "impacts to t = 750 down to speeds of 1e-20 (depends on that floor)");
    add_count("figure2_sticks", count(events, Kind::stick), scene,
              "sticks to t = 750, both masses");
    add_count("figure2_releases", count(events, Kind::release), scene,
              "releases to t = 750, both masses");
    add("figure2b_chatter_end",
        completion.of(first(events, Kind::stick, mass_2, Real(715), Real(722))), scene,
        "the chatter of mass 2 in Figure 2(b) is complete and it sticks");
  }
  {
    const Scene scene = in_digits("figure3 at 0.65", vibro_impact::paper::figure3(0.65), 750);
    const Real ten_periods = 20 * acos(Real(-1)) / scene.chain.frequency;
    add_count(
        "figure3_sticks_of_mass_1_at_0_65",
        count(simulate(scene, {}, resolution), Kind::stick, mass_1, scene.end_time - ten_periods),
        "scene figure3", "sticks of mass 1 in the last ten forcing periods before t = 750");
  }
  for (const std::string name : {"figure4a", "figure4b"}) {
    const Scene scene = scene_named(name);
    const Real period = 2 * acos(Real(-1)) / scene.chain.frequency;
    std::optional<Real> closest;
    const auto observe = [&](const Flow &flow, const Real &duration) {
      extend_closest_hold(closest, scene, mass_1, flow, duration, scene.end_time - 2 * period);
    };
    const auto events = simulate(scene, observe, resolution);
    const char *source = name == "figure4a" ? "scene figure4a" : "scene figure4b";
    add_count(name + "_sticks_of_mass_1",
              count(events, Kind::stick, mass_1, scene.end_time - 10 * period), source,
              "sticks of mass 1 in the last ten forcing periods before t = 750");
    if (closest && name == "figure4a") {
      add("figure4a_hold_force_peak", *closest, source,
          "hold force on mass 1 where it comes closest to zero inside its sticking phase, last two "
          "periods");
    }
  }
  {
    const Scene figure5a = scene_named("figure5a");
    Completion completion{figure5a, mass_1, Real(950)};
    const auto events = simulate(
        figure5a, [&](const Flow &flow, const Real &) { completion.observe(flow); }, resolution);
    const Real stick = completion.of(first(events, Kind::stick, mass_1, Real(950), Real(964)));
    add("figure5a_stick_time", stick, "scene figure5a",
        "the chatter of mass 1 in Figure 5(a) is complete");
    add_count("figure5a_impacts_while_stuck", count(events, Kind::impact, mass_2, stick, Real(964)),
              "scene figure5a", "impacts of mass 2 from then to t = 964, mass 1 being stuck (SI)");
  }
  {
    const Scene scene = scene_named("figure5b");
    Extremes extremes, while_stuck;
    Completion completion{scene, mass_1, Real(916)};
    const auto observe = [&](const Flow &flow, const Real &duration) {
      completion.observe(flow);
      extend_extremes(extremes, flow, duration, Real(916), Real(930));
      if (std::find(flow.free.begin(), flow.free.end(), mass_1) == flow.free.end())
        extend_extremes(while_stuck, flow, duration, Real(916), Real(930));
    };
    const auto events = simulate(scene, observe, resolution);
    add("figure5b_stick_time",
        completion.of(first(events, Kind::stick, mass_1, Real(916), Real(930))), "scene figure5b",
        "the short chatter of mass 1 in Figure 5(b) is complete");
    add("figure5b_nearest_time", while_stuck.highest_at[mass_2], "scene figure5b",
        "mass 2 is nearest its stop, mass 1 being stuck (GS)");
    add("figure5b_nearest_gap", scene.stops[mass_2].position - while_stuck.highest[mass_2],
        "scene figure5b", "how far it is from its stop then");
    add("figure5b_x2_min", extremes.lowest[mass_2], "scene figure5b",
        "smallest x2 for t in 916-930");
    add_count("figure5b_impacts_of_mass_2",
              count(events, Kind::impact, mass_2, Real(916), Real(930)), "scene figure5b",
              "impacts of mass 2 for t in 916-930");
    add_count("figure5b_dual_sticks", dual_sticks(events), "scene figure5b",
              "times to t = 930 at which both masses stick");
  }
  {
    const auto events = simulate(scene_named("figure5c"), {}, resolution);
    const Event &release = first(events, Kind::release, mass_1, Real(900), Real(1000));
    add("figure5c_release_time", release.time, "scene figure5c", "mass 1 is let go in Figure 5(c)");
    std::vector<Event> bounces;
    for (const Event &e : events) {
      if (e.kind == Kind::impact && e.mass == mass_2 && e.time < release.time) bounces.push_back(e);
    }
    const Event &last = bounces[bounces.size() - 1];
    const Event &previous = bounces[bounces.size() - 2];
    add("figure5c_bounce_interval_computed", last.time - previous.time, "scene figure5c",
        "time between the last two bounces of mass 2 before that");
    add("figure5c_bounce_ratio_computed", last.velocity_before / previous.velocity_before,
        "scene figure5c", "ratio of their impact speeds");
    add("figure5c_last_bounce_speed", last.velocity_before, "scene figure5c",
        "speed of the last of them: mass 2 still bounces, it never sticks");
  }
  {
    const Scene scene = in_digits("reduced", vibro_impact::paper::figure5c_reduced(), 1000);
    add_count("figure5c_dual_sticks", dual_sticks(simulate(scene, {}, resolution)),
              "Figure 5(c) with Omega = 0.015 and r = 0.5",
              "times to t = 1000 at which both masses stick");
  }
  return rows;
}

/// The table key_numbers.csv: first the rows of stated.csv as they are.
inline std::string key_numbers_table() {
  const std::string path = REFERENCE_DIR "/stated.csv";
  std::ifstream file(path);
  if (!file) throw std::runtime_error("table '" + path + "': cannot be read");
  std::string table(std::istreambuf_iterator<char>(file), {});
  for (const auto &rows : {derived_numbers(), computed_numbers()})
    for (const KeyNumber &row : rows)
      table += row.symbol + ',' + row.value + ',' + row.kind + ',' + quoted(row.source) + ',' +
               quoted(row.meaning) + '\n';
  return table;
}

}  // namespace vibro_impact_reference
