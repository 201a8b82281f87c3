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
#include <utility>

namespace vibro_impact::runner {

namespace fs = std::filesystem;

namespace {

// The file that an output names, behind links.
fs::path target_of(const Output &output) {
  std::error_code error;
  const fs::path name = fs::weakly_canonical(fs::absolute(output.path), error);
  const fs::file_status there = error ? fs::file_status() : fs::status(name, error);
  if (error && there.type() != fs::file_type::not_found)
    refuse("{}: {}", output.given(), error.message());
  if (fs::is_symlink(fs::symlink_status(name, error)))
    refuse("{}: is a link to a file that is not there", output.given());
  if (fs::exists(there) && !fs::is_regular_file(there))
    refuse("{}: is no file, and cannot be replaced by one", output.given());
  return name;
}

}  // namespace

void check_outputs(const std::vector<Output> &outputs, const std::string &read) {
  std::vector<fs::path> names;
  if (!read.empty()) names.push_back(target_of({"--scene", read}));
  for (const Output &output : outputs) {
    if (!output.wanted()) continue;
    const fs::path name = output.is_file() ? target_of(output) : "-", folder = name.parent_path();
    const bool taken = std::ranges::find(names, name) != names.end();
    if (taken && !output.is_file()) refuse("{}: standard output takes one table", output.given());
    if (taken) refuse("{}: another file of the command has that name", output.given());
    names.push_back(name);
    if (!output.is_file()) continue;
    if (!fs::is_directory(folder)) refuse("{}: {} is no folder", output.given(), folder.string());
    if (access(folder.c_str(), W_OK | X_OK) != 0)
      refuse("{}: {} is write-protected", output.given(), folder.string());
  }
}

std::string contents(const std::string &path) {
  std::ifstream file(path, std::ios::binary);
  return std::string(std::istreambuf_iterator<char>(file), {});
}

void write_text(std::string text, const std::string &path) {
  Table table("");
  table.text = std::move(text);
  if (path != "-") return write(table, path);
  const std::size_t size = table.text.size();
  if (std::fwrite(table.text.data(), 1, size, stdout) != size || std::fflush(stdout) != 0)
    throw std::runtime_error("standard output cannot be written");
}

std::uint32_t checksum_of(const std::string &bytes) {
  boost::crc_32_type checksum;
  checksum.process_bytes(bytes.data(), bytes.size());
  return checksum.checksum();
}

std::string path_of(std::FILE *file) {
  return fmt::format("/proc/self/fd/{}", fileno(file));
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
  checksum_.process_bytes(head.data(), head.size());
  const std::size_t whole = in_head ? 0 : read(text, head.size(), rule);
  if (ftruncate(fileno(file_.get()), static_cast<off_t>(whole)) != 0)
    refuse("{}: cannot be written: {}", path, std::strerror(errno));
  if (in_head) append(head);
}

// Reads the blocks behind the head, and returns where the last whole block ends.
std::size_t Journal::read(const std::string &text, std::size_t head, const RowRule &rule) {
  const auto lines_of_head = std::ranges::count(text.substr(0, head), '\n');
  std::size_t whole = head, row = 0, table = 0, number = static_cast<std::size_t>(lines_of_head);
  Texts block;
  for (std::size_t begin = head, end; (end = text.find('\n', begin)) != std::string::npos;
       begin = end + 1) {
    const std::string line = text.substr(begin, end - begin);
    std::string wrong;
    if (line.starts_with("# ")) {
      if (take(std::exchange(block, {})) != text.substr(whole, end + 1 - whole))
        wrong = "the rows above do not fit their checksum";
      whole = end + 1;
      table = 0;
    } else if (line == "#") {
      table = (table + 1) % block.size();
    } else {
      if (table == 0) wrong = rule(row++, line);
      block[table] += line + '\n';
    }
    ++number;
    if (!wrong.empty()) refuse("{}: line {}: {}; remove the file", path_, number, wrong);
  }
  return whole;
}

std::size_t Journal::size() const {
  return static_cast<std::size_t>(std::ranges::count(rows_[0], '\n'));
}

bool Journal::is_at_path() const {
  std::error_code error;
  return fs::equivalent(path_, path_of(file_.get()), error);
}

void Journal::append(const std::string &text) {
  if (std::fwrite(text.data(), 1, text.size(), file_.get()) != text.size() ||
      std::fflush(file_.get()) != 0)
    throw std::runtime_error(fmt::format("{}: cannot be written: {}", path_, std::strerror(errno)));
}

std::string Journal::take(const Texts &block) {
  for (std::size_t k = 0; k < block.size(); ++k) rows_[k] += block[k];
  const std::string rows = fmt::format("{}", fmt::join(block, "#\n"));
  checksum_.process_bytes(rows.data(), rows.size());
  const std::string closing_line = fmt::format("# crc {:08x}\n", checksum_.checksum());
  checksum_.process_bytes(closing_line.data(), closing_line.size());
  return rows + closing_line;
}

void Journal::add(const Texts &block) {
  append(take(block));
}

bool Journal::remove() {
  const bool ours = is_at_path(), same = checksum_of(contents(path_)) == checksum_.checksum();
  if (ours) fs::remove(path_);
  return ours && same;
}

}  // namespace vibro_impact::runner
