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
//
// In chaos the growth varies from period to period, so that the sign of a short mean may be chance.
// It counts as certain when the mean over at least 4 blocks of 40 forcing periods is larger than 4
// times its standard error (the deviation of the blocks over the root of their number); then the
// recorder ends the run. A motion whose transient is chaotic for much longer cannot be told from
// chaos.
class GrowthRecorder {
 public:
  // `start` is the state the run starts from, which should lie away from events (`at_quiet_phase`).
  // Throws std::invalid_argument for a start that does not fit the scene, or no forcing period.
  GrowthRecorder(const Scene &scene, const MotionState &start);

  void event(const Event &event, const Moment &moment);
  double next_time() const;
  void sample(const Moment &moment);
  bool done() const {
    return sign_is_certain_;
  }

  // Brings the change to the end of the run. To be called once, after the run.
  void finish(const Instant &end);
  // From the start to the end; 0 before `finish`.
  double exponent() const {
    return exponent_;
  }
  // The sign of the exponent is no chance.
  bool sign_is_certain() const {
    return sign_is_certain_;
  }

 private:
  Scene scene_;
  Clock clock_;
  Instant started_, next_;
  Held held_;
  bool in_chatter_ = false;  // tangents of a chatter are extrapolated from all of its impacts
  double logarithm_ = 0.0, exponent_ = 0.0;
  std::optional<TangentRecorder> tangents_;
  Instant block_begin_;
  double before_block_ = 0.0;        // the logarithm there
  std::vector<double> blocks_ = {};  // growth per forcing period of each
  bool sign_is_certain_ = false;

  void follow(const MotionState &from, Matrix column);
  void end_block(const Instant &now);
};

}  // namespace vibro_impact
