// A recorder that looks at a run from time to time: how far it has come, and whether it is to end.
#pragma once

#include <chrono>
#include <limits>
#include <span>

#include "progress.hpp"
#include "vibro_impact/record.hpp"

namespace vibro_impact::runner {

// Asks for some 20 samples a second where the progress is read, for none where it is not, and ends
// the run at the next flight when `signal` gives a number other than 0. What the run tells others
// does not change.
class Watch {
 public:
  // `begin`: before it nothing of the run is told; `others`: the other recorders of the run.
  Watch(double begin, double until, int (*signal)(), Progress &progress,
        std::span<const RecorderRef> others);

  double next_time() const {
    return signal_() != 0 ? begin_ : next_;  // a time that is over is served at once
  }
  void sample(const Moment &moment);
  bool done() const {
    return signal_() != 0;
  }
  // Evaluations of the motion that no other recorder had asked for.
  long long looks() const {
    return looks_;
  }

 private:
  double begin_, until_;
  int (*signal_)();
  Progress &progress_;
  std::span<const RecorderRef> others_;
  double next_ = std::numeric_limits<double>::infinity(), step_ = 0.0;
  std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
  long long looks_ = 0;

  void choose_next(double time);
};

}  // namespace vibro_impact::runner
