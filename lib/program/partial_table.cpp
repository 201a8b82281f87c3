#include "partial_table.hpp"

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <system_error>
#include <utility>

#include "bad_input.hpp"

namespace vibro_impact::runner {

namespace {

namespace fs = std::filesystem;

constexpr std::string_view kind = "vibro-impact sweep 1", points_key = "points ";
constexpr std::size_t most_open = 64;  // rows

// "points 128 " of a line that closes rows.
std::string closing(std::size_t points) {
  return fmt::format("{}{} ", points_key, points);
}

// A line with its end; false when there is none, or no end.
bool next_line(std::istream &file, std::string &line) {
  if (!std::getline(file, line) || file.eof()) return false;
  line.push_back('\n');
  return true;
}

}  // namespace

PartialTable::PartialTable(std::string path, const std::string &definition,
                           const std::string &header, bool resume)
    : path_(std::move(path)) {
  if (fs::exists(path_) && !resume)
    throw BadInput(
        fmt::format("{}: the rows of a sweep that was ended stand there; --resume goes on with it, "
                    "or remove it",
                    path_));
  const bool there = fs::exists(path_);
  if (there) read(definition, header);
  file_ = std::fopen(path_.c_str(), there ? "ab" : "wbx");
  if (file_ == nullptr) throw BadInput(fmt::format("{}: cannot be written", path_));
  if (fs::file_size(path_) == 0) {
    open_ = fmt::format("{}\n{}\n{}", kind, definition, header);
    close_rows();
  }
}

PartialTable::~PartialTable() {
  if (file_ != nullptr) std::fclose(file_);
}

// Takes over what stands under a checksum, and cuts off the rest.
void PartialTable::read(const std::string &definition, const std::string &header) {
  std::ifstream file(path_, std::ios::binary);
  if (!file) throw BadInput(fmt::format("{}: cannot be read", path_));
  std::string line;
  std::size_t number = 0, rows = 0;
  std::uintmax_t length = 0, good = 0;
  Checksum checksum;
  const std::string head[] = {fmt::format("{}\n", kind), definition + "\n", header};
  while (next_line(file, line)) {
    ++number;
    length += line.size();
    if (number <= 3) {
      if (line != head[number - 1])
        throw BadInput(fmt::format("{} line {}: {}", path_, number,
                                   number == 1 ? "is not the rows of a sweep"
                                               : "another sweep was ended there: the scene, the "
                                                 "ranges and what is recorded must be the same"));
    } else if (line.compare(0, points_key.size(), points_key) == 0) {
      const std::string begin = closing(closed_ + rows);
      checksum.add(begin);
      if (line != begin + checksum.line())
        throw BadInput(fmt::format("{} line {}: the checksum does not fit: the file was changed",
                                   path_, number));
      checksum.add(checksum.line());
      closed_ = points_ = closed_ + rows;
      rows = 0;
      good = length;
      checksum_ = checksum;
      continue;
    } else {
      ++rows;
    }
    checksum.add(line);
  }
  if (number == 0 && kind.substr(0, line.size()) != line)
    throw BadInput(fmt::format("{}: is not the rows of a sweep", path_));
  file.close();
  fs::resize_file(path_, good);
}

void PartialTable::add(std::string_view row) {
  open_ += row;
  ++points_;
  const auto now = std::chrono::steady_clock::now();
  if (points_ - closed_ >= most_open || now - last_ > std::chrono::seconds(1)) close_rows();
}

void PartialTable::close_rows() {
  checksum_.add(open_);
  const std::string begin = closing(points_);
  checksum_.add(begin);
  const std::string end = checksum_.line();
  checksum_.add(end);
  open_ += begin + end;
  if (std::fwrite(open_.data(), 1, open_.size(), file_) != open_.size() || std::fflush(file_) != 0)
    throw std::runtime_error(
        fmt::format("{}: cannot be written: {}", path_, std::generic_category().message(errno)));
  open_.clear();
  closed_ = points_;
  last_ = std::chrono::steady_clock::now();
}

void PartialTable::finish(StreamedFile &table) {
  if (!open_.empty()) close_rows();
  if (std::fclose(std::exchange(file_, nullptr)) != 0)
    throw std::runtime_error(fmt::format("{}: cannot be written", path_));
  std::ifstream file(path_, std::ios::binary);
  std::string line, block;
  for (std::size_t number = 1; next_line(file, line); ++number) {
    if (number < 3 || line.compare(0, points_key.size(), points_key) == 0) continue;
    block += line;
    if (block.size() < 1 << 16) continue;
    table.write(block);
    block.clear();
  }
  table.write(block);
  table.complete();
  table.put_in_place();
  std::error_code ignored;
  fs::remove(path_, ignored);
}

}  // namespace vibro_impact::runner
