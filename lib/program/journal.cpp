#include "journal.hpp"

#include <fmt/format.h>
#include <sys/file.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>

#include "files.hpp"
#include "vibro_impact/scene_text.hpp"

namespace vibro_impact::runner {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t before_text = sizeof "row 01234567 " - 1;
constexpr char end_of_text = '\x1f', end_of_line = '\x1e';  // the unit and record separators

// The line with this text behind its checksum.
std::string checked(const std::string &text) {
  return fmt::format("row {:08x} {}", checksum_of(text), text);
}

std::size_t row_of(const std::string &line) {
  return std::stoull(line.substr(before_text));
}

}  // namespace

std::string journal_line(std::size_t row, const Texts &texts) {
  std::string text = fmt::format("{}", row);
  for (const std::string &of_table : texts) text += end_of_text + of_table;
  std::ranges::replace(text, '\n', end_of_line);
  return checked(text);
}

Journal::Journal(const std::string &path, const std::string &head, std::size_t rows, bool resume)
    : path_(path), file_(nullptr, std::fclose), lines_(rows) {
  if (!resume && fs::exists(path))
    refuse("{}: rows of a sweep stand there; --resume goes on with it, or remove it", path);
  file_.reset(std::fopen(path.c_str(), resume ? "ab" : "abx"));
  if (!file_) refuse("{}: cannot be written: {}", path, std::strerror(errno));
  if (flock(fileno(file_.get()), LOCK_EX | LOCK_NB) != 0 || !is_at_path())
    refuse("{}: another sweep is writing it", path);
  const std::string bytes = contents(path);
  if (!head.starts_with(bytes.substr(0, head.size())))
    refuse("{}: not the rows of this sweep: its options and its program must be the same", path);
  // The end of the last whole line; 0 in a new file, or if the sweep was killed at once.
  std::size_t end = bytes.starts_with(head) ? head.size() : 0;
  for (std::size_t next; end > 0 && (next = bytes.find('\n', end)) < bytes.size(); end = next + 1) {
    const std::string line = bytes.substr(end, next - end),
                      text = line.substr(std::min(line.size(), before_text));
    if (line != checked(text) || row_of(line) >= rows)
      refuse("{}: byte {}: a row that does not fit its checksum; remove the file", path, end);
    lines_[row_of(line)] = line;
  }
  fs::resize_file(path, end);
  if (end == 0) append(head);
}

bool Journal::is_at_path() const {
  std::error_code error;
  return fs::equivalent(path_, path_of(file_.get()), error);
}

void Journal::append(const std::string &text) const {
  if (std::fwrite(text.data(), 1, text.size(), file_.get()) != text.size() ||
      std::fflush(file_.get()) != 0)
    throw std::runtime_error(fmt::format("{}: cannot be written: {}", path_, std::strerror(errno)));
}

void Journal::add(const std::string &line) {
  append(line + '\n');
  lines_[row_of(line)] = line;
}

Texts Journal::texts_of(std::size_t row) const {
  std::string text = lines_[row].substr(before_text);
  std::ranges::replace(text, end_of_line, '\n');
  const auto parts = words::parts_of(text, end_of_text);
  Texts texts;
  for (std::size_t k = 0; k < texts.size(); ++k) texts[k] = parts.at(k + 1);
  return texts;
}

void Journal::remove() const {
  if (is_at_path()) fs::remove(path_);
}

}  // namespace vibro_impact::runner
