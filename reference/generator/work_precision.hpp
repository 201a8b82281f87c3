// The problems of the work-precision figure: where they start, what happens, where they end.
#pragma once

#include "event_driven.hpp"
#include "in_digits.hpp"

#include <sstream>
#include <string>
#include <vector>

namespace vibro_impact_reference {

/// A stretch of the motion of a scene of the paper. The state at `from` is rounded to double before
/// the 50-digit run goes on from it, so that a run in double starts from exactly the same numbers.
struct Stretch {
  std::string name, scene;
  double from, until;
};

/// Two whole motions of ten forcing periods from rest, and three pieces of Figure 2 after three of
/// its periods: a flight with the impact that ends it, a chatter sequence of mass 2 with the stick
/// that ends it, and the sticking phase after it with its release.
inline std::vector<Stretch> stretches() {
  const auto ten_periods = [](const char *scene) {
    const double two_pi = 6.283185307179586477;
    return 10.0 * two_pi / static_cast<double>(scene_named(scene)[&Field::omega]);
  };
  return {{"figure2", "figure2", 0.0, ten_periods("figure2")},
          {"figure4", "figure4a", 0.0, ten_periods("figure4a")},
          {"flight", "figure2", 117.5, 119.5},
          {"chatter", "figure2", 121.0, 125.5},
          {"sticking", "figure2", 125.5, 133.0}};
}

struct StretchRun {
  Stretch stretch;
  State start, end;
  std::vector<Event> events;
};

inline StretchRun run(const Stretch &stretch) {
  Scene scene = scene_named(stretch.scene);
  const Resolution resolution;
  Run run;
  State state = initial_state(scene, resolution, run);
  scene.end_time = Real(stretch.from);
  advance(scene, state, run);
  run.events.clear();
  for (Real &x : state.x) x = Real(static_cast<double>(x));
  for (Real &v : state.v) v = Real(static_cast<double>(v));
  state.time = scene.end_time;
  const State start = state;
  scene.end_time = Real(stretch.until);
  advance(scene, state, run);
  return {stretch, start, state, run.events};
}

/// Start (exactly doubles) and end (30 digits) of every stretch; held masses as 0 or 1.
inline std::string states_table(const std::vector<StretchRun> &runs) {
  std::ostringstream table;
  table << "problem,scene,from,until,x1,x2,v1,v2,held1,held2,end_x1,end_x2,end_v1,end_v2\n";
  for (const StretchRun &run : runs) {
    table << run.stretch.name << ',' << run.stretch.scene << ',' << Real(run.stretch.from).str(17)
          << ',' << Real(run.stretch.until).str(17);
    for (const Real &x : run.start.x) table << ',' << x.str(17);
    for (const Real &v : run.start.v) table << ',' << v.str(17);
    for (const auto &stop : run.start.stuck_on) table << ',' << stop.has_value();
    for (const Real &x : run.end.x) table << ',' << x.str(30);
    for (const Real &v : run.end.v) table << ',' << v.str(30);
    table << '\n';
  }
  return table.str();
}

}  // namespace vibro_impact_reference
