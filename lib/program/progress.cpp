#include "progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace vibro_impact {

namespace {

using namespace std::chrono_literals;

std::string duration(double seconds) {
  constexpr double day = 86400.0, year = 365.25 * day;
  if (!(seconds < 1e6 * year)) return "more than a million years";
  if (seconds >= year) return fmt::format("{:.3g} years", seconds / year);
  if (seconds >= 3.0 * day) return fmt::format("{:.0f} days", seconds / day);
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
    : Progress(std::move(of_what), total, asked_for, before,
               Screen{stderr, isatty(STDERR_FILENO) != 0}) {
}

Progress::Progress(std::string of_what, double total, bool asked_for, double before, Screen screen)
    : of_what_(std::move(of_what)),
      total_(total),
      before_(before),
      done_(before),
      screen_(screen),
      is_read_(asked_for || screen.terminal),
      start_(screen.now()),
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
  const auto now = screen_.now();
  if (now < next_) return;
  const double seconds = std::chrono::duration<double>(now - start_).count();
  const std::string line = progress_line(of_what_, before_, done_, total_, seconds);
  // Not fmt::print, which throws where the terminal is gone.
  if (screen_.terminal)
    std::fprintf(screen_.file, "\r%-*s", static_cast<int>(width_), line.c_str());
  else
    std::fprintf(screen_.file, "%s\n", line.c_str());
  std::fflush(screen_.file);
  width_ = line.size();
  next_ = screen_.terminal ? now + 200ms : start_ + 2 * (now - start_);
}

Progress::~Progress() {
  if (!screen_.terminal || width_ == 0) return;
  std::fprintf(screen_.file, "\r%*s\r", static_cast<int>(width_), "");
  std::fflush(screen_.file);
}

}  // namespace vibro_impact
