#include "destination.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>
#include <filesystem>

#include "bad_input.hpp"

namespace vibro_impact::runner {

namespace {

namespace fs = std::filesystem;

// True when a file can be made, or written to, at `path`; it is left as it was.
bool can_be_made(const std::string &path) {
  std::error_code error;
  const fs::file_status status = fs::symlink_status(path, error);
  if (fs::exists(status) && !fs::is_regular_file(status)) return false;
  std::FILE *file = std::fopen(path.c_str(), fs::exists(status) ? "rb+" : "wbx");
  if (file == nullptr) return false;
  std::fclose(file);
  if (!fs::exists(status)) fs::remove(path, error);
  return true;
}

bool is_standard_output(const std::string &path) {
  return path == "-" || path == "/dev/stdout" || path == "/dev/fd/1" || path == "/proc/self/fd/1";
}

// True when a file written to `path`, or on its way there, gets in the way of `other`.
bool meet(const std::string &path, const std::string &other) {
  const auto place = [](const std::string &of) {
    std::error_code error;
    return fs::weakly_canonical(fs::absolute(of, error), error).string();
  };
  std::error_code error;
  // Nothing in a terminal or in /dev/null is written over.
  if (fs::is_character_file(path, error) && fs::is_character_file(other, error)) return false;
  const std::string one = place(path), two = place(other);
  return one == two || one + ".part" == two || one == two + ".part";
}

struct Output {
  const char *option;
  const std::string &path;
};

void require_apart(const Output &one, const Output &two) {
  if (one.path.empty() || two.path.empty()) return;
  const bool first = is_standard_output(one.path), second = is_standard_output(two.path);
  if (first && second)
    throw BadInput(fmt::format("{} {} {} {}: only one of them can go to standard output",
                               one.option, one.path, two.option, two.path));
  if (!first && !second && meet(one.path, two.path))
    throw BadInput(fmt::format("{} {} {} {}: these need to be two files", one.option, one.path,
                               two.option, two.path));
}

}  // namespace

Destination destination(const std::string &option, const std::string &given) {
  if (given.empty()) return {};
  if (is_standard_output(given)) return {"-"};
  std::error_code error;
  const fs::file_status status = fs::status(given, error);
  // A file that is open already, under another name (2>log): what stands in it stays.
  if (fs::is_regular_file(status) && (given == "/dev/stderr" || given.starts_with("/dev/fd/")))
    return {given, true};
  if (fs::is_directory(status))
    throw BadInput(fmt::format("{} {}: is a directory, cannot be written", option, given));
  if (fs::exists(status) && !fs::is_regular_file(status)) {
    if (fs::is_socket(status) || access(given.c_str(), W_OK) != 0)
      throw BadInput(fmt::format("{} {}: cannot be written", option, given));
    return {given, true};
  }
  const bool link = fs::is_symlink(fs::symlink_status(given, error));
  if (link && !fs::exists(status))
    throw BadInput(fmt::format("{} {}: is a link that leads nowhere", option, given));
  const Destination to{link ? fs::canonical(given, error).string() : given};
  if (!can_be_made(to.temporary()))
    throw BadInput(fmt::format("{} {}: cannot be written", option, given));
  return to;
}

void require_apart(const Request &request) {
  const Output events{"--events", request.events}, samples{"--samples", request.samples},
      save_state{"--save-state", request.save_state}, plot{"--plot", request.plot},
      resume{"--resume", request.resume};
  require_apart(events, samples);
  require_apart(events, save_state);
  require_apart(samples, save_state);
  for (const Output &other : {events, samples, save_state, resume}) require_apart(plot, other);
  // The state is read before the run and may be replaced after it by the new one, but not by a
  // table.
  if (events.path != "-") require_apart(events, resume);
  if (samples.path != "-") require_apart(samples, resume);
}

}  // namespace vibro_impact::runner
