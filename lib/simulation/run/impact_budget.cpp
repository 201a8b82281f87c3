#include "impact_budget.hpp"

#include <algorithm>

#include "events_at_an_instant.hpp"
#include "simulation/chain/require.hpp"

namespace vibro_impact::detail {

namespace {

// True when the impacts at this instant continue a chatter of so many impacts that the budget would
// end the run before the limit. They do not count while two nodes of the chatter table are at most
// ten budgets of impacts apart. With the default budget of 1e6 this holds up to r = 0.9999999.
bool continues_slow_chatter(const Run &run, std::span<const std::size_t> hits) {
  const Chatter &chatter = run.chatter;
  const long long budget = run.problem.options.max_impacts_per_period;
  return chatter.stride >= slow_chatter_stride && chatter.under_way() &&
         chatter.stride / longest_stride <= static_cast<std::size_t>(budget) &&
         std::ranges::equal(hits, chatter.contacts);
}

}  // namespace

void count_impact(Run &run, std::span<const std::size_t> hits, StopState &stop, double speed) {
  ++run.counters.impacts;
  const bool falls = speed < stop.last_speed;
  if (!falls && stop.falling >= chatter_impacts) ++run.counters.chatter_incomplete;
  stop.falling = falls ? stop.falling + 1 : 0;
  stop.last_speed = speed;
  const double flight = elapsed(stop.left, run.motion.now, run.problem.clock);
  stop.duration = std::max(falls ? stop.duration : 0.0, flight);
  stop.left = run.motion.now;
  if (run.progress.inside_chatter || continues_slow_chatter(run, hits)) return;
  ImpactBudget &budget = run.budget;
  if (!(elapsed(budget.start, run.motion.now, run.problem.clock) <= budget.window)) {
    budget.start = run.motion.now;
    budget.impacts = 0;
  }
  const long long most = run.problem.options.max_impacts_per_period;
  if (++budget.impacts > most)
    stop_run(run, Ending::given_up,
             line("more than ", most, " impacts in one period, given up at t = ",
                  time_of(run.motion.now, run.problem.clock)));
}

}  // namespace vibro_impact::detail
