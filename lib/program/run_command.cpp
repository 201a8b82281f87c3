#include <fmt/format.h>

#include <cstdio>
#include <string>
#include <utility>
#include <vector>

#include "files.hpp"
#include "options.hpp"
#include "plot.hpp"
#include "progress.hpp"

namespace vibro_impact::runner {

namespace {

Table table_of(const EventRecorder &recorder) {
  Table table("time,mass,event,velocity_before,velocity_after,contact_mode");
  for (const Event &event : recorder.events)
    table.row(event.time, event.mass, name(event.kind), event.velocity_before, event.velocity_after,
              contact_mode_name(event.held));
  return table;
}

Table table_of(const SampleRecorder &recorder, int masses) {
  std::string header = "time";
  for (int mass = 1; mass <= masses; ++mass) header += fmt::format(",x{}", mass);
  Table table(header);
  auto displacement = recorder.displacements.begin();
  for (const double time : recorder.times) {
    table.cell(time);
    for (int mass = 1; mass <= masses; ++mass) table.cell(*displacement++);
    table.end_row();
  }
  return table;
}

}  // namespace

// Shows how far a run is.
struct ProgressRecorder {
  Progress &progress;
  double last = 0.0;

  void event(const Event &event, const Moment &) {
    progress.advance(event.time - std::exchange(last, event.time));
  }
};

void run_scene(const RunRequest &request) {
  check_files(
      {{"--events", request.events}, {"--samples", request.samples}, {"--plot", request.plot}});
  if (!request.plot.empty()) check_plot(request);
  EventRecorder events{request.from};
  SampleRecorder samples{request.from, request.until, request.every};
  Progress progress("time", request.until);
  ProgressRecorder shown{progress};
  RecorderGroup recorders;
  if (!request.events.empty()) recorders.add(events);
  if (!request.samples.empty()) recorders.add(samples);
  recorders.add(shown);
  Simulation simulation(request.scene, request.options);
  const Outcome outcome = require_complete(simulation.advance(request.until, recorders));
  if (!request.events.empty()) write_table(table_of(events), request.events);
  if (!request.samples.empty())
    write_table(table_of(samples, request.scene.masses()), request.samples);
  if (!request.plot.empty()) draw(request);
  const Counters &counters = outcome.counters;
  const std::string summary = fmt::format(
      "t = {:.17g}: {} impacts resolved, {} sticks, {} releases; chatter {} times carried to "
      "its limit, {} times incomplete\n",
      outcome.time, counters.impacts, counters.sticks, counters.releases, counters.chatter_limits,
      counters.chatter_incomplete);
  std::fputs(summary.c_str(), stderr);
}

}  // namespace vibro_impact::runner
