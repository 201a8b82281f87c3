#include "output.hpp"

#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstring>
#include <filesystem>
#include <stdexcept>
#include <utility>

#include "interrupt.hpp"
#include "refuse.hpp"

namespace vibro_impact::runner {

namespace {

namespace fs = std::filesystem;

bool is_standard_output(const std::string &path) {
  return path == "-" || path == "/dev/stdout" || path == "/dev/fd/1" || path == "/proc/self/fd/1";
}

// True when a file written to `path` gets in the way of `other`.
bool meet(const std::string &path, const std::string &other) {
  if (is_standard_output(path) || is_standard_output(other))
    return is_standard_output(path) && is_standard_output(other);
  std::error_code error;
  // Nothing in a terminal or in /dev/null is written over.
  return !fs::is_character_file(path, error) &&
         fs::weakly_canonical(fs::absolute(path), error) ==
             fs::weakly_canonical(fs::absolute(other), error);
}

[[noreturn]] void fail(const std::string &path, int error) {
  throw std::runtime_error(fmt::format("{}: cannot be written: {}", path, std::strerror(error)));
}

}  // namespace

Destination::Destination(const Named &file)
    : path(file.path), standard(is_standard_output(path)), direct(standard) {
  if (standard) return;
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (fs::is_directory(status))
    refuse("{} {}: is a directory, cannot be written", file.option, path);
  const bool link = fs::is_symlink(fs::symlink_status(path, error));
  if (link && !fs::exists(status)) refuse("{} {}: is a link that leads nowhere", file.option, path);
  // A file that is open already, under another name (2>log): what stands in it stays.
  const bool open = path == "/dev/stderr" || path.starts_with("/dev/fd/");
  direct = fs::exists(status) && (open || !fs::is_regular_file(status));
  if (link && !direct) path = fs::canonical(path, error).string();
}

void require_apart(const std::vector<Named> &written, const Named &read) {
  const auto require = [](const Named &one, const Named &two) {
    if (!one.path.empty() && !two.path.empty() && meet(one.path, two.path))
      refuse("{} {} {} {}: these need to be two files", one.option, one.path, two.option, two.path);
  };
  for (std::size_t k = 0; k < written.size(); ++k) {
    for (std::size_t j = 0; j < k; ++j) require(written[j], written[k]);
    if (!is_standard_output(written[k].path) && written[k].option != "--save-state")
      require(written[k], read);
  }
}

// The number of the process makes the temporary name its own, and no file that is there already
// is opened under it.
Output::Output(const Named &file)
    : to_(file), temporary_(to_.direct ? "" : fmt::format("{}.part{}", to_.path, getpid())) {
  file_ = to_.standard ? stdout
          : to_.direct ? std::fopen(to_.path.c_str(), "ab")
                       : std::fopen(temporary_.c_str(), "wbx");
  if (file_ == nullptr)
    refuse("{} {}: cannot be written: {}", file.option, file.path, std::strerror(errno));
}

Output::~Output() {
  if (file_ != nullptr && file_ != stdout) std::fclose(file_);
  std::error_code ignored;
  if (!temporary_.empty()) fs::remove(temporary_, ignored);
}

void Output::write(std::string_view text) {
  // Every block goes out at once: the reader of a pipe waits for it, a full disk shows.
  if (!failed() &&
      (std::fwrite(text.data(), 1, text.size(), file_) != text.size() || std::fflush(file_) != 0))
    error_ = errno;
}

void Output::complete() {
  if (file_ != stdout && std::fclose(std::exchange(file_, nullptr)) != 0 && !failed())
    error_ = errno;
  if (to_.standard && error_ == EPIPE) throw EndedBySignal{SIGPIPE, ""};
  if (failed()) fail(to_.standard ? "standard output" : to_.path, error_);
}

void Output::put_in_place() {
  if (temporary_.empty()) return;
  if (std::rename(temporary_.c_str(), to_.path.c_str()) != 0) fail(to_.path, errno);
  temporary_.clear();
}

}  // namespace vibro_impact::runner
