#include "output.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <filesystem>
#include <stdexcept>
#include <system_error>
#include <utility>

#include "bad_input.hpp"

namespace vibro_impact::runner {

namespace {

namespace fs = std::filesystem;

bool is_standard_output(const std::string &path) {
  return path == "-" || path == "/dev/stdout" || path == "/dev/fd/1" || path == "/proc/self/fd/1";
}

// True when a file written to `path`, or on its way there, gets in the way of `other`.
bool meet(const std::string &path, const std::string &other) {
  const auto place = [](const std::string &of) {
    std::error_code error;
    return is_standard_output(of) ? "-"
                                  : fs::weakly_canonical(fs::absolute(of, error), error).string();
  };
  std::error_code error;
  // Nothing in a terminal or in /dev/null is written over.
  if (fs::is_character_file(path, error) && fs::is_character_file(other, error) &&
      !is_standard_output(path))
    return false;
  const std::string one = place(path), two = place(other);
  return one == two || one + ".part" == two || one == two + ".part";
}

std::string reason_of(int error) {
  return std::generic_category().message(error);
}

}  // namespace

Destination::Destination(const Named &file) : path(file.path), standard(is_standard_output(path)) {
  if (standard) return;
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (fs::is_directory(status))
    throw BadInput(fmt::format("{} {}: is a directory, cannot be written", file.option, path));
  const bool link = fs::is_symlink(fs::symlink_status(path, error));
  if (link && !fs::exists(status))
    throw BadInput(fmt::format("{} {}: is a link that leads nowhere", file.option, path));
  // A file that is open already, under another name (2>log): what stands in it stays.
  const bool open = path == "/dev/stderr" || path.starts_with("/dev/fd/");
  direct = fs::exists(status) && (open || !fs::is_regular_file(status));
  if (link && !direct) path = fs::canonical(path, error).string();
}

void require_apart(const std::vector<Named> &written, const Named &read) {
  const auto require = [](const Named &one, const Named &two) {
    if (!one.path.empty() && !two.path.empty() && meet(one.path, two.path))
      throw BadInput(fmt::format("{} {} {} {}: these need to be two files", one.option, one.path,
                                 two.option, two.path));
  };
  for (std::size_t k = 0; k < written.size(); ++k)
    for (std::size_t j = 0; j < k; ++j) require(written[j], written[k]);
  for (const Named &file : written)
    if (!is_standard_output(file.path) && file.option != "--save-state") require(file, read);
}

Output::Output(const Named &file)
    : to_(file), temporary_(to_.standard || to_.direct ? "" : to_.path + ".part") {
  file_ = to_.standard ? stdout
                       : std::fopen(to_.direct ? to_.path.c_str() : temporary_.c_str(),
                                    to_.direct ? "ab" : "wb");
  if (file_ == nullptr)
    throw BadInput(
        fmt::format("{} {}: cannot be written: {}", file.option, file.path, reason_of(errno)));
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
  if (to_.standard && error_ == EPIPE) throw ReaderLeft{};
  if (failed())
    throw std::runtime_error(fmt::format("{}: cannot be written: {}",
                                         to_.standard ? "standard output" : to_.path,
                                         reason_of(error_)));
}

void Output::put_in_place() {
  if (temporary_.empty()) return;
  std::error_code error;
  fs::rename(temporary_, to_.path, error);
  if (error)
    throw std::runtime_error(fmt::format("{}: cannot be written: {}", to_.path, error.message()));
  temporary_.clear();
}

}  // namespace vibro_impact::runner
