#include "files.hpp"

#include <fmt/ranges.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>

namespace vibro_impact::runner {

namespace fs = std::filesystem;

namespace {

std::string contents(const std::string &path) {
  std::ifstream file(path, std::ios::binary);
  return std::string(std::istreambuf_iterator<char>(file), {});
}

// The file that a path names, behind links.
fs::path target_of(const std::string &option, const std::string &path) {
  std::error_code error;
  const fs::path name = fs::weakly_canonical(fs::absolute(path), error);
  const fs::file_status there = error ? fs::file_status() : fs::status(name, error);
  if (error && there.type() != fs::file_type::not_found)
    refuse("{} {}: {}", option, path, error.message());
  if (fs::is_symlink(fs::symlink_status(name, error)))
    refuse("{} {}: is a link to a file that is not there", option, path);
  if (fs::exists(there) && !fs::is_regular_file(there))
    refuse("{} {}: is no file, and cannot be replaced by one", option, path);
  return name;
}

}  // namespace

void check_files(const std::vector<std::pair<std::string, std::string>> &files,
                 const std::string &read) {
  std::vector<fs::path> names;
  if (!read.empty()) names.push_back(target_of("--scene", read));
  for (const auto &[option, path] : files) {
    if (path.empty()) continue;
    const fs::path name = path == "-" ? fs::path(path) : target_of(option, path);
    if (path != "-" && !fs::is_directory(name.parent_path()))
      refuse("{} {}: {} is no folder", option, path, name.parent_path().string());
    if (path != "-" && access(name.parent_path().c_str(), W_OK | X_OK) != 0)
      refuse("{} {}: {} is write-protected", option, path, name.parent_path().string());
    const bool taken = std::find(names.begin(), names.end(), name) != names.end();
    if (taken && path == "-") refuse("{} -: standard output takes one table", option);
    if (taken) refuse("{} {}: another file of the command has that name", option, path);
    names.push_back(name);
  }
}

void write_text(std::string text, const std::string &path) {
  Table table("");
  table.text = std::move(text);
  if (path != "-") return write(table, path);
  const std::size_t size = table.text.size();
  if (std::fwrite(table.text.data(), 1, size, stdout) != size || std::fflush(stdout) != 0)
    throw std::runtime_error("standard output cannot be written");
}

Journal::Journal(const std::string &path, const std::string &head, bool resume, const RowRule &rule)
    : path_(path), file_(nullptr, std::fclose) {
  if (!resume && fs::exists(path))
    refuse("{}: rows of a sweep stand there; --resume goes on with it, or remove it", path);
  file_.reset(std::fopen(path.c_str(), resume ? "ab" : "abx"));
  if (!file_) refuse("{}: cannot be written: {}", path, std::strerror(errno));
  if (flock(fileno(file_.get()), LOCK_EX | LOCK_NB) != 0 || !is_at_path())
    refuse("{}: another sweep is writing it", path);
  const std::string text = contents(path);
  const bool in_head = head.starts_with(text);  // a new file, or the sweep was killed at once
  if (!in_head && !text.starts_with(head))
    refuse("{}: not the rows of this sweep: its options and its program must be the same", path);
  if (!in_head) checksum_.process_bytes(head.data(), head.size());
  const std::size_t whole = in_head ? 0 : read(text, head.size(), rule);
  if (ftruncate(fileno(file_.get()), static_cast<off_t>(whole)) != 0)
    refuse("{}: cannot be written: {}", path, std::strerror(errno));
  fstat(fileno(file_.get()), &latest_);
  if (in_head) append(head);
}

// Reads the blocks behind the head, and returns where the last whole block ends.
std::size_t Journal::read(const std::string &text, std::size_t head, const RowRule &rule) {
  std::size_t whole = head, number = static_cast<std::size_t>(std::count(
                                text.begin(), text.begin() + static_cast<long>(head), '\n'));
  boost::crc_32_type checksum_of_blocks = checksum_;
  std::size_t rows = 0, table = 0;
  Texts block;
  for (std::size_t begin = head, end; (end = text.find('\n', begin)) != std::string::npos;
       begin = end + 1) {
    ++number;
    const std::string line = text.substr(begin, end - begin);
    const bool closes = line.starts_with("# ");
    std::string wrong;
    if (closes && line != closing_line()) wrong = "the rows above do not fit their checksum";
    if (line == "#" && ++table == block.size()) wrong = "a block has too many tables";
    if (!line.starts_with("#") && table == 0) wrong = rule(rows++, line);
    if (!wrong.empty()) refuse("{}: line {}: {}; remove the file", path_, number, wrong);
    checksum_.process_bytes(text.data() + begin, end + 1 - begin);
    if (!line.starts_with("#")) block[table] += line + '\n';
    if (!closes) continue;
    for (std::size_t k = 0; k < block.size(); ++k) rows_[k] += std::exchange(block[k], "");
    table = 0;
    whole = end + 1;
    checksum_of_blocks = checksum_;
  }
  checksum_ = checksum_of_blocks;
  return whole;
}

std::string Journal::closing_line() const {
  return fmt::format("# crc {:08x}", checksum_.checksum());
}

std::size_t Journal::size() const {
  return static_cast<std::size_t>(std::count(rows_[0].begin(), rows_[0].end(), '\n'));
}

bool Journal::is_at_path() const {
  struct stat own = {}, there = {};
  return fstat(fileno(file_.get()), &own) == 0 && stat(path_.c_str(), &there) == 0 &&
         own.st_dev == there.st_dev && own.st_ino == there.st_ino;
}

void Journal::note_changes() {
  struct stat now = {};
  fstat(fileno(file_.get()), &now);
  changed_ = changed_ || !is_at_path() || now.st_size != latest_.st_size ||
             now.st_mtim.tv_sec != latest_.st_mtim.tv_sec ||
             now.st_mtim.tv_nsec != latest_.st_mtim.tv_nsec;
}

void Journal::append(const std::string &text) {
  note_changes();
  if (std::fwrite(text.data(), 1, text.size(), file_.get()) != text.size() ||
      std::fflush(file_.get()) != 0)
    throw std::runtime_error(fmt::format("{}: cannot be written: {}", path_, std::strerror(errno)));
  checksum_.process_bytes(text.data(), text.size());
  fstat(fileno(file_.get()), &latest_);
}

void Journal::add(const Texts &block) {
  for (std::size_t k = 0; k < block.size(); ++k) rows_[k] += block[k];
  append(fmt::format("{}", fmt::join(block, "#\n")));
  append(closing_line() + "\n");
}

bool Journal::remove() {
  note_changes();
  if (is_at_path()) fs::remove(path_);
  return !changed_;
}

}  // namespace vibro_impact::runner
