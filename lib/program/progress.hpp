// How far a long computation has come and how long it will still take: one line on the terminal
// that is rewritten, and wiped at the end. Nothing is written where standard error is no terminal.
#pragma once

#include <chrono>
#include <string>

namespace vibro_impact {

// "time: 12.5 of 750 (1 %), 2.95 min left", `seconds` after the computation began.
std::string progress_line(const std::string &name, double done, double total, double seconds);

// Whether the line is written `seconds` after the computation began, and after it was written at
// `last_shown`: not in the first two seconds, and at most five times a second.
bool is_progress_due(double seconds, double last_shown);

class Progress {
 public:
  Progress(std::string name, double total);
  ~Progress();

  void advance(double by = 1.0);

 private:
  std::string name_;
  double total_, done_ = 0.0;
  bool terminal_;
  double last_shown_ = 0.0;  // seconds after the start; 0: never
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace vibro_impact
