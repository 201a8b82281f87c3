#include "progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cmath>
#include <cstdio>
#include <utility>

namespace vibro_impact {

namespace {

using namespace std::chrono_literals;

constexpr const char *wipe = "\r\033[K";

std::string duration(double seconds) {
  if (!(seconds < 3e13)) return "more than a million years";
  if (seconds >= 3.0 * 86400.0) return fmt::format("{:.0f} days", seconds / 86400.0);
  const auto whole = static_cast<long long>(std::ceil(seconds));
  if (whole >= 3600) return fmt::format("{} h {} min", whole / 3600, whole % 3600 / 60);
  if (whole >= 60) return fmt::format("{} min {} s", whole / 60, whole % 60);
  return fmt::format("{} s", whole);
}

}  // namespace

std::string progress_line(const std::string &of_what, double before, double done, double total,
                          double seconds) {
  const double percent = total > 0.0 ? std::floor(100.0 * (done / total)) : 100.0;
  std::string line = fmt::format("{}: {:.6g} of {:.6g} ({:.0f} %)", of_what, done, total, percent);
  if (done > before)
    line += ", " + duration(seconds * ((total - done) / (done - before))) + " left";
  return line;
}

Progress::Progress(std::string of_what, double total, bool asked_for, double before)
    : of_what_(std::move(of_what)),
      total_(total),
      before_(before),
      done_(before),
      terminal_(isatty(STDERR_FILENO) != 0),
      is_read_(asked_for || terminal_),
      next_(start_ + 2s) {
}

void Progress::reach(double done) {
  const std::lock_guard lock(mutex_);
  done_ = done;
  show();
}

void Progress::advance(double by) {
  const std::lock_guard lock(mutex_);
  done_ += by;
  show();
}

void Progress::show() {
  if (!is_read_) return;
  const auto now = Clock::now();
  if (now < next_) return;
  const double seconds = std::chrono::duration<double>(now - start_).count();
  const std::string line = progress_line(of_what_, before_, done_, total_, seconds);
  // Not fmt::print, which throws where the terminal is gone.
  std::fprintf(stderr, "%s%s%s", terminal_ ? wipe : "", line.c_str(), terminal_ ? "" : "\n");
  shown_ = true;
  next_ = terminal_ ? now + 200ms : start_ + 2 * (now - start_);
}

Progress::~Progress() {
  if (terminal_ && shown_) std::fputs(wipe, stderr);
}

}  // namespace vibro_impact
