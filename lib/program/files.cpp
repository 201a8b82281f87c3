#include "files.hpp"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <stdexcept>

#include "refuse.hpp"

namespace vibro_impact::runner {

namespace fs = std::filesystem;

void check_files(const std::vector<std::pair<std::string, std::string>> &files) {
  std::vector<fs::path> names;
  for (const auto &[option, path] : files) {
    if (path.empty()) continue;
    const fs::path name = path == "-" ? fs::path(path) : fs::weakly_canonical(fs::absolute(path));
    if (path != "-" && !fs::is_directory(name.parent_path()))
      refuse("{} {}: {} is no folder", option, path, name.parent_path().string());
    if (path != "-" && fs::exists(name) && !fs::is_regular_file(name))
      refuse("{} {}: is no file, and cannot be replaced by one", option, path);
    if (std::find(names.begin(), names.end(), name) != names.end())
      refuse("{} {}: another file of the run has that name", option, path);
    names.push_back(name);
  }
}

void write_table(const Table &table, const std::string &path) {
  if (path != "-") return write(table, path);
  const std::size_t size = table.text.size();
  if (std::fwrite(table.text.data(), 1, size, stdout) != size || std::fflush(stdout) != 0)
    throw std::runtime_error("standard output cannot be written");
}

}  // namespace vibro_impact::runner
