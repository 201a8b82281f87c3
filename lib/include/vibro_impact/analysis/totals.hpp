/// \file
/// Impulses, energies and times of contact of each stop in a part of a run: sums over events and
/// over two states.
#pragma once

#include <optional>
#include <vector>

#include "vibro_impact/record.hpp"

namespace vibro_impact {

/// The totals of a stop. Impulses are those of the stop on its mass, away from the stop.
struct StopTotals {
  long long impacts = 0;       ///< down to the speed that the recorder states
  long long sticks = 0;        ///< phases of sticking that begin
  ImpactSum taken = {};        ///< by all impacts, also the infinitely many of complete chatters
  double largest_speed = 0.0;  ///< of these impacts
  double contact = 0.0;        ///< the time in which the stop holds its mass
  double pressing = 0.0;       ///< the impulse of the stop on the mass that it holds
};

/// Records the totals from time `from` to time `to` of a run of this scene. Impacts of a chatter
/// are counted as EventRecorder records them.
///
/// While the contact mode is the same, the pressing impulse follows from the balance of momentum
///   M [v] + K Y = integral of the forcing + impulses of the stops,   Y = integral of x + beta [x],
/// with Y = s (t_b - t_a) for a held mass. The rows of the free masses give the rest of Y.
struct TotalsRecorder : Recorder {
  double from, to;
  std::optional<double> slowest;
  std::vector<StopTotals> stops;  ///< one for each stop of the scene

  TotalsRecorder(const Scene &scene, double from_time, double to_time,
                 std::optional<double> slowest_speed = {});
  void check(const Scene &scene) const override;
  double slowest_impact(double first, double limit) const override;
  double next_time() const override;
  void sample(const Moment &moment) override;
  void event(const Event &event, const Moment &moment) override;

 private:
  Scene scene_;
  int samples_ = 0;
  std::vector<double> first_speeds_;  ///< of the impacts at each stop whose speeds fall
  std::vector<double> impulses_;      ///< on each mass, towards +x, in the present contact mode
  std::optional<MotionState> begin_ = {}, end_ = {};  ///< of the present contact mode

  void add(int stop, const ImpactSum &taken, double share);
  void add_unreported(const Moment &moment, double share);
  void close_mode();
};

}  // namespace vibro_impact
