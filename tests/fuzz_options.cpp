// One entry point for whatever a user or a file may hand to the project: the command line of the
// runner and the readers of the CSV tables. libFuzzer drives it (`make fuzz`); fuzz_inputs_test.cpp
// replays fixed inputs through it.
//
// The first byte chooses what the rest is: 'e' an event table, 'k' a table of key numbers, else a
// command line, one argument per line. What is wrong with an input may only be said by a
// std::runtime_error or a std::invalid_argument with a message; a command line that is accepted
// must pass `check` and run to its end or to the limit of impacts.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <new>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "event_tables.hpp"
#include "options.hpp"
#include "table_reader.hpp"

namespace {

using namespace vibro_impact;

[[noreturn]] void fail(const std::string &what) {
  fmt::print(stderr, "fuzz: {}\n", what);
  std::abort();
}

// A run of bounded work: short against the fastest rate of the scene, few impacts.
void run_shortly(const runner::Request &request) {
  const Scene &scene = request.scene;
  if (scene.masses() > 12) return;  // the modes of a long chain take cubic work
  const double squared = largest_eigenvalue_bound(scene);
  const double rate = std::max({scene.omega, std::sqrt(squared), scene.beta * squared});
  RunOptions options = request.options;
  options.max_impacts_per_period = std::min(options.max_impacts_per_period, 200LL);
  EventRecorder events;
  const double until = scene.stops.empty() ? request.until : std::min(request.until, 200.0 / rate);
  if (!(until > 0.0)) return;  // rates beyond the range of double precision
  try {
    const Outcome outcome = simulate(scene, until, options, events);
    if (outcome.time < 0.0) fail("time runs backwards");
  } catch (const std::runtime_error &) {  // the limit of impacts
  }
  for (std::size_t i = 1; i < events.events.size(); ++i)
    if (events.events[i].time < events.events[i - 1].time) fail("events out of order");
}

void take_command_line(const std::string &text) {
  std::vector<std::string> words{"vibro-impact"};
  std::istringstream stream(text);
  for (std::string word; std::getline(stream, word);) words.push_back(word);
  std::vector<char *> arguments;
  for (std::string &word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  runner::Request request;
  if (runner::parse(static_cast<int>(words.size()), arguments.data(), request)) return;
  try {
    check(request.scene);
  } catch (const std::invalid_argument &error) {
    fail(std::string("accepted, then refused: ") + error.what());
  }
  run_shortly(request);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size) {
  if (size == 0) return 0;
  const std::string text(reinterpret_cast<const char *>(data) + 1, size - 1);
  std::istringstream table(text);
  try {
    if (data[0] == 'e')
      figures::read_event_table(table, "events");
    else if (data[0] == 'k')
      figures::read_references(table, "key numbers");
    else
      take_command_line(text);
  } catch (const std::runtime_error &error) {
    if (*error.what() == '\0') fail("an error without a message");
  } catch (const std::invalid_argument &error) {
    if (*error.what() == '\0') fail("an error without a message");
  }
  return 0;
}
