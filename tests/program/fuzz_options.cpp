// One entry point for whatever a user or a file may hand to the project: the command line of the
// runner, its state files and the readers of the CSV tables. libFuzzer drives it (`make fuzz`);
// fuzz_inputs_test.cpp replays fixed inputs through it.
//
// The first byte chooses what the rest is: 'e' an event table, 'k' a table of key numbers, 's' a
// state file but for the two lines with checksums, which no fuzzer would guess; else a command
// line, one argument per line. What is wrong with an input may only be said by a std::runtime_error
// or a std::invalid_argument with a message; a command line that is accepted must pass `check`, and
// it and a state must run to their end or to the limit of impacts.
#include <fmt/format.h>

#include <algorithm>
#include <boost/crc.hpp>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "figures/event_tables.hpp"
#include "program/options.hpp"
#include "program/state_file.hpp"
#include "reference/table_reader.hpp"

namespace {

using namespace vibro_impact;

[[noreturn]] void fail(const std::string &what) {
  fmt::print(stderr, "fuzz: {}\n", what);
  std::abort();
}

// Time of a run of bounded work, short against the fastest rate of the scene; 0 for none.
double short_time(const Scene &scene) {
  if (scene.masses() > 12) return 0.0;  // the modes of a long chain take cubic work
  const double squared = largest_eigenvalue_bound(scene);
  return 200.0 / std::max({scene.omega, std::sqrt(squared), scene.beta * squared});
}

RunOptions with_few_impacts(RunOptions options) {
  options.max_impacts_per_period = std::min(options.max_impacts_per_period, 200LL);
  return options;
}

void require_order(const Outcome &outcome, const EventRecorder &events) {
  if (outcome.time < 0.0) fail("time runs backwards");
  if (outcome.ending == Ending::given_up && outcome.reason.empty())
    fail("given up without a reason");
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
  if (request.sweep) {
    try {
      check(request.sweep->grid);
    } catch (const std::invalid_argument &error) {
      fail(std::string("sweep accepted, then refused: ") + error.what());
    }
    return;
  }
  if (!request.resume.empty()) return;  // the scene would come from a file
  const Scene &scene = request.scene;
  try {
    check(scene);
  } catch (const std::invalid_argument &error) {
    fail(std::string("accepted, then refused: ") + error.what());
  }
  const double brief = short_time(scene);
  if (!(brief > 0.0)) return;  // rates beyond the range of double precision
  const double until = scene.stops.empty() ? request.until : std::min(request.until, brief);
  EventRecorder events;
  require_order(simulate(scene, until, with_few_impacts(request.options), events), events);
}

// A state that is read must be written as it stood, and gone on with or refused.
void take_state(const std::string &text) {
  const std::size_t end = text.find('\n', text.find("time ")) + 1;  // 0: none
  const std::string numbers = text.substr(end);
  boost::crc_32_type checksum;
  checksum.process_bytes(numbers.data(), numbers.size());
  const std::string others = text.substr(0, end) + "vibro-impact run state 4, checksum " +
                             std::to_string(checksum.checksum()) + "\n" + numbers;
  std::istringstream file(runner::first_line(others) + others);
  const runner::SavedRun saved = runner::read_saved_run(file, "state");
  const std::string written = runner::text_of(saved);
  std::istringstream again(written);
  if (runner::text_of(runner::read_saved_run(again, "state")) != written)
    fail("a state changes on its way through a file");
  const double brief = short_time(saved.scene);
  if (!(brief > 0.0 && brief < 1e300)) return;
  const double until = saved.time + brief;
  EventRecorder events;
  require_order(resume(saved.scene, saved.state, until, with_few_impacts({}), events), events);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size) {
  if (size == 0) return 0;
  const std::string text(reinterpret_cast<const char *>(data) + 1, size - 1);
  std::istringstream table(text);
  try {
    if (data[0] == 'e')
      for (const auto &cells : figures::read_rows(table, "events", 6))
        figures::event_in("events", cells);
    else if (data[0] == 'k')
      for (const auto &cells : figures::read_rows(table, "key numbers", 3))
        figures::number_in("key numbers", cells[1]);
    else if (data[0] == 's')
      take_state(text);
    else
      take_command_line(text);
  } catch (const std::runtime_error &error) {
    if (*error.what() == '\0') fail("an error without a message");
  } catch (const std::invalid_argument &error) {
    if (*error.what() == '\0') fail("an error without a message");
  }
  return 0;
}
