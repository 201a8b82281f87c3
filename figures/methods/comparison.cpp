// The library beside a stiff spring in place of the stops and the plain event-driven scheme.
//
// comparison_springs.csv     (a), (b): errors and cost of the stiff spring
// comparison_cost.csv        (b): cost of the library and of the plain scheme, the same period
// comparison_chatter.csv     (c): impact speeds over the first chatter
// comparison_thresholds.csv  (d): the plain scheme with and without a threshold
#include "comparison.hpp"

#include "figures/driver.hpp"

namespace {

using namespace vibro_impact;

constexpr double softest = 1e2, stiffest = 1e16;
constexpr long long most_evaluations = 5'000'000, most_impacts = 1'000'000;

// (a) errors well before the first chatter, (b) cost of the first forcing period.
template <class Advance>
Table springs(const Scene &scene, Advance &&advance) {
  Table table(
      "stepper,tolerance,kappa,time_error,state_error,evaluations,jacobians,steps,contacts,"
      "reached,broke");
  const figures::Rigid rigid = figures::rigid_motion(scene);
  for (auto stepper : {stiff_spring::Stepper::dopri5, stiff_spring::Stepper::rosenbrock4})
    for (double tolerance : {1e-6, 1e-10})
      for (int half_decades = 0; half_decades <= 28; ++half_decades) {
        const double kappa = softest * std::pow(10.0, half_decades / 2.0);
        const stiff_spring::Options options{kappa, tolerance, stepper, most_evaluations};
        const figures::SpringError error = figures::spring_error(scene, rigid, options);
        const auto period = stiff_spring::integrate(scene, Clock(scene.omega).period, options);
        table.row(name(stepper), tolerance, kappa, error.time, error.state, period.evaluations,
                  period.jacobians, period.steps, period.contacts.size(), period.time,
                  period.broke.empty() ? "-" : period.broke);
        advance();
      }
  return table;
}

// (b) the same forcing period by the library and by the plain scheme; two rows, to draw a line.
Table cost(const Scene &scene) {
  const double period = Clock(scene.omega).period;
  const Counters counters = require_complete(simulate(scene, period)).counters;
  const plain::Result plain = plain::run(scene, period, {.threshold = 1e-6});
  Table table("kappa,expansions,coefficients,plain_evaluations");
  for (double kappa : {softest, stiffest})
    table.row(kappa, counters.expansions, counters.coefficients, plain.evaluations);
  return table;
}

// (c) speeds against the number of the impact of mass 1. The plain scheme goes on.
Table chatter(const Scene &scene) {
  constexpr int shown = 250;
  Table table("scheme,impact,time,speed");
  int impact = 0;
  for (const Event &event : figures::resolved_chatter(scene))
    table.row("library", ++impact, event.time, std::abs(event.velocity_before));
  impact = 0;
  for (const auto &event : plain::run(scene, 20.0, {.max_impacts = shown + 10}).events)
    if (event.mass == 1 && impact < shown)
      table.row("plain", ++impact, event.time, std::abs(event.velocity_before));
  return table;
}

// (d) impacts per forcing period up to t = 750, and the largest errors in the times of sticks and
// releases. Threshold 0: none. `needed`: impacts at least as fast as the threshold and one more for
// every stick, by the library with all chatter resolved; NaN below the speed it resolves to.
template <class Advance>
Table thresholds(const Scene &scene, Advance &&advance) {
  constexpr double until = 750.0;
  const double periods = until / Clock(scene.omega).period;
  EventRecorder limits, resolved;
  const Outcome outcome = require_complete(simulate(scene, until, {}, limits));
  RunOptions options;
  options.resolve_chatter = 0.0;
  require_complete(simulate(scene, until, options, resolved));
  Table table(
      "threshold,impacts_per_period,needed,library,stick_error,release_error,impacts,"
      "sticks,releases,evaluations,reached,capped");
  const auto row = [&](double threshold) {
    const figures::ThresholdRun run = figures::with_threshold(
        scene, until, limits.events, {.threshold = threshold, .max_impacts = most_impacts});
    const auto faster =
        std::count_if(resolved.events.begin(), resolved.events.end(), [threshold](const Event &e) {
          return e.kind == EventKind::impact && std::abs(e.velocity_before) >= threshold;
        });
    const double elapsed = run.plain.time / Clock(scene.omega).period;
    table.row(threshold, static_cast<double>(run.plain.impacts) / std::max(1.0, elapsed),
              threshold < 1e-10 ? figures::not_reached
                                : static_cast<double>(faster + outcome.counters.sticks) / periods,
              static_cast<double>(outcome.counters.impacts) / periods, run.stick_error,
              run.release_error, run.plain.impacts, run.sticks, run.releases, run.plain.evaluations,
              run.plain.time, run.plain.capped ? 1 : 0);
    advance();
  };
  for (int decade = 2; decade <= 13; ++decade) row(std::pow(10.0, -decade));
  row(0.0);
  return table;
}

}  // namespace

int main(int argc, char **argv) {
  return figures::drive(argc, argv,
                        "The library beside a stiff spring and the plain event-driven scheme",
                        [](const std::filesystem::path &output) {
                          const Scene scene = paper::figure2();
                          Progress progress("comparison", 4 * 29 + 13);
                          const auto advance = [&progress] { progress.advance(); };
                          const Table spring_table = springs(scene, advance);
                          const Table threshold_table = thresholds(scene, advance);
                          write(spring_table, output / "comparison_springs.csv");
                          write(cost(scene), output / "comparison_cost.csv");
                          write(chatter(scene), output / "comparison_chatter.csv");
                          write(threshold_table, output / "comparison_thresholds.csv");
                        });
}
