#include "run_command.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <iterator>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "plot.hpp"
#include "progress.hpp"
#include "refuse.hpp"
#include "state_file.hpp"
#include "tables.hpp"

namespace vibro_impact::runner {

namespace {

// To standard error, come what may: a terminal that is gone does not undo what the run has done.
void summarise(const Outcome &outcome) {
  const Counters &c = outcome.counters;
  const std::string text = fmt::format(
      "t = {:.17g}: {} impacts resolved, {} sticks, {} releases\n"
      "chatter: {} complete and carried to the limit, {} incomplete\n"
      "work: {} contact modes, {} expansions, {} root searches ({} stops dismissed), {} root "
      "iterations, {} modal evaluations\n",
      outcome.time, c.impacts, c.sticks, c.releases, c.chatter_limits, c.chatter_incomplete,
      c.modes_built, c.expansions, c.roots_searched, c.roots_dismissed + c.stops_clear,
      c.root_iterations, c.modal_evaluations);
  std::fputs(text.c_str(), stderr);
}

// The saved run to go on with; nothing: the run starts at t = 0.
std::optional<SavedRun> saved_run(const Request &request) {
  if (request.resume.empty()) return std::nullopt;
  SavedRun saved = read_saved_run(request.resume);
  if (request.until < saved.time)
    refuse("--until {}: lies before the end {} of the run saved in {}", request.until, saved.time,
           request.resume);
  return saved;
}

// A recorder that ends the run after the flight in which a signal comes.
struct Interruption {
  int (*signal)();

  bool done() const {
    return signal() != 0;
  }
};

// A recorder that shows, at the events, how far the run is.
struct ShownProgress {
  Progress &progress;

  void event(const Event &event, const Moment &) {
    progress.reach(event.time);
  }
};

// What a run writes. A table that is not asked for takes no part in it.
struct Files {
  std::optional<EventRows> events;
  std::optional<SampleRows> samples;
  std::optional<Output> state;
  std::optional<Plot> plot;

  Files(const Request &request, const std::optional<SavedRun> &saved, const Scene &scene) {
    const double begin = saved ? std::max(request.from, saved->time) : request.from;
    if (!request.plot.empty())
      plot.emplace(request.plot, scene, saved ? saved->state.held() : start_of(scene).held, begin,
                   request.until);
    if (!request.save_state.empty()) state.emplace(Named{"--save-state", request.save_state});
    if (!request.events.empty()) events.emplace(Named{"--events", request.events}, request.from);
    // The samples of one whole run, but for those that the first part of it has written.
    const std::size_t taken =
        saved ? samples_taken(request.from, request.every, saved->time) : std::size_t{0};
    if (!request.samples.empty())
      samples.emplace(Named{"--samples", request.samples}, scene.masses(),
                      SampleTimes{request.from, request.until, request.every, taken});
  }

  void add_to(std::vector<RecorderRef> &recorders) {
    if (events) recorders.push_back(recorder_ref(*events));
    if (samples) recorders.push_back(recorder_ref(*samples));
    if (plot) recorders.push_back(recorder_ref(*plot));
  }

  // A run that was given up may be gone on with, too, under another limit of impacts: unless its
  // numbers have left the range of double precision.
  void save(const SavedRun &run) {
    if (!state) return;
    if (const auto text = text_of(run))
      state->write(*text);
    else
      state.reset();
  }

  // First all are closed, then all put in place: one that cannot be written leaves none behind.
  void finish() {
    if (events) events->complete();
    if (samples) samples->complete();
    if (state) state->complete();
    if (events) events->file.put_in_place();
    if (samples) samples->file.put_in_place();
    if (state) state->put_in_place();
  }
};

// Where the tables go to the terminal on which it would stand, no progress line mixes with them.
bool shows_progress(const Request &request) {
  const bool table_on_screen =
      (request.events == "-" || request.samples == "-") && isatty(STDOUT_FILENO) != 0;
  return request.progress || (isatty(STDERR_FILENO) != 0 && !table_on_screen);
}

// The outcome, in which `time` is the one up to which the tables reach.
Outcome simulate_or_resume(const Request &request, const std::optional<SavedRun> &saved,
                           const Scene &scene, int (*signal)(), Files &files) {
  const double begin = saved ? saved->time : 0.0;
  Interruption interruption{signal};
  std::vector<RecorderRef> recorders{recorder_ref(interruption)};
  files.add_to(recorders);
  Progress progress("time", request.until, request.progress, begin);
  ShownProgress shown{progress};
  if (shows_progress(request)) recorders.push_back(recorder_ref(shown));
  Outcome outcome =
      saved ? resume_seen(scene, saved->state, request.until, request.options, recorders)
            : simulate_seen(scene, start_of(scene), request.until, request.options, recorders);
  if (files.samples && outcome.ending != Ending::reached)
    outcome.time = files.samples->at.reach(outcome.time);
  return outcome;
}

// Where the motion stood when the run was given up.
std::string place_of(const MotionState &state) {
  std::string place = " with";
  for (std::size_t i = 0; i < state.displacement.size(); ++i)
    fmt::format_to(std::back_inserter(place), "{}x{} = {}, x{}' = {}", i == 0 ? " " : ", ", i + 1,
                   state.displacement[i], i + 1, state.velocity[i]);
  return place;
}

// What the files of a run hold that did not come to its end.
std::string remark_on(const Files &files, bool state_wanted) {
  std::string remark;
  if (files.events || files.samples) remark += "; the tables hold what came before";
  if (state_wanted)
    remark += files.state ? "; the state reached is saved" : "; there is no state to be saved";
  return remark;
}

}  // namespace

void run_scene(const Request &request, int (*signal)()) {
  require_apart({{"--events", request.events},
                 {"--samples", request.samples},
                 {"--save-state", request.save_state},
                 {"--plot", request.plot}},
                {"--resume", request.resume});
  const std::optional<SavedRun> saved = saved_run(request);
  const Scene &scene = saved ? saved->scene : request.scene;
  Files files(request, saved, scene);
  remember_signals();
  const Outcome outcome = simulate_or_resume(request, saved, scene, signal, files);
  files.save({saved ? saved->scene_text : request.scene_text, scene, outcome.resume, outcome.time});
  files.finish();
  if (files.plot) files.plot->draw(outcome.time);
  const bool state_wanted = !request.save_state.empty();
  const std::string remark = remark_on(files, state_wanted);
  if (outcome.ending == Ending::given_up)
    throw std::runtime_error(outcome.reason + place_of(outcome.state) + remark);
  if (outcome.ending == Ending::stopped)  // a table that cannot be written has thrown in `finish`
    throw EndedBySignal{signal(), fmt::format("interrupted at t = {}{}", outcome.time, remark)};
  if (state_wanted && !files.state)
    throw std::runtime_error(
        fmt::format("--save-state {}: the state is out of range", request.save_state));
  summarise(outcome);
}

}  // namespace vibro_impact::runner
