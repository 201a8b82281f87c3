#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include "options.hpp"
#include "scene_text.hpp"
#include "vibro_impact/analysis/orbit_record.hpp"
#include "vibro_impact/analysis/periodic_orbit.hpp"

namespace vibro_impact::runner {

namespace {

struct FoundOrbit {
  PeriodicOrbit orbit;
  int period = 0;  // forcing periods
  EventCounts counts = {};
};

// The orbit near the settled motion, or near the start. Throws std::runtime_error with the reason
// if there is none.
FoundOrbit found_orbit(const OrbitRequest &request) {
  const Scene &scene = request.scene;
  const RunOptions &run = request.settle.run;
  FoundOrbit found{{}, request.period, {}};
  MotionState near = start_of(scene);
  if (!request.near_start) {
    const OrbitRecord settled = record_of(scene, {.settle = request.settle});
    near = settled.state;
    if (found.period == 0 && settled.period == 0)
      throw std::runtime_error(fmt::format(
          "no period was found in {} forcing periods (--longest): --period N looks for an orbit",
          request.settle.longest));
    if (found.period == 0) found.period = settled.period;
  }
  found.period = std::max(found.period, 1);
  found.orbit = find_periodic_orbit(scene, at_quiet_phase(scene, near, run), found.period);
  if (!found.orbit.converged)
    throw std::runtime_error(
        fmt::format("no orbit of period {} was found: {}", found.period, found.orbit.why_not));
  EventRecorder events;
  const MotionState &start = found.orbit.state;
  stroboscopic_map(scene, start, found.period, run, events);
  found.counts = counts_of(scene, events.events, found.period, start.held);
  return found;
}

// The columns of a list: name1,name2,...
std::string columns(const char *name, std::size_t count) {
  std::string text;
  for (std::size_t k = 1; k <= count; ++k) text += fmt::format(",{}{}", name, k);
  return text;
}

// One row: period, residual, stability, phase, states, counts per mass, multipliers. Multipliers of
// held masses have empty cells.
Table table_of(const FoundOrbit &found) {
  const auto &[orbit, period, counts] = found;
  const std::size_t n = counts.impacts.size();
  Table table("period,residual,stable,phase,contact_mode" + columns("x", n) + columns("v", n) +
              columns("impacts", n) + columns("sticks", n) + columns("re", 2 * n) +
              columns("im", 2 * n));
  table.cell(period);
  table.cell(orbit.residuals.back());
  table.cell(orbit.stable() ? 1 : 0);
  table.cell(orbit.state.instant.phase);
  table.cell(contact_mode_name(orbit.state.held));
  for (const double coordinate : coordinates(orbit.state)) table.cell(coordinate);
  for (const auto *of_masses : {&counts.impacts, &counts.sticks})
    for (const int count : *of_masses) table.cell(count);
  for (const bool imaginary : {false, true})
    for (std::size_t k = 0; k < 2 * n; ++k)
      if (k < orbit.multipliers.size())
        table.cell(imaginary ? orbit.multipliers[k].imag() : orbit.multipliers[k].real());
      else
        table.cell(std::string_view());
  table.end_row();
  return table;
}

void print(const FoundOrbit &found, double forcing_period) {
  const auto &[orbit, period, counts] = found;
  const MotionState &state = orbit.state;
  fmt::print("period: {}\nresidual: {:.2g}, of {} evaluations of the map\n", period,
             orbit.residuals.back(), orbit.residuals.size());
  fmt::print("section: phase {:.15g} of {:.15g}, contact mode {}\n", state.instant.phase,
             forcing_period, contact_mode_name(state.held));
  for (std::size_t i = 0; i < state.displacement.size(); ++i)
    fmt::print("mass {}: x = {:.15g}, v = {:.15g}; impacts: {}, sticks: {}\n", i + 1,
               state.displacement[i], state.velocity[i], counts.impacts[i], counts.sticks[i]);
  for (const std::complex<double> &multiplier : orbit.multipliers)
    fmt::print("multiplier: {:.12f} {:+.12f}i, modulus {:.12f}\n", multiplier.real(),
               multiplier.imag(), std::abs(multiplier));
  fmt::print("{}\n", orbit.stable() ? "stable" : "unstable");
}

}  // namespace

void find_orbit(const OrbitRequest &request) {
  check_outputs_of(request, request.table);
  const FoundOrbit found = found_orbit(request);
  const Clock clock(request.scene.omega);
  print(found, clock.period);
  if (request.table.wanted()) write_text(request.head + table_of(found).text, request.table.path);
  RunRequest of_orbit = request;
  of_orbit.start = found.orbit.state;
  of_orbit.start->instant.cycle = 0;
  of_orbit.options = request.settle.run;
  of_orbit.from = of_orbit.start->instant.phase;
  of_orbit.until = time_after(request.scene, *of_orbit.start, found.period);
  record_run(of_orbit);
}

}  // namespace vibro_impact::runner
