#include "files.hpp"

#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>

namespace vibro_impact::runner {

namespace fs = std::filesystem;

namespace {

std::string contents(const std::string &path) {
  std::ifstream file(path, std::ios::binary);
  return std::string(std::istreambuf_iterator<char>(file), {});
}

std::size_t lines_in(const std::string &text) {
  return static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
}

}  // namespace

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

PartialTable::PartialTable(const std::string &path, const std::string &definition,
                           const std::string &header, bool resume)
    : path_(path), definition_(definition + "\n"), file_(nullptr, std::fclose) {
  if (!resume && fs::exists(path))
    refuse("{}: rows of a sweep stand there; --resume goes on with it, or remove it", path);
  file_.reset(std::fopen(path.c_str(), "ab"));
  if (!file_) refuse("{}: cannot be written: {}", path, std::strerror(errno));
  if (flock(fileno(file_.get()), LOCK_EX | LOCK_NB) != 0)
    refuse("{}: another sweep is writing it", path);
  const std::string head = definition_ + header, text = contents(path);
  const bool in_head = head.starts_with(text);  // a new file, or the sweep was killed at once
  if (!in_head && !text.starts_with(head))
    refuse("{}: not the rows of this sweep: its options and its program must be the same", path);
  const std::size_t whole = in_head ? 0 : text.rfind('\n') + 1;
  if (ftruncate(fileno(file_.get()), static_cast<off_t>(whole)) != 0)
    refuse("{}: cannot be written: {}", path, std::strerror(errno));
  if (in_head)
    append(head);
  else
    rows_ = lines_in(text) - lines_in(head);
}

void PartialTable::append(const std::string &text) {
  if (std::fwrite(text.data(), 1, text.size(), file_.get()) != text.size() ||
      std::fflush(file_.get()) != 0)
    throw std::runtime_error(fmt::format("{}: cannot be written: {}", path_, std::strerror(errno)));
}

void PartialTable::add(const std::string &rows) {
  append(rows);
  rows_ += lines_in(rows);
}

std::string PartialTable::text() const {
  return contents(path_).substr(definition_.size());
}

void PartialTable::remove() {
  fs::remove(path_);
}

}  // namespace vibro_impact::runner
