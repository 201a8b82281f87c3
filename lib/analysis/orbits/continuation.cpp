#include "vibro_impact/analysis/continuation.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "simulation/for_analysis.hpp"

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

// The point where the way to `to`, outside, leaves the box; nothing where there is none near.
std::optional<CurvePoint> on_the_side(const Corrector &corrector, const CurvePoint &last,
                                      const PlanePoint &to, const PlaneBox &box, double near) {
  const Exit exit = exit_of(box, last.at, to);
  const PlanePoint border = moved(last.at, {to.x - last.at.x, to.y - last.at.y}, exit.part);
  auto end = corrector(border, exit.side, last);
  if (end && !(box.distance(end->at, border) < near)) end.reset();
  return end;
}

bool same_orbit(const CurvePoint &a, const CurvePoint &b) {
  return a.period == b.period && a.events == b.events;
}

// The angle between the tangents at two points, measured in units of the box.
double turn_between(const PlaneBox &box, const CurvePoint &a, const CurvePoint &b) {
  const double width = box.x_to - box.x_from, height = box.y_to - box.y_from;
  const PlanePoint s = box.along(a.gradient), t = box.along(b.gradient);
  const double cosine = s.x * t.x / (width * width) + s.y * t.y / (height * height);
  return std::acos(std::clamp(cosine, -1.0, 1.0));
}

}  // namespace

bool PlaneBox::contains(const PlanePoint &at) const {
  return at.x >= x_from && at.x <= x_to && at.y >= y_from && at.y <= y_to;
}

double PlaneBox::distance(const PlanePoint &a, const PlanePoint &b) const {
  return std::hypot((a.x - b.x) / (x_to - x_from), (a.y - b.y) / (y_to - y_from));
}

PlanePoint PlaneBox::across(const PlanePoint &gradient) const {
  const double width = x_to - x_from, height = y_to - y_from;
  const double x = gradient.x * width, y = gradient.y * height, length = std::hypot(x, y);
  return {x / length * width, y / length * height};
}

PlanePoint PlaneBox::along(const PlanePoint &gradient) const {
  const double width = x_to - x_from, height = y_to - y_from;
  const PlanePoint rising = across(gradient);
  return {rising.y / height * width, -rising.x / width * height};
}

const char *name(CurveEnd end) {
  constexpr std::array names{"leaves the box", "events change", "lost", "closed", "most points"};
  const auto k = static_cast<std::size_t>(end);
  require(k < names.size(), "end of a curve = ", k, ": there are 0 to ", names.size() - 1);
  return names[k];
}

FollowedCurve follow_curve(const Corrector &corrector, const CurvePoint &start, const PlaneBox &box,
                           int direction, const FollowOptions &options) {
  require(box.x_from < box.x_to && box.y_from < box.y_to, "box from (", box.x_from, ", ",
          box.y_from, ") to (", box.x_to, ", ", box.y_to, "): must not be empty");
  require(box.contains(start.at), "start (", start.at.x, ", ", start.at.y, "): outside the box");
  require(direction == 1 || direction == -1, "direction = ", direction, ": must be 1 or -1");
  require(
      options.least_step > 0.0 && options.least_step <= options.step && std::isfinite(options.step),
      "steps from ", options.least_step, " to ", options.step,
      ": must be positive, finite and in this order");
  require(options.turn > 0.0, "turn = ", options.turn, ": must be positive");
  require(corrector != nullptr, "corrector: no function given");
  FollowedCurve curve{{start}, CurveEnd::lost};
  const auto ended = [&curve](CurveEnd end) {
    curve.end = end;
    return curve;
  };
  double length = 0.0;
  for (double step = options.step / 4.0; step >= options.least_step;) {
    if (curve.points.size() >= options.most) return ended(CurveEnd::most);
    const CurvePoint last = curve.points.back();
    const PlanePoint guess = moved(last.at, box.along(last.gradient), direction * step);
    const auto found =
        box.contains(guess) ? corrector(guess, box.across(last.gradient), last) : std::nullopt;
    if (!box.contains(guess) || (found && !box.contains(found->at))) {
      const auto end = on_the_side(corrector, last, found ? found->at : guess, box, step);
      if (end && same_orbit(*end, last)) {
        curve.points.push_back(*end);
        return ended(CurveEnd::box);
      }
      curve.end = end ? CurveEnd::events : CurveEnd::lost;
      step /= 2.0;
      continue;
    }
    // What it ends for should all shorter steps fail, too.
    curve.end = found && !same_orbit(*found, last) ? CurveEnd::events : CurveEnd::lost;
    const double turn = found ? turn_between(box, last, *found) : 0.0;
    if (!found || curve.end == CurveEnd::events || turn > options.turn ||
        box.distance(found->at, guess) > 0.5 * step) {
      step /= 2.0;
      continue;
    }
    length += box.distance(found->at, last.at);
    curve.points.push_back(*found);
    if (length > 4.0 * options.step && box.distance(found->at, start.at) < 0.75 * step)
      return ended(CurveEnd::closed);
    if (turn < options.turn / 3.0) step = std::min(1.5 * step, options.step);
  }
  return curve;
}

}  // namespace vibro_impact
