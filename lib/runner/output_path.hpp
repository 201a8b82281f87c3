// Where a table goes, settled before the run: a long run must not fail at its end.
#pragma once

#include <fmt/format.h>

#include <cstdio>
#include <filesystem>
#include <string>

#include "options.hpp"

namespace vibro_impact::runner {

// The path to write for the one given (empty: no table, `-`: standard output). A link is followed,
// for the table is renamed into place and would otherwise replace the link. Throws BadInput when a
// file cannot be made there; leaves nothing behind and touches no file that exists.
inline std::string output_path(const std::string &option, const std::string &given) {
  namespace fs = std::filesystem;
  if (given.empty() || given == "-") return given;
  std::error_code error;
  const fs::file_status status = fs::status(given, error);
  // Renaming a table onto a device or a pipe would replace it by a file.
  if (fs::exists(status) && !fs::is_regular_file(status))
    throw BadInput(
        fmt::format("{} {}: is not a regular file, cannot be written; - is standard "
                    "output",
                    option, given));
  const bool link = fs::is_symlink(fs::symlink_status(given, error));
  const std::string path = link ? fs::canonical(given, error).string() : given;
  const std::string temporary = path + ".part";  // the name `write` uses
  const bool there = fs::exists(fs::symlink_status(temporary, error));
  std::FILE *file = path.empty() ? nullptr : std::fopen(temporary.c_str(), there ? "rb+" : "wbx");
  if (file == nullptr) throw BadInput(fmt::format("{} {}: cannot be written", option, given));
  std::fclose(file);
  if (!there) fs::remove(temporary, error);
  return path;
}

// Throws BadInput when both tables would go to the same place.
inline void require_apart(const std::string &events, const std::string &samples) {
  if (events.empty() || samples.empty()) return;
  if (events == "-" && samples == "-")
    throw BadInput("--events - --samples -: only one table can go to standard output");
  if (events == "-" || samples == "-") return;
  const auto place = [](const std::string &path) {
    return std::filesystem::weakly_canonical(std::filesystem::absolute(path));
  };
  if (place(events) == place(samples))
    throw BadInput(
        fmt::format("--events {} --samples {}: the tables need two files", events, samples));
}

}  // namespace vibro_impact::runner
