#include "vibro_impact/analysis/curve_end.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <tuple>
#include <utility>

#include "curve_kinds.hpp"
#include "simulation/for_analysis.hpp"
#include "units.hpp"

namespace vibro_impact {

namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

constexpr double well_known = 1e-11;  // of a point of the curve, its error
// Speeds and gaps below this tell less of where they are zero: next to a grazing their error grows
// as one divided by them.
constexpr double slow = 1e-6;

struct Node {
  PlanePoint at;
  double value;
};

// The point as a polynomial in the value through the last `count` nodes, at zero.
PlanePoint at_zero(const std::vector<Node> &nodes, std::size_t count) {
  const PlanePoint origin = nodes.back().at;
  PlanePoint sum = origin;
  for (std::size_t i = nodes.size() - count; i < nodes.size(); ++i) {
    double weight = 1.0;
    for (std::size_t j = nodes.size() - count; j < nodes.size(); ++j)
      if (j != i) weight *= nodes[j].value / (nodes[j].value - nodes[i].value);
    sum.x += weight * (nodes[i].at.x - origin.x);
    sum.y += weight * (nodes[i].at.y - origin.y);
  }
  return sum;
}

// The same through as many, up to five, as agree best with one less and one more, and how well;
// none that lies behind the last node.
std::pair<PlanePoint, double> zero_of(const std::vector<Node> &nodes, const Units &units) {
  const PlanePoint &last = nodes.back().at, &previous = nodes[nodes.size() - 2].at;
  const auto ahead = [&](const PlanePoint &at) {
    return (at.x - last.x) * (last.x - previous.x) / (units.width * units.width) +
               (at.y - last.y) * (last.y - previous.y) / (units.height * units.height) >
           0.0;
  };
  PlanePoint best = last, before = last;
  double least = std::numeric_limits<double>::infinity(), off_before = least;
  for (std::size_t count = 2; count <= std::min<std::size_t>(5, nodes.size()); ++count) {
    const PlanePoint at = at_zero(nodes, count);
    const double off = units.distance(at, before), both = std::max(off, off_before);
    if (both < least && ahead(off < off_before ? at : before)) {
      least = both;
      best = off < off_before ? at : before;
    }
    if (count == 2) best = at;
    off_before = off;
    before = at;
  }
  return {best, least};
}

// The values at points from which it falls towards the end, each by a fifth at least, five at most;
// a few at the end, where it may be past zero or another motion, are left out, and values below
// `least`. And the number of the last point that counts.
std::pair<std::vector<Node>, std::size_t> falling_nodes(const FollowedCurve &curve,
                                                        std::size_t condition, double least) {
  constexpr std::size_t left_out = 5;
  std::vector<Node> backwards;
  std::size_t end = 0;
  for (std::size_t k = curve.points.size(); k-- > 0 && backwards.size() < 5;) {
    const double value = curve.values[k][condition];
    if (value > 0.0 && value < least) continue;
    const bool usable = value > 0.0 && value < std::numeric_limits<double>::infinity() &&
                        curve.points[k].error < well_known;
    if (!usable || (!backwards.empty() && value <= backwards.back().value)) {
      if (backwards.size() >= 3 || k + left_out < curve.points.size()) break;
      backwards.clear();
    }
    if (!usable || (!backwards.empty() && value < 1.2 * backwards.back().value)) continue;
    if (backwards.empty()) end = k;
    backwards.push_back({curve.points[k].at, value});
  }
  return {{backwards.rbegin(), backwards.rend()}, end};
}

// A condition that falls, how far ahead its zero seems, and the last point that tells of it.
struct Falling {
  std::size_t condition;
  std::vector<Node> nodes;
  CurvePoint last;
  double ahead;
};

std::optional<Falling> falling_to_zero(const FollowedCurve &curve, const EndConditions &conditions,
                                       std::size_t condition, const Units &units) {
  const double least = conditions.names[condition].starts_with("grazing") ? slow : 0.0;
  auto [nodes, end] = falling_nodes(curve, condition, least);
  if (nodes.size() < 2) std::tie(nodes, end) = falling_nodes(curve, condition, 0.0);
  if (nodes.size() < 2) return std::nullopt;
  const CurvePoint &last = curve.points[end];
  const double ahead = units.distance(zero_of(nodes, units).first, last.at);
  return Falling{condition, std::move(nodes), last, ahead};
}

// The zero of a condition through ever nearer points of the curve.
std::optional<LocatedEnd> approached(const Corrector &corrector, const EndConditions &conditions,
                                     Falling falling, const PlaneBox &box) {
  const Units units(box);
  const std::string &name = conditions.names[falling.condition];
  CurvePoint &last = falling.last;
  std::vector<Node> &nodes = falling.nodes;
  LocatedEnd end{name, {}, std::numeric_limits<double>::infinity(), 0.0};
  for (int step = 0; step < 20 && !(end.error < 1e-10); ++step) {
    if (nodes.back().value < slow && end.error < 1e-8 && name.starts_with("grazing")) break;
    const auto [at, error] = zero_of(nodes, units);
    if (error < end.error) end = {name, at, error, nodes.back().value};
    std::optional<CurvePoint> next;
    double value = unknown;
    for (double part = 0.75; part > 0.01 && !next; part /= 2.0) {
      const PlanePoint guess{last.at.x + part * (at.x - last.at.x),
                             last.at.y + part * (at.y - last.at.y)};
      if (!inside(box, guess)) break;
      next = corrector(guess, units.across(last), last);
      if (next && (units.distance(next->at, guess) > 0.5 * units.distance(guess, last.at) ||
                   !(next->error < well_known)))
        next.reset();
      if (next) value = conditions.values(*next)[falling.condition];
      if (!(value > 0.0 && value < nodes.back().value)) next.reset();
    }
    if (!next) break;
    last = *next;
    nodes.push_back({last.at, value});
  }
  if (!(end.error < 1e-5)) return std::nullopt;
  return end;
}

}  // namespace

std::optional<LocatedEnd> end_of(const Corrector &corrector, const EndConditions &conditions,
                                 const FollowedCurve &curve, const PlaneBox &box) {
  require(curve.points.size() >= 2, "points: ", curve.points.size(), " given, an end needs 2");
  require(curve.values.size() == curve.points.size() &&
              curve.values.back().size() == conditions.names.size(),
          "curve: must have been followed with these ", conditions.names.size(), " conditions");
  const Units units(box);
  std::vector<Falling> candidates;
  for (std::size_t condition = 0; condition < conditions.names.size(); ++condition) {
    auto found = falling_to_zero(curve, conditions, condition, units);
    if (!found) continue;
    // Where a speed and a gap are zero together the speed: the gap may be its square.
    for (const Falling &before : candidates)
      if (conditions.names[before.condition] == conditions.names[condition]) found->ahead *= 50.0;
    candidates.push_back(std::move(*found));
  }
  std::sort(candidates.begin(), candidates.end(),
            [](const Falling &a, const Falling &b) { return a.ahead < b.ahead; });
  for (const Falling &candidate : candidates)
    if (auto end = approached(corrector, conditions, candidate, box)) return end;
  return std::nullopt;
}

std::optional<Beyond> beyond(const BifurcationCurve &curve, const LocatedEnd &end,
                             const CurvePoint &last, const PlaneBox &box) {
  const bool goes_on = end.condition.starts_with("grazing") ||
                       end.condition.starts_with("border orbit") ||
                       end.condition == "double impact";
  if (of_impacts(curve.what) || !goes_on) return std::nullopt;
  const Units units(box);
  const Scene before = curve.at(last.at);
  const auto found_at = [&](const PlanePoint &way, double far) -> std::optional<CurvePoint> {
    const PlanePoint guess = units.moved(end.at, way, far);
    if (!inside(box, guess)) return std::nullopt;
    // To where the phase is whole, as far as the curve before tells.
    PlanePoint across{-way.y * units.width, way.x * units.height};
    if (along(last.gradient, across) < 0.0) across = {-across.x, -across.y};
    const Scene scene = curve.at(guess);
    MotionState seed = last.state;
    seed.instant.phase = same_angle(seed.instant.phase, before, scene);
    try {
      const auto found =
          point_of(curve, guess, across, orbit_near(scene, seed, curve.periods, {}, 400),
                   same_angle(last.time, before, scene));
      if (found && units.distance(found->at, guess) < 0.4 * far) return found;
    } catch (const std::exception &) {  // no such motion here
    }
    return std::nullopt;
  };
  const double came =
      std::atan2((end.at.y - last.at.y) / units.height, (end.at.x - last.at.x) / units.width);
  for (double far = 5e-4; far < 0.01; far *= 4.0)
    for (const double turn : {0.0, 0.6, -0.6, 1.2, -1.2, 1.8, -1.8}) {
      const PlanePoint way{std::cos(came + turn), std::sin(came + turn)};
      const auto found = found_at(way, far);
      if (!found) continue;
      const PlanePoint tangent = units.tangent(*found);
      return Beyond{*found, tangent.x * way.x + tangent.y * way.y > 0.0 ? 1 : -1};
    }
  return std::nullopt;
}

}  // namespace vibro_impact
