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

#include "vibro_impact/scene_text.hpp"

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

void check_outputs(const std::vector<Output> &outputs, const std::string &scene_file) {
  std::vector<fs::path> names;
  if (!scene_file.empty()) names.push_back(target_of({"--scene", scene_file}));
  for (const Output &output : outputs) {
    if (!output.wanted()) continue;
    const fs::path name = output.is_file() ? target_of(output) : "-", folder = name.parent_path();
    if (std::ranges::find(names, name) != names.end())
      refuse("{}: the scene or another table of the command stands there", output.given());
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
  Table table;
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

namespace {

// The line below blocks, of which this is the checksum with the head.
std::string closing_line(std::uint32_t checksum) {
  return fmt::format("# crc {:08x}\n", checksum);
}

}  // namespace

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
  const std::size_t whole = in_head ? 0 : read(text, head.size(), rule);
  if (ftruncate(fileno(file_.get()), static_cast<off_t>(whole)) != 0)
    refuse("{}: cannot be written: {}", path, std::strerror(errno));
  checksum_.process_bytes(text.data(), whole);
  if (in_head) append(head);
}

// Keeps the rows of the whole blocks behind the head, and returns where the last block ends. Its
// checksum is that of all blocks.
std::size_t Journal::read(const std::string &text, std::size_t head, const RowRule &rule) {
  const std::size_t last = text.rfind("\n# crc ", text.rfind('\n') - 1) + 1;
  if (last <= head) return head;
  const std::size_t whole = text.find('\n', last) + 1;
  auto number = std::ranges::count(text.substr(0, head), '\n');
  std::size_t row = 0, table = 0;
  for (const std::string_view line : detail::parts_of({&text[head], &text[last - 1]}, '\n')) {
    ++number;
    if (line.starts_with('#'))
      table = line == "#" ? (table + 1) % rows_.size() : 0;
    else if (table == 0 && !rule(row++, line))
      refuse("{}: line {}: not the row of its point; remove the file", path_, number);
    else
      rows_[table].append(line).push_back('\n');
  }
  if (text.substr(last, whole - last) != closing_line(checksum_of(text.substr(0, last))))
    refuse("{}: line {}: the rows above do not fit it; remove the file", path_, number + 1);
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
  checksum_.process_bytes(text.data(), text.size());
  if (std::fwrite(text.data(), 1, text.size(), file_.get()) != text.size() ||
      std::fflush(file_.get()) != 0)
    throw std::runtime_error(fmt::format("{}: cannot be written: {}", path_, std::strerror(errno)));
}

void Journal::add(const Texts &block) {
  for (std::size_t k = 0; k < block.size(); ++k) rows_[k] += block[k];
  append(fmt::format("{}", fmt::join(block, "#\n")));
  append(closing_line(checksum_.checksum()));
}

bool Journal::remove() {
  const bool ours = is_at_path(), same = checksum_of(contents(path_)) == checksum_.checksum();
  if (ours) fs::remove(path_);
  return ours && same;
}

}  // namespace vibro_impact::runner
