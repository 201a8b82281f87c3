#include "partial_table.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <filesystem>
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

}  // namespace

PartialTable::PartialTable(std::string path, const std::string &definition,
                           const std::string &header, bool resume)
    : path_(std::move(path)), head_(fmt::format("{}\n{}\n{}", kind, definition, header)) {
  const bool there = fs::exists(path_);
  if (there && !resume)
    throw BadInput(
        fmt::format("{}: the rows of a sweep that was ended, or still runs, stand there; --resume "
                    "goes on with it, or remove it",
                    path_));
  const int descriptor = open(path_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
  if (descriptor >= 0) file_ = fdopen(descriptor, "r+b");
  if (file_ == nullptr) throw BadInput(fmt::format("{}: cannot be written", path_));
  if ((flock(descriptor, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK) || !is_ours()) {
    std::fclose(std::exchange(file_, nullptr));
    throw BadInput(fmt::format("{}: another sweep is writing it", path_));
  }
  try {
    read([](std::string_view) {});
  } catch (...) {
    std::fclose(std::exchange(file_, nullptr));
    throw;
  }
  if (ftruncate(descriptor, static_cast<off_t>(size_)) != 0 || std::fseek(file_, 0, SEEK_END) != 0)
    throw std::runtime_error(fmt::format("{}: cannot be written", path_));
  if (size_ > 0) return;
  open_ = head_;
  close_rows();
}

PartialTable::~PartialTable() {
  if (file_ != nullptr) std::fclose(file_);
}

// The file under that name is the one that is open, and as long as it was left.
bool PartialTable::is_ours() const {
  struct stat open = {}, named = {};
  return fstat(fileno(file_), &open) == 0 && stat(path_.c_str(), &named) == 0 &&
         open.st_ino == named.st_ino && open.st_dev == named.st_dev &&
         open.st_size >= static_cast<off_t>(size_);
}

// Takes over what stands under a checksum, and hands the table on up to there.
void PartialTable::read(const std::function<void(std::string_view)> &take) {
  std::string line, rows;
  std::size_t number = 0, length = 0, points = 0;
  Checksum checksum;
  closed_ = points_ = size_ = 0;
  std::rewind(file_);
  for (int c; (c = std::getc(file_)) != EOF;) {
    line.push_back(static_cast<char>(c));
    if (c != '\n') continue;
    ++number;
    length += line.size();
    if (length <= head_.size() && line != head_.substr(length - line.size(), line.size()))
      throw BadInput(fmt::format("{} line {}: {}", path_, number,
                                 number == 1 ? "is not the rows of a sweep"
                                             : "another sweep was ended there: the scene, the "
                                               "ranges and what is recorded must be the same"));
    if (line.starts_with(points_key)) {
      const std::string begin = closing(points);
      checksum.add(begin);
      if (line != begin + checksum.line())
        throw BadInput(fmt::format("{} line {}: the checksum does not fit: the file was changed",
                                   path_, number));
      checksum.add(checksum.line());
      take(rows);
      rows.clear();
      closed_ = points_ = points;
      size_ = length;
      checksum_ = checksum;
    } else {
      checksum.add(line);
      if (number > 2) rows += line;
      if (number > 3) ++points;
    }
    line.clear();
  }
  if (number == 0 && !kind.starts_with(line))
    throw BadInput(fmt::format("{}: is not the rows of a sweep", path_));
}

void PartialTable::add(std::string_view row) {
  open_ += row;
  ++points_;
  const auto now = std::chrono::steady_clock::now();
  if (points_ - closed_ >= most_open || now - last_ > std::chrono::seconds(1)) close_rows();
}

void PartialTable::close_rows() {
  if (!is_ours())
    throw std::runtime_error(fmt::format("{}: was removed or cut while the sweep ran", path_));
  checksum_.add(open_);
  const std::string begin = closing(points_);
  checksum_.add(begin);
  const std::string end = checksum_.line();
  checksum_.add(end);
  open_ += begin + end;
  if (std::fwrite(open_.data(), 1, open_.size(), file_) != open_.size() || std::fflush(file_) != 0)
    throw std::runtime_error(
        fmt::format("{}: cannot be written: {}", path_, std::generic_category().message(errno)));
  size_ += open_.size();
  open_.clear();
  closed_ = points_;
  last_ = std::chrono::steady_clock::now();
}

void PartialTable::finish(const Named &to) {
  if (!open_.empty()) close_rows();
  const std::size_t points = points_, size = size_;
  Output output(to);
  try {
    read([&output](std::string_view rows) { output.write(rows); });
  } catch (const BadInput &changed) {
    throw std::runtime_error(changed.what());
  }
  if (!is_ours() || points_ != points || size_ != size)
    throw std::runtime_error(fmt::format("{}: was removed or cut while the sweep ran", path_));
  output.complete();
  output.put_in_place();
  std::error_code ignored;
  fs::remove(path_, ignored);
}

}  // namespace vibro_impact::runner
