/// \file
/// Counts of the work of a run. Unlike run time, they are repeatable. The work for an end, samples
/// and listed impacts before the limit of a chatter is not counted, but for states and modes.
#pragma once

namespace vibro_impact {

struct Counters {
  long long expansions = 0;          ///< Taylor expansions of the flow
  long long coefficients = 0;        ///< Taylor orders, summed over the expansions
  long long search_steps = 0;        ///< evaluations of a long flight in search of its end
  long long roots_searched = 0;      ///< polynomials iterated on
  long long root_iterations = 0;     ///< guaranteed steps taken by those iterations
  long long impacts = 0;             ///< impacts resolved one by one
  long long sticks = 0;              ///< masses that came to stick
  long long releases = 0;            ///< masses released
  long long rest_orders = 0;         ///< orders of forces computed to decide who sticks
  long long chatter_limits = 0;      ///< complete chatters that ended at their limit
  long long chatter_incomplete = 0;  ///< five or more falling impacts at a stop that end in flight
  long long modes_built = 0;         ///< contact modes that were built
  long long states_computed = 0;     ///< states at samples, and at ends in closed form
};

}  // namespace vibro_impact
