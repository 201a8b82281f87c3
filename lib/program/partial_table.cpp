#include "partial_table.hpp"

#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <utility>

#include "output.hpp"
#include "refuse.hpp"

namespace vibro_impact::runner {

PartialTable::PartialTable(std::string path, const std::string &definition,
                           const std::string &header, bool resume)
    : path_(std::move(path)),
      head_(fmt::format("vibro-impact sweep 2 {}\n{}", definition, header)),
      file_(nullptr, std::fclose) {
  if (!resume && std::filesystem::exists(path_))
    refuse("{}: rows of a sweep stand there; --resume goes on with it, or remove it", path_);
  file_.reset(std::fopen(path_.c_str(), "abe"));
  if (!file_) refuse("{}: cannot be written: {}", path_, std::strerror(errno));
  if (flock(fileno(file_.get()), LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK)
    refuse("{}: another sweep is writing it", path_);
  held_ = fmt::format("/proc/self/fd/{}", fileno(file_.get()));
  const std::size_t size = read([](std::string_view) {});
  if (ftruncate(fileno(file_.get()), static_cast<off_t>(size)) != 0)
    refuse("{}: cannot be written: {}", path_, std::strerror(errno));
  if (size == 0) append(head_);
}

// Hands on the header and the rows that stand there whole, and counts them. Returns the size of the
// file up to the last of them.
std::size_t PartialTable::read(const std::function<void(std::string_view)> &take) {
  checksum_.reset();
  points_ = 0;
  std::ifstream file(held_, std::ios::binary);
  if (!file) refuse("{}: cannot be read", path_);
  std::string start(head_.size(), '\0');
  file.read(start.data(), static_cast<std::streamsize>(start.size()));
  start.resize(static_cast<std::size_t>(file.gcount()));
  if (!head_.starts_with(start))
    refuse("{}: not the rows of this sweep: options and version must be those that began it",
           path_);
  if (start.size() < head_.size()) return 0;
  std::size_t size = head_.size();
  take(std::string_view(head_).substr(head_.find('\n') + 1));
  for (std::string line; std::getline(file, line) && !file.eof();) {
    const std::string row = line.substr(0, line.rfind(' ')) + "\n";
    checksum_.process_bytes(row.data(), row.size());
    if (line.substr(std::min(line.size(), row.size())) != fmt::to_string(checksum_.checksum()))
      refuse("{} line {}: the checksum does not fit: the file was changed", path_, points_ + 3);
    take(row);
    ++points_;
    size += line.size() + 1;
  }
  return size;
}

void PartialTable::append(const std::string &text) {
  if (std::fwrite(text.data(), 1, text.size(), file_.get()) != text.size() ||
      std::fflush(file_.get()) != 0)
    throw std::runtime_error(fmt::format("{}: cannot be written: {}", path_, std::strerror(errno)));
}

void PartialTable::add(std::string_view row) {
  checksum_.process_bytes(row.data(), row.size());
  append(fmt::format("{} {}\n", row.substr(0, row.size() - 1), checksum_.checksum()));
  ++points_;
}

void PartialTable::finish(const std::string &name) {
  const std::size_t points = points_;
  Output output(name);
  read([&output](std::string_view row) { output.write(row); });
  if (points_ != points)
    throw std::runtime_error(fmt::format("{}: was cut while the sweep ran", path_));
  output.complete();
  output.put_in_place();
  std::error_code ignored;
  if (std::filesystem::equivalent(path_, held_, ignored)) std::filesystem::remove(path_, ignored);
}

}  // namespace vibro_impact::runner
