// vibro-impact: runs the user's own scene and writes its event and sample tables.
#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <exception>
#include <iterator>
#include <stdexcept>
#include <string>

#include "options.hpp"
#include "output_path.hpp"
#include "vibro_impact/table.hpp"

namespace {

using namespace vibro_impact;
using runner::Request;

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
             c.modes_built, c.expansions, c.roots_searched + c.crossings_sought,
             c.roots_dismissed + c.stops_out_of_reach, c.root_iterations, c.modal_evaluations);
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
    runner::require_apart(request.events, request.samples);
    request.events = runner::output_path("--events", request.events);
    request.samples = runner::output_path("--samples", request.samples);
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
