// A witness of a run: the motion between its events again, in extended precision and by modes of
// its own, with a close look at every stop on the way.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "energy_balance.hpp"

namespace vibro_impact::testing {

// A recorder. From event to event it moves on from the state the run had, and holds the next event
// against what it sees; `scene` must outlive it. For runs that resolve all impacts: of those that a
// chatter limit leaves out it knows nothing.
struct Witness {
  const Scene &scene;
  double radians = 0.05;     // of the fastest mode, from look to look
  EnergyAudit audit{scene};  // carries the motion
  Real rate = std::max(std::sqrt(largest_eigenvalue_bound(scene)), scene.omega);

  Real size = 0;          // of the displacements
  Real deepest = 0;       // beyond a stop, between events
  Real weakest = 0;       // hold force that pulls, between events
  Real off_the_stop = 0;  // gap at an impact
  Real off_in_speed = 0;  // of the speed of an impact
  Real not_zero = 0;      // hold force at a release that no impact has caused
  Real displaced = 0;     // any mass, at an event
  long long flights = 0, looks = 0, releases = 0;
  long long near_misses = 0;  // dips that end within a hundredth of a stop, or of its force

  explicit Witness(const Scene &of) : scene(of) {
  }
  Witness(const Scene &of, const MotionState &start) : scene(of) {
    audit.since = start.instant;
    audit.held = start.held;
    for (std::size_t i = 0; i < start.held.size(); ++i) {
      audit.account.x(static_cast<Eigen::Index>(i)) = start.displacement[i];
      audit.account.v(static_cast<Eigen::Index>(i)) = start.velocity[i];
    }
  }

  void event(const Event &event, const Moment &moment) {
    look_on(event.instant);
    audit.move_to(event.instant);
    const auto i = static_cast<Eigen::Index>(event.mass - 1);
    const Stop &stop = scene.stops[event.stop];
    if (event.kind == EventKind::impact) {
      off_the_stop = std::max(off_the_stop, std::abs(gap(stop, audit.account)));
      off_in_speed = std::max(off_in_speed, std::abs(audit.account.v(i) - event.velocity_before));
    } else if (event.kind == EventKind::release && !event.by_a_jump) {
      ++releases;
      not_zero = std::max(not_zero, std::abs(press(stop, audit.account, event.instant.phase)));
    }
    const RealVector expected = audit.account.x;
    audit.take_over([&](int mass) { return moment.displacement(mass); },
                    [&](int mass) { return moment.velocity(mass); });
    displaced = std::max(displaced, (audit.account.x - expected).cwiseAbs().maxCoeff());
    audit.held = event.held;
  }
  // Looks on to the end of the run.
  void close(const MotionState &end) {
    look_on(end.instant);
    audit.move_to(end.instant);
    for (std::size_t i = 0; i < end.held.size(); ++i)
      displaced = std::max(
          displaced, std::abs(audit.account.x(static_cast<Eigen::Index>(i)) - end.displacement[i]));
  }

 private:
  static Real gap(const Stop &stop, const EnergyAccount &at) {
    return sign(stop.side) * (stop.position - at.x(stop.mass - 1));
  }
  // The force on a mass at rest that presses it into its stop.
  Real press(const Stop &stop, const EnergyAccount &at, Real phase) const {
    const Eigen::Index i = stop.mass - 1;
    const auto links = [&](const RealVector &x, Real here) {
      Real sum = scene.stiffness[static_cast<std::size_t>(i)] * ((i > 0 ? x(i - 1) : 0) - here);
      if (i + 1 < x.size())
        sum += scene.stiffness[static_cast<std::size_t>(i + 1)] * (x(i + 1) - here);
      return sum;
    };
    Real sum = links(at.x, stop.position) + scene.beta * links(at.v, 0);
    if (!scene.amplitude.empty())
      sum += scene.amplitude[static_cast<std::size_t>(i)] * std::cos(scene.omega * phase);
    return sign(stop.side) * sum;
  }

  // The flight from the latest event on.
  struct Flight {
    const Scene &scene;
    const EnergyAudit &audit;
    const FreeModes &basis;
    RealVector q = basis.inverse * audit.account.x, v = basis.inverse * audit.account.v;
    std::vector<std::vector<Exponential>> parts = {};

    Flight(const Scene &of, EnergyAudit &from) : scene(of), audit(from), basis(from.basis_now()) {
      for (Eigen::Index j = 0; j < q.size(); ++j) {
        const Real lambda = basis.lambda(j);
        parts.push_back({});
        if (lambda > 0)
          parts.back() = parts_of(scene, lambda, basis.force(j), audit.since.phase,
                                  {q(j) - basis.pull(j) / lambda, v(j)});
      }
    }
    EnergyAccount after(Real t) const {
      RealVector at = q, speed = v;
      for (Eigen::Index j = 0; j < q.size(); ++j) {
        const Real lambda = basis.lambda(j);
        Place place = lambda > 0 ? place_after(parts[static_cast<std::size_t>(j)], t)
                                 : rigid_body_after(scene, basis.force(j), audit.since.phase, t,
                                                    {q(j), v(j)});
        at(j) = place.at + (lambda > 0 ? basis.pull(j) / lambda : 0);
        speed(j) = place.speed;
      }
      EnergyAccount there;
      there.x = basis.shape * at;
      there.v = basis.shape * speed;
      for (Eigen::Index i = 0; i < there.x.size(); ++i)
        if (audit.held[static_cast<std::size_t>(i)] != 0) there.x(i) = audit.account.x(i);
      return there;
    }
  };
  // Looks at all stops up to the next event: none may have been passed before. Where three looks
  // show a dip, its lowest point is looked for.
  void look_on(const Instant &next) {
    const Real t = elapsed(audit.since, next, audit.clock);
    if (!(t > 0)) return;
    const Flight flight(scene, audit);
    const int steps = 4 + static_cast<int>(std::min<Real>(1e6, t * rate / radians));
    const std::size_t stops = scene.stops.size();
    const auto watched = [&](std::size_t k, const EnergyAccount &at, Real s) {
      const Stop &stop = scene.stops[k];
      const bool held = audit.held[static_cast<std::size_t>(stop.mass - 1)] != 0;
      return held ? press(stop, at, audit.since.phase + s) : gap(stop, at);
    };
    std::vector<std::array<Real, 3>> last(stops);
    ++flights;
    for (int n = 0; n <= steps; ++n, ++looks) {
      const Real s = t * n / steps;
      const EnergyAccount at = flight.after(s);
      size = std::max(size, at.x.cwiseAbs().maxCoeff());
      for (std::size_t k = 0; k < stops; ++k) {
        if (across(k)) continue;
        auto &[first, second, third] = last[k];
        first = second, second = third, third = watched(k, at, s);
        note(k, third);
        const Real bend = first - 2 * second + third;
        if (n < 2 || !(second <= first && second <= third && second < bend)) continue;
        Real from = s - 2 * t / steps, to = s;
        for (int third_off = 0; third_off < 40; ++third_off) {
          const Real left = from + (to - from) / 3, right = to - (to - from) / 3;
          const bool rises =
              watched(k, flight.after(left), left) < watched(k, flight.after(right), right);
          (rises ? to : from) = rises ? right : left;
        }
        const Real lowest = watched(k, flight.after(from), from);
        near_misses += lowest > 0 && lowest < 0.01L;
        note(k, lowest);
      }
    }
  }
  bool held_at(const Stop &stop) const {
    return audit.held[static_cast<std::size_t>(stop.mass - 1)] ==
           static_cast<signed char>(stop.side);
  }
  // A stop across from the one its mass is held at.
  bool across(std::size_t k) const {
    const Stop &stop = scene.stops[k];
    return audit.held[static_cast<std::size_t>(stop.mass - 1)] != 0 && !held_at(stop);
  }
  void note(std::size_t k, Real value) {
    Real &worst = held_at(scene.stops[k]) ? weakest : deepest;
    worst = std::max(worst, -value);
  }
};

}  // namespace vibro_impact::testing
