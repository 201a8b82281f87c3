#include "procedures.hpp"

#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "fixed_steps.hpp"
#include "vibro_impact/analysis/pressing_force.hpp"

namespace vibro_impact::figures {

namespace {

// Records events, and ends a run where the procedure has to act.
struct ProcedureRecorder : Recorder {
  Procedure procedure;
  std::array<double, 2> last_impact;  // of each mass, its time
  std::vector<Event> events = {};
  int cut_off = 0;                  // the mass whose chatter the procedure ends, 0: none
  bool mass_2_has_changed = false;  // it sticks, or is released

  explicit ProcedureRecorder(const Procedure &followed) : procedure(followed) {
    last_impact.fill(-infinity);
  }
  void event(const Event &event, const Moment &) override {
    events.push_back(event);
    mass_2_has_changed = event.mass == 2 && changes_contact_mode(event.kind);
    cut_off = 0;
    if (event.kind != EventKind::impact) return;
    double &last = last_impact[static_cast<std::size_t>(event.mass - 1)];
    if (event.time - last < procedure.shortest_flight ||
        std::abs(event.velocity_before) < procedure.slowest_impact)
      cut_off = event.mass;
    last = event.time;
  }
  bool done() const override {
    return cut_off != 0 || (mass_2_has_changed && procedure.printed_equation24);
  }
};

}  // namespace

FollowedMotion follow(Scene scene, MotionState state, double until, const Procedure &procedure) {
  if (procedure.step > 0.0) return follow_in_steps(scene, std::move(state), until, procedure);
  // Impacts faster than this are resolved, so that a cut-off acts before the limit of a chatter is
  // computed. The forces at the stops are of the order of 0.1, and the flight behind an impact at
  // the speed 1e-5 lasts some 2e-4, less than any cut-off by flights that is tried.
  const double slower_than_all =
      procedure.slowest_impact > 0.0 ? 0.1 * procedure.slowest_impact : 1e-5;
  const bool cuts_off = procedure.shortest_flight > 0.0 || procedure.slowest_impact > 0.0;
  const RunOptions options{.limit_below_speed =
                               cuts_off ? slower_than_all : RunOptions{}.limit_below_speed};
  ProcedureRecorder recorder(procedure);
  std::optional<Simulation> run;
  for (;;) {
    if (!run) {
      if (procedure.printed_equation24)
        scene.constant = {state.held[1] != 0 ? -2.0 * scene.stops[1].position : 0.0, 0.0};
      run.emplace(scene, state, options);
    }
    const Outcome outcome = require_complete(run->advance(until, recorder));
    state = outcome.state;
    if (outcome.ending == Ending::reached) return {std::move(recorder.events), std::move(state)};
    if (recorder.cut_off != 0) {
      const auto i = static_cast<std::size_t>(recorder.cut_off - 1);
      const Stop &stop = scene.stops[i];
      const double force = pressing_force(scene, stop, state);
      if (!(procedure.holds_without_force ? force >= 0.0 : force > 0.0)) continue;
      state.velocity[i] = 0.0;
      state.held[i] = static_cast<signed char>(stop.side);
      Event stick = recorder.events.back();
      stick.kind = EventKind::stick;
      stick.held = state.held;
      recorder.events.push_back(stick);
    }
    // At a release the force on mass 2 is zero but for rounding, which must not hold it again. The
    // gap is far below all that is counted.
    if (recorder.mass_2_has_changed && state.held[1] == 0)
      state.displacement[1] -= sign(scene.stops[1].side) * 1e-12;
    run.reset();
  }
}

}  // namespace vibro_impact::figures
