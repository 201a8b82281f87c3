#include <fmt/ranges.h>
#include <unistd.h>

#include <cmath>
#include <cstdio>
#include <string>
#include <utility>
#include <vector>

#include "options.hpp"
#include "picture.hpp"
#include "progress.hpp"
#include "summary.hpp"

namespace vibro_impact::runner {

namespace {

Table table_of(const EventRecorder &recorder, const Scene &scene) {
  Table table(
      "time,mass,event,velocity_before,velocity_after,contact_mode,stop,side,phase,impulse");
  for (const Event &event : recorder.events) {
    const double m = scene.mass[static_cast<std::size_t>(event.mass - 1)];
    table.row(event.time, event.mass, name(event.kind), event.velocity_before, event.velocity_after,
              contact_mode_name(event.held), event.stop, name(event.side), event.instant.phase,
              m * std::abs(event.velocity_before - event.velocity_after));
  }
  return table;
}

// The table of samples, row by row.
struct SampleTable : SampleRecorder {
  bool velocities;
  Table table;

  explicit SampleTable(const RunRequest &request)
      : SampleRecorder(request.from, request.until, request.every),
        velocities(request.velocities),
        table("time" + numbered_columns("x", request.scene.mass.size()) +
              (velocities ? numbered_columns("v", request.scene.mass.size()) : "")) {
  }
  void sample(const Moment &moment) override {
    times.push_back(moment.time);
    table.cell(moment.time);
    for (int mass = 1; mass <= moment.masses(); ++mass) table.cell(moment.displacement(mass));
    for (int mass = 1; mass <= moment.masses() && velocities; ++mass)
      table.cell(moment.velocity(mass));
    table.end_row();
  }
};

// Shows a thousand times how far a run is.
struct ProgressRecorder : Recorder {
  static constexpr double shown_times = 1000.0;

  Progress progress;
  double until, taken = 0.0;

  explicit ProgressRecorder(double end) : progress("time", end), until(end) {
  }
  double next_time() const override {
    const double next = until * ((taken + 1.0) / shown_times);
    return taken + 1.0 < shown_times && next > 0.0 ? next : infinity;
  }
  void sample(const Moment &) override {
    ++taken;
    progress.advance(until / shown_times);
  }
};

// The positions of the stops of each mass on one side, in words for gnuplot.
std::string positions_of(const Scene &scene, Side side) {
  std::vector<std::string> positions(static_cast<std::size_t>(scene.masses()), "NaN");
  for (const Stop &stop : scene.stops)
    if (stop.side == side)
      positions[static_cast<std::size_t>(stop.mass) - 1] = fmt::format("{}", stop.position);
  return fmt::format("{}", fmt::join(positions, " "));
}

void draw_pictures(const RunRequest &request) {
  const Scene &scene = request.scene;
  const std::string panels = fmt::format("{}", fmt::join(request.panels, " "));
  if (request.plot.wanted())
    draw(request.plot, "motion", panels, {request.samples, request.events},
         {positions_of(scene, Side::lower), positions_of(scene, Side::upper)});
  // Samples so far apart are not joined to lines.
  const bool are_points = scene.omega > 0.0 && request.every > 0.4 * Clock(scene.omega).period;
  if (request.portrait.wanted())
    draw(request.portrait, "portrait", panels, {request.samples},
         {are_points ? "points" : "lines", std::to_string(scene.masses())});
}

// The chain, of which the user may have given little, and what happened to it.
void print_summary(const Scene &scene, const Outcome &outcome) {
  int forced = 0;
  for (int mass = 1; mass <= scene.masses(); ++mass) forced += scene.forced(mass);
  const Counters &counters = outcome.counters;
  fmt::print(stderr,
             "masses: {}, forced: {}, stops: {}, restitution: {}, beta: {}; t = {:.17g}: since t = "
             "0, {} impacts "
             "resolved, {} sticks, {} releases; chatter {} times carried to its limit, {} times "
             "incomplete\n",
             scene.masses(), forced, scene.stops.size(), scene.restitution, scene.beta,
             outcome.time, counters.impacts, counters.sticks, counters.releases,
             counters.chatter_limits, counters.chatter_incomplete);
}

}  // namespace

void check_outputs_of(const RunRequest &request, const Output &more) {
  check_outputs(
      {request.events, request.samples, request.summary, request.plot, request.portrait, more},
      request.scene_file);
  for (const Output &picture : {request.plot, request.portrait})
    if (picture.wanted()) check_picture(picture, request.samples);
  if (request.portrait.wanted() && !request.velocities)
    refuse("{}: needs --velocities", request.portrait.given());
}

Outcome record_run(const RunRequest &request) {
  EventRecorder events(request.from);
  SampleTable samples(request);
  Summary summary(request.scene, request.from, request.until);
  std::vector<Recorder *> recorders;
  if (request.events.wanted()) recorders.push_back(&events);
  if (request.samples.wanted()) recorders.push_back(&samples);
  if (request.summary.wanted()) recorders.push_back(&summary);
  Outcome outcome;
  {
    ProgressRecorder progress(request.until);
    if (isatty(STDERR_FILENO) != 0 && !request.start) recorders.push_back(&progress);
    Simulation simulation(request.scene, request.start.value_or(start_of(request.scene)),
                          request.options);
    outcome = simulation.advance(request.until, recorders);
  }
  outcome = require_complete(std::move(outcome));
  for (const auto &[output, text] :
       {std::pair{request.events, table_of(events, request.scene).text},
        {request.samples, samples.table.text},
        {request.summary, summary.table().text}})
    if (output.wanted()) write_text(request.head + text, output.path);
  draw_pictures(request);
  return outcome;
}

void run_scene(const RunRequest &request) {
  check_outputs_of(request, {});
  print_summary(request.scene, record_run(request));
}

}  // namespace vibro_impact::runner
