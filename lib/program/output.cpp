#include "output.hpp"

#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstring>
#include <filesystem>
#include <utility>

#include "interrupt.hpp"
#include "refuse.hpp"

namespace vibro_impact::runner {

namespace fs = std::filesystem;

Destination::Destination(const std::string &name)
    : path(name == "/dev/stdout" ? "-" : name), direct(path == "-") {
  if (direct) return;
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (fs::is_directory(status)) refuse("{}: is a directory, cannot be written", path);
  const bool link = fs::is_symlink(fs::symlink_status(path, error));
  if (link && !fs::exists(status)) refuse("{}: is a link that leads nowhere", path);
  // A file that is open already, under another name (2>log): what stands in it stays.
  const bool open = path == "/dev/stderr" || path.starts_with("/dev/fd/");
  direct = fs::exists(status) && (open || !fs::is_regular_file(status));
  if (link && !direct) path = fs::canonical(path, error).string();
}

// The number of the process makes the temporary name its own, and no file that is there already
// is opened under it.
Output::Output(const std::string &name)
    : to_(name), temporary_(to_.direct ? "" : fmt::format("{}.part{}", to_.path, getpid())) {
  file_ = to_.path == "-" ? fdopen(dup(STDOUT_FILENO), "a")
          : to_.direct    ? std::fopen(to_.path.c_str(), "ab")
                          : std::fopen(temporary_.c_str(), "wbx");
  if (file_ == nullptr)
    refuse("{}: cannot be written: {}", name,
           errno == EEXIST ? "another file is being written there" : std::strerror(errno));
}

Output::~Output() {
  if (file_ != nullptr) std::fclose(file_);
  std::error_code ignored;
  if (!temporary_.empty()) fs::remove(temporary_, ignored);
}

void Output::write(std::string_view text) {
  if (!failed() && std::fwrite(text.data(), 1, text.size(), file_) != text.size()) error_ = errno;
}

void Output::take(Table &rows) {
  write(rows.text);
  rows.text.clear();
}

void Output::complete() {
  if (std::fclose(std::exchange(file_, nullptr)) != 0 && !failed()) error_ = errno;
  if (error_ == EPIPE) throw EndedBySignal{SIGPIPE, ""};
  if (failed())
    throw std::runtime_error(
        fmt::format("{}: cannot be written: {}", to_.path, std::strerror(error_)));
}

void Output::put_in_place() {
  if (temporary_.empty()) return;
  fs::rename(temporary_, to_.path);
  temporary_.clear();
}

}  // namespace vibro_impact::runner
