// The border orbit: the period with its chatter cut short, and the point of a curve from that.
#include "curve_kinds.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>

#include "change_flow.hpp"
#include "motion_state.hpp"
#include "tolerances.hpp"

namespace vibro_impact {

namespace {

using Eigen::Index;
using Row = Eigen::RowVectorXd;

// Every chatter is resolved until what is left of it lies below rounding.
constexpr RunOptions every_impact{.resolve_chatter = 0.0};

// An impact of a chatter at which its speed and the next are compared.
struct Compared {
  std::size_t impact = 0;
  bool similar = false;  // the speeds before it fall as on a border orbit, too
  double next = 0.0;     // the excess with which the impact after it is the last near the border
};

// What is zero on a border orbit, and its derivatives by the free coordinates of the section and by
// the two parameters, in this order.
struct BorderEquations {
  Eigen::VectorXd residual;  // P(z) - z
  Eigen::MatrixXd residual_by;
  double excess = 0.0;
  Eigen::RowVectorXd excess_by;
  double end = 0.0;  // of the chatter, after the section
  Compared compared;
  EventSequence events;  // of the orbit but for the chatter
};

// Of the chatters at a stop that which ends nearest to `time`, and not farther from it than
// `window`.
std::optional<Chatter> chatter_near(const std::vector<Event> &events, std::size_t stop, double time,
                                    double window) {
  std::optional<Chatter> nearest;
  for (const Chatter &chatter : chatters_of(events)) {
    const double away = std::abs(events[chatter.impacts.back()].time - time);
    if (chatter.stop != stop || !(away < window)) continue;
    nearest = chatter;
    window = away;
  }
  return nearest;
}

// The last impact that leaves in proportion to how far the motion is from the border orbit: by how
// much the speed falls to the next is then nearly what it is there. Impacts before it know less of
// the border, those after it are carried away from it. Number `least`, if that is later and not yet
// far away.
std::optional<Compared> last_near_border(const std::vector<double> &speeds, const ImpactLaw &law,
                                         std::size_t least) {
  // At r the ratio of a chatter that completes, at 0 that of one which is over: of the way there.
  const BorderChatter border = border_chatter(law.at_rest());
  const double ratio = border.speed_ratio, way = std::min(ratio, law.at_rest() - ratio);
  const auto off = [&](std::size_t n) { return std::abs(speeds[n + 1] / speeds[n] - ratio); };
  const std::size_t ratios = speeds.size() - 1;
  if (ratios == 0) return std::nullopt;
  std::size_t best = 0;
  for (std::size_t n = 1; n + 1 < ratios; ++n)
    if (std::max(off(n), off(n + 1)) < std::max(off(best), off(best + 1))) best = n;
  while (best + 1 < ratios && off(best + 1) < near_border * way) ++best;
  if (best < least && least < ratios && off(least) < not_far_off * way) best = least;
  bool similar = best > 0;
  for (std::size_t back = 1; back <= 3 && back < best; ++back)
    similar = similar && off(best - back) < near_border * way;
  return Compared{best, similar, near_border * way / border.escape};
}

// Ends the run right after an impact at a stop, counted from 0.
struct UntilImpact {
  std::size_t stop, number;
  std::size_t seen = 0;

  void event(const Event &event, const Moment &) {
    if (event.kind == EventKind::impact && event.stop == stop) ++seen;
  }
  bool done() const {
    return seen > number;
  }
};

// The chatter is followed to the impact that is nearest to the border orbit, and there the mass is
// held, until it is let go: of what that neglects the others see the square of the speed there. The
// motion is so a smooth function of where it starts, on both sides of the border.
class HeldChatter {
 public:
  HeldChatter(const BifurcationCurve &curve, const PlanePoint &at, const MotionState &start)
      : curve_(curve), scene_(curve.at(at)), at_(start), by_{curve.x, curve.y} {
    const std::vector<std::size_t> free = free_coordinates(start.held);
    columns_ = Matrix(2 * start.held.size(), free.size() + by_.size());
    for (std::size_t k = 0; k < free.size(); ++k) columns_(free[k], k) = 1.0;
  }

  std::optional<BorderEquations> equations(double time, std::size_t least) {
    const MotionState start = at_;
    const double begin = time_of(start.instant, Clock(scene_.omega)),
                 end = time_after(scene_, start, curve_.periods);
    EventRecorder told{.from = begin};
    simulate_from(scene_, start, end, every_impact, told);
    const auto chatter = chatter_near(told.events, curve_.stop, begin + time,
                                      (end - begin) / (16.0 * curve_.periods));
    if (!chatter) return std::nullopt;
    const auto first = static_cast<std::ptrdiff_t>(chatter->impacts.front());
    std::vector<double> speeds;
    for (const std::size_t k : chatter->impacts) speeds.push_back(told.events[k].velocity_before);
    const auto before = static_cast<std::size_t>(
        std::count_if(told.events.begin(), told.events.begin() + first, [&](const Event &event) {
          return event.kind == EventKind::impact && event.stop == curve_.stop;
        }));
    const Stop &stop = scene_.stops[curve_.stop];
    auto n = last_near_border(speeds, law_of(scene_, stop), least);
    if (!n) return std::nullopt;
    const Matrix unmoved = columns_;
    std::vector<EventChange> impacts;
    for (bool holding = false; !holding;) {
      at_ = start;
      columns_ = unmoved;
      UntilImpact next{curve_.stop, before + n->impact + 1};
      impacts = fly(end, every_impact, next);
      holding = next.done() && hold(impacts.back());
      if (!holding && n->impact-- == 0) return std::nullopt;
    }
    fly(end, {});
    if (at_.held != start.held) return std::nullopt;
    const ValueChange excess =
        border_excess_change(scene_, by_, impacts[impacts.size() - 2], impacts.back());
    const std::vector<std::size_t> free = free_coordinates(start.held);
    BorderEquations found{(view(coordinates(at_)) - view(coordinates(start)))(free),
                          view(columns_)(free, Eigen::all),
                          excess.value,
                          view(excess.by),
                          told.events[chatter->impacts.back()].time - begin,
                          *n,
                          sequence_of(curve_, told.events, &*chatter)};
    for (std::size_t k = 0; k < free.size(); ++k)
      found.residual_by(static_cast<Index>(k), static_cast<Index>(k)) -= 1.0;
    if (!found.residual_by.allFinite() || !found.excess_by.allFinite()) return std::nullopt;
    return found;
  }

 private:
  // On to a time, with the derivatives. The impacts at the stop on the way.
  template <class... Recorders>
  std::vector<EventChange> fly(double until, const RunOptions &options, Recorders &...recorders) {
    TangentRecorder tangents(scene_, at_, columns_, {.by = by_, .events = true});
    at_ =
        require_complete(simulate_from(scene_, at_, until, options, tangents, recorders...)).state;
    const ChangesAtEnd at_end = tangents.finish(at_.instant);
    columns_ = at_end.changes;
    std::vector<EventChange> impacts;
    for (const EventChange &change : at_end.events)
      if (change.event.kind == EventKind::impact && change.event.stop == curve_.stop)
        impacts.push_back(change);
    return impacts;
  }

  // The mass at rest at the stop from this impact on, which has just been: if it is pressed to it.
  bool hold(const EventChange &impact) {
    const Stop &stop = scene_.stops[curve_.stop];
    Row time = view(impact.time);
    time += impact.event.time / scene_.omega *  // at a fixed phase
            columns_of(scene_, by_, Parameter::Kind::omega, 0, time.size());
    Eigen::MatrixXd columns = view(columns_);
    columns += vector_field(scene_, at_) * time;
    at_.held[static_cast<std::size_t>(stop.mass - 1)] = static_cast<signed char>(stop.side);
    hold_at_stops(scene_, at_);
    columns -= vector_field(scene_, at_) * time;
    columns.row(stop.mass - 1).setZero();
    columns.row(scene_.masses() + stop.mass - 1).setZero();
    columns_ = matrix_of(columns);
    return pressing_force(scene_, stop, at_) > 0.0;
  }

  const BifurcationCurve &curve_;
  Scene scene_;
  MotionState at_;
  std::vector<Parameter> by_;
  Matrix columns_;
};

// Where Newton's method is: the section, in the scene of a point of the plane.
struct BorderIterate {
  PlanePoint at;
  MotionState section;
  double time;
  std::size_t least = 0;  // impact of the chatter to compare speeds at
};

std::optional<BorderEquations> equations(const BifurcationCurve &curve, const BorderIterate &at) {
  try {
    return HeldChatter(curve, at.at, at.section).equations(at.time, at.least);
  } catch (const std::exception &) {  // outside the scene's limits, a run given up
    return std::nullopt;
  }
}

// A step of Newton's method.
struct BorderStep {
  Eigen::VectorXd section;
  PlanePoint place;
};

// The iterate a part of a step away, at the same angle of the forcing.
BorderIterate moved(const BifurcationCurve &curve, const BorderIterate &from,
                    const BorderStep &step, double part) {
  BorderIterate to = from;
  to.at = moved(from.at, step.place, part);
  const Scene before = curve.at(from.at), after = curve.at(to.at);
  to.section.instant.phase = same_angle(from.section.instant.phase, before, after);
  to.time = same_angle(from.time, before, after);
  Index k = 0;
  for (const std::size_t row : free_coordinates(from.section.held))
    coordinate(to.section, row) += part * step.section(k++);
  hold_at_stops(after, to.section);
  return to;
}

// The step of Newton's method for the section and the place together, to where the excess is `aim`
// on the line through `guess`. Nothing where there is none, or it leads far away.
std::optional<BorderStep> newton_step(const BorderEquations &eq, const PlanePoint &from,
                                      const PlanePoint &guess, const PlanePoint &across,
                                      double aim) {
  const Index n = eq.residual.size();
  const Eigen::Vector2d to_guess{guess.x - from.x, guess.y - from.y}, line{across.x, across.y};
  Eigen::MatrixXd matrix(n + 1, n + 1);
  matrix << eq.residual_by.leftCols(n), eq.residual_by.rightCols(2) * line, eq.excess_by.head(n),
      eq.excess_by.tail(2) * line;
  Eigen::VectorXd residual(n + 1);
  residual << eq.residual + eq.residual_by.rightCols(2) * to_guess,
      eq.excess - aim + eq.excess_by.tail(2) * to_guess;
  const Eigen::VectorXd step = -matrix.partialPivLu().solve(residual);
  const Eigen::Vector2d place = to_guess + step(n) * line;
  if (!step.allFinite() || place.norm() > longest_step) return std::nullopt;
  return BorderStep{step.head(n), {place(0), place(1)}};
}

// How the excess changes with the place, the orbit moving along.
PlanePoint gradient_of(const BorderEquations &eq) {
  const Index n = eq.residual.size();
  const Eigen::MatrixXd section =
      -eq.residual_by.leftCols(n).partialPivLu().solve(eq.residual_by.rightCols(2));
  const Eigen::RowVectorXd gradient = eq.excess_by.tail(2) + eq.excess_by.head(n) * section;
  return {gradient(0), gradient(1)};
}

}  // namespace

std::optional<CurvePoint> by_held_chatter(const BifurcationCurve &curve, const PlanePoint &guess,
                                          const PlanePoint &across, const CurvePoint &from) {
  BorderIterate at{from.at, from.state, from.time};
  auto eq = equations(curve, at);
  double last = std::numeric_limits<double>::infinity(), aim = 0.0;
  for (int iteration = 0; eq && iteration < 20; ++iteration) {
    const bool deeper = iteration > 0 && eq->compared.impact >= at.least;
    // A chatter that does not complete may end before it can be told from one that does: back then
    // to where one has.
    aim = deeper || iteration == 0 ? 0.0 : std::max(2.0 * aim, eq->compared.next);
    const auto step = newton_step(*eq, at.at, guess, across, aim);
    if (!step) return std::nullopt;
    const double size = std::hypot(step->place.x, step->place.y);
    if (deeper && eq->compared.similar &&
        (size < last_step || (size < rounding_step && size > 0.5 * last))) {
      const CurvePoint here{at.at, gradient_of(*eq), 0.0, at.section, eq->end, 1, eq->events};
      return point_from(curve, at.at, here, std::max(size, 1e-16));
    }
    last = size;
    const std::size_t least = eq->compared.impact + 1;
    BorderIterate next = at;
    eq.reset();
    for (double part = 1.0; !eq && part > 0.05; part /= 2.0) {
      next = moved(curve, at, *step, part);
      eq = equations(curve, next);
    }
    at = next;
    at.least = least;
    if (eq) at.time = eq->end;
  }
  return std::nullopt;
}

}  // namespace vibro_impact
