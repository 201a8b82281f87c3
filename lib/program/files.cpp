#include "files.hpp"

#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <utility>

namespace vibro_impact::runner {

namespace fs = std::filesystem;

namespace {

// The file that an output names, behind links.
fs::path target_of(const Output &output) {
  std::error_code error;
  fs::path name = fs::weakly_canonical(fs::absolute(output.path), error);
  const fs::file_status status = error ? fs::file_status() : fs::status(name, error);
  if (error && status.type() != fs::file_type::not_found)
    refuse("{}: {}", output.given(), error.message());
  if (fs::is_symlink(fs::symlink_status(name, error)))
    refuse("{}: is a link to a file that is not there", output.given());
  if (fs::exists(status) && !fs::is_regular_file(status))
    refuse("{}: is no file, and cannot be replaced by one", output.given());
  return name;
}

}  // namespace

bool Output::is_file() const {
  std::error_code error;
  return wanted() && path != "-" && !fs::is_fifo(path, error);
}

std::string numbered_columns(const std::string &name, std::size_t count,
                             const std::string &behind) {
  std::string columns;
  for (std::size_t k = 1; k <= count; ++k) columns += fmt::format(",{}{}{}", name, k, behind);
  return columns;
}

void check_outputs(const std::vector<Output> &outputs, const std::string &scene_file) {
  std::vector<fs::path> names;
  if (!scene_file.empty()) names.push_back(target_of({"--scene", scene_file}));
  for (const Output &output : outputs) {
    if (!output.wanted()) continue;
    const fs::path name = output.is_file() ? target_of(output) : fs::path(output.path);
    if (std::ranges::find(names, name) != names.end())
      refuse("{}: the scene or another table of the command stands there", output.given());
    names.push_back(name);
    if (!output.is_file()) continue;
    const fs::path folder = name.parent_path();
    if (!fs::is_directory(folder)) refuse("{}: {} is no folder", output.given(), folder.string());
    if (access(folder.c_str(), W_OK | X_OK) != 0)
      refuse("{}: {} is write-protected", output.given(), folder.string());
  }
}

std::string contents(const std::string &path) {
  std::ifstream file(path, std::ios::binary);
  return std::string(std::istreambuf_iterator<char>(file), {});
}

OpenOutput::OpenOutput(const std::string &path) {
  if (path != "-") file_.emplace(path);
}

void OpenOutput::append(std::string_view text) {
  if (file_) return file_->append(text);
  if (std::fwrite(text.data(), 1, text.size(), stdout) != text.size() || std::fflush(stdout) != 0)
    throw std::runtime_error("standard output cannot be written");
}

void OpenOutput::finish() {
  if (file_) file_->finish();
}

void TemporaryFile::append(std::string_view text) const {
  if (!file_ || std::fwrite(text.data(), 1, text.size(), file_.get()) != text.size() ||
      std::fflush(file_.get()) != 0)
    throw std::runtime_error("a temporary file cannot be written");
}

void write_text(std::string_view text, const std::string &path) {
  OpenOutput output(path);
  output.append(text);
  output.finish();
}

std::string path_of(std::FILE *file) {
  return fmt::format("/proc/self/fd/{}", fileno(file));
}

}  // namespace vibro_impact::runner
