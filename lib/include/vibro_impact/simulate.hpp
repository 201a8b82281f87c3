// A run: from a scene and a start to an outcome, telling recorders what happens on the way.
//
// Threads may run simulations at the same time, each its own: they share nothing that changes.
#pragma once

#include <array>
#include <limits>
#include <memory>
#include <span>
#include <string>

#include "counters.hpp"
#include "record.hpp"
#include "scene.hpp"

namespace vibro_impact {

struct RunOptions {
  // Chatter is carried to its limit only from impacts slower than this: every faster one is
  // resolved and recorded. 0 resolves chatter until what is left of it lies below rounding.
  double resolve_chatter = std::numeric_limits<double>::infinity();
  // Largest estimated error of the time of a chatter limit, times the rate of the fastest mode, at
  // which the limit is accepted, in (0, 1).
  double chatter_tolerance = 1e-13;
  // Largest remainder of the expansion of a flight, relative to its second-order term, in (0, 1);
  // the order follows from it. The default lies below rounding.
  double flight_tolerance = 0x1p-56;
  // More impacts than this in one forcing period, or in a thousand periods of the fastest mode
  // where these are shorter, end the run: it is given up. Without a forcing that turns, the window
  // is one period of that mode.
  long long max_impacts_per_period = 1'000'000;
};

// Why a run ended: it reached its time, a recorder was done, or it was given up.
enum class Ending { reached, stopped, given_up };

struct Outcome {
  MotionState state;  // at the end: N displacements and velocities, and the contact mode
  double time = 0.0;
  Ending ending = Ending::reached;
  std::string reason = {};  // one line: why the run was given up
  Counters counters;
};

// Returns the outcome. Throws std::runtime_error with the reason when the run was given up.
Outcome require_complete(Outcome outcome);

namespace detail {

struct Run;
Outcome simulate(const Scene &scene, const MotionState *start, double until,
                 const RunOptions &options, std::span<const RecorderRef> recorders);

}  // namespace detail

// A run as a value. A copy goes on as the original would, bit for bit, also inside a chatter; it
// shares nothing with the original that a thread could change.
class Simulation {
 public:
  // From the scene's own initial state at t = 0, or from another motion of it. Throws
  // std::invalid_argument, with one line that names the value and the rule, for a scene that
  // `check` rejects, a start that does not fit it, and options out of range.
  explicit Simulation(const Scene &scene, const RunOptions &options = {});
  Simulation(const Scene &scene, const MotionState &start, const RunOptions &options = {});
  Simulation(const Simulation &other);
  Simulation(Simulation &&other) noexcept;
  Simulation &operator=(Simulation other) noexcept;
  ~Simulation();

  // Goes on with other options. Throws std::invalid_argument for options out of range.
  void set_options(const RunOptions &options);

  // Runs on to time `until` (non-dimensional, counted from t = 0) and tells the recorders what they
  // ask for. The events do not depend on the times at which calls end. The counters of the outcome
  // are those of this call. Throws std::invalid_argument, with one line, for a time that is not
  // finite or lies before where the simulation stands, and where a recorder rejects the scene.
  template <Recorder... Recorders>
  [[nodiscard]] Outcome advance(double until, Recorders &...recorders) {
    const std::array<detail::RecorderRef, sizeof...(Recorders)> refs{
        detail::recorder_ref(recorders)...};
    return advance_with(until, refs);
  }
  [[nodiscard]] Outcome advance(double until, const RecorderGroup &recorders) {
    return advance_with(until, recorders.refs());
  }

 private:
  std::unique_ptr<detail::Run> run_;

  Outcome advance_with(double until, std::span<const detail::RecorderRef> recorders);
};

// One call of `advance` of a new simulation: from the scene's own initial state at t = 0, or from
// another motion of it. Throws what its constructor and `advance` throw.
template <Recorder... Recorders>
[[nodiscard]] Outcome simulate(const Scene &scene, const MotionState &start, double until,
                               const RunOptions &options, Recorders &...recorders) {
  const std::array<detail::RecorderRef, sizeof...(Recorders)> refs{
      detail::recorder_ref(recorders)...};
  return detail::simulate(scene, &start, until, options, refs);
}

template <Recorder... Recorders>
[[nodiscard]] Outcome simulate(const Scene &scene, const MotionState &start, double until,
                               Recorders &...recorders) {
  return simulate(scene, start, until, RunOptions{}, recorders...);
}

template <Recorder... Recorders>
[[nodiscard]] Outcome simulate(const Scene &scene, double until, const RunOptions &options,
                               Recorders &...recorders) {
  const std::array<detail::RecorderRef, sizeof...(Recorders)> refs{
      detail::recorder_ref(recorders)...};
  return detail::simulate(scene, nullptr, until, options, refs);
}

template <Recorder... Recorders>
[[nodiscard]] Outcome simulate(const Scene &scene, double until, Recorders &...recorders) {
  return simulate(scene, until, RunOptions{}, recorders...);
}

}  // namespace vibro_impact
