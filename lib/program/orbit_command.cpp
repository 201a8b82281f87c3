#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "options.hpp"
#include "picture.hpp"
#include "scene_text.hpp"
#include "vibro_impact/analysis/follow_orbit.hpp"
#include "vibro_impact/analysis/orbit_record.hpp"

namespace vibro_impact::runner {

namespace {

// The orbit near the settled motion, or near the start. Throws std::runtime_error with the reason
// if there is none.
OrbitPoint found_orbit(const OrbitRequest &request) {
  const Scene &scene = request.scene;
  MotionState near = start_of(scene);
  int period = request.period;
  if (!request.near_start) {
    const OrbitRecord settled = record_of(scene, {.settle = request.settle});
    near = settled.state;
    if (period == 0 && settled.period == 0)
      throw std::runtime_error(fmt::format(
          "no period was found in {} forcing periods (--longest): --period N looks for an orbit",
          request.settle.longest));
    if (period == 0) period = settled.period;
  }
  period = std::max(period, 1);
  OrbitPoint found = find_orbit(scene, at_quiet_phase(scene, near, request.settle.run), period);
  if (!found.orbit.converged)
    throw std::runtime_error(
        fmt::format("no orbit of period {} was found: {}", period, found.orbit.why_not));
  return found;
}

// The branch from its end towards `from` to its end towards `to`, or the orbit alone.
std::vector<OrbitPoint> branch_of(const OrbitRequest &request, const OrbitPoint &found) {
  if (!request.range) return {found};
  const auto follow = [&](const Axis &range) {
    return follow_orbit(request.scene, found.orbit.state, range, {.periods = found.counts.periods});
  };
  Axis reversed = *request.range;
  std::swap(reversed.from, reversed.to);
  const std::vector<OrbitPoint> towards_to = follow(*request.range);
  if (towards_to.back().kind == BranchPoint::closed) return towards_to;
  std::vector<OrbitPoint> branch = follow(reversed);
  std::ranges::reverse(branch);
  branch.pop_back();  // the orbit itself, which both have
  branch.insert(branch.end(), towards_to.begin(), towards_to.end());
  return branch;
}

// The velocity before the fastest impact of a mass, which --impacts of a sweep has as well; 0
// without impacts.
double fastest_impact(const PeriodicOrbit &orbit, std::size_t mass) {
  double fastest = 0.0;
  for (const Event &event : orbit.events)
    if (event.kind == EventKind::impact && event.mass == static_cast<int>(mass) + 1 &&
        std::abs(event.velocity_before) > std::abs(fastest))
      fastest = event.velocity_before;
  return fastest;
}

// The table of a branch, with the parameter along it, or of one orbit, without rows.
Table empty_table(std::size_t n, const std::optional<Axis> &range) {
  return Table(
      (range ? range->parameter + "," : "") + "kind,period,residual,stability,phase,contact_mode" +
      numbered_columns("x", n) + numbered_columns("v", n) + numbered_columns("impacts", n) +
      numbered_columns("sticks", n) + numbered_columns("fastest", n) +
      numbered_columns("multiplier", 2 * n, "_re") + numbered_columns("multiplier", 2 * n, "_im"));
}

// Adds a row for each orbit of a branch. Multipliers of held masses have empty cells.
Table table_of(const std::vector<OrbitPoint> &branch, const std::optional<Axis> &range) {
  const std::size_t n = branch.front().orbit.state.held.size();
  Table table = empty_table(n, range);
  for (const auto &[parameter, error, orbit, counts, kind] : branch) {
    if (range) table.cell(parameter, error);
    table.cell(name(kind));
    table.cell(counts.periods);
    table.cell(orbit.residuals.empty() ? NAN : orbit.residuals.back());
    table.cell(name(orbit.stability()));
    table.cell(orbit.state.instant.phase);
    table.cell(contact_mode_name(orbit.state.held));
    for (const double coordinate : coordinates(orbit.state)) table.cell(coordinate);
    for (const std::vector<int> &events : {counts.impacts, counts.sticks})
      for (const int count : events) table.cell(count);
    for (std::size_t i = 0; i < n; ++i) table.cell(fastest_impact(orbit, i));
    for (const bool imaginary : {false, true})
      for (std::size_t k = 0; k < 2 * n; ++k)
        if (orbit.multipliers.exists() && k < orbit.multipliers.size())
          table.cell(imaginary ? orbit.multipliers[k].imag() : orbit.multipliers[k].real());
        else
          table.cell(std::string_view());
    table.end_row();
  }
  return table;
}

// Prints the row of one orbit, a line `column = cell` each.
void print(const Table &table) {
  const auto lines = parts_of(table.text, '\n'), names = parts_of(lines[0], ','),
             cells = parts_of(lines[1], ',');
  for (std::size_t k = 0; k < names.size(); ++k)
    if (!cells[k].empty()) fmt::print("{} = {}\n", names[k], cells[k]);
}

// A number to the digit of its error, or to 15 digits.
std::string digits(double value, double error) {
  if (!(error > 0.0)) return fmt::format("{:.15g}", value);
  Table number;
  number.cell(value, 10.0 * error);
  number.text.pop_back();
  return number.text;
}

void check_branch_picture(const OrbitRequest &request) {
  const Table header = empty_table(request.scene.mass.size(), request.range);
  const auto columns =
      parts_of(std::string_view(header.text).substr(0, header.text.size() - 1), ',');
  if (!request.column.empty() && std::ranges::find(columns, request.column) == columns.end())
    refuse("--column {}: is no column of the table", request.column);
  if (!request.diagram.empty() && contents(request.diagram).empty())
    refuse("--diagram {}: is no table", request.diagram);
}

// The panels show a column, or the fastest impacts of the masses that have a stop.
void draw_branch(const OrbitRequest &request) {
  std::string columns = request.column;
  if (columns.empty())
    for (const int mass : request.panels)
      if (std::ranges::find(request.scene.stops, mass, &Stop::mass) != request.scene.stops.end())
        columns += fmt::format("{}fastest{}", columns.empty() ? "" : " ", mass);
  draw(request.plot, "branch", columns, {request.table, {"--diagram", request.diagram}},
       {request.range->parameter});
}

}  // namespace

void run_orbit(const OrbitRequest &request) {
  check_outputs_of(request, request.table, request.range ? request.table : request.samples);
  check_branch_picture(request);
  const OrbitPoint found = found_orbit(request);
  const std::vector<OrbitPoint> branch = branch_of(request, found);
  print(table_of({found}, {}));
  for (const OrbitPoint &point : branch) {
    if (point.kind == BranchPoint::orbit || point.kind == BranchPoint::coincidence) continue;
    const std::string why = point.orbit.why_not;
    fmt::print("{} at {} = {}{}\n", name(point.kind), request.range->parameter,
               digits(point.parameter, point.error), why.empty() ? "" : ": " + why);
  }
  if (request.table.wanted())
    write_text(request.head + table_of(branch, request.range).text, request.table.path);
  RunRequest run = request;
  run.start = found.orbit.state;
  run.start->instant.cycle = 0;
  run.options = request.settle.run;
  run.from = run.start->instant.phase;
  run.until = time_after(request.scene, *run.start, found.counts.periods);
  if (request.range) run.plot.path.clear();
  record_run(run);
  if (request.range && request.plot.wanted()) draw_branch(request);
  for (const OrbitPoint &point : branch)
    if (point.kind == BranchPoint::lost)
      throw std::runtime_error(
          fmt::format("the branch is lost at {} = {}: {}", request.range->parameter,
                      digits(point.parameter, point.error), point.orbit.why_not));
}

}  // namespace vibro_impact::runner
