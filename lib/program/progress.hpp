// How far a long computation has come and how long it will still take, on standard error.
#pragma once

#include <chrono>
#include <mutex>
#include <string>

namespace vibro_impact {

// "time: 12.5 of 750 (1 %), 2.95 min left": the rest at the pace since `before`, where the
// computation began `seconds` ago.
std::string progress_line(const std::string &of_what, double before, double done, double total,
                          double seconds);

// Says nothing in the first two seconds. On a terminal one line is rewritten, at most five times a
// second, and wiped at the end; elsewhere a line follows after 2, 4, 8, ... seconds. May be called
// from several threads.
class Progress {
 public:
  // `before`: what of `total` was done before the computation began.
  Progress(std::string of_what, double total, double before = 0.0);
  ~Progress();
  Progress(const Progress &) = delete;
  Progress &operator=(const Progress &) = delete;

  void advance(double by = 1.0);

 private:
  using Clock = std::chrono::steady_clock;

  std::string of_what_;
  double total_, before_, done_;
  bool terminal_, shown_ = false;
  Clock::time_point start_ = Clock::now();
  Clock::time_point next_ = start_ + std::chrono::seconds(2);  // before it nothing is written
  std::mutex mutex_ = {};
};

}  // namespace vibro_impact
