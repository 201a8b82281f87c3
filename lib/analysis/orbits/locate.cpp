#include "vibro_impact/analysis/locate.hpp"

#include <algorithm>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <cstdint>
#include <numeric>

#include "simulation/for_analysis.hpp"
#include "vibro_impact/analysis/periodic_orbit.hpp"

namespace vibro_impact {

namespace {

void require_interval(double below, double above) {
  require(std::isfinite(below) && std::isfinite(above) && below < above, "interval from ", below,
          " to ", above, ": must be finite and not empty");
  require(std::isfinite(above - below), "interval from ", below, " to ", above,
          ": wider than the range of double precision");
}

}  // namespace

CountJump bisect(const std::function<int(double)> &count, double below, double above,
                 double width) {
  require_interval(below, above);
  require(width >= 0.0, "width = ", width, ": must be non-negative");
  CountJump jump{below, above, count(below), count(above)};
  require(jump.count_below != jump.count_above, "count = ", jump.count_below, " at both ", below,
          " and ", above, ": no change to locate");
  while (jump.above - jump.below > width) {
    const double middle = std::midpoint(jump.below, jump.above);
    if (!(jump.below < middle && middle < jump.above)) break;
    const int counted = count(middle);
    if (counted == jump.count_below) {
      jump.below = middle;
    } else {
      jump.above = middle;
      jump.count_above = counted;
    }
  }
  return jump;
}

int sticking_phases(const Scene &scene, int mass, int settling, int periods) {
  Simulation simulation(scene);
  require_mass(mass, scene.masses());
  const MotionState settled{.instant = {settling, 0.0}};
  EventRecorder recorder(time_of(settled.instant, Clock(scene.omega)));
  require_complete(simulation.advance(time_after(scene, settled, periods), recorder));
  return static_cast<int>(std::count_if(
      recorder.events.begin(), recorder.events.end(),
      [mass](const Event &event) { return event.kind == EventKind::stick && event.mass == mass; }));
}

double zero(const std::function<double(double)> &f, double below, double above) {
  require_interval(below, above);
  const auto number = [&f](double x) {
    const double y = f(x);
    require(!std::isnan(y), "f = ", y, " at ", x, ": must be a number");
    return y;
  };
  const double at_below = number(below), at_above = number(above);
  // The signs are compared, because a product of the two values may underflow.
  require((at_below <= 0.0 && at_above >= 0.0) || (at_below >= 0.0 && at_above <= 0.0),
          "f = ", at_below, " at ", below, " and ", at_above, " at ", above, ": no change of sign");
  std::uintmax_t steps = 100;
  const auto [a, b] =
      boost::math::tools::toms748_solve(number, below, above, at_below, at_above,
                                        boost::math::tools::eps_tolerance<double>(52), steps);
  return 0.5 * (a + b);
}

}  // namespace vibro_impact
