// The totals of each stop over a part of a run: its impacts, what they took, and sticking.
#pragma once

#include <optional>
#include <vector>

#include "vibro_impact/analysis/table.hpp"
#include "vibro_impact/record.hpp"

namespace vibro_impact::runner {

// Impulse and energy of a complete chatter contain its infinitely many impacts beyond the resolved
// ones. Those behind an impact of speed v take, to leading order, the geometric sums
//   m v r (1 + r) / (1 - r)  of impulse,   m v^2 r^2 / 2  of energy,
// and the sums up to the limit are extrapolated to v = 0 from the latest impacts. Over a time in
// one contact mode, the pressing impulse of held masses follows from the balance of momentum
//   M [v] + K Y = integral of the forcing + impulses of the stops,   Y = integral of x + beta [x],
// with Y = s (t_b - t_a) for a held mass. The rows of the free masses give the rest of Y.
class Summary : public Recorder {
 public:
  // From time `from` to time `to` of a run of this scene, which must outlive the summary. A chatter
  // whose limit lies beyond `to` counts with its resolved impacts.
  Summary(const Scene &scene, double from, double to)
      : scene_(scene), from_(from), to_(to), totals_(scene.stops.size()) {
  }

  double next_time() const override;
  void sample(const Moment &moment) override;
  void event(const Event &event, const Moment &moment) override;

  // A row for each stop. To be called after the run.
  Table table() const;

 private:
  struct Totals {
    long long impacts = 0, sticks = 0;
    double speeds = 0.0, squares = 0.0, largest = 0.0, impulse = 0.0, energy = 0.0, contact = 0.0,
           pressing = 0.0;
    std::vector<double> falling = {};  // the latest speeds, each below the one before
  };

  const Scene &scene_;
  double from_, to_;
  int samples_ = 0;
  std::vector<Totals> totals_;         // by stop
  std::vector<double> impulses_ = {};  // on each mass, towards +x, in the present contact mode
  std::optional<MotionState> begin_ = {}, end_ = {};  // of the present contact mode

  void add(const Event &event, double impulse, double energy);
  void add_impact(const Event &event);
  void add_stick(const Event &event);
  void close_mode();
};

}  // namespace vibro_impact::runner
