#include "observers.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "endings.hpp"
#include "simulation/chain/require.hpp"

namespace vibro_impact::detail {

MomentOfMotion::MomentOfMotion(const Run &run, const Motion &motion, const Instant &at, double tau)
    : Moment(at, time_of(at, run.chain().clock)),
      chain_(run.chain()),
      motion_(motion),
      table_(run.scratch.flight.table),
      stops_(run.stops),
      tau_(tau) {
}

Real MomentOfMotion::x(std::size_t i) const {
  return tau_ > 0.0 ? mass_along(motion_, table_, i, tau_).x : motion_.x[i];
}

Real MomentOfMotion::v(std::size_t i) const {
  return tau_ > 0.0 ? mass_along(motion_, table_, i, tau_).v : motion_.v[i];
}

std::size_t MomentOfMotion::index_of(int mass) const {
  require_mass(mass, masses());
  return static_cast<std::size_t>(mass - 1);
}

int MomentOfMotion::masses() const {
  return static_cast<int>(chain_.masses);
}

double MomentOfMotion::displacement(int mass) const {
  const std::size_t i = index_of(mass);
  const double place = x(i).hi, inside = std::clamp(place, chain_.lowest[i], chain_.highest[i]);
  if (place == inside) return place;
  double terms = std::abs(inside) + motion_.x_terms[i];
  if (tau_ > 0.0) {
    const double u = tau_ / table_.step.unit;
    terms += tau_ * std::abs(motion_.v[i].hi) + u * u * table_.travel[i];
  }
  return is_rounding_at_stop(std::abs(place - inside), terms, largest_terms(chain_, motion_, time))
             ? inside
             : place;
}

double MomentOfMotion::velocity(int mass) const {
  return v(index_of(mass)).hi;
}

double MomentOfMotion::hold_force(int mass) const {
  const std::size_t i = index_of(mass);
  if (motion_.mode->held[i] == 0) return std::numeric_limits<double>::quiet_NaN();
  const Turn turn = tau_ > 0.0 ? turn_at(chain_, motion_.now.phase + tau_) : motion_.turn;
  return rounded(force_at_rest(
      chain_, i, turn, [this](std::size_t j) { return x(j); },
      [this](std::size_t j) { return v(j); }));
}

ImpactSum MomentOfMotion::unreported(int stop) const {
  require(stop >= 1 && static_cast<std::size_t>(stop) <= stops_.size(), "stop ", stop,
          ": the chain has ", stops_.size(), " stops");
  return stops_[static_cast<std::size_t>(stop - 1)].unreported;
}

MotionState MomentOfMotion::state() const {
  return state_at(*this, motion_.mode->held);
}

MomentOfMotion moment_at(Run &run, const Real &tau, const Instant &at) {
  if (run.long_flight.is_under_way()) {
    const Real since = tau.hi > 0.0 ? tau : Real(0.0);
    return {run, run.long_flight.at(run.chain(), since), at};
  }
  return {run, run.motion, at, tau.hi};
}

ImpactSum taken_by_impact(const Chain &chain, std::size_t stop, double closing, double leaving) {
  const double m = chain.mass[chain.stops[stop].mass];
  return {m * (closing + leaving), 0.5 * m * (closing - leaving) * (closing + leaving)};
}

void report_impact(Run &run, std::size_t stop, double closing, double leaving,
                   Recorders recorders) {
  const ImpactSum taken = taken_by_impact(run.chain(), stop, closing, leaving);
  if (run.limit.is_ahead) {
    if (!(closing >= run.limit.slowest)) {
      run.stops[stop].unreported += taken;
      return;
    }
    run.limit.reported += taken;
  }
  const double sigma = run.chain().stops[stop].sigma;
  report_event(run, EventKind::impact, stop, sigma * closing, -sigma * leaving, false, taken,
               recorders);
}

void report_event(Run &run, EventKind kind, std::size_t stop, double before, double after,
                  bool by_a_jump, const ImpactSum &taken, Recorders recorders) {
  if (recorders.empty()) return;
  const Stop &stop_of_event = run.scene().stops[stop];
  Event &event = run.scratch.event;
  event.kind = kind;
  event.stop = static_cast<int>(stop) + 1;
  event.mass = stop_of_event.mass;
  event.side = stop_of_event.side;
  event.instant = run.motion.now.rounded();
  event.velocity_before = before;
  event.velocity_after = after;
  event.taken = taken;
  event.falling = run.stops[stop].falling;
  event.by_a_jump = by_a_jump;
  event.held = run.motion.mode->held;
  const MomentOfMotion moment(run, run.motion, event.instant);
  event.time = moment.time;
  for (Recorder *recorder : recorders) {
    recorder->event(event, moment);
    if (recorder->done()) stop_run(run, Ending::stopped);
  }
  run.progress.next_sample = next_sample(recorders);
}

double next_sample(Recorders recorders) {
  double next = infinity;
  for (const Recorder *recorder : recorders) {
    const double time = recorder->next_time();
    require(!std::isnan(time), "next_time = ", time, ": must be a time");
    next = std::min(next, time);
  }
  return next;
}

bool report_sample(Run &run, const Moment &moment, double time, Recorders recorders) {
  bool any_done = false;
  for (Recorder *recorder : recorders) {
    if (recorder->next_time() > time) continue;
    recorder->sample(moment);
    if (recorder->done()) {
      any_done = true;
      continue;
    }
    const double next = recorder->next_time();
    require(next > time, "next_time = ", next, " after the sample at ", time, ": must be later");
  }
  run.progress.next_sample = next_sample(recorders);
  return any_done;
}

}  // namespace vibro_impact::detail
