#include "watch.hpp"

#include <algorithm>

namespace vibro_impact::runner {

namespace {

constexpr double seconds_between_looks = 0.05;

}  // namespace

Watch::Watch(double begin, double until, int (*signal)(), Progress &progress,
             std::span<const RecorderRef> others)
    : begin_(begin), until_(until), signal_(signal), progress_(progress), others_(others) {
  if (!progress_.is_read()) return;
  step_ = (until - begin) * 0x1p-50;  // how fast the run goes is not known yet
  choose_next(begin);
}

void Watch::choose_next(double time) {
  const double next = time + std::max(step_, until_ * 0x1p-50);
  next_ = next < until_ ? next : std::numeric_limits<double>::infinity();
}

void Watch::sample(const Moment &) {
  if (signal_() != 0) return;
  const double asked = next_;
  if (std::none_of(others_.begin(), others_.end(), [asked](const RecorderRef &other) {
        return other.next_time != nullptr && other.next_time(other.recorder) <= asked;
      }))
    ++looks_;
  if (!progress_.is_read()) return;
  progress_.reach(asked);
  const auto now = std::chrono::steady_clock::now();
  const double took = std::chrono::duration<double>(now - last_).count();
  last_ = now;
  step_ *= std::clamp(seconds_between_looks / took, 1e-3, 2.0);
  choose_next(asked);
}

}  // namespace vibro_impact::runner
