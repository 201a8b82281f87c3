#include "vibro_impact/analysis/totals.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "simulation/for_analysis.hpp"

namespace vibro_impact {

namespace {

// The integral of the external force on mass i between two instants.
double forcing_impulse(const Scene &scene, std::size_t i, const Instant &a, const Instant &b) {
  const double w = scene.omega, length = elapsed(a, b, Clock(w)),
               cosine = entry_of(scene.amplitude, i), sine = entry_of(scene.sine, i);
  if (w == 0.0) return (entry_of(scene.constant, i) + cosine) * length;
  return entry_of(scene.constant, i) * length +
         (cosine * (std::sin(w * b.phase) - std::sin(w * a.phase)) -
          sine * (std::cos(w * b.phase) - std::cos(w * a.phase))) /
             w;
}

// The masses of a chain from one end on. `known` is the impulse of all but springs and dampers on a
// free mass, and Y of a held one. `link` is the stiffness of the spring to the mass before.
struct Row {
  double known, link, ground;
  bool held;
};

// Adds to `impulses`, in the order of the rows, those of the links from this end on the held
// masses. The masses up to mass i exert the impulse a - e Y on the next one, whose row has this Y.
// Neither number is found from a difference, so that a stiff link costs no digits.
void add_links(const std::vector<Row> &rows, std::vector<double> &impulses) {
  double a = 0.0, e = rows[0].link;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const Row &row = rows[i];
    const double k = i + 1 < rows.size() ? rows[i + 1].link : 0.0;
    if (row.held) {
      impulses[i] += a - e * row.known;
      a = k * row.known;
      e = k;
    } else {
      const double s = e + row.ground, share = k > 0.0 ? k / (s + k) : 0.0;
      a = share * (row.known + a);
      e = share * s;
    }
  }
}

// The impulses of the springs and dampers on the held masses.
std::vector<double> impulses_of_springs(const Scene &scene, const std::vector<double> &known,
                                        const Held &held) {
  const std::size_t n = known.size();
  std::vector<Row> rows(n), mirrored(n);
  std::vector<double> impulses(n, 0.0), from_the_end(n, 0.0);
  for (std::size_t i = 0; i < n; ++i) {
    const double ground = entry_of(scene.ground, i);
    rows[i] = {known[i], scene.stiffness[i], ground, held[i] != 0};
    mirrored[n - 1 - i] = {known[i], i + 1 < n ? scene.stiffness[i + 1] : 0.0,
                           i == 0 ? ground + scene.stiffness[0] : ground, held[i] != 0};
  }
  add_links(rows, impulses);
  add_links(mirrored, from_the_end);
  for (std::size_t i = 0; i < n; ++i)
    impulses[i] += from_the_end[n - 1 - i] - rows[i].ground * known[i];
  return impulses;
}

}  // namespace

TotalsRecorder::TotalsRecorder(const Scene &scene, double from_time, double to_time,
                               std::optional<double> slowest_speed)
    : from(from_time),
      to(to_time),
      slowest(slowest_speed),
      stops(scene.stops.size()),
      scene_(scene),
      first_speeds_(scene.stops.size(), 0.0),
      impulses_(scene.mass.size(), 0.0) {
}

void TotalsRecorder::check(const Scene &scene) const {
  require(std::isfinite(from) && std::isfinite(to) && from <= to, "totals from ", from, " to ", to,
          ": must be finite and not end before they begin");
  require(scene == scene_, "totals: are those of another scene");
}

double TotalsRecorder::slowest_impact(double first, double limit) const {
  return limit < from || samples_ > 1 ? infinity : slowest_listed(slowest, first);
}

double TotalsRecorder::next_time() const {
  if (samples_ == 0) return from;
  return samples_ == 1 && from < to ? to : infinity;
}

void TotalsRecorder::sample(const Moment &moment) {
  if (end_) close_mode();
  if (++samples_ > 1) {
    add_unreported(moment, 1.0);
    end_ = state_at(moment, begin_->held);
    return close_mode();
  }
  begin_ = state_at(moment, Held(scene_.mass.size(), 0));
  for (const Stop &stop : scene_.stops)
    if (!std::isnan(moment.hold_force(stop.mass)) &&
        moment.displacement(stop.mass) == stop.position)
      begin_->held[static_cast<std::size_t>(stop.mass - 1)] = static_cast<signed char>(stop.side);
  add_unreported(moment, -1.0);
}

void TotalsRecorder::event(const Event &event, const Moment &moment) {
  const auto stop = static_cast<std::size_t>(event.stop - 1);
  StopTotals &totals = stops[stop];
  const double speed = std::abs(event.velocity_before);
  double &first = first_speeds_[stop];
  if (event.kind == EventKind::impact && event.falling == 0) first = speed;
  if (event.time < from || event.time > to) return;
  if (end_ && end_->instant < event.instant) close_mode();
  add(event.stop, event.taken, 1.0);
  if (event.kind == EventKind::impact && speed > 0.0 && speed >= slowest_listed(slowest, first)) {
    ++totals.impacts;
    totals.largest_speed = std::max(totals.largest_speed, speed);
  }
  if (event.kind == EventKind::stick) ++totals.sticks;
  if (begin_ && changes_contact_mode(event.kind)) end_ = state_at(moment, event.held);
}

void TotalsRecorder::add(int stop, const ImpactSum &taken, double share) {
  const Stop &at = scene_.stops[static_cast<std::size_t>(stop - 1)];
  ImpactSum &sum = stops[static_cast<std::size_t>(stop - 1)].taken;
  sum += {share * taken.impulse, share * taken.energy};
  if (begin_)
    impulses_[static_cast<std::size_t>(at.mass - 1)] -= sign(at.side) * share * taken.impulse;
}

// The impacts that no event has reported at the end belong to the totals, those at the start do
// not: the event at the limit of their chatter has both.
void TotalsRecorder::add_unreported(const Moment &moment, double share) {
  for (int stop = 1; stop <= static_cast<int>(stops.size()); ++stop)
    add(stop, moment.unreported(stop), share);
}

void TotalsRecorder::close_mode() {
  const MotionState &a = *begin_, &b = *end_;
  const double length = elapsed(a.instant, b.instant, Clock(scene_.omega));
  std::vector<double> force, known;  // integrals of force; on held masses, the stop is missing
  for (std::size_t i = 0; i < impulses_.size(); ++i) {
    force.push_back(forcing_impulse(scene_, i, a.instant, b.instant) + impulses_[i] -
                    scene_.mass[i] * (b.velocity[i] - a.velocity[i]));
    known.push_back(a.held[i] != 0 ? b.displacement[i] * length : force[i]);
  }
  const std::vector<double> springs = impulses_of_springs(scene_, known, a.held);
  for (std::size_t k = 0; k < stops.size(); ++k) {
    const Stop &stop = scene_.stops[k];
    const auto i = static_cast<std::size_t>(stop.mass - 1);
    if (a.held[i] != static_cast<signed char>(stop.side)) continue;
    stops[k].contact += length;
    stops[k].pressing += sign(stop.side) * (force[i] + springs[i]);
  }
  begin_ = std::exchange(end_, std::nullopt);
  impulses_.assign(impulses_.size(), 0.0);
}

}  // namespace vibro_impact
