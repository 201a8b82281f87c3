#include "library_engine.hpp"

#include <algorithm>
#include <boost/math/statistics/linear_regression.hpp>
#include <stdexcept>
#include <utility>

#include "published_results.hpp"
#include "vibro_impact/analysis/analysis.hpp"
#include "vibro_impact/vibro_impact.hpp"

namespace vibro_impact::figures {

using numbers::Arguments;

namespace {

std::size_t index(int mass) {
  return static_cast<std::size_t>(mass - 1);
}

// The frequency between two at which a count differs.
template <class Count>
double change_of(const Count &count, double one, double other) {
  const CountJump change = bisect(count, std::min(one, other), std::max(one, other));
  return 0.5 * (change.below + change.above);
}

}  // namespace

std::vector<numbers::TimedEvent<double>> LibraryEngine::events(const paper::NamedScene &run) {
  std::vector<numbers::TimedEvent<double>> events;
  for (const Event &event : events_of(run.scene, 0.0, run.until))
    events.push_back({event.time, event.kind, event.mass, contact_mode_name(event.held)});
  return events;
}

double LibraryEngine::period(const Scene &scene) {
  return Clock(scene.omega).period;
}

Range LibraryEngine::range(const paper::NamedScene &run, int mass,
                           const numbers::Interval<double> &window) {
  SampleRecorder samples(window.from, window.to, 1e-4);
  require_complete(simulate(run.scene, window.to, samples));
  return range_of(samples, mass);
}

numbers::TurningPoint<double> LibraryEngine::turning_point(
    const paper::NamedScene &run, int mass, const numbers::Interval<double> &window) {
  const auto state_at = [&](double time) {
    return require_complete(simulate(run.scene, time)).state;
  };
  const double time =
      zero([&](double t) { return state_at(t).velocity[index(mass)]; }, window.from, window.to);
  return {time, state_at(time).displacement[index(mass)]};
}

double LibraryEngine::least_pressing(const paper::NamedScene &run, std::size_t stop) {
  const MotionState settled = state_after_periods(run.scene, 60);
  const PeriodicOrbit orbit = find_periodic_orbit(run.scene, at_quiet_phase(run.scene, settled));
  if (!orbit.converged) throw std::runtime_error("no periodic orbit: " + orbit.why_not);
  return least_pressing_force(run.scene, orbit.state, run.scene.stops[stop]).value().value;
}

double LibraryEngine::changing_frequency(const Scene &given, int mass, double near, double far,
                                         numbers::Change motion) {
  if (motion == numbers::Change::from_rest)
    return change_of(
        [&](double omega) { return settled_sticking_phases(with(given, "omega", omega), mass); },
        near, far);
  // The sticking phases change where the branch of the settled orbit ends.
  const Scene scene = with(given, "omega", near);
  const OrbitRecord settled = record_of(scene, {.settle = {.longest = 2000}});
  const OrbitPoint end = follow_orbit(scene, at_quiet_phase(scene, settled.state),
                                      {"omega", near, far, 7}, {.periods = settled.period})
                             .back();
  if (end.kind != BranchPoint::border_orbit && end.kind != BranchPoint::multi_sliding)
    throw std::runtime_error("the branch does not end where a sticking phase changes");
  return end.parameter;
}

double LibraryEngine::grazing_frequency(const Scene &given, int mass, double near, double far) {
  const auto stop = static_cast<std::ptrdiff_t>(numbers::stop_of(given, mass));
  const auto impacts = [&](double omega) {
    Scene scene = with(given, "omega", omega);
    scene.stops.erase(scene.stops.begin() + stop);
    const MotionState start = state_after_periods(scene, paper::figure4_settling_periods);
    scene.stops = given.stops;
    EventRecorder recorder(-1.0, infinity);
    stroboscopic_map(scene, start, 1, {}, recorder);
    return static_cast<int>(std::ranges::count_if(recorder.events, [mass](const Event &event) {
      return event.kind == EventKind::impact && event.mass == mass;
    }));
  };
  return change_of(impacts, near, far);
}

// --- Quantities that have a formula in 50 digits -------------------------------------------------

namespace {

NaturalModes free_modes(const Arguments &given) {
  const Scene scene = numbers::run_of(given).scene;
  return natural_modes(scene, Held(scene.mass.size(), 0));
}

// Intercept and slope of the least-squares line through the motion of the other mass at the
// releases of one at roots of its hold force. Several frequencies spread these points along the
// exit boundary.
std::pair<double, double> exit_boundary(const Arguments &given) {
  const int mass = given.mass("mass");
  std::vector<double> x, v;
  for (double omega : {0.25, 0.26, 0.27, 0.28, 0.29, 0.3, 0.32, 0.34, 0.36, 0.4}) {
    StickingPhaseRecorder phases(mass, 3 - mass, 0.0, 200.0, 200.0);
    require_complete(simulate(with(numbers::run_of(given).scene, "omega", omega), 200.0, phases));
    for (const auto &row : phases.rows) {
      if (row.kind != "release" || row.force != 0.0) continue;
      x.push_back(row.x);
      v.push_back(row.v);
    }
  }
  return boost::math::statistics::simple_ordinary_least_squares(x, v);
}

}  // namespace

const numbers::Quantities<LibraryEngine> &library_quantities() {
  static const auto quantities = [] {
    auto all = numbers::common_quantities<LibraryEngine>();
    const std::string run = numbers::run_names;
    add(all, "eigenvalue", run + " mode", [](const Arguments &given) {
      return free_modes(given).lambda.at(index(given.mass("mode")));
    });
    add(all, "mode_shape", run + " mode mass", [](const Arguments &given) {
      return free_modes(given).shape(index(given.mass("mass")), index(given.mass("mode")));
    });
    add(all, "exit_slope", run + " mass",
        [](const Arguments &given) { return exit_boundary(given).second; });
    add(all, "exit_intercept", run + " mass",
        [](const Arguments &given) { return exit_boundary(given).first; });
    published::add_quantities(all);
    return all;
  }();
  return quantities;
}

void add(numbers::Quantities<LibraryEngine> &all, const std::string &quantity,
         const std::string &names, std::function<double(const Arguments &)> answer) {
  all[quantity] = {names, [answer = std::move(answer)](LibraryEngine &, const Arguments &given) {
                     return answer(given);
                   }};
}

double computed(const numbers::CheckedNumber &number) {
  LibraryEngine engine;
  return numbers::answer(engine, library_quantities(), number);
}

}  // namespace vibro_impact::figures
