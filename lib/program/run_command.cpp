#include <fmt/format.h>

#include <cstdio>
#include <fstream>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "options.hpp"
#include "output.hpp"
#include "plot.hpp"
#include "progress.hpp"
#include "refuse.hpp"
#include "sample_times.hpp"
#include "state_file.hpp"

namespace vibro_impact::runner {

namespace {

// A recorder of the events from time `from` on. The run ends when they cannot be written.
struct EventRows {
  Output file;
  double from;
  Table row{"time,mass,event,velocity_before,velocity_after,contact_mode"};

  EventRows(const std::string &name, double begin) : file(name), from(begin) {
    file.take(row);
  }
  void event(const Event &event, const Moment &) {
    if (event.time < from) return;
    row.row(event.time, event.mass, name(event.kind), event.velocity_before, event.velocity_after,
            contact_mode_name(event.held));
    file.take(row);
  }
  bool done() const {
    return file.failed();
  }
};

std::string header_of_samples(const Scene &scene) {
  std::string header = "time";
  for (int i = 1; i <= scene.masses(); ++i) header += fmt::format(",x{}", i);
  return header;
}

// A recorder of the displacements at these times. A flight that nothing disturbs has any number of
// them: it ends at a signal, and when they cannot be written.
struct SampleRows {
  Output file;
  Table row;
  SampleTimes times;
  int (*signal)();

  SampleRows(const Request &of, const Scene &scene, int (*asked)())
      : file(of.samples),
        row(header_of_samples(scene)),
        times{of.from, of.until, of.every},
        signal(asked) {
    file.take(row);
  }
  double next_time() const {
    return times.next();
  }
  void sample(const Moment &moment) {
    ++times.taken;
    row.cell(moment.time);
    for (int mass = 1; mass <= moment.masses(); ++mass) row.cell(moment.displacement(mass));
    row.end_row();
    file.take(row);
  }
  bool done() const {
    return file.failed() || signal() != 0;
  }
};

// The run to go on with, or one that stands at its start.
SavedRun start_of(const Request &request) {
  if (request.resume.empty()) return {request.scene_text, request.scene, {}, 0.0};
  std::ifstream file(request.resume, std::ios::binary);
  SavedRun saved = read_saved_run(file, fmt::format("--resume {}", request.resume));
  if (request.until < saved.time)
    refuse("--until {}: lies before the end {} of the run saved in {}", request.until, saved.time,
           request.resume);
  return saved;
}

// What a run writes. A table that is not asked for takes no part in it.
struct Files {
  std::optional<EventRows> events;
  std::optional<SampleRows> samples;
  std::optional<Output> state, picture;

  Files(const Request &of, const SavedRun &start, int (*signal)()) {
    if (!of.plot.empty()) check_plot(of);
    if (!of.plot.empty()) picture.emplace(of.plot);
    if (!of.save_state.empty()) state.emplace(of.save_state);
    if (!of.events.empty()) events.emplace(of.events, of.from);
    if (!of.samples.empty()) samples.emplace(of, start.scene, signal);
    // Those of one whole run, but for those that the first part of it has written.
    if (samples && !of.resume.empty()) samples->times.skip_to(start.time);
  }
  // First all are closed, then all put in place: one that cannot be written leaves none behind.
  void finish() {
    std::vector<Output *> all;
    if (events) all.push_back(&events->file);
    if (samples) all.push_back(&samples->file);
    if (state) all.push_back(&*state);
    for (Output *file : all) file->complete();
    for (Output *file : all) file->put_in_place();
  }
};

// The outcome, in which `time` is the one up to which the tables reach.
Outcome simulate_or_resume(const Request &request, const SavedRun &start, int (*signal)(),
                           Files &files) {
  Progress progress("time", request.until, start.time);
  std::vector<RecorderRef> recorders{{.done = [signal] { return signal() != 0; }}};
  if (files.events) recorders.push_back(recorder_ref(*files.events));
  if (files.samples) recorders.push_back(recorder_ref(*files.samples));
  const auto show = [&progress, last = start.time](const Event &event, const Moment &) mutable {
    progress.advance(event.time - std::exchange(last, event.time));
  };
  // No progress line mixes with a table on standard output.
  if (request.events != "-" && request.samples != "-") recorders.push_back({.event = show});
  Outcome outcome =
      request.resume.empty()
          ? simulate_seen(start.scene, vibro_impact::start_of(start.scene), request.until,
                          request.options, recorders)
          : resume_seen(start.scene, start.state, request.until, request.options, recorders);
  if (files.samples && outcome.ending != Ending::reached)
    outcome.time = files.samples->times.reach(outcome.time);
  return outcome;
}

}  // namespace

void run_scene(const Request &request, int (*signal)()) {
  if (Destination(request.events).path == "-" && Destination(request.samples).path == "-")
    refuse("--events {} --samples {}: two tables cannot be written to one place", request.events,
           request.samples);
  const SavedRun start = start_of(request);
  Files files(request, start, signal);
  remember_signals();
  const Outcome outcome = simulate_or_resume(request, start, signal, files);
  // A run that was given up may be gone on with, too, under another limit of impacts.
  if (files.state)
    files.state->write(text_of({start.scene_text, start.scene, outcome.resume, outcome.time}));
  files.finish();
  if (files.picture) draw(request, start.scene, *files.picture);
  std::string remark;
  if (files.events || files.samples) remark += "; the tables hold what came before";
  if (files.state) remark += "; the state reached is saved";
  if (outcome.ending == Ending::given_up) throw std::runtime_error(outcome.reason + remark);
  if (outcome.ending == Ending::stopped)  // a table that cannot be written has thrown in `finish`
    throw EndedBySignal{signal(), fmt::format("interrupted at t = {}{}", outcome.time, remark)};
  const Counters &c = outcome.counters;
  const std::string sum = fmt::format(
      "t = {:.17g}: {} impacts resolved, {} sticks, {} releases; chatter {} times carried to its "
      "limit, {} times incomplete\n",
      outcome.time, c.impacts, c.sticks, c.releases, c.chatter_limits, c.chatter_incomplete);
  std::fputs(sum.c_str(), stderr);  // come what may: fmt::print throws where the terminal is gone
}

}  // namespace vibro_impact::runner
