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

#include "bad_input.hpp"
#include "destination.hpp"
#include "plot.hpp"
#include "progress.hpp"
#include "state_file.hpp"
#include "streamed_file.hpp"
#include "tables.hpp"
#include "watch.hpp"

namespace vibro_impact::runner {

namespace {

// To standard error, come what may: a terminal that is gone does not undo what the run has done.
void say(const std::string &text) {
  std::fputs(text.c_str(), stderr);
}

void summarise(const Outcome &outcome) {
  const Counters &c = outcome.counters;
  say(
      fmt::format("t = {:.17g}: {} impacts resolved, {} sticks, {} releases\n"
                  "chatter: {} complete and carried to the limit, {} incomplete\n"
                  "work: {} contact modes, {} expansions, {} root searches ({} stops dismissed), "
                  "{} root iterations, {} modal evaluations\n",
                  outcome.time, c.impacts, c.sticks, c.releases, c.chatter_limits,
                  c.chatter_incomplete, c.modes_built, c.expansions, c.roots_searched,
                  c.roots_dismissed + c.stops_clear, c.root_iterations, c.modal_evaluations));
}

// The saved run to go on with; nothing: the run starts at t = 0.
std::optional<SavedRun> saved_run(const Request &request) {
  if (request.resume.empty()) return std::nullopt;
  SavedRun saved = read_saved_run(request.resume);
  if (request.until < saved.time)
    throw BadInput(fmt::format("--until {}: lies before the end {} of the run saved in {}",
                               request.until, saved.time, request.resume));
  return saved;
}

// The files of one run. A table that is not asked for takes no part in it.
struct Files {
  std::optional<StreamedTable> events, samples;
  std::optional<StreamedFile> state;
};

// The recorders that write the tables.
struct Recorders {
  std::optional<EventRows> events;
  std::optional<SampleRows> samples;
  std::vector<RecorderRef> all = {};

  Recorders(const Request &request, const std::optional<SavedRun> &saved, Files &files) {
    if (files.events)
      all.push_back(recorder_ref(events.emplace(EventRows{*files.events, request.from})));
    if (!files.samples) return;
    // The samples of one whole run, but for those that the first part of it has written.
    const std::size_t taken =
        saved ? samples_taken(request.from, request.every, saved->time) : std::size_t{0};
    all.push_back(recorder_ref(samples.emplace(
        SampleRows{*files.samples, request.from, request.until, request.every, taken})));
  }
};

// Where the tables go to the terminal on which it would stand, no progress line mixes with them.
Progress progress_of(const Request &request, double begin) {
  const bool table_on_screen = (request.events == "-" || request.samples == "-") &&
                               isatty(STDOUT_FILENO) != 0 && isatty(STDERR_FILENO) != 0;
  return {"time", request.until, request.progress, begin,
          Progress::Screen{stderr, isatty(STDERR_FILENO) != 0 && !table_on_screen}};
}

// The outcome, in which `time` is the one up to which the tables reach.
Outcome simulate_or_resume(const Request &request, const std::optional<SavedRun> &saved,
                           const Scene &scene, int (*signal)(), Files &files,
                           std::optional<Plot> &plot) {
  Recorders tables(request, saved, files);
  if (plot) tables.all.push_back(recorder_ref(*plot));
  const double begin = saved ? saved->time : 0.0;
  Progress progress = progress_of(request, begin);
  Watch watch(begin, request.until, signal, progress, tables.all);
  std::vector<RecorderRef> recorders{recorder_ref(watch)};
  recorders.insert(recorders.end(), tables.all.begin(), tables.all.end());
  Outcome outcome =
      saved ? resume_seen(scene, saved->state, request.until, request.options, recorders)
            : simulate_seen(scene, start_of(scene), request.until, request.options, recorders);
  outcome.counters.modal_evaluations -= watch.looks();
  if (tables.samples && outcome.ending != Ending::reached)
    outcome.time = tables.samples->reach(outcome.time);
  return outcome;
}

// First all are closed, then all put in place: one that cannot be written leaves none behind.
void finish(Files &files) {
  if (files.events) files.events->complete();
  if (files.samples) files.samples->complete();
  if (files.state) files.state->complete();
  if (files.events) files.events->file.put_in_place();
  if (files.samples) files.samples->file.put_in_place();
  if (files.state) files.state->put_in_place();
}

// A run that was given up may be gone on with, too, under another limit of impacts: unless its
// numbers have left the range of double precision.
void save_state(const Destination &to, const SavedRun &run, Files &files) {
  if (to.path.empty()) return;
  const auto text = text_of(run);
  if (text) files.state.emplace(to).write(*text);
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

int run_scene(const Request &request, int (*signal)()) {
  require_apart(request);
  const Destination events = destination("--events", request.events),
                    samples = destination("--samples", request.samples),
                    state = destination("--save-state", request.save_state),
                    picture = destination("--plot", request.plot);
  const std::optional<SavedRun> saved = saved_run(request);
  const Scene &scene = saved ? saved->scene : request.scene;
  std::optional<Plot> plot;
  if (!picture.path.empty())
    plot.emplace(picture, scene, saved ? saved->state.held() : start_of(scene).held,
                 saved ? std::max(request.from, saved->time) : request.from, request.until);
  Files files;
  if (!events.path.empty()) files.events.emplace(events, event_header);
  if (!samples.path.empty()) files.samples.emplace(samples, sample_header(scene.masses()));
  const Outcome outcome = simulate_or_resume(request, saved, scene, signal, files, plot);
  save_state(state, {scene, outcome.resume, outcome.time}, files);
  finish(files);
  if (plot) plot->draw(outcome.time);
  const std::string remark = remark_on(files, !state.path.empty());
  if (outcome.ending == Ending::given_up)
    throw std::runtime_error(outcome.reason + place_of(outcome.state) + remark);
  if (outcome.ending == Ending::stopped) {  // a table that cannot be written has thrown in `finish`
    say(fmt::format("vibro-impact: interrupted at t = {}{}\n", outcome.time, remark));
    return 128 + signal();
  }
  if (!state.path.empty() && !files.state)
    throw std::runtime_error(fmt::format("--save-state {}: the state is out of range", state.path));
  summarise(outcome);
  return 0;
}

}  // namespace vibro_impact::runner
