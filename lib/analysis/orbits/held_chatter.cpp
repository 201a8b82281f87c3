#include "held_chatter.hpp"

#include <algorithm>
#include <cmath>

#include "fits.hpp"
#include "motion_state.hpp"
#include "vibro_impact/analysis/orbit_change.hpp"

namespace vibro_impact {

namespace {

using Eigen::Index;
using Row = Eigen::RowVectorXd;

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
  constexpr double near = 0.2, not_far = 0.5;
  const BorderChatter border = border_chatter(law.at_rest());
  const double ratio = border.speed_ratio, way = std::min(ratio, law.at_rest() - ratio);
  const auto off = [&](std::size_t n) { return std::abs(speeds[n + 1] / speeds[n] - ratio); };
  const std::size_t ratios = speeds.size() - 1;
  if (ratios == 0) return std::nullopt;
  std::size_t best = 0;
  for (std::size_t n = 1; n + 1 < ratios; ++n)
    if (std::max(off(n), off(n + 1)) < std::max(off(best), off(best + 1))) best = n;
  while (best + 1 < ratios && off(best + 1) < near * way) ++best;
  if (best < least && least < ratios && off(least) < not_far * way) best = least;
  bool similar = best > 0;
  for (std::size_t back = 1; back <= 3 && back < best; ++back)
    similar = similar && off(best - back) < near * way;
  return Compared{best, similar, near * way / border.escape};
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
    simulate_from(scene_, start, end, every_impact(), told);
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
      impacts = fly(end, every_impact(), next);
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
    for (std::size_t k = 0; k < by_.size(); ++k)  // at a fixed phase
      if (by_[k].kind == Parameter::Kind::omega)
        time(time.size() - static_cast<Index>(by_.size() - k)) += impact.event.time / scene_.omega;
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

}  // namespace

std::optional<BorderEquations> border_equations(const BifurcationCurve &curve, const PlanePoint &at,
                                                const MotionState &section, double time,
                                                std::size_t least) {
  return HeldChatter(curve, at, section).equations(time, least);
}

}  // namespace vibro_impact
