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

constexpr std::string_view kind = "vibro-impact state ", version = "2";

// More stops than this no chain the runner takes can have.
constexpr std::size_t most_stops = 20000;

// The lines of the scene in their order, once for both directions: `lines` writes or reads them.
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
  writer.text += save(run.state);
  writer.text += checksum_line(writer.text);
  try {
    std::istringstream file(writer.text);
    read_saved_run(file, "");
  } catch (const std::invalid_argument &) {
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
  std::string state, next = reader.next_line();  // the library's own lines, up to the checksum
  for (; !next.starts_with("checksum "); next = reader.next_line()) state += next + "\n";
  reader.checksum.add(state);
  if (next + "\n" != reader.checksum.line())
    reader.fail("the checksum does not fit: the file was changed");
  if (file.peek() != std::istream::traits_type::eof()) {
    ++reader.number;
    reader.fail("nothing may follow the checksum");
  }
  check(run.scene);
  run.state = load(run.scene, state);
  return run;
}

SavedRun read_saved_run(const std::string &path) {
  const std::string name = fmt::format("--resume {}", path);
  std::ifstream file(path, std::ios::binary);
  if (!file) throw BadInput(fmt::format("{}: cannot be read", name));
  return read_saved_run(file, name);
}

}  // namespace vibro_impact::runner
