// The greatest Lyapunov exponent of a motion: the rate, per unit of (non-dimensional) time, at
// which a small change of its state grows in the long run. Negative infinity where every change
// dies out in finite time, as it does where all masses are held at once.
#pragma once

#include <complex>
#include <optional>
#include <vector>

#include "tangent.hpp"

namespace vibro_impact {

// Of a periodic motion, ln|mu| / duration with mu the largest of its Floquet multipliers over that
// time. Throws std::invalid_argument for a duration that is not positive.
double greatest_exponent(const std::vector<std::complex<double>> &multipliers, double duration);

// Of any motion: a recorder that follows one change of the state by tangents, and brings it back to
// length 1 every few forcing periods (there is one column, so that orthonormalising is scaling).
class GrowthRecorder {
 public:
  // `start` is the state the run starts from, which should lie away from events (`at_quiet_phase`).
  // Throws std::invalid_argument for a start that does not fit the scene, or no forcing period.
  GrowthRecorder(const Scene &scene, const MotionState &start);

  void event(const Event &event, const Moment &moment);
  double next_time() const;
  void sample(const Moment &moment);

  // Brings the change to the end of the run. To be called once, after the run.
  void finish(const Instant &end);
  // From the start to the end; 0 before `finish`.
  double exponent() const;

 private:
  Scene scene_;
  Clock clock_;
  Instant started_, next_;
  Held held_;
  bool in_chatter_ = false;  // tangents of a chatter are extrapolated from all of its impacts
  double logarithm_ = 0.0, exponent_ = 0.0;
  std::optional<TangentRecorder> tangents_;

  void follow(const MotionState &from, Matrix column);
};

}  // namespace vibro_impact
