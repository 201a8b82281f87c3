// vibro-impact: runs the user's own scene and writes its event and sample tables.
#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <string>

#include "options.hpp"
#include "vibro_impact/table.hpp"

namespace {

using namespace vibro_impact;
using runner::BadInput;
using runner::Request;

// Fails before the run, not after it, when a table could not be written.
void require_writable(const std::string &option, const std::string &path) {
  if (path.empty() || path == "-") return;
  const std::string rule = fmt::format("{} {}: cannot be written", option, path);
  std::error_code error;
  if (std::filesystem::is_directory(path, error)) throw BadInput(rule);
  const std::string temporary = path + ".part";
  std::FILE *file = std::fopen(temporary.c_str(), "wb");
  if (file == nullptr) throw BadInput(rule);
  std::fclose(file);
  std::filesystem::remove(temporary, error);
}

Table event_table(const EventRecorder &recorder) {
  Table table("time,mass,event,velocity_before,velocity_after,contact_mode");
  for (const Event &event : recorder.events)
    table.row(event.time, event.mass, name(event.kind), event.velocity_before, event.velocity_after,
              contact_mode_name(event.held));
  return table;
}

Table sample_table(const SampleRecorder &recorder) {
  std::string header = "time";
  for (int i = 1; i <= recorder.masses; ++i) fmt::format_to(std::back_inserter(header), ",x{}", i);
  Table table(header);
  const auto masses = static_cast<std::size_t>(recorder.masses);
  for (std::size_t k = 0; k < recorder.times.size(); ++k) {
    fmt::format_to(std::back_inserter(table.text), "{:.17g}", recorder.times[k]);
    for (std::size_t i = 0; i < masses; ++i)
      fmt::format_to(std::back_inserter(table.text), ",{:.17g}",
                     recorder.displacements[masses * k + i]);
    table.text.push_back('\n');
  }
  return table;
}

void summarise(const Outcome &outcome) {
  const Counters &c = outcome.counters;
  fmt::print(stderr,
             "t = {:.17g}: {} impacts resolved, {} sticks, {} releases\n"
             "chatter: {} complete and carried to the limit, {} incomplete\n"
             "work: {} contact modes, {} expansions, {} root searches ({} stops dismissed), "
             "{} root iterations, {} modal evaluations\n",
             outcome.time, c.impacts, c.sticks, c.releases, c.chatter_limits, c.chatter_incomplete,
             c.modes_built, c.expansions, c.roots_searched, c.roots_dismissed, c.root_iterations,
             c.modal_evaluations);
}

// Only the recorders that are asked for take part in the run.
Outcome run(const Request &request, EventRecorder &events, SampleRecorder &samples) {
  const bool with_events = !request.events.empty(), with_samples = !request.samples.empty();
  if (with_events && with_samples)
    return simulate(request.scene, request.until, request.options, events, samples);
  if (with_events) return simulate(request.scene, request.until, request.options, events);
  if (with_samples) return simulate(request.scene, request.until, request.options, samples);
  return simulate(request.scene, request.until, request.options);
}

int fail(std::string message, int status) {
  std::replace(message.begin(), message.end(), '\n', ' ');
  fmt::print(stderr, "vibro-impact: {}\n", message);
  return status;
}

}  // namespace

int main(int argc, char **argv) {
  try {
    Request request;
    if (const auto answer = runner::parse(argc, argv, request)) {
      std::fputs(answer->text.c_str(), stdout);
      return 0;
    }
    require_writable("--events", request.events);
    require_writable("--samples", request.samples);
    EventRecorder events;
    events.from = request.from;
    SampleRecorder samples;
    samples.from = request.from;
    samples.to = request.until;
    samples.every = request.every;
    samples.masses = request.scene.masses();
    const Outcome outcome = run(request, events, samples);
    if (!request.events.empty()) write(event_table(events), request.events);
    if (!request.samples.empty()) write(sample_table(samples), request.samples);
    summarise(outcome);
    return 0;
  } catch (const std::invalid_argument &bad) {
    return fail(bad.what(), 2);
  } catch (const std::exception &failure) {
    return fail(failure.what(), 1);
  }
}
