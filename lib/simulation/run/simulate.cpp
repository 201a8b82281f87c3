#include "vibro_impact/simulate.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

#include "run.hpp"
#include "simulation/chain/forces.hpp"
#include "simulation/chain/require.hpp"

namespace vibro_impact {

namespace detail {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double most_radians = 1e12;  // of an undamped mode, whose phase rounds to 1e-4 there

void check_options(const RunOptions &options) {
  for (const auto &[name, tolerance] :
       {std::pair{"chatter", options.chatter_tolerance}, {"flight", options.flight_tolerance}})
    require(tolerance > 0.0 && tolerance < 1.0, name, "_tolerance = ", tolerance,
            ": must lie between 0 and 1");
  require(options.flight_tolerance >= least_flight_tolerance,
          "flight_tolerance = ", options.flight_tolerance, ": must be at least ",
          least_flight_tolerance, ", the remainder of the highest order");
  require(options.resolve_chatter >= 0.0, "resolve_chatter = ", options.resolve_chatter,
          ": must be non-negative");
  require(options.max_steps > 0, "max_steps = ", options.max_steps, ": must be positive");
}

// A run before its first step.
Run start_run(std::shared_ptr<const Scene> scene, const MotionState *start,
              const RunOptions &options) {
  MotionState state = start_of(*scene);  // checks the scene
  if (start != nullptr) {
    check(*scene, *start);
    state = *start;
  }
  check_options(options);
  Run run{.problem = Problem(std::move(scene), options), .start = std::move(state)};
  run.motion.now = run.start->instant;
  return run;
}

Outcome advance_to(Run &run, double until, Recorders recorders) {
  const Clock &clock = run.problem.clock;
  // The motion of the run may stand before the end of the call before: see `advance`.
  const Instant begin = run.start ? run.start->instant : run.progress.last.instant;
  const double begin_time = time_of(begin, clock);
  require(std::isfinite(until), "until = ", until, ": must be finite");
  const Instant end = instant_at(until, clock);
  require(until >= begin_time || !(end < begin), "until = ", until, ": lies before the start at ",
          begin_time);
  const double rate = std::sqrt(largest_eigenvalue_bound(run.scene()));
  require(run.scene().beta > 0.0 || rate * (until - begin_time) <= most_radians, "rate = ", rate,
          " of an undamped chain: times the time ", until - begin_time, " it must not exceed ",
          most_radians);
  for (const Recorder *recorder : recorders) {
    recorder->check(run.scene());
    const double first = recorder->next_time();
    require(first >= begin_time, "sample at t = ", first, ": the run begins at ", begin_time);
  }
  run.counters = {};
  advance(run, end, recorders);
  const Progress &progress = run.progress;
  return {progress.last, time_of(progress.last.instant, clock), progress.ending, progress.reason,
          run.counters};
}

}  // namespace

Problem::Problem(std::shared_ptr<const Scene> scene_of_run, const RunOptions &options_of_run)
    : scene(std::move(scene_of_run)),
      options(options_of_run),
      clock(scene->omega),
      rate_bound(detail::rate_bound(*scene)),
      forced(scene->forced()),
      orders(options.flight_tolerance) {
}

}  // namespace detail

Outcome require_complete(Outcome outcome) {
  if (outcome.ending == Ending::given_up) throw std::runtime_error(outcome.reason);
  return outcome;
}

Simulation::Simulation(const Scene &scene, const RunOptions &options)
    : run_(std::make_unique<detail::Run>(
          detail::start_run(std::make_shared<const Scene>(scene), nullptr, options))) {
}

Simulation::Simulation(const Scene &scene, const MotionState &start, const RunOptions &options)
    : run_(std::make_unique<detail::Run>(
          detail::start_run(std::make_shared<const Scene>(scene), &start, options))) {
}

Simulation::Simulation(const Simulation &other) : run_(std::make_unique<detail::Run>(*other.run_)) {
}

Simulation::Simulation(Simulation &&other) noexcept = default;

Simulation &Simulation::operator=(Simulation other) noexcept {
  run_ = std::move(other.run_);
  return *this;
}

Simulation::~Simulation() = default;

void Simulation::set_options(const RunOptions &options) {
  detail::check_options(options);
  run_->problem = detail::Problem(run_->problem.scene, options);
}

Outcome Simulation::advance(double until, std::span<Recorder *const> recorders) {
  return detail::advance_to(*run_, until, recorders);
}

}  // namespace vibro_impact
