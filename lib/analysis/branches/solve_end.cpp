#include <algorithm>
#include <cmath>

#include "ends.hpp"
#include "simulation/for_analysis.hpp"
#include "tolerances.hpp"

namespace vibro_impact::branches {

namespace {

constexpr int most_impacts = 300;  // that a border orbit is given, for r up to 0.98

// Gives a border orbit more impacts, until the limit of its chatter meets the release within
// rounding. False if they do not converge.
bool lengthen_border(const Problem &problem, End &end) {
  double before = infinity;
  for (int more = 0; more < most_impacts; ++more) {
    const size_t k = end.condition.item;
    const double left = end.u(problem.time_at(k)), size = problem.parameter_size(end.u(0));
    if (!(left > 0.0)) return false;
    if (left * rate_bound(problem.scene) < 0.1 * last_flight) return true;
    const Model model(problem.scene, problem.parameter, end.u(0));
    const Item &item = end.sequence.items[k];
    const double c = border_constant(model.stop(item.stop).ratio_at_rest()).value,
                 e = 1.5 - 3.0 * std::sqrt(0.25 - c * 2.0 / 3.0);  // c = e / 2 - e^2 / 6
    End longer = end;
    longer.sequence.items[k].what = Happening::impact;
    longer.sequence.items.insert(longer.sequence.items.begin() + static_cast<std::ptrdiff_t>(k + 1),
                                 {Happening::hold, item.stop});
    longer.u = divided(problem, end.u, k, e * left);
    longer.condition.item = k + 1;
    if (!solve(problem, longer.sequence, longer.u, longer.condition, true, &longer.error))
      return before < 1e-11 * size;
    const double moved = std::abs(longer.u(0) - end.u(0));
    end = std::move(longer);
    // Each impact reduces the distance to the limit by a constant factor.
    end.error = std::max(end.error, moved);
    if (moved < 2.0 * rounding * size) return true;
    if (more > 5 && moved > before) return moved < 1e-12 * size;
    before = moved;
  }
  return false;
}

}  // namespace

bool solve_end(const Problem &problem, End &end) {
  if (end.is_unexplained) return false;
  if (!solve(problem, end.sequence, end.u, end.condition, true, &end.error)) return false;
  if (end.condition.extra == Extra::border && !lengthen_border(problem, end)) return false;
  const Inspection seen = inspect(problem, end.sequence, end.u);
  for (size_t k = 0; k < end.sequence.items.size(); ++k) {
    if (end.u(problem.time_at(k)) < -below_zero) return false;
    if (hits(end.sequence.items[k].what) && seen.items[k].speed < -below_zero * problem.length)
      return false;
  }
  return std::ranges::none_of(seen.minima, [&](const Minimum &least) {
    return least.value < -below_zero * problem.length;
  });
}

}  // namespace vibro_impact::branches
