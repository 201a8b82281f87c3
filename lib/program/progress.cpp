#include "progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

namespace vibro_impact {

constexpr const char *wipe = "\r\033[K";

std::string progress_line(const std::string &name, double done, double total, double seconds) {
  const double percent = total > 0.0 ? std::floor(100.0 * (done / total)) : 100.0;
  std::string line = fmt::format("{}: {:.6g} of {:.6g} ({:.0f} %)", name, done, total, percent);
  if (done > 0.0)
    line += fmt::format(", {:.3g} min left", seconds / 60.0 * ((total - done) / done));
  return line;
}

bool is_progress_due(double seconds, double last_shown) {
  return seconds >= 2.0 && seconds >= last_shown + 0.2;
}

Progress::Progress(std::string name, double total)
    : name_(std::move(name)), total_(total), terminal_(isatty(STDERR_FILENO) != 0) {
}

void Progress::advance(double by) {
  if (!terminal_) return;
  done_ = std::min(total_, done_ + by);
  const auto elapsed = std::chrono::steady_clock::now() - start_;
  const double seconds = std::chrono::duration<double>(elapsed).count();
  if (!is_progress_due(seconds, last_shown_)) return;
  const std::string line = progress_line(name_, done_, total_, seconds);
  std::fprintf(stderr, "%s%s", wipe, line.c_str());
  last_shown_ = seconds;
}

Progress::~Progress() {
  if (last_shown_ > 0.0) std::fputs(wipe, stderr);
}

}  // namespace vibro_impact
