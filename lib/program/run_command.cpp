#include <fmt/ranges.h>
#include <unistd.h>

#include <cstdio>
#include <filesystem>
#include <limits>
#include <string>
#include <vector>

#include "files.hpp"
#include "options.hpp"
#include "picture.hpp"
#include "progress.hpp"

namespace vibro_impact::runner {

namespace {

namespace fs = std::filesystem;

Table table_of(const EventRecorder &recorder) {
  Table table("time,mass,event,velocity_before,velocity_after,contact_mode");
  for (const Event &event : recorder.events)
    table.row(event.time, event.mass, name(event.kind), event.velocity_before, event.velocity_after,
              contact_mode_name(event.held));
  return table;
}

// The table of samples, row by row.
struct SampleTable : Recorder {
  const RunRequest &request;
  Table table;
  std::size_t taken = 0;

  explicit SampleTable(const RunRequest &of) : request(of), table("") {
    std::string header = "time";
    for (const char *column : {"x", "v"})
      for (int mass = 1; mass <= of.scene.masses() && (*column == 'x' || of.velocities); ++mass)
        header += fmt::format(",{}{}", column, mass);
    table = Table(header);
  }
  void check(const Scene &scene) const override {
    SampleRecorder(request.from, request.until, request.every).check(scene);
  }
  double next_time() const override {
    return sample_time(request.from, request.until, request.every, taken);
  }
  void sample(const Moment &moment) override {
    ++taken;
    table.cell(moment.time);
    for (int mass = 1; mass <= moment.masses(); ++mass) table.cell(moment.displacement(mass));
    for (int mass = 1; mass <= moment.masses() && request.velocities; ++mass)
      table.cell(moment.velocity(mass));
    table.end_row();
  }
};

// Shows how far a run is, at its events and at times between them.
struct ProgressRecorder : Recorder {
  static constexpr double shown_times = 1000.0;

  Progress progress;
  double until, latest = 0.0, taken = 0.0;

  explicit ProgressRecorder(double end) : progress("time", end), until(end) {
  }
  void reach(double time) {
    progress.advance(time - latest);
    latest = time;
  }
  void event(const Event &event, const Moment &) override {
    reach(event.time);
  }
  double next_time() const override {
    const double next = until * ((taken + 1.0) / shown_times);
    return taken + 1.0 < shown_times && next > 0.0 ? next : std::numeric_limits<double>::infinity();
  }
  void sample(const Moment &moment) override {
    ++taken;
    reach(moment.time);
  }
};

// Draws the motion over time, with the positions of the stops of each mass in words.
void draw_motion(const RunRequest &request) {
  std::vector<std::string> lower(static_cast<std::size_t>(request.scene.masses()), "NaN");
  std::vector<std::string> upper = lower;
  for (const Stop &stop : request.scene.stops)
    (stop.side == Side::lower ? lower : upper)[static_cast<std::size_t>(stop.mass) - 1] =
        fmt::format("{:.17g}", stop.position);
  const bool events = !request.events.empty() && request.events != "-";
  draw({"--plot", request.plot}, "motion",
       {fs::absolute(request.samples).string(),
        events ? fs::absolute(request.events).string() : "/dev/null",
        fmt::format("{}", fmt::join(lower, " ")), fmt::format("{}", fmt::join(upper, " "))});
}

void check_files_of(const RunRequest &request) {
  check_files({{"--events", request.events},
               {"--samples", request.samples},
               {"--plot", request.plot},
               {"--portrait", request.portrait}},
              request.scene_file);
  if (!request.plot.empty()) check_picture({"--plot", request.plot}, "--samples", request.samples);
  if (request.portrait.empty()) return;
  if (!request.velocities) refuse("--portrait {}: needs --velocities", request.portrait);
  check_picture({"--portrait", request.portrait}, "--samples", request.samples);
}

}  // namespace

void run_scene(const RunRequest &request) {
  check_files_of(request);
  EventRecorder events(request.from);
  SampleTable samples(request);
  std::vector<Recorder *> recorders;
  if (!request.events.empty()) recorders.push_back(&events);
  if (!request.samples.empty()) recorders.push_back(&samples);
  Outcome outcome;
  {
    ProgressRecorder progress(request.until);
    if (isatty(STDERR_FILENO) != 0) recorders.push_back(&progress);
    Simulation simulation(request.scene, request.options);
    outcome = require_complete(simulation.advance(request.until, recorders));
  }
  if (!request.events.empty()) write_text(request.head + table_of(events).text, request.events);
  if (!request.samples.empty()) write_text(request.head + samples.table.text, request.samples);
  if (!request.plot.empty()) draw_motion(request);
  if (!request.portrait.empty())
    draw({"--portrait", request.portrait}, "portrait",
         {fs::absolute(request.samples).string(), std::to_string(request.scene.masses()),
          request.points ? "points" : "lines"});
  const Counters &counters = outcome.counters;
  fmt::print(
      stderr,
      "t = {:.17g}: since t = 0, {} impacts resolved, {} sticks, {} releases; chatter {} times "
      "carried to its limit, {} times incomplete\n",
      outcome.time, counters.impacts, counters.sticks, counters.releases, counters.chatter_limits,
      counters.chatter_incomplete);
}

}  // namespace vibro_impact::runner
