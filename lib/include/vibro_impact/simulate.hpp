/// \file
/// A run goes from a scene and a start to an outcome, and reports the events and samples on the way
/// to recorders. Times, velocities and forces are non-dimensional.
///
///     #include <vibro_impact/vibro_impact.hpp>
///     #include <cstdio>
///     int main() {
///       using namespace vibro_impact;
///       const Scene scene{.mass = {1}, .stiffness = {1}, .amplitude = {0.5}, .omega = 0.4,
///                         .restitution = 0.7, .stops = {{1, Side::upper, 0.2}}};
///       EventRecorder events;
///       const Outcome outcome = require_complete(simulate(scene, 100.0, events));
///       for (const Event &e : events.events) std::printf("%.17g %s\n", e.time, name(e.kind));
///       std::printf("%lld impacts, x = %.17g\n", outcome.counters.impacts,
///                   outcome.state.displacement[0]);
///     }
///
/// Threads may run different simulations at the same time, because runs share nothing that changes.
#pragma once

#include <array>
#include <concepts>
#include <memory>
#include <span>
#include <string>

#include "counters.hpp"
#include "record.hpp"
#include "scene.hpp"

namespace vibro_impact {

struct RunOptions {
  /// A chatter of impacts slower than this ends at its limit. The motion resolves every faster
  /// impact. Recorders may ask for slower ones, which do not change it. With 0, all impacts are
  /// resolved until the remaining ones lie below rounding.
  double limit_below_speed = infinity;
  /// Largest estimated error at which a chatter limit is accepted: of its time, relative to the
  /// duration of the chatter and to 1 / rate of the fastest mode, and of the velocities, relative
  /// to their jumps. It lies in (0, 1).
  double chatter_tolerance = 1e-13;
  /// Largest remainder of the Taylor series of a step, relative to its second-order term, from
  /// 1e-21 to below 1. The order of the series follows from it. The default lies so far below
  /// rounding that the energy of an elastic chain does not drift.
  double flight_tolerance = 0x1p-59;
  /// A run is given up after this many steps in one call of `advance`. Every impact ends a step, so
  /// that this number bounds the impacts, too. Twenty orders of decisions who sticks take as long
  /// as a step, and count as one. A sample or a listed impact inside a chatter that is taken to its
  /// limit needs further impacts, which count for themselves. An undamped mode of frequency w takes
  /// at least w/2 steps per unit of time while an impact is near.
  long long max_steps = 10'000'000;
};

/// Why a run ended: it reached its time, a recorder stopped it, or it was given up, after
/// `max_steps`, because the motion comes next to the largest double (1e305), because the search for
/// a root does not end, or because a mass lies beyond its stop, which is a fault of the library.
enum class Ending { reached, stopped, given_up };

struct Outcome {
  MotionState state = {};  ///< at the end: N displacements and velocities, and the contact mode
  double time = 0.0;       ///< at the end, counted from t = 0
  Ending ending = Ending::reached;
  std::string reason = {};  ///< one line that says why the run was given up
  Counters counters = {};
};

/// Returns the outcome, or throws std::runtime_error with the reason if the run was given up.
Outcome require_complete(Outcome outcome);

namespace detail {
struct Run;
}

/// A run as a value. A copy goes on as the original would, bit for bit, also inside a chatter. It
/// shares nothing with the original that changes, so another thread may advance it.
class Simulation {
 public:
  /// Starts from the scene's own initial state at t = 0, or from another motion of it. Throws
  /// std::invalid_argument, with one line that names the value and the rule, for a scene that
  /// `check` rejects, a start that does not fit it, and options out of range.
  ///
  /// A simulation that was moved from can be assigned to and destroyed, and nothing else.
  explicit Simulation(const Scene &scene, const RunOptions &options = {});
  Simulation(const Scene &scene, const MotionState &start, const RunOptions &options = {});
  Simulation(const Simulation &other);
  Simulation(Simulation &&other) noexcept;
  Simulation &operator=(Simulation other) noexcept;
  ~Simulation();

  /// The scene of the run. The reference is valid until the simulation is assigned to or destroyed.
  const Scene &scene() const;

  /// Goes on from another motion of the scene, as a new simulation with these options would start
  /// from it. Throws std::invalid_argument for a start that does not fit the scene, which is not
  /// checked again.
  void start_from(const MotionState &start);

  /// Runs on to time `until`, counted from t = 0, and calls the recorders on the way. The events do
  /// not depend on the times at which calls end. Which impacts of a chatter they list, and which
  /// the event at its limit sums up, depends on what the recorders ask for. The counters of the
  /// outcome are those of this call. Throws std::invalid_argument, with one line, for a time that
  /// is not finite or lies before the state of the simulation, for a sample before it, and if a
  /// recorder refuses the scene. Throws it also if some mode may still swing at the end, and its
  /// rate times the time to run exceeds 1e12: its phase then has a rounding of 1e-4. Passes on what
  /// a recorder throws.
  [[nodiscard]] Outcome advance(double until, std::span<Recorder *const> recorders);
  template <std::derived_from<Recorder>... Recorders>
  [[nodiscard]] Outcome advance(double until, Recorders &...recorders) {
    const std::array<Recorder *, sizeof...(Recorders)> pointers{&recorders...};
    return advance(until, std::span<Recorder *const>(pointers));
  }

 private:
  std::unique_ptr<detail::Run> run_;
};

/// Makes a simulation from the scene's own initial state and calls `advance` once. Throws what the
/// constructor and `advance` throw.
template <std::derived_from<Recorder>... Recorders>
[[nodiscard]] Outcome simulate(const Scene &scene, double until, const RunOptions &options,
                               Recorders &...recorders) {
  return Simulation(scene, options).advance(until, recorders...);
}
template <std::derived_from<Recorder>... Recorders>
[[nodiscard]] Outcome simulate(const Scene &scene, double until, Recorders &...recorders) {
  return Simulation(scene).advance(until, recorders...);
}

}  // namespace vibro_impact
