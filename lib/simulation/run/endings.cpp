#include "endings.hpp"

#include <cmath>
#include <utility>

#include "simulation/chain/require.hpp"
#include "simulation/chain/tolerances.hpp"

namespace vibro_impact::detail {

namespace {

bool is_in_range(const Motion &motion) {
  for (std::size_t i = 0; i < motion.x.size(); ++i)
    if (!(std::abs(motion.x[i].hi) <= largest_motion && std::abs(motion.v[i].hi) <= largest_motion))
      return false;
  return true;
}

void give_up_beyond_range(Run &run, double time) {
  stop_run(run, Ending::given_up,
           line("the motion leaves the range of double precision before t = ", time, ", given up"));
}

}  // namespace

void stop_run(Run &run, Ending ending, std::string reason) {
  if (run.progress.ending) return;
  run.progress.ending = ending;
  run.progress.reason = std::move(reason);
}

void check_motion(Run &run, const Motion &motion) {
  const double time = time_of(motion.now.rounded(), run.chain().clock);
  if (!is_in_range(motion)) return give_up_beyond_range(run, time);
  for (const Contact &stop : run.chain().stops) {
    const double gap = stop.sigma * (stop.position - motion.x[stop.mass].hi);
    if (!(gap < 0.0)) continue;
    const double terms = std::abs(stop.position) + motion.x_terms[stop.mass];
    if (!is_rounding_at_stop(-gap, terms, largest_terms(run.chain(), motion, time)))
      return stop_run(run, Ending::given_up,
                      line("mass ", stop.mass + 1, " lies beyond its stop at t = ", time,
                           ", given up: an event was missed"));
  }
}

void check_search(Run &run, const FlightEnd &end) {
  if (!end.event || std::isfinite(end.tau.hi)) return;
  if (std::isnan(end.tau.hi)) return give_up_beyond_range(run, run.time());
  stop_run(run, Ending::given_up,
           line("a root is not found in ", most_root_iterations,
                " iterations after t = ", run.time(), ", given up"));
}

long long steps_left(const Run &run) {
  const Counters &counters = run.counters;
  return run.problem.options.max_steps - counters.expansions - counters.search_steps -
         counters.rest_orders / orders_as_a_step;
}

void check_steps(Run &run) {
  if (steps_left(run) > 0) return;
  stop_run(run, Ending::given_up,
           line("at least ", run.problem.options.max_steps, " steps, given up at t = ", run.time(),
                "; the largest rate is ", run.motion.mode->fastest,
                "; RunOptions::max_steps (--max-steps) can allow more"));
}

}  // namespace vibro_impact::detail
