#include "streamed_file.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <filesystem>
#include <stdexcept>
#include <system_error>
#include <utility>

namespace vibro_impact::runner {

StreamedFile::StreamedFile(Destination to) : to_(std::move(to)) {
}

StreamedFile::~StreamedFile() {
  if (file_ != nullptr && file_ != stdout) std::fclose(file_);
  std::error_code ignored;
  if (temporary_) std::filesystem::remove(to_.temporary(), ignored);
}

void StreamedFile::fail() {
  if (failed()) return;
  const std::string reason = std::generic_category().message(errno);
  error_ = fmt::format("{}: cannot be written: {}", to_.path == "-" ? "standard output" : to_.path,
                       reason);
}

void StreamedFile::write(std::string_view text) {
  if (failed()) return;
  if (file_ == nullptr) {
    const bool standard = to_.path == "-";
    const std::string name = to_.direct ? to_.path : to_.temporary();
    file_ = standard ? stdout : std::fopen(name.c_str(), to_.direct ? "ab" : "wb");
    if (file_ == nullptr) return fail();
    temporary_ = !standard && !to_.direct;
  }
  // Every block goes out at once: the reader of a pipe waits for it, a full disk shows.
  if (std::fwrite(text.data(), 1, text.size(), file_) != text.size() || std::fflush(file_) != 0)
    fail();
}

void StreamedFile::complete() {
  write("");
  if (file_ != nullptr && file_ != stdout && std::fclose(std::exchange(file_, nullptr)) != 0)
    fail();
  throw_error();
}

void StreamedFile::put_in_place() {
  if (!temporary_) return;
  std::error_code error;
  std::filesystem::rename(to_.temporary(), to_.path, error);
  if (error)
    throw std::runtime_error(fmt::format("{}: cannot be written: {}", to_.path, error.message()));
  temporary_ = false;
}

void StreamedFile::throw_error() const {
  if (failed()) throw std::runtime_error(error_);
}

}  // namespace vibro_impact::runner
