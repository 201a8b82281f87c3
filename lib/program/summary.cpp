#include "summary.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace vibro_impact::runner {

namespace {

constexpr std::size_t most_extrapolated = 10;  // impacts: more add rounding

// The value at x = 0 of the polynomial through the last points, of as many of them as change it
// least (Neville). There is at least one point.
double extrapolated(const std::vector<double> &x, std::vector<double> y) {
  double best = y.back(), least_change = infinity;
  for (std::size_t order = 1; order < x.size(); ++order) {
    const double before = y.back();
    for (std::size_t k = x.size(); k-- > order;)
      y[k] += (y[k] - y[k - 1]) * x[k] / (x[k - order] - x[k]);
    const double change = std::abs(y.back() - before);
    if (change < least_change) best = y.back();
    least_change = std::min(least_change, change);
  }
  return best;
}

// The integral of the external force on mass i between two instants.
double forcing_impulse(const Scene &scene, std::size_t i, const Instant &a, const Instant &b) {
  const auto value = [i](const std::vector<double> &list) { return list.empty() ? 0.0 : list[i]; };
  const double w = scene.omega, length = elapsed(a, b, Clock(w)), cosine = value(scene.amplitude),
               sine = value(scene.sine);
  if (w == 0.0) return (value(scene.constant) + cosine) * length;
  return value(scene.constant) * length +
         (cosine * (std::sin(w * b.phase) - std::sin(w * a.phase)) -
          sine * (std::cos(w * b.phase) - std::cos(w * a.phase))) /
             w;
}

// K Y, with the rows of the held masses replaced by Y itself, solved for a right side.
std::vector<double> solved(const Scene &scene, const Held &held, std::vector<double> right) {
  const std::size_t n = right.size();
  std::vector<double> pivot(n), beyond(n, 0.0);  // beyond the diagonal, on the right
  for (std::size_t i = 0; i < n; ++i) {
    pivot[i] = 1.0;
    if (held[i] != 0) continue;
    if (i + 1 < n) beyond[i] = -scene.stiffness[i + 1];
    pivot[i] = stiffness_at(scene, i);
    if (i == 0) continue;
    const double factor = -scene.stiffness[i] / pivot[i - 1];
    pivot[i] -= factor * beyond[i - 1];
    right[i] -= factor * right[i - 1];
  }
  for (std::size_t i = n; i-- > 0;) {
    if (i + 1 < n) right[i] -= beyond[i] * right[i + 1];
    right[i] /= pivot[i];
  }
  return right;
}

}  // namespace

double Summary::next_time() const {
  if (samples_ == 0) return from_;
  return samples_ == 1 && from_ < to_ ? to_ : infinity;
}

void Summary::sample(const Moment &moment) {
  if (end_) close_mode();
  if (++samples_ > 1) {
    end_ = state_at(moment, begin_->held);
    return close_mode();
  }
  begin_ = state_at(moment, Held(scene_.mass.size(), 0));
  for (const Stop &stop : scene_.stops)
    if (!std::isnan(moment.hold_force(stop.mass)) &&
        moment.displacement(stop.mass) == stop.position)
      begin_->held[static_cast<std::size_t>(stop.mass - 1)] = static_cast<signed char>(stop.side);
  impulses_.assign(scene_.mass.size(), 0.0);
}

void Summary::event(const Event &event, const Moment &moment) {
  if (end_ && end_->instant < event.instant) close_mode();
  if (event.kind == EventKind::impact) add_impact(event);
  if (event.kind == EventKind::stick) add_stick(event);
  if (begin_ && changes_contact_mode(event.kind)) end_ = state_at(moment, event.held);
}

void Summary::add(const Event &event, double impulse, double energy) {
  Totals &totals = totals_[static_cast<std::size_t>(event.stop - 1)];
  totals.impulse += impulse;
  totals.energy += energy;
  if (begin_) impulses_[static_cast<std::size_t>(event.mass - 1)] -= sign(event.side) * impulse;
}

void Summary::add_impact(const Event &event) {
  Totals &totals = totals_[static_cast<std::size_t>(event.stop - 1)];
  const double m = scene_.mass[static_cast<std::size_t>(event.mass - 1)],
               speed = std::abs(event.velocity_before), after = std::abs(event.velocity_after);
  if (event.falling == 0) totals.falling.clear();
  if (totals.falling.size() == most_extrapolated) totals.falling.erase(totals.falling.begin());
  totals.falling.push_back(speed);
  if (event.time < from_) return;
  add(event, m * (speed + after), m / 2.0 * (speed - after) * (speed + after));
  ++totals.impacts;
  totals.speeds += speed;
  totals.squares += speed * speed;
  totals.largest = std::max(totals.largest, speed);
}

// Adds the impacts of a chatter between the resolved ones and its limit, too.
void Summary::add_stick(const Event &event) {
  if (event.time < from_) return;
  Totals &totals = totals_[static_cast<std::size_t>(event.stop - 1)];
  ++totals.sticks;
  const ImpactLaw law = law_of(scene_, stop_of(scene_, event));
  const double m = scene_.mass[static_cast<std::size_t>(event.mass - 1)], r = law.at_rest();
  if (totals.falling.empty() || r == 1.0) return;
  std::vector<double> impulses, energies;  // behind the latest impact, as each impact predicts them
  double impulse = 0.0, energy = 0.0;      // of the impacts behind an impact, up to the latest
  for (std::size_t k = totals.falling.size(); k-- > 0;) {
    const double v = totals.falling[k], after = law.after(v);
    impulses.insert(impulses.begin(), m * v * r * (1.0 + r) / (1.0 - r) - impulse);
    energies.insert(energies.begin(), m / 2.0 * r * r * v * v - energy);
    impulse += m * (v + after);
    energy += m / 2.0 * (v - after) * (v + after);
  }
  add(event, extrapolated(totals.falling, impulses), extrapolated(totals.falling, energies));
  totals.falling.clear();
}

void Summary::close_mode() {
  const MotionState &a = *begin_, &b = *end_;
  const double length = elapsed(a.instant, b.instant, Clock(scene_.omega));
  std::vector<double> force;  // integrals; for held masses, the stop is missing
  for (std::size_t i = 0; i < impulses_.size(); ++i)
    force.push_back(forcing_impulse(scene_, i, a.instant, b.instant) + impulses_[i] -
                    scene_.mass[i] * (b.velocity[i] - a.velocity[i]));
  std::vector<double> y = force;
  for (std::size_t i = 0; i < y.size(); ++i)
    if (a.held[i] != 0) y[i] = b.displacement[i] * length;
  y = solved(scene_, a.held, y);
  for (std::size_t k = 0; k < totals_.size(); ++k) {
    const Stop &stop = scene_.stops[k];
    const auto i = static_cast<std::size_t>(stop.mass - 1);
    if (a.held[i] != static_cast<signed char>(stop.side)) continue;
    totals_[k].contact += length;
    totals_[k].pressing += sign(stop.side) * (force[i] + spring_force(scene_, i, y));
  }
  begin_ = std::exchange(end_, std::nullopt);
  impulses_.assign(impulses_.size(), 0.0);
}

Table Summary::table() const {
  Table table(
      "stop,mass,side,impacts,sticks,mean_speed,rms_speed,largest_speed,impulse,energy_lost,"
      "contact_time,pressing_impulse");
  for (std::size_t k = 0; k < totals_.size(); ++k) {
    const Totals &totals = totals_[k];
    const double impacts = std::max(1.0, static_cast<double>(totals.impacts));
    table.row(k + 1, scene_.stops[k].mass, name(scene_.stops[k].side), totals.impacts,
              totals.sticks, totals.speeds / impacts, std::sqrt(totals.squares / impacts),
              totals.largest, totals.impulse, totals.energy, totals.contact, totals.pressing);
  }
  return table;
}

}  // namespace vibro_impact::runner
