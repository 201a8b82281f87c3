#include "vibro_impact/analysis/continuation.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>

#include "fits.hpp"
#include "units.hpp"

namespace vibro_impact {

namespace {

// The part of the way from `from`, inside, to `to`, outside, that lies inside; and the direction of
// the side met.
struct Exit {
  double part = 1.0;
  PlanePoint side;
};

Exit exit_of(const PlaneBox &box, const PlanePoint &from, const PlanePoint &to) {
  Exit exit;
  const auto meet = [&exit](double a, double b, double bound, const PlanePoint &side) {
    const double part = (bound - a) / (b - a);
    if (part >= 0.0 && part < exit.part) exit = {part, side};
  };
  if (to.x < box.x_from) meet(from.x, to.x, box.x_from, {0.0, 1.0});
  if (to.x > box.x_to) meet(from.x, to.x, box.x_to, {0.0, 1.0});
  if (to.y < box.y_from) meet(from.y, to.y, box.y_from, {1.0, 0.0});
  if (to.y > box.y_to) meet(from.y, to.y, box.y_to, {1.0, 0.0});
  return exit;
}

// True where a condition that falls towards zero, and may have reached it within the step, has
// changed by more than a factor of three or means nothing any more. (One that cannot have, or has
// only just become so small, is another one now: of two impacts the other is the slower, or a
// minimum has met a maximum.)
bool leaps(const std::vector<std::vector<double>> &before, const std::vector<double> &to,
           std::size_t passable, double step) {
  const double small = std::min(0.05, 30.0 * step);
  const std::vector<double> &from = before.back(), &earlier = before[before.size() - 2];
  for (std::size_t k = 0; k + passable < to.size(); ++k)
    if (from[k] < small && from[k] < earlier[k] && earlier[k] < 100.0 * from[k] &&
        !(to[k] < 3.0 * from[k] && from[k] < 3.0 * to[k]))
      return true;
  return false;
}

}  // namespace

const char *name(CurveEnd end) {
  switch (end) {
    case CurveEnd::box:
      return "leaves the box";
    case CurveEnd::closed:
      return "closed";
    case CurveEnd::most:
      return "most points";
    case CurveEnd::lost:
      break;
  }
  return "lost";
}

FollowedCurve follow_curve(const Corrector &corrector, const CurvePoint &start, const PlaneBox &box,
                           int direction, const FollowOptions &options,
                           const EndConditions &conditions) {
  require(box.x_from < box.x_to && box.y_from < box.y_to, "box from (", box.x_from, ", ",
          box.y_from, ") to (", box.x_to, ", ", box.y_to, "): must not be empty");
  require(inside(box, start.at), "start (", start.at.x, ", ", start.at.y, "): outside the box");
  require(direction == 1 || direction == -1, "direction = ", direction, ": must be 1 or -1");
  require(options.least_step > 0.0 && options.least_step <= options.step, "steps from ",
          options.least_step, " to ", options.step, ": must be positive and in this order");
  require(options.turn > 0.0, "turn = ", options.turn, ": must be positive");
  const Units units(box);
  FollowedCurve curve{{start}, {}, CurveEnd::lost};
  double step = options.step / 4.0, length = 0.0;
  const auto values_at = [&](const CurvePoint &point) {
    return conditions.values ? conditions.values(point) : std::vector<double>{};
  };
  curve.values.push_back(values_at(start));
  while (step >= options.least_step) {
    if (curve.points.size() >= options.most) {
      curve.end = CurveEnd::most;
      return curve;
    }
    const CurvePoint &last = curve.points.back();
    const PlanePoint tangent = units.tangent(last), across = units.across(last);
    const PlanePoint guess = units.moved(last.at, tangent, direction * step);
    const auto found = inside(box, guess) ? corrector(guess, across, last) : std::nullopt;
    if (!inside(box, guess) || (found && !inside(box, found->at))) {
      const Exit exit = exit_of(box, last.at, found ? found->at : guess);
      const PlanePoint &to = found ? found->at : guess;
      const PlanePoint border{last.at.x + exit.part * (to.x - last.at.x),
                              last.at.y + exit.part * (to.y - last.at.y)};
      const auto end = corrector(border, exit.side, last);
      if (end && units.distance(end->at, border) < step) {
        curve.points.push_back(*end);
        curve.values.push_back(values_at(*end));
        curve.end = CurveEnd::box;
        return curve;
      }
      step /= 2.0;
      continue;
    }
    if (!found) {
      if (getenv("DBG")) printf("## none step %g\n", step);
      step /= 2.0;
      continue;
    }
    const PlanePoint next = units.tangent(*found);
    const double turn = std::acos(std::clamp(tangent.x * next.x + tangent.y * next.y, -1.0, 1.0));
    const double off = units.distance(found->at, guess);
    if (turn > options.turn || off > 0.5 * step) {
      if (getenv("DBG"))
        printf("## turn %g off %g step %g (%.12g,%.12g)\n", turn, off, step, found->at.x,
               found->at.y);
      step /= 2.0;
      continue;
    }
    std::vector<double> now = values_at(*found);
    if (curve.values.size() > 1 && leaps(curve.values, now, conditions.passable, step)) {
      if (getenv("DBG")) {
        printf("## leap step %g:", step);
        for (size_t k = 0; k < now.size(); ++k)
          printf(" %.3g->%.3g", curve.values.back()[k], now[k]);
        printf("\n");
      }
      step /= 2.0;
      continue;
    }
    length += units.distance(found->at, last.at);
    curve.points.push_back(*found);
    curve.values.push_back(std::move(now));
    if (turn < options.turn / 3.0) step = std::min(1.5 * step, options.step);
    if (length > 4.0 * options.step &&
        units.distance(curve.points.back().at, start.at) < 0.75 * step) {
      curve.end = CurveEnd::closed;
      return curve;
    }
  }
  return curve;
}

std::optional<Crossing> crossing_of(const Corrector &one, const Corrector &other,
                                    const CurvePoint &near_one, const CurvePoint &near_other,
                                    const PlaneBox &box, double tolerance) {
  const Units units(box);
  Crossing crossing{near_one, near_other, 0.0};
  CurvePoint &a = crossing.one, &b = crossing.other;
  for (int step = 0; step < 12; ++step) {
    // The tangents of both cross here.
    const double det = a.gradient.x * b.gradient.y - a.gradient.y * b.gradient.x;
    const double at_a = a.gradient.x * a.at.x + a.gradient.y * a.at.y,
                 at_b = b.gradient.x * b.at.x + b.gradient.y * b.at.y;
    const PlanePoint at{(at_a * b.gradient.y - at_b * a.gradient.y) / det,
                        (a.gradient.x * at_b - b.gradient.x * at_a) / det};
    if (!std::isfinite(at.x) || !std::isfinite(at.y) || !inside(box, at)) return std::nullopt;
    crossing.error = std::max(units.distance(at, a.at), units.distance(at, b.at));
    const auto next_a = one(at, units.across(a), a), next_b = other(at, units.across(b), b);
    if (!next_a || !next_b) return std::nullopt;
    a = *next_a;
    b = *next_b;
    if (units.distance(a.at, at) < tolerance && units.distance(b.at, at) < tolerance)
      return crossing;
  }
  return std::nullopt;
}

}  // namespace vibro_impact
