#include "state_file.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <concepts>
#include <cstdint>
#include <fstream>
#include <iterator>
#include <sstream>
#include <vector>

#include "bad_input.hpp"
#include "checksum.hpp"

namespace vibro_impact::runner {

namespace {

constexpr std::string_view kind = "vibro-impact state ", version = "1";

// More stops than this no chain the runner takes can have.
constexpr std::size_t most_stops = 20000;

// A number that may be infinite; no other one may.
template <class Number>
struct OrInfinite {
  Number &value;
};

// The lines of the format in their order, once for both directions: `lines` writes or reads them.
template <class Lines, class Run>
void pass(Lines &lines, Run &run) {
  auto &[scene, state, time] = run;
  lines.line("mass", scene.mass);
  lines.line("stiffness", scene.stiffness);
  lines.line("beta", scene.beta);
  lines.line("amplitude", scene.amplitude);
  lines.line("omega", scene.omega);
  lines.line("restitution", scene.restitution);
  lines.line("initial_displacement", scene.displacement);
  lines.line("initial_velocity", scene.velocity);
  lines.entries("stops", scene.stops);
  for (auto &stop : scene.stops)
    lines.line("stop", stop.mass, stop.side, stop.position, stop.restitution);
  lines.line("time", time);
  lines.line("instant", state.instant.cycle, state.instant.phase);
  lines.line("held", state.held);
  lines.line("modal_values", state.value);
  lines.line("modal_slopes", state.slope);
  lines.entries("states_at_stops", state.stops);
  for (auto &at : state.stops)
    lines.line("at_stop", at.gap, at.speed, at.zeros, at.leading, at.below_rounding, at.last_speed,
               at.falling);
  lines.line("next_flight", OrInfinite<decltype((state.next_flight))>{state.next_flight});
  lines.line("clear", state.clear);
  lines.line("events_told", state.told);
  lines.line("period_start", state.period_start.cycle, state.period_start.phase);
  lines.line("impacts_this_period", state.impacts_this_period);
}

struct Writer {
  std::string text;

  template <class... Values>
  void line(const char *key, const Values &...values) {
    text += key;
    (put(values), ...);
    text.push_back('\n');
  }
  template <class Entry>
  void entries(const char *key, const std::vector<Entry> &values) {
    line(key, values.size());
  }

  void put(double value) {
    fmt::format_to(std::back_inserter(text), " {:.17g}", value);
  }
  void put(std::integral auto value) {
    fmt::format_to(std::back_inserter(text), " {:d}", value);
  }
  void put(Side side) {
    text.push_back(' ');
    text += name(side);
  }
  void put(const std::optional<double> &value) {
    if (value) put(*value);
  }
  template <class Value>
  void put(const std::vector<Value> &values) {
    for (const Value value : values) put(value);
  }
  template <class Number>
  void put(const OrInfinite<Number> &number) {
    put(number.value);
  }
};

struct Reader {
  std::istream &file;
  const std::string &file_name;
  int number = 0;  // of the current line
  Checksum checksum = {};
  std::vector<std::string> words = {};
  std::size_t next = 0;  // word not yet read

  [[noreturn]] void fail(const std::string &what) const {
    throw BadInput(fmt::format("{} line {}: {}", file_name, number, what));
  }

  // The next line without its end, which must be there.
  std::string next_line() {
    ++number;
    std::string line;
    if (!std::getline(file, line) || file.eof()) fail("the file is cut short");
    return line;
  }

  // The words of the next line, which must begin with `key`.
  void open(const char *key) {
    const std::string line = next_line();
    checksum.add(line);
    checksum.add("\n");
    words.assign(1, "");
    for (const char c : line) {
      if (c == ' ')
        words.emplace_back();
      else
        words.back().push_back(c);
    }
    if (words.front() != key) fail(fmt::format("'{}' expected, not '{:.40}'", key, words.front()));
    next = 1;
  }

  template <class... Values>
  void line(const char *key, Values &&...values) {
    open(key);
    (take(values), ...);
    if (next < words.size()) fail(fmt::format("'{:.40}' is one value too many", words[next]));
  }
  template <class Entry>
  void entries(const char *key, std::vector<Entry> &values) {
    std::size_t size = 0;
    line(key, size);
    if (size > most_stops) fail(fmt::format("{} are too many", size));
    values.resize(size);
  }

  const std::string &word() {
    if (next == words.size()) fail(fmt::format("'{}' lacks a value", words.front()));
    return words[next++];
  }
  template <class Number>
  Number value_of(const std::string &token) const {
    Number value{};
    const char *end = token.data() + token.size();
    const auto [stop, error] = std::from_chars(token.data(), end, value);
    if (stop != end || error == std::errc::invalid_argument)
      fail(fmt::format("'{:.40}' is not a {}", token,
                       std::is_integral_v<Number> ? "whole number in range" : "number"));
    if (error != std::errc()) fail(fmt::format("'{:.40}' is out of range", token));
    return value;
  }

  void take(double &value) {
    const std::string &token = word();
    value = value_of<double>(token);
    if (!std::isfinite(value)) fail(fmt::format("'{:.40}' is not finite", token));
  }
  template <class Number>
  void take(OrInfinite<Number> &number_or_infinite) {
    const std::string &token = word();
    number_or_infinite.value = value_of<double>(token);
    if (std::isnan(number_or_infinite.value)) fail(fmt::format("'{:.40}' is not a number", token));
  }
  void take(bool &value) {
    const std::string &token = word();
    if (token != "0" && token != "1") fail(fmt::format("'{:.40}' is neither 0 nor 1", token));
    value = token == "1";
  }
  // Whole numbers count something: none is negative, and all stay exact as doubles.
  void take(std::integral auto &value) {
    const std::string &token = word();
    value = value_of<std::remove_reference_t<decltype(value)>>(token);
    if (value < 0 || static_cast<double>(value) > 0x1p53)
      fail(fmt::format("'{:.40}' is out of range", token));
  }
  void take(Side &side) {
    const std::string &token = word();
    if (token != "lower" && token != "upper")
      fail(fmt::format("'{:.40}' is neither lower nor upper", token));
    side = token == "lower" ? Side::lower : Side::upper;
  }
  void take(std::optional<double> &value) {
    if (next < words.size()) take(value.emplace());
  }
  void take(std::vector<double> &values) {
    while (next < words.size()) take(values.emplace_back());
  }
  void take(Held &held) {
    while (next < words.size()) {
      const std::string &token = word();
      if (token != "-1" && token != "0" && token != "1")
        fail(fmt::format("'{:.40}' is none of -1, 0 and 1", token));
      held.push_back(value_of<signed char>(token));
    }
  }
};

// The first line, byte by byte at first: what is not a state file may have no lines at all.
void take_header(Reader &reader) {
  std::string start(kind.size(), '\0');
  reader.file.read(start.data(), static_cast<std::streamsize>(start.size()));
  if (!reader.file || start != kind)
    throw BadInput(fmt::format("{}: is not a state file", reader.file_name));
  const std::string found = reader.next_line();
  if (found != version)
    reader.fail(fmt::format("state files of version {} are read, not of '{:.40}'", version, found));
  reader.checksum.add(fmt::format("{}{}\n", kind, version));
}

}  // namespace

std::optional<std::string> text_of(const SavedRun &run) {
  Writer writer{fmt::format("{}{}\n", kind, version)};
  pass(writer, run);
  writer.text += checksum_line(writer.text);
  try {
    std::istringstream file(writer.text);
    read_saved_run(file, "");
  } catch (const BadInput &) {
    return std::nullopt;
  }
  return writer.text;
}

std::string checksum_line(std::string_view text) {
  Checksum checksum;
  checksum.add(text);
  return checksum.line();
}

SavedRun read_saved_run(std::istream &file, const std::string &name) {
  Reader reader{file, name};
  SavedRun run;
  take_header(reader);
  pass(reader, run);
  const std::string expected = reader.checksum.line(), found = reader.next_line() + "\n";
  if (found.compare(0, 9, expected, 0, 9) != 0)
    reader.fail("'checksum' expected: the file has too many lines");
  if (found != expected) reader.fail("the checksum does not fit: the file was changed");
  if (file.peek() != std::istream::traits_type::eof()) {
    ++reader.number;
    reader.fail("nothing may follow the checksum");
  }
  check(run.scene);
  return run;
}

SavedRun read_saved_run(const std::string &path) {
  const std::string name = fmt::format("--resume {}", path);
  std::ifstream file(path, std::ios::binary);
  if (!file) throw BadInput(fmt::format("{}: cannot be read", name));
  return read_saved_run(file, name);
}

}  // namespace vibro_impact::runner
