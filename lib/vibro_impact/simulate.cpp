#include "simulate.hpp"

#include <cmath>

#include "at_an_impact.hpp"

namespace vibro_impact {

namespace detail {

template <int D>
double choose_span(const Run<D> &run, double remaining) {
  const double fastest = fastest_in_motion(*run.state.mode, run.state.value, run.state.slope);
  const double longest = fastest > 0.0 ? max_reach / fastest : remaining;
  if (!run.state.value.allFinite() || !run.state.slope.allFinite())
    throw std::runtime_error(
        fmt::format("the motion leaves the range of double precision before t = {}, given up",
                    time_of(run.state.now, run.clock)));
  if (longest < remaining && run.state.now.phase + longest == run.state.now.phase)
    throw std::runtime_error(
        fmt::format("the rate {} of the fastest mode cannot be resolved at t = {}, given up",
                    fastest, time_of(run.state.now, run.clock)));
  // Flights may be short without bound (r = 1e-300), spans not: slope * span must not underflow.
  return std::min({remaining, longest, std::max(run.flight_guess, 0x1p-60 * longest)});
}

template <int D>
Outcome simulate_lanes(const Scene &scene, const MotionState &start, double until,
                       const RunOptions &options, std::span<const RecorderRef> recorders) {
  const Clock clock(scene.omega);
  Run<D> run{scene, options, recorders, clock, instant_at(until, clock), {}};
  run.stride =
      scene.restitution > 0.0 && scene.restitution < 1.0 ? chatter_stride(scene.restitution) : 1;
  if (options.flight_tolerance != flight_rounding) {
    run.remainder.emplace(options.flight_tolerance);
    run.flight.expansion.remainder = run.chatter.bounces.path.remainder =
        run.chatter.tail.path.remainder = &*run.remainder;
  }
  for (const RecorderRef &recorder : recorders) {
    run.takes_events |= recorder.event != nullptr;
    run.takes_samples |= recorder.sample != nullptr;
  }
  run.last_speed.assign(scene.stops.size(), 0.0);
  run.falling.assign(scene.stops.size(), 0);
  run.period_start = run.state.now = start.instant;
  set_lanes(run.state, scene, run.modes.enter(scene, start.held, run.counters), start);
  run.state.stops.resize(scene.stops.size());
  for (std::size_t k = 0; k < scene.stops.size(); ++k) {
    const Stop &stop = scene.stops[k];
    const auto i = static_cast<Eigen::Index>(stop.mass - 1);
    const double sigma = sign(stop.side), gap = sigma * (stop.position - start.displacement(i));
    run.state.stops[k] = {gap, -sigma * start.velocity(i), 0, 0.0};
    if (start.held[static_cast<std::size_t>(stop.mass - 1)] == static_cast<int>(stop.side))
      run.state.stops[k] = {};  // held: nothing is known of its force beforehand
    else if (gap == 0.0)
      run.state.stops[k] = {0.0, -sigma * start.velocity(i), 1, -sigma * start.velocity(i)};
  }
  for (std::size_t k = 0; k < scene.stops.size(); ++k)
    if (start.held[static_cast<std::size_t>(scene.stops[k].mass - 1)] == 0 &&
        run.state.stops[k].gap == 0.0 && run.state.stops[k].speed == 0.0)
      settle(run, k);

  while (true) {
    const double remaining = elapsed(run.state.now, run.end, clock);
    if (!(remaining > 0.0)) break;
    const ContactMode<D> &mode = *run.state.mode;
    if (mode.open.empty() && mode.closed.empty()) {  // no stops: nothing can happen
      sample_flight(run, remaining);
      const State<D> from = run.state;
      flow(mode, scene, from.value, from.slope, remaining, run.state.value, run.state.slope);
      ++run.counters.modal_evaluations;
      run.state.now = run.end;
      break;
    }
    const double span = choose_span(run, remaining);
    run.flight_guess = std::numeric_limits<double>::infinity();
    expand(mode, run.state.value, run.state.slope, span, run.flight.expansion, run.counters);
    find_first_event(run.state, scene, clock, run.flight, run.counters);
    const FirstEvent &event = run.flight.event;
    sample_flight(run, event.u * span);
    move_to(run.state, run.flight, event.u, scene, clock, run.counters);
    run.since_impact += event.u * span;
    if (event.kind == Happening::nothing && span == remaining) run.state.now = run.end;

    switch (event.kind) {
      case Happening::nothing:
        break;
      case Happening::impact:
        handle_impact(run);
        break;
      case Happening::press:
        stick_at(run, event.stops.front());
        break;
      case Happening::release: {
        const std::size_t stop = event.stops.front();
        const double m = scene.mass[static_cast<std::size_t>(scene.stops[stop].mass - 1)];
        const int order = event.force_order;
        release_at(run, stop, std::min(order + 2, max_order),
                   -event.force_slope / (std::pow(span, order) * m));
        break;
      }
      case Happening::force_graze:
        run.state.stops[event.stops.front()].zeros = 1;
        break;
    }
  }
  return {physical(run.state, scene), time_of(run.state.now, clock), run.counters};
}

}  // namespace detail

Outcome simulate_seen(const Scene &scene, const MotionState &start, double until,
                      const RunOptions &options, std::span<const RecorderRef> recorders) {
  check(scene);
  for (const auto &[name, tolerance] :
       {std::pair{"chatter", options.chatter_tolerance}, {"flight", options.flight_tolerance}})
    detail::require(tolerance > 0.0 && tolerance < 1.0,
                    "{}_tolerance = {}: must lie between 0 and 1", name, tolerance);
  // The whole periods are counted, and the phase kept exact.
  detail::require(!(until * scene.omega > 0x1p53),
                  "until = {}: more forcing periods than double precision can count", until);
  // Up to three masses under forcing, the paper's case among them, get lanes of fixed size; the
  // code is the same. They have no room for a strongly damped mode split in two.
  if (scene.forced() && !strongly_damped(scene.beta, largest_eigenvalue_bound(scene))) {
    if (scene.masses() == 1)
      return detail::simulate_lanes<3>(scene, start, until, options, recorders);
    if (scene.masses() == 2)
      return detail::simulate_lanes<4>(scene, start, until, options, recorders);
    if (scene.masses() == 3)
      return detail::simulate_lanes<5>(scene, start, until, options, recorders);
  }
  return detail::simulate_lanes<Eigen::Dynamic>(scene, start, until, options, recorders);
}

}  // namespace vibro_impact
