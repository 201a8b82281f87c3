#include "vibro_impact/analysis/bifurcation_curve.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "change_flow.hpp"
#include "curve_kinds.hpp"
#include "motion_state.hpp"
#include "tolerances.hpp"

namespace vibro_impact {

namespace {

void check(const BifurcationCurve &curve) {
  name(curve.what);  // refuses one that is none
  require(curve.stop < curve.scene.stops.size(), "stop ", curve.stop, ": the scene has ",
          curve.scene.stops.size(), " stops");
  require(curve.periods >= 1, "periods = ", curve.periods, ": must be at least 1");
}

double product(const PlanePoint &a, const PlanePoint &b) {
  return a.x * b.x + a.y * b.y;
}

// The least number of periods, a divisor of those of the orbit, after which it is where it was.
int least_period(const Scene &scene, const MotionState &at, int periods) {
  for (int n = 1; n < periods; ++n) {
    if (periods % n != 0) continue;
    const MotionState end = stroboscopic_map(scene, at, n).state;
    if ((view(coordinates(end)) - view(coordinates(at))).cwiseAbs().maxCoeff() < sections_apart)
      return n;
  }
  return periods;
}

// The orbit from a neighbouring motion of scene `from`: by Newton's method, or where that fails,
// from the motion followed for a while.
std::optional<PeriodicOrbit> orbit_in(const Scene &scene, const Scene &from, MotionState seed,
                                      int periods) {
  seed.instant.phase = same_angle(seed.instant.phase, from, scene);
  const NewtonOptions options{.max_iterations = 12, .tolerance = 1e-12};
  PeriodicOrbit orbit = find_periodic_orbit(scene, seed, periods, options);
  if (!orbit.converged)
    orbit = find_periodic_orbit(scene, orbit_near(scene, seed, periods, 40), periods, options);
  if (!orbit.converged) return std::nullopt;
  return orbit;
}

// How often the mass sticks at the stop (multi-sliding) or hits it (grazing): another number is
// another side of the curve.
std::ptrdiff_t count_in(const BifurcationCurve &curve, const EventSequence &events) {
  const EventKind kind = curve.what == Bifurcation::grazing ? EventKind::impact : EventKind::stick;
  return std::count(events.begin(), events.end(), std::pair(kind, curve.stop));
}

struct Reading {
  double value = 0.0;
  CurvePoint point;
};

// The least pressing force, or gap, where it is positive. Nothing where the orbit does not stick,
// or hit, as often as that of `beside`, if there is one.
std::optional<Reading> least_value(const BifurcationCurve &curve, const PlanePoint &at,
                                   const Scene &from, const MotionState &seed,
                                   const EventSequence *beside) {
  const Scene scene = curve.at(at);
  const auto orbit = orbit_in(scene, from, seed, curve.periods);
  if (!orbit) return std::nullopt;
  EventRecorder told{.from = time_of(orbit->state.instant, Clock(scene.omega))};
  stroboscopic_map(scene, orbit->state, curve.periods, {}, told);
  EventSequence events = sequence_of(curve, told.events);
  if (beside != nullptr && count_in(curve, events) != count_in(curve, *beside)) return std::nullopt;
  const OrbitChange change = orbit_change(scene, *orbit, {curve.x, curve.y});
  const Stop &stop = scene.stops[curve.stop];
  const auto least = curve.what == Bifurcation::grazing
                         ? least_gap_change(scene, *orbit, change, stop)
                         : least_pressing_force_change(scene, *orbit, change, stop);
  if (!least || !(least->value > 0.0)) return std::nullopt;
  return Reading{least->value,
                 {at, {least->by[0], least->by[1]}, 0.0, orbit->state, 0.0, 1, std::move(events)}};
}

// Multi-sliding and grazing: on the line through `guess`, from the side where the value is
// positive, the direction `side` of `across`; from a motion of scene `from`. Each step goes most of
// the way left, the last by the derivative.
std::optional<CurvePoint> from_one_side(const BifurcationCurve &curve, const PlanePoint &guess,
                                        const PlanePoint &across, const Scene &from,
                                        const MotionState &start, double side,
                                        const EventSequence *beside) {
  double s = 0.0;
  std::optional<Reading> reading = least_value(curve, guess, from, start, beside);
  for (double margin = first_margin; !reading && margin < last_margin; margin *= 8.0) {
    s = side * margin;
    reading = least_value(curve, moved(guess, across, s), from, start, beside);
  }
  for (int step = 0; reading && step < 30; ++step) {
    const double way = reading->value / product(reading->point.gradient, across);
    if (!std::isfinite(way)) return std::nullopt;
    if (std::abs(way) <= by_derivative)
      return point_from(curve, moved(guess, across, s - way), reading->point, way * way);
    const Scene here = curve.at(reading->point.at);
    std::optional<Reading> next;
    double part = 1.0 - std::max(1.0 / 30.0, 0.5 * by_derivative / std::abs(way));
    for (int halving = 0; halving < 6 && !next; ++halving, part /= 2.0) {
      next = least_value(curve, moved(guess, across, s - part * way), here, reading->point.state,
                         beside);
      if (next) s -= part * way;
    }
    reading = next;
  }
  return std::nullopt;
}

}  // namespace

ValueChange border_excess_change(const Scene &scene, const std::vector<Parameter> &by,
                                 const EventChange &one, const EventChange &next) {
  const double r = law_of(scene, scene.stops[one.event.stop]).at_rest();
  const BorderChatter border = border_chatter(r);
  // (3 - s) (1 - s)^2 = r (3 - 2 s) differentiated; the ratio is (1 - s)^2.
  const double q = border.press_ratio, s = border.flight;
  const double by_r = 2.0 * q * (3.0 - 2.0 * s) / (q * q + 2.0 * (3.0 - s) * q - 2.0 * r);
  const double ratio = next.event.velocity_before / one.event.velocity_before;
  ValueChange excess{ratio - border.speed_ratio, {}};
  const auto after = view(next.velocity_before), before = view(one.velocity_before);
  const Eigen::RowVectorXd of_r =
      columns_of(scene, by, Parameter::Kind::restitution, one.event.stop + 1, before.size());
  for (Eigen::Index k = 0; k < before.size(); ++k)
    excess.by.push_back((after(k) - ratio * before(k)) / one.event.velocity_before -
                        by_r * of_r(k));
  return excess;
}

EventSequence sequence_of(const BifurcationCurve &curve, const std::vector<Event> &events,
                          const Chatter *on_border) {
  std::vector<bool> left_out(events.size(), false);
  const auto leave_out = [&](const Chatter &chatter) {
    for (const std::size_t k : chatter.impacts) left_out[k] = true;
  };
  for (const Chatter &chatter : chatters_of(events))
    if (chatter.complete) leave_out(chatter);
  if (on_border != nullptr) {
    leave_out(*on_border);
    for (std::size_t k = on_border->impacts.back() + 1; k < events.size(); ++k) {
      if (events[k].stop != on_border->stop) continue;
      if (events[k].kind == EventKind::impact) break;
      left_out[k] = true;
      if (events[k].kind == EventKind::release) break;
    }
  }
  EventSequence kept;
  for (std::size_t k = 0; k < events.size(); ++k)
    if (!left_out[k] && (events[k].kind != EventKind::impact ||
                         (curve.what == Bifurcation::grazing && events[k].stop == curve.stop)))
      kept.emplace_back(events[k].kind, events[k].stop);
  EventSequence least = kept;
  for (std::size_t k = 1; k < kept.size(); ++k) {
    std::rotate(kept.begin(), kept.begin() + 1, kept.end());
    least = std::min(least, kept);
  }
  return least;
}

CurvePoint point_from(const BifurcationCurve &curve, const PlanePoint &at, CurvePoint reading,
                      double error) {
  const Scene scene = curve.at(reading.at);
  const double period = Clock(scene.omega).period;
  CurvePoint point = std::move(reading);
  point.at = at;
  point.error = error;
  double later = -point.state.instant.phase;
  point.state = at_quiet_phase(scene, point.state);
  later += point.state.instant.phase;
  if (later < 0.0) later += period;
  point.period = least_period(scene, point.state, curve.periods);
  point.time -= later;
  if (point.time < 0.0) point.time += curve.periods * period;
  return point;
}

const char *name(Bifurcation bifurcation) {
  constexpr std::array names{"multi-sliding", "border orbit", "grazing"};
  const auto k = static_cast<std::size_t>(bifurcation);
  require(k < names.size(), "bifurcation = ", k, ": there are 0 to ", names.size() - 1);
  return names[k];
}

Scene BifurcationCurve::at(const PlanePoint &point) const {
  return with(with(scene, x, point.x), y, point.y);
}

Corrector corrector_of(const BifurcationCurve &curve) {
  check(curve);
  return [curve](const PlanePoint &guess, const PlanePoint &across,
                 const CurvePoint &neighbour) -> std::optional<CurvePoint> {
    try {
      if (curve.what == Bifurcation::border_orbit)
        return by_held_chatter(curve, guess, across, neighbour);
      const double side = product(neighbour.gradient, across) > 0.0 ? 1.0 : -1.0;
      return from_one_side(curve, guess, across, curve.at(neighbour.at), neighbour.state, side,
                           &neighbour.events);
    } catch (const std::exception &) {  // outside the scene's limits, a run given up, a fold
      return std::nullopt;
    }
  };
}

std::optional<CurvePoint> point_of(const BifurcationCurve &curve, const PlanePoint &guess,
                                   const PlanePoint &across, const MotionState &seed, double time) {
  check(curve);
  require(std::isfinite(across.x + across.y + time), "across (", across.x, ", ", across.y,
          ") at time ", time, ": must be finite");
  const Scene scene = curve.at(guess);
  check(scene);
  require_fits(scene, seed);
  if (curve.what == Bifurcation::border_orbit)
    return by_held_chatter(curve, guess, across,
                           {.at = guess, .gradient = {}, .state = seed, .time = time});
  return from_one_side(curve, guess, across, scene, seed, 1.0, nullptr);
}

}  // namespace vibro_impact
