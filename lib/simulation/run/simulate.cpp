#include "vibro_impact/simulate.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "run.hpp"
#include "simulation/chain/require.hpp"
#include "simulation/chain/scene.hpp"
#include "simulation/chain/tolerances.hpp"

namespace vibro_impact {

namespace detail {

namespace {

// The most radians after which some mode of rates up to `rate` may still swing: with the damping
// beta, the amplitude of a mode of the rate w falls by exp(-beta w^2 t / 2).
double longest_swing(double rate, double beta, double time) {
  return std::min(rate, std::sqrt(2.0 * dead_after / (beta * time))) * time;
}

void check_options(const RunOptions &options) {
  for (const auto &[name, tolerance] :
       {std::pair{"chatter", options.chatter_tolerance}, {"flight", options.flight_tolerance}})
    require(tolerance > 0.0 && tolerance < 1.0, name, "_tolerance = ", tolerance,
            ": must lie between 0 and 1");
  require(options.flight_tolerance >= least_flight_tolerance,
          "flight_tolerance = ", options.flight_tolerance, ": must be at least ",
          least_flight_tolerance, ", the remainder of the highest order");
  require(options.limit_below_speed >= 0.0, "limit_below_speed = ", options.limit_below_speed,
          ": must be non-negative");
  require(options.max_steps > 0, "max_steps = ", options.max_steps, ": must be positive");
}

// The run is made where it stays: it has 5 kB, of which `make_unique` would move a copy.
std::unique_ptr<Run> new_run(const Scene &scene, MotionState start, const RunOptions &options) {
  check_options(options);
  return std::unique_ptr<Run>(new Run{.problem = {std::make_shared<const Scene>(scene), options},
                                      .start = std::move(start)});
}

}  // namespace

Problem::Problem(std::shared_ptr<const Scene> scene_of_run, const RunOptions &options_of_run)
    : scene(std::move(scene_of_run)),
      chain(std::make_shared<const Chain>(*scene)),
      options(options_of_run) {
}

}  // namespace detail

Outcome require_complete(Outcome outcome) {
  if (outcome.ending == Ending::given_up) throw std::runtime_error(outcome.reason);
  return outcome;
}

Simulation::Simulation(const Scene &scene, const RunOptions &options) {
  check(scene);
  run_ = detail::new_run(scene, detail::first_motion(scene), options);
}

Simulation::Simulation(const Scene &scene, const MotionState &start, const RunOptions &options) {
  check(scene);
  check(scene, start);
  run_ = detail::new_run(scene, start, options);
}

Simulation::Simulation(const Simulation &other) : run_(std::make_unique<detail::Run>(*other.run_)) {
}

Simulation::Simulation(Simulation &&other) noexcept = default;

Simulation &Simulation::operator=(Simulation other) noexcept {
  run_ = std::move(other.run_);
  return *this;
}

Simulation::~Simulation() = default;

const Scene &Simulation::scene() const {
  return run_->scene();
}

void Simulation::start_from(const MotionState &start) {
  check(scene(), start);
  run_.reset(new detail::Run{.problem = run_->problem, .start = start});
}

Outcome Simulation::advance(double until, std::span<Recorder *const> recorders) {
  using detail::require;
  detail::Run &run = *run_;
  const Clock &clock = run.chain().clock;
  // The motion of the run may stand before the end of the call before: see `advance`.
  const double begin_time =
      time_of(run.start ? run.start->instant : run.progress.last.instant, clock);
  require(std::isfinite(until), "until = ", until, ": must be finite");
  const Instant end = instant_at(until, clock);
  require(until >= begin_time, "until = ", until, ": lies before the start at ", begin_time);
  const double rate = std::sqrt(detail::largest_eigenvalue_bound(run.scene()));
  require(detail::longest_swing(rate, run.scene().beta, until - begin_time) <= detail::most_radians,
          "rate = ", rate, " of a chain that swings on: times the time ", until - begin_time,
          " it must not exceed ", detail::most_radians);
  for (const Recorder *recorder : recorders) {
    recorder->check(run.scene());
    const double first = recorder->next_time();
    require(first >= begin_time, "sample at t = ", first, ": the run begins at ", begin_time);
  }
  detail::advance(run, end, recorders);
  const detail::Progress &progress = run.progress;
  return {progress.last, time_of(progress.last.instant, clock), *progress.ending, progress.reason,
          run.counters};
}

}  // namespace vibro_impact
