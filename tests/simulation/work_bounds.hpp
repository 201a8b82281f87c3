// What a run may cost: its work is bounded by its events and by the time it takes the fastest mode.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <string>

#include "random_scenes.hpp"

namespace vibro_impact::testing {

// What is exceeded of the bounds below, or nothing.
// - An expansion ends at an event or spans 2 radians of the fastest lane, which is no faster than
//   the chain's fastest mode with all masses free (its eigenvalues interlace those of every contact
//   mode) or the forcing; where there is no rate at all, one mass in free fall, it spans 2. After
//   an impact one is cut where the next flight is expected to end, and may end before it does; at a
//   node of a chatter one may go to the limit; the last one goes beyond the end of the run.
// - Every stop is looked at once an expansion, or known to be clear.
// - A root search takes below 40 steps on average in any scene seen, and two or three in most; 64
//   would be a search that creeps.
// - Every stick but one at the start follows an impact.
inline std::string excessive_work(const Scene &scene, double until, const Counters &work) {
  const double w = frequency_bound(scene), stops = static_cast<double>(scene.stops.size());
  const double forcing = scene.forced() ? scene.omega : 0.0;
  const double fastest = std::max(forcing, root_modulus(scene.beta * w * w, w * w));
  const double spans = (fastest > 0.0 ? fastest : 1.0) * until / 2.0;
  const auto count = [](long long counted) { return static_cast<double>(counted); };
  const double impacts = count(work.impacts), searched = count(work.roots_searched);
  const double looked_at = searched + count(work.roots_dismissed) + count(work.stops_clear);
  const struct {
    const char *what;
    double counted, bound;
  } bounds[] = {
      {"expansions", count(work.expansions),
       2.0 * impacts + count(work.chatter_nodes) + count(work.releases) + spans + 2.0},
      {"stops looked at", looked_at, stops * count(work.expansions)},
      {"root iterations", count(work.root_iterations), 64.0 * searched},
      {"chatter nodes", count(work.chatter_nodes), impacts},
      {"sticks", count(work.sticks), impacts + stops},
      {"releases", count(work.releases), count(work.sticks)},
  };
  for (const auto &[what, counted, bound] : bounds)
    if (counted > bound) return fmt::format("{} {}, at most {:.6g} expected", counted, what, bound);
  return "";
}

}  // namespace vibro_impact::testing
