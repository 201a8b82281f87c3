#include "progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cmath>
#include <cstdio>
#include <utility>

namespace vibro_impact {

constexpr const char *wipe = "\r\033[K";

std::string progress_line(const std::string &of_what, double before, double done, double total,
                          double seconds) {
  const double percent = total > 0.0 ? std::floor(100.0 * (done / total)) : 100.0;
  std::string line = fmt::format("{}: {:.6g} of {:.6g} ({:.0f} %)", of_what, done, total, percent);
  if (done > before)
    line += fmt::format(", {:.3g} min left", seconds / 60.0 * ((total - done) / (done - before)));
  return line;
}

Progress::Progress(std::string of_what, double total, double before)
    : of_what_(std::move(of_what)),
      total_(total),
      before_(before),
      done_(before),
      terminal_(isatty(STDERR_FILENO) != 0) {
}

void Progress::advance(double by) {
  const std::lock_guard lock(mutex_);
  done_ += by;
  const auto now = Clock::now();
  if (now < next_) return;
  const double seconds = std::chrono::duration<double>(now - start_).count();
  const std::string line = progress_line(of_what_, before_, done_, total_, seconds);
  // Not fmt::print, which throws where the terminal is gone.
  std::fprintf(stderr, "%s%s%s", terminal_ ? wipe : "", line.c_str(), terminal_ ? "" : "\n");
  shown_ = true;
  next_ = terminal_ ? now + std::chrono::milliseconds(200) : start_ + 2 * (now - start_);
}

Progress::~Progress() {
  if (terminal_ && shown_) std::fputs(wipe, stderr);
}

}  // namespace vibro_impact
