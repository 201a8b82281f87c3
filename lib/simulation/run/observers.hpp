// The reports of a run to its recorders. They change nothing of the run but its progress, the
// sums of what was reported, and scratch.
#pragma once

#include "run.hpp"

namespace vibro_impact::detail {

// The moment of a motion of the run.
class MomentOfMotion final : public Moment {
 public:
  MomentOfMotion(const Run &run, const Motion &motion, const Instant &at);
  int masses() const override;
  double displacement(int mass) const override;
  double velocity(int mass) const override;
  double hold_force(int mass) const override;
  ImpactSum unreported(int stop) const override;
  MotionState state() const;

 private:
  const Run &run_;
  const Motion &motion_;

  std::size_t index_of(int mass) const;
};

// The motion at a time `tau` of the step or long flight of the run. The rounding of a sample may
// put `tau` below 0, which is the start. It is valid until the next one.
const Motion &motion_at(Run &run, const Real &tau);

// Reports an event at a stop, and ends the call when a recorder is done. `before` and `after` are
// the velocities of an impact, else 0.
void report_event(Run &run, EventKind kind, std::size_t stop, double before, double after,
                  bool by_a_jump, const ImpactSum &taken, Recorders recorders);

// Reports an impact. Before the limit of a chatter that is ahead, it adds one that is too slow to
// those that are unreported.
void report_impact(Run &run, std::size_t stop, double closing, double leaving, Recorders recorders);

// The next time at which a recorder asks for a sample; infinite when there is none.
double next_sample(Recorders recorders);

// Reports this moment as the sample at this time to the recorders that have asked for it. Returns
// true when one of them is done.
bool report_sample(Run &run, const Moment &moment, double time, Recorders recorders);

}  // namespace vibro_impact::detail
