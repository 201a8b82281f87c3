#include <fmt/ranges.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <regex>
#include <string>
#include <utility>
#include <vector>

#include "files.hpp"
#include "options.hpp"
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

// The name of gnuplot's terminal for a file.
std::string terminal_of(const std::string &path) {
  if (path.ends_with(".png")) return "pngcairo";
  if (path.ends_with(".pdf")) return "pdfcairo";
  if (path.ends_with(".svg")) return "svg";
  refuse("--plot {}: must end in .png, .pdf or .svg", path);
}

// A word of a command of the shell.
std::string quoted(const std::string &word) {
  return fmt::format("'{}'", std::regex_replace(word, std::regex("'"), "'\\''"));
}

// Runs gnuplot without the settings of the user; true when it succeeds.
bool gnuplot(const std::string &arguments) {
  return std::system(fmt::format("gnuplot -d {} 2>/dev/null", arguments).c_str()) == 0;
}

bool is_file(const std::string &path) {
  return !path.empty() && path != "-";
}

// Refuses a picture if the run writes no table of samples to draw it from, if gnuplot is not
// installed, or if gnuplot cannot write this format.
void check_plot(const RunRequest &request) {
  const std::string terminal = terminal_of(request.plot);
  if (!is_file(request.samples))
    refuse("--plot {}: is drawn from the table of --samples, which must be a file", request.plot);
  if (!gnuplot(fmt::format("-e 'set terminal {}'", terminal)))
    refuse("--plot {}: needs gnuplot with its terminal {}, not found", request.plot, terminal);
}

// The picture of a run: the displacement of each mass over time, its stops, its impacts and the
// phases in which it sticks. Gnuplot draws it from the tables, which are written by now, by
// plot.gp, which is installed. Throws std::runtime_error.
void draw(const RunRequest &request) {
  const Scene &scene = request.scene;
  std::vector<std::string> lower(static_cast<std::size_t>(scene.masses()), "NaN"), upper = lower;
  for (const Stop &stop : scene.stops)
    (stop.side == Side::lower ? lower : upper)[static_cast<std::size_t>(stop.mass) - 1] =
        fmt::format("{:.17g}", stop.position);
  // Beside the program, in the build folder as where it is installed.
  const fs::path script =
      fs::read_symlink("/proc/self/exe").parent_path() / "../share/vibro-impact/plot.gp";
  const std::string samples = fs::absolute(request.samples).string(),
                    events = is_file(request.events) ? fs::absolute(request.events).string()
                                                     : "/dev/null",
                    temporary = request.plot + ".part";
  const bool drawn = gnuplot(fmt::format(
      "-c {} {} {} {} '{}' '{}' >{}", quoted(script), terminal_of(request.plot), quoted(samples),
      quoted(events), fmt::join(lower, " "), fmt::join(upper, " "), quoted(temporary)));
  std::error_code failed;
  if (drawn) fs::rename(temporary, request.plot, failed);
  if (drawn && !failed) return;
  fs::remove(temporary, failed);
  throw std::runtime_error(fmt::format("--plot {}: gnuplot could not draw it", request.plot));
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
