#include "files.hpp"

#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <boost/crc.hpp>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <optional>
#include <utility>

#include "vibro_impact/scene_text.hpp"

namespace vibro_impact::runner {

namespace fs = std::filesystem;

namespace {

// The file that an output names, behind links.
fs::path target_of(const Output &output) {
  std::error_code error;
  const fs::path name = fs::weakly_canonical(fs::absolute(output.path), error);
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

std::string with_remedy(const std::string &reason) {
  const bool too_long = reason.find(" steps, given up at t = ") != std::string::npos;
  return reason + (too_long ? "; --max-steps can allow more" : "");
}

std::string numbered_columns(const std::string &name, std::size_t count) {
  std::string columns;
  for (std::size_t k = 1; k <= count; ++k) columns += fmt::format(",{}{}", name, k);
  return columns;
}

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

std::uint32_t checksum_of(std::string_view bytes) {
  boost::crc_32_type checksum;
  checksum.process_bytes(bytes.data(), bytes.size());
  return checksum.checksum();
}

std::string path_of(std::FILE *file) {
  return fmt::format("/proc/self/fd/{}", fileno(file));
}

namespace {

constexpr std::size_t before_text = sizeof "row 01234567 " - 1;
constexpr char end_of_text = '\x1f', end_of_line = '\x1e';  // the unit and record separators

// The line with this text behind its checksum.
std::string checked(const std::string &text) {
  return fmt::format("row {:08x} {}", checksum_of(text), text);
}

struct Row {
  std::size_t number = 0;
  Texts texts = {};
};

// The row of a line without its end, or nothing if it does not fit its checksum.
std::optional<Row> row_of(std::string line) {
  const std::string text = line.substr(std::min(line.size(), before_text));
  if (line != checked(text)) return {};
  std::ranges::replace(line, end_of_line, '\n');
  const auto parts = detail::parts_of(std::string_view(line).substr(before_text), end_of_text);
  Row row{std::stoull(std::string(parts[0]))};
  for (std::size_t k = 0; k < row.texts.size(); ++k) row.texts[k] = parts.at(k + 1);
  return row;
}

}  // namespace

std::string journal_line(std::size_t row, const Texts &texts) {
  std::string text = fmt::format("{}", row);
  for (const std::string &of_table : texts) text += end_of_text + of_table;
  std::ranges::replace(text, '\n', end_of_line);
  return checked(text) + '\n';
}

Journal::Journal(const std::string &path, const std::string &head, std::size_t rows, bool resume)
    : path_(path), file_(nullptr, std::fclose), places_(rows, 0) {
  if (!resume && fs::exists(path))
    refuse("{}: rows of a sweep stand there; --resume goes on with it, or remove it", path);
  file_.reset(std::fopen(path.c_str(), resume ? "ab" : "abx"));
  if (!file_) refuse("{}: cannot be written: {}", path, std::strerror(errno));
  if (flock(fileno(file_.get()), LOCK_EX | LOCK_NB) != 0 || !is_at_path())
    refuse("{}: another sweep is writing it", path);
  std::ifstream file(path, std::ios::binary);
  std::string text(head.size(), '\0');
  file.read(text.data(), static_cast<std::streamsize>(text.size()));
  text.resize(static_cast<std::size_t>(file.gcount()));
  if (!head.starts_with(text))
    refuse("{}: not the rows of this sweep: its options and its program must be the same", path);
  const bool is_begun = text == head;  // else a new file, or the sweep was killed at once
  end_ = is_begun ? head.size() : 0;
  for (std::string line; is_begun && std::getline(file, line) && !file.eof();
       end_ += line.size() + 1) {
    const std::optional<Row> row = row_of(line);
    if (!row || row->number >= rows) refuse("{}", damage_at(end_));
    places_[row->number] = end_;
  }
  fs::resize_file(path, end_);
  if (!is_begun) append(head);
}

std::string Journal::damage_at(std::uint64_t place) const {
  return fmt::format("{}: byte {}: a row that does not fit its checksum; remove the file", path_,
                     place);
}

bool Journal::is_at_path() const {
  std::error_code error;
  return fs::equivalent(path_, path_of(file_.get()), error);
}

void Journal::append(const std::string &text) {
  if (std::fwrite(text.data(), 1, text.size(), file_.get()) != text.size() ||
      std::fflush(file_.get()) != 0)
    throw std::runtime_error(fmt::format("{}: cannot be written: {}", path_, std::strerror(errno)));
  end_ += text.size();
}

void Journal::add(const std::string &line) {
  const std::uint64_t place = end_;
  append(line);
  places_[std::stoull(line.substr(before_text))] = place;
}

void Journal::read(const std::function<void(const Texts &texts)> &use) const {
  std::ifstream file(path_of(file_.get()), std::ios::binary);
  std::string line;
  for (std::size_t number = 0; number < places_.size(); ++number) {
    file.seekg(static_cast<std::streamoff>(places_[number]));
    std::getline(file, line);
    const std::optional<Row> row = row_of(line);
    if (!row || row->number != number) throw std::runtime_error(damage_at(places_[number]));
    use(row->texts);
  }
}

bool Journal::remove() {
  if (!is_at_path()) return false;
  const bool same = fs::file_size(path_) == end_;
  fs::remove(path_);
  return same;
}

}  // namespace vibro_impact::runner
