#include "vibro_impact/analysis/locate.hpp"

#include <algorithm>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <vector>

#include "simulation/for_analysis.hpp"
#include "tolerances.hpp"
#include "vibro_impact/analysis/periodic_orbit.hpp"

namespace vibro_impact {

namespace {

void require_interval(double below, double above) {
  require(std::isfinite(below) && std::isfinite(above) && below < above, "interval from ", below,
          " to ", above, ": must be finite and not empty");
  require(std::isfinite(above - below), "interval from ", below, " to ", above,
          ": wider than the range of double precision");
}

template <class Function>
void require_function(const Function &function, const char *what) {
  require(static_cast<bool>(function), what, ": no function given");
}

// A point (x, f(x)).
struct Point {
  double x, f;
};

// x as a polynomial in f through the last four points, at f = 0. Counted from `origin`, which lies
// near it, so that the small distances keep their digits.
double inverse_interpolation(const std::vector<Point> &points, double origin) {
  const std::size_t first = points.size() > 4 ? points.size() - 4 : 0;
  double distance = 0.0;
  for (std::size_t i = first; i < points.size(); ++i) {
    double weight = 1.0;
    for (std::size_t j = first; j < points.size(); ++j)
      if (j != i) weight *= points[j].f / (points[j].f - points[i].f);
    distance += weight * (points[i].x - origin);
  }
  return origin + distance;
}

}  // namespace

int sticking_phases(const Scene &scene, int mass, int settling, int periods) {
  check(scene);
  require_mass(mass, scene.masses());
  require(settling >= 0, "settling = ", settling, ": must be non-negative");
  require(periods >= 1, "periods = ", periods, ": must be at least 1");
  require(periods <= std::numeric_limits<int>::max() - settling, "settling = ", settling,
          " and periods = ", periods, ": more than an int can count");
  const MotionState start = start_of(scene);
  EventRecorder told{time_of({settling, 0.0}, Clock(scene.omega))};
  require_complete(
      simulate_from(scene, start, time_after(scene, start, settling + periods), {}, told));
  return static_cast<int>(std::count_if(
      told.events.begin(), told.events.end(),
      [mass](const Event &event) { return event.kind == EventKind::stick && event.mass == mass; }));
}

Change bisect(const std::function<int(double)> &count, double below, double above, double width) {
  require_function(count, "count");
  require_interval(below, above);
  require(width >= 0.0, "width = ", width, ": must be non-negative");
  Change change{below, above, count(below), count(above)};
  require(change.count_below != change.count_above, "count = ", change.count_below, " at both ",
          below, " and ", above, ": no change to locate");
  while (change.above - change.below > width) {
    const double middle = std::midpoint(change.below, change.above);
    if (!(change.below < middle && middle < change.above)) break;
    const int counted = count(middle);
    if (counted == change.count_below) {
      change.below = middle;
    } else {
      change.above = middle;
      change.count_above = counted;
    }
  }
  return change;
}

Located zero(const std::function<double(double)> &f, double below, double above) {
  require_function(f, "f");
  require_interval(below, above);
  const auto number = [&f](double x) {
    const double y = f(x);
    require(!std::isnan(y), "f = ", y, " at ", x, ": must be a number");
    return y;
  };
  const double at_below = number(below), at_above = number(above);
  // By the signs: a product of the two may underflow.
  require((at_below <= 0.0 && at_above >= 0.0) || (at_below >= 0.0 && at_above <= 0.0),
          "f = ", at_below, " at ", below, " and ", at_above, " at ", above, ": no change of sign");
  std::uintmax_t steps = 100;
  const auto [a, b] =
      boost::math::tools::toms748_solve(number, below, above, at_below, at_above,
                                        boost::math::tools::eps_tolerance<double>(52), steps);
  return {0.5 * (a + b), 0.5 * (b - a)};
}

Located zero_from_one_side(const std::function<double(double)> &f, double far, double near) {
  require_function(f, "f");
  require(std::isfinite(far) && std::isfinite(near) && far != near, "from ", far, " to ", near,
          ": must be two finite numbers");
  std::vector<Point> points{{far, f(far)}, {near, f(near)}};
  Located root{near, std::abs(far - near)};
  for (int step = 0; step < 40; ++step) {
    const Point &last = points.back(), &before = points[points.size() - 2];
    if (!(last.f > 0.0 && last.f < before.f))
      throw std::runtime_error(line("f = ", last.f, " at ", last.x, ": not falling to zero"));
    const double estimate = inverse_interpolation(points, near);
    root = {estimate, std::abs(estimate - root.value)};
    const double distance = estimate - last.x;
    if (step > 2 && std::abs(distance) < one_sided * std::abs(estimate)) break;
    const double next = estimate - distance / 8;
    points.push_back({next, f(next)});
  }
  return root;
}

}  // namespace vibro_impact
