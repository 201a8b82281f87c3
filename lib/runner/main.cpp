// vibro-impact: runs the user's own scene and writes its event and sample tables.
#include <fmt/format.h>

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <exception>
#include <iterator>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "bad_input.hpp"
#include "destination.hpp"
#include "options.hpp"
#include "state_file.hpp"
#include "streamed_file.hpp"
#include "tables.hpp"

namespace {

using namespace vibro_impact;
using namespace vibro_impact::runner;

void summarise(const Outcome &outcome) {
  const Counters &c = outcome.counters;
  fmt::print(stderr,
             "t = {:.17g}: {} impacts resolved, {} sticks, {} releases\n"
             "chatter: {} complete and carried to the limit, {} incomplete\n"
             "work: {} contact modes, {} expansions, {} root searches ({} stops dismissed), "
             "{} root iterations, {} modal evaluations\n",
             outcome.time, c.impacts, c.sticks, c.releases, c.chatter_limits, c.chatter_incomplete,
             c.modes_built, c.expansions, c.roots_searched, c.roots_dismissed + c.stops_clear,
             c.root_iterations, c.modal_evaluations);
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

Outcome simulate_or_resume(const Request &request, const std::optional<SavedRun> &saved,
                           const Scene &scene, Files &files) {
  std::vector<RecorderRef> recorders;
  std::optional<EventRows> events;
  std::optional<SampleRows> samples;
  if (files.events)
    recorders.push_back(recorder_ref(events.emplace(EventRows{*files.events, request.from})));
  if (files.samples) {
    // The samples of one whole run, but for those that the first part of it has written.
    const std::size_t taken =
        saved ? samples_taken(request.from, request.every, saved->time) : std::size_t{0};
    recorders.push_back(recorder_ref(samples.emplace(
        SampleRows{*files.samples, request.from, request.until, request.every, taken})));
  }
  if (saved) return resume_seen(scene, saved->state, request.until, request.options, recorders);
  return simulate_seen(scene, start_of(scene), request.until, request.options, recorders);
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

// Where the motion stood when the run was given up, and what the files hold then.
std::string remark_on(const MotionState &state, const Files &files, bool state_wanted) {
  std::string remark = " with";
  for (std::size_t i = 0; i < state.displacement.size(); ++i)
    fmt::format_to(std::back_inserter(remark), "{}x{} = {}, x{}' = {}", i == 0 ? " " : ", ", i + 1,
                   state.displacement[i], i + 1, state.velocity[i]);
  if (files.events || files.samples) remark += "; the tables hold what came before";
  if (state_wanted)
    remark += files.state ? "; the state reached is saved" : "; there is no state to be saved";
  return remark;
}

void run(const Request &request) {
  require_apart(request);
  const Destination events = destination("--events", request.events),
                    samples = destination("--samples", request.samples),
                    state = destination("--save-state", request.save_state);
  const std::optional<SavedRun> saved = saved_run(request);
  const Scene &scene = saved ? saved->scene : request.scene;
  Files files;
  if (!events.path.empty()) files.events.emplace(events, event_header);
  if (!samples.path.empty()) files.samples.emplace(samples, sample_header(scene.masses()));
  const Outcome outcome = simulate_or_resume(request, saved, scene, files);
  save_state(state, {scene, outcome.resume, outcome.time}, files);
  finish(files);
  if (outcome.ending == Ending::given_up)
    throw std::runtime_error(outcome.reason + remark_on(outcome.state, files, !state.path.empty()));
  if (!state.path.empty() && !files.state)
    throw std::runtime_error(fmt::format("--save-state {}: the state is out of range", state.path));
  summarise(outcome);
}

int fail(std::string message, int status) {
  std::replace(message.begin(), message.end(), '\n', ' ');
  fmt::print(stderr, "vibro-impact: {}\n", message);
  return status;
}

}  // namespace

int main(int argc, char **argv) {
  // A reader that leaves the pipe is met like a full disk: with a message, and no table half
  // written.
  std::signal(SIGPIPE, SIG_IGN);
  std::signal(SIGXFSZ, SIG_IGN);
  try {
    Request request;
    if (const auto answer = parse(argc, argv, request)) {
      StreamedFile out(Destination{"-"});
      out.write(answer->text);
      out.complete();
      return 0;
    }
    run(request);
    return 0;
  } catch (const std::invalid_argument &bad) {
    return fail(bad.what(), 2);
  } catch (const std::exception &failure) {
    return fail(failure.what(), 1);
  }
}
