// The paper's key numbers in one table, each with its kind: printed (in the paper), derived (from a
// formula), reconstructed (missing in the paper's text, inferred from it and from its figures),
// computed (by this generator).
#pragma once

#include "event_driven.hpp"
#include "scenes.hpp"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace vibro_impact_reference {

struct KeyNumber {
  std::string symbol, value, kind, source, meaning;
};

/// Smallest and largest position of each mass over [from, to], filled by an observer of simulate.
/// Extremes are at zeros of the velocity (sampled, then bisected) or where one piece of motion
/// meets the next.
struct Extremes {
  Vector lowest, highest;
};

inline void extend_extremes(Extremes &extremes, const Flow &flow, const Real &duration,
                            const Real &from, const Real &to) {
  const Real begin = std::max<Real>(Real(0), from - flow.start_time);
  const Real end = std::min<Real>(duration, to - flow.start_time);
  if (begin >= end) return;
  const auto include = [&](const Motion &motion) {
    if (extremes.lowest.empty()) extremes = {motion.x, motion.x};
    for (std::size_t p = 0; p < motion.x.size(); ++p) {
      extremes.lowest[p] = std::min<Real>(extremes.lowest[p], motion.x[p]);
      extremes.highest[p] = std::max<Real>(extremes.highest[p], motion.x[p]);
    }
  };
  const Real step = 2 * acos(Real(-1)) / fastest_rate_at(flow, Real(0)) / 128;
  Motion at_a = motion_at(flow, begin);
  include(at_a);
  for (Real a = begin; a < end;) {
    const Real b = std::min<Real>(a + step, end);
    const Motion at_b = motion_at(flow, b);
    include(at_b);
    for (const std::size_t p : flow.free) {
      const bool positive = at_a.v[p] > 0;
      if (positive == (at_b.v[p] > 0)) continue;
      const Real turn =
          bisect([&](const Real &tau) { return (motion_at(flow, tau).v[p] > 0) == positive; }, a, b,
                 Real("1e-36"));
      include(motion_at(flow, turn));
    }
    at_a = at_b;
    a = b;
  }
}

/// Largest interior local maximum of the hold force on a mass (towards letting go: of -|F|, with
/// the force's own sign for a lower stop) among the sticking phases that lie after `from`; none if
/// the force has no such maximum there.
inline void extend_closest_hold(std::optional<Real> &closest, const Scene &scene,
                                std::size_t stop_index, const Flow &flow, const Real &duration,
                                const Real &from) {
  const Stop &stop = scene.stops[stop_index];
  const bool free = std::find(flow.free.begin(), flow.free.end(), stop.mass) != flow.free.end();
  if (free || flow.start_time < from) return;
  const auto pressing = [&](const Real &tau) {
    return pressing_signal(scene.chain, stop, motion_at(flow, tau));
  };
  const Real step = 2 * acos(Real(-1)) / fastest_rate_at(flow, Real(0)) / 128;
  Signal at_a = pressing(Real(0));
  for (Real a = 0; a < duration;) {
    const Real b = std::min<Real>(a + step, duration);
    const Signal at_b = pressing(b);
    if (at_a.rate < 0 && at_b.rate > 0) {  // the pressing is least here
      const Real turn =
          bisect([&](const Real &tau) { return pressing(tau).rate < 0; }, a, b, Real("1e-36"));
      const Real force = side_sign(stop) * pressing(turn).value;
      if (!closest || abs(force) < abs(*closest)) closest = force;
    }
    at_a = at_b;
    a = b;
  }
}

inline std::size_t count(const std::vector<Event> &events, Event::Kind kind,
                         std::optional<std::size_t> mass = {}, const Real &from = Real(0),
                         const Real &to = Real("1e9")) {
  return static_cast<std::size_t>(std::count_if(events.begin(), events.end(), [&](const Event &e) {
    return e.kind == kind && (!mass || e.mass == *mass) && e.time >= from && e.time <= to;
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

/// What is printed in the paper or had to be reconstructed.
inline std::vector<KeyNumber> stated_numbers() {
  std::vector<KeyNumber> rows;
  const auto printed = [&](const char *symbol, const char *value, const char *source,
                           const char *meaning) {
    rows.push_back({symbol, value, "printed", source, meaning});
  };
  const auto reconstructed = [&](const char *symbol, const char *value, const char *source,
                                 const char *meaning) {
    rows.push_back({symbol, value, "reconstructed", source, meaning});
  };
  printed("lambda1_printed", "0.382", "section 3", "smaller eigenvalue of E for two masses");
  printed("lambda2_printed", "2.618", "section 3", "larger eigenvalue of E for two masses");
  printed("xi1_mass1_printed", "0.526", "section 3", "first eigenvector, entry of mass 1");
  printed("xi1_mass2_printed", "0.851", "section 3", "first eigenvector, entry of mass 2");
  printed("xi2_mass1_printed", "-0.851", "section 3", "second eigenvector, entry of mass 1");
  printed("xi2_mass2_printed", "0.526", "section 3", "second eigenvector, entry of mass 2");
  printed("exit_slope_printed", "-10", "section 3.2",
          "slope of the exit boundary of mass 2's sticking region, dx1'/dx1");
  printed("exit_intercept_printed", "1", "section 3.2",
          "x1' of that exit boundary at x1 = 0, with s2 = 0.1");
  printed("exit_point_x", "0.1", "section 3.2",
          "the exit boundary passes through (0.1, 0): x1 there");
  printed("m", "1", "section 3", "both masses");
  printed("k", "1", "section 3", "both stiffnesses");
  printed("c", "0.1", "section 3", "both viscous dampings");
  printed("r", "0.7", "section 3", "coefficient of restitution, all scenes but Figure 5(b)");
  printed("A1", "0.5", "section 3", "forcing amplitude on mass 1");
  printed("A2", "0", "section 3", "forcing amplitude on mass 2");
  printed("figure2_s1", "-0.3", "caption of Figure 2", "stop of mass 1 (lower), Figures 2-4");
  printed("figure2_s2", "0.1", "caption of Figure 2", "stop of mass 2 (upper), Figures 2-4");
  reconstructed("figure2_Omega", "0.28", "matched to the text and axis boxes",
                "forcing frequency of Figure 2");
  printed("figure2a_t_min", "700", "axes of Figure 2(a)", "start of the shown window");
  printed("figure2a_t_max", "750", "axes of Figure 2(a)", "end of the shown window");
  printed("figure2a_x_min", "-0.5", "axes of Figure 2(a)", "lower edge of the axis box");
  printed("figure2a_x_max", "0.4", "axes of Figure 2(a)", "upper edge of the axis box");
  printed("figure2b_t_min", "715", "axes of Figure 2(b)", "start of the shown window");
  printed("figure2b_t_max", "722", "axes of Figure 2(b)", "end of the shown window");
  printed("figure2b_x_min", "-0.06", "axes of Figure 2(b)", "lower edge of the axis box");
  printed("figure2b_x_max", "0.12", "axes of Figure 2(b)", "upper edge of the axis box");
  printed("figure3_Omega_min", "0.25", "section 3.2 and axes of Figure 3",
          "lowest forcing frequency");
  printed("figure3_Omega_max", "0.7", "section 3.2 and axes of Figure 3",
          "highest forcing frequency");
  printed("figure3a_v1_min", "-0.4", "axes of Figure 3(a)",
          "lower edge; impact speeds of mass 1 are negative");
  printed("figure3b_v2_max", "0.4", "axes of Figure 3(b)",
          "upper edge; impact speeds of mass 2 are positive");
  printed("sticking_Omega_max", "0.5", "section 3.2",
          "sticking motions exist below this forcing frequency");
  printed("incomplete_1_from", "0.3", "section 3.2",
          "mass 1's chatter is incomplete about from this Omega");
  printed("incomplete_1_to", "0.35", "section 3.2", "to about this Omega");
  printed("incomplete_2_from", "0.37", "section 3.2", "and again about from this Omega");
  printed("incomplete_2_to", "0.4", "section 3.2", "to about this Omega");
  printed("multi_sliding_Omega_below", "0.256", "caption of Figure 4",
          "just before the multi-sliding bifurcation, 4(a)");
  printed("multi_sliding_Omega_above", "0.2561", "caption of Figure 4",
          "just after the multi-sliding bifurcation, 4(b)");
  printed("figure4_t_min", "12", "axes of Figure 4",
          "start of the shown window (time within the forcing period)");
  printed("figure4_t_max", "17.5", "axes of Figure 4", "end of the shown window");
  printed("figure4_F_min", "-0.2", "axes of Figure 4", "lower edge of the axis box");
  printed("figure4_F_max", "0.02", "axes of Figure 4", "upper edge of the axis box");
  printed("figure5a_s1", "0.3", "section 3.3", "stop of mass 1 (upper)");
  printed("figure5a_s2", "0.3", "section 3.3", "stop of mass 2 (upper)");
  reconstructed("figure5a_Omega", "0.1769",
                "matched to the text and axis box; 0.157-0.184 behave alike",
                "forcing frequency of Figure 5(a)");
  printed("figure5b_s2", "0.45", "section 3.3",
          "stop of mass 2 (upper); that of mass 1 stays at 0.3");
  printed("figure5b_r", "0.001", "section 3.3", "coefficient of restitution of Figure 5(b)");
  printed("figure5b_graze_time", "920", "section 3.3",
          "mass 2 touches its stop about then while mass 1 is stuck (GS)");
  reconstructed("figure5b_Omega", "0.2996", "matched to the text and axis box",
                "forcing frequency of Figure 5(b)");
  printed("figure5c_Omega", "0.02", "section 3.3", "forcing frequency of Figure 5(c)");
  reconstructed("figure5c_s1", "0.3", "axis box of Figure 5(c)", "stop of mass 1 (upper)");
  reconstructed("figure5c_s2", "0.3", "axis box of Figure 5(c)", "stop of mass 2 (upper)");
  printed("figure5a_t_min", "950", "axes of Figure 5(a)", "start of the shown window");
  printed("figure5a_t_max", "964", "axes of Figure 5(a)", "end of the shown window");
  printed("figure5a_x_min", "-0.05", "axes of Figure 5(a)", "lower edge of the axis box");
  printed("figure5a_x_max", "0.35", "axes of Figure 5(a)", "upper edge of the axis box");
  printed("figure5b_t_min", "916", "axes of Figure 5(b)", "start of the shown window");
  printed("figure5b_t_max", "930", "axes of Figure 5(b)", "end of the shown window");
  printed("figure5b_x_min", "-0.4", "axes of Figure 5(b)", "lower edge of the axis box");
  printed("figure5b_x_max", "0.5", "axes of Figure 5(b)", "upper edge of the axis box");
  printed("figure5c_t_min", "900", "axes of Figure 5(c)", "start of the shown window");
  printed("figure5c_t_max", "1000", "axes of Figure 5(c)", "end of the shown window");
  printed("figure5c_x_min", "0.2", "axes of Figure 5(c)", "lower edge of the axis box");
  printed("figure5c_x_max", "0.31", "axes of Figure 5(c)", "upper edge of the axis box");
  return rows;
}

/// What follows from a formula.
inline std::vector<KeyNumber> derived_numbers() {
  const Real root5 = sqrt(Real(5));
  const Real pi = acos(Real(-1));
  const Real zeta = Real("0.05");
  const auto row = [](const char *symbol, const Real &value, const char *source,
                      const char *meaning) {
    return KeyNumber{symbol, value.str(20), "derived", source, meaning};
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
    rows.push_back({symbol, value.str(20), "computed", source, meaning});
  };
  const auto add_count = [&](const std::string &symbol, std::size_t value, const char *source,
                             const char *meaning) {
    rows.push_back({symbol, std::to_string(value), "computed", source, meaning});
  };

  {
    Extremes extremes;
    const auto events =
        simulate(scene_named("figure2"), [&](const Flow &flow, const Real &duration) {
          extend_extremes(extremes, flow, duration, Real(700), Real(750));
        });
    const char *scene = "scene figure2";
    add("figure2_x1_min", extremes.lowest[0], scene,
        "smallest x1 for t in 700-750 (the stop of mass 1)");
    add("figure2_x1_max", extremes.highest[0], scene, "largest x1 for t in 700-750");
    add("figure2_x2_min", extremes.lowest[1], scene, "smallest x2 for t in 700-750");
    add("figure2_x2_max", extremes.highest[1], scene,
        "largest x2 for t in 700-750 (the stop of mass 2)");
    add_count("figure2_impacts", count(events, Kind::impact), scene,
              "impacts to t = 750 down to speeds of 1e-20 (depends on that floor)");
    add_count("figure2_sticks", count(events, Kind::stick), scene,
              "sticks to t = 750, both masses");
    add_count("figure2_releases", count(events, Kind::release), scene,
              "releases to t = 750, both masses");
    add("figure2b_chatter_end", first(events, Kind::stick, mass_2, Real(715), Real(722)).time,
        scene, "the chatter of mass 2 in Figure 2(b) is complete and it sticks");
  }
  for (const std::string name : {"figure4a", "figure4b"}) {
    const Scene scene = scene_named(name);
    const Real period = 2 * acos(Real(-1)) / scene.chain.frequency;
    std::optional<Real> closest;
    const auto events = simulate(scene, [&](const Flow &flow, const Real &duration) {
      extend_closest_hold(closest, scene, mass_1, flow, duration, scene.end_time - 2 * period);
    });
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
    const auto events = simulate(scene_named("figure5a"));
    const Real stick = first(events, Kind::stick, mass_1, Real(950), Real(964)).time;
    add("figure5a_stick_time", stick, "scene figure5a",
        "the chatter of mass 1 in Figure 5(a) is complete");
    add_count("figure5a_impacts_while_stuck", count(events, Kind::impact, mass_2, stick, Real(964)),
              "scene figure5a", "impacts of mass 2 from then to t = 964, mass 1 being stuck (SI)");
  }
  {
    const auto events = simulate(scene_named("figure5b"));
    const Event &touch = first(events, Kind::impact, mass_2, Real(916), Real(930));
    add("figure5b_stick_time", first(events, Kind::stick, mass_1, Real(916), Real(930)).time,
        "scene figure5b", "the short chatter of mass 1 in Figure 5(b) is complete");
    add("figure5b_touch_time", touch.time, "scene figure5b",
        "mass 2 just reaches its stop, mass 1 being stuck (GS)");
    add("figure5b_touch_speed", touch.velocity_before, "scene figure5b", "speed of mass 2 then");
  }
  {
    const auto events = simulate(scene_named("figure5c"));
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
  return rows;
}

/// Rows as a table: symbol,value,kind,source,meaning.
inline std::string table_of(const std::vector<KeyNumber> &rows) {
  const auto quoted = [](const std::string &field) {
    return field.find(',') == std::string::npos ? field : '"' + field + '"';
  };
  std::string table = "symbol,value,kind,source,meaning\n";
  for (const KeyNumber &row : rows)
    table += row.symbol + ',' + row.value + ',' + row.kind + ',' + quoted(row.source) + ',' +
             quoted(row.meaning) + '\n';
  return table;
}

/// The table key_numbers.csv.
inline std::string key_numbers_table() {
  std::vector<KeyNumber> all;
  for (const auto &rows : {stated_numbers(), derived_numbers(), computed_numbers()})
    all.insert(all.end(), rows.begin(), rows.end());
  return table_of(all);
}

}  // namespace vibro_impact_reference
