// A witness of a run: the motion between its events again, in extended precision and by modes of
// its own, with a close look at every stop on the way.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <vector>

#include "mode_motion.hpp"
#include "rates.hpp"
#include "vibro_impact/vibro_impact.hpp"

namespace vibro_impact::testing {

// A recorder. From each event it computes the flight from the state of the run, and compares the
// next event and its state with those of the run. If every flight is right and every impact obeys
// its law, so does the energy of the run. `scene` must outlive it. The run must resolve all
// impacts, because the witness does not see those that a chatter limit leaves out.
class Witness : public Recorder {
 public:
  // The worst that was seen; infinite where a number was none.
  Real deepest = 0;       // beyond a stop, between events
  Real weakest = 0;       // hold force that pulls, between events
  Real off_the_stop = 0;  // gap at an impact
  Real not_zero = 0;      // hold force at a release that no impact has caused
  Real lost = 0;          // speed of a mass that sticks, but for what a chatter would soon lose

  // Looks about every `radians` of the fastest mode.
  explicit Witness(const Scene &of, Real radians = 0.05L) : scene_(of), radians_(radians) {
    flown_ = state_of_run_ = motion_of(start_of(of));
    clock_speeds_ = 0 * flown_.v;
    greatest_ = energy(state_of_run_);
  }

  void event(const Event &event, const Moment &moment) override {
    fly_to(event.instant);
    const auto i = static_cast<Eigen::Index>(event.mass - 1);
    const Stop &stop = stop_of(scene_, event);
    const Real rounding = clock_rounding_[static_cast<std::size_t>(event.stop - 1)];
    const Real off = beyond(flown_.v(i) - event.velocity_before, clock_speeds_(i));
    switch (event.kind) {
      case EventKind::impact:
        note(off_the_stop, std::abs(gap(stop, flown_)) - rounding);
        note(apart_, scene_.mass[static_cast<std::size_t>(i)] * off * off / 2);
        flown_.v(i) = event.velocity_after;
        break;
      case EventKind::stick:  // its last speed counts as off
        note(off_the_stop, std::abs(gap(stop, flown_)) - rounding);
        note(lost, std::abs(flown_.v(i)) - soon_lost(stop, event));
        break;
      case EventKind::release:
        if (event.by_a_jump) break;
        note(not_zero, std::abs(press(stop, flown_, event.instant.phase)) - rounding);
        break;
    }
    for (Eigen::Index k = 0; k < flown_.x.size(); ++k) {
      state_of_run_.x(k) = moment.displacement(static_cast<int>(k) + 1);
      state_of_run_.v(k) = moment.velocity(static_cast<int>(k) + 1);
    }
    held_ = event.held;
  }
  // Looks on to the end of the run.
  void close(const MotionState &end) {
    fly_to(end.instant);
    state_of_run_ = motion_of(end);
    compare();
  }

  // In the energy norm, the root of kinetic and elastic energy: the largest difference of the state
  // of the run from where a flight, and the impacts at its end, had taken it.
  double apart() const {
    return static_cast<double>(std::sqrt(apart_));
  }
  // Likewise the motion: all that took part. The library carries it as its deviation from the
  // steady response, so that this counts too.
  double size() const {
    return static_cast<double>(std::sqrt(greatest_ + steady_));
  }
  // Likewise neighbours as far apart as any mass has been from zero.
  double stretch() const {
    Real stiffness = 0;
    for (const double k : scene_.stiffness) stiffness += k;
    return static_cast<double>(std::sqrt(stiffness / 2) * farthest_);
  }
  double farthest() const {
    return static_cast<double>(farthest_);
  }
  // The largest speed of a mass.
  double fastest() const {
    return static_cast<double>(fastest_);
  }

 private:
  struct Motion {
    RealVector x, v;
  };

  const Scene &scene_;
  Real radians_;
  Clock clock_{scene_.omega};
  Real rate_ = std::max(frequency_bound(scene_), scene_.omega);
  std::map<Held, FreeModes> modes_;
  Instant since_ = {};
  Held held_ = Held(scene_.mass.size());
  Motion flown_;         // the end of the latest flight, with the events recorded since
  Motion state_of_run_;  // the state of the run at the latest event
  // The change of each speed, of the motion in the energy norm, and of each gap or hold force, in
  // the last rounding of the clock before the end of the latest flight, or in one rounding where
  // the flight is shorter. At events of one time they add up. Beside a link of 1e9 the force may be
  // larger than what the links carry, and its damper may change a speed by 1e-6.
  RealVector clock_speeds_;
  Real clock_apart_ = 0;
  std::vector<Real> clock_rounding_ = std::vector<Real>(scene_.stops.size());
  Real apart_ = 0, greatest_ = 0, steady_ = 0, farthest_ = 0;  // energies, and a displacement
  Real fastest_ = 0;

  static void note(Real &worst, Real value) {
    if (!(value <= worst)) worst = std::isnan(value) ? INFINITY : value;
  }
  // How far a difference goes beyond the roundings of both ends of a flight.
  static Real beyond(Real difference, Real rounding) {
    return std::max<Real>(0, std::abs(difference) - 2 * std::abs(rounding));
  }
  static Motion motion_of(const MotionState &state) {
    const auto real = [](const std::vector<double> &values) -> RealVector {
      const auto n = static_cast<Eigen::Index>(values.size());
      return Eigen::Map<const Eigen::VectorXd>(values.data(), n).cast<Real>();
    };
    return {real(state.displacement), real(state.velocity)};
  }
  // Kinetic and elastic.
  Real energy(const Motion &at) const {
    Real sum = 0;
    for (Eigen::Index i = 0; i < at.x.size(); ++i) {
      const auto k = static_cast<std::size_t>(i);
      const Real stretch = at.x(i) - (i > 0 ? at.x(i - 1) : 0);
      sum += (scene_.stiffness[k] * stretch * stretch + scene_.mass[k] * at.v(i) * at.v(i)) / 2;
      if (!scene_.ground.empty()) sum += scene_.ground[k] * at.x(i) * at.x(i) / 2;
    }
    return sum;
  }
  static Real gap(const Stop &stop, const Motion &at) {
    return sign(stop.side) * (stop.position - at.x(stop.mass - 1));
  }
  // The force on a mass at rest that presses it into its stop.
  Real press(const Stop &stop, const Motion &at, Real phase) const {
    const Eigen::Index i = stop.mass - 1;
    const auto links = [&](const RealVector &x, Real position) {
      Real sum =
          scene_.stiffness[static_cast<std::size_t>(i)] * ((i > 0 ? x(i - 1) : 0) - position);
      if (i + 1 < x.size())
        sum += scene_.stiffness[static_cast<std::size_t>(i + 1)] * (x(i + 1) - position);
      if (!scene_.ground.empty()) sum -= scene_.ground[static_cast<std::size_t>(i)] * position;
      return sum;
    };
    Real sum = links(at.x, stop.position) + scene_.beta * links(at.v, 0);
    const auto add = [&](const std::vector<double> &forces, Real factor) {
      if (!forces.empty()) sum += forces[static_cast<std::size_t>(i)] * factor;
    };
    add(scene_.amplitude, std::cos(scene_.omega * phase));
    add(scene_.sine, std::sin(scene_.omega * phase));
    add(scene_.constant, 1);
    return sign(stop.side) * sum;
  }

  // The speed whose impacts would end within a rounding of the clock: the time left is
  // 2 u / (a (1 - r)), a the acceleration into the stop.
  Real soon_lost(const Stop &stop, const Event &event) const {
    const Real press = std::max<Real>(0, this->press(stop, flown_, event.instant.phase)),
               mass = scene_.mass[static_cast<std::size_t>(stop.mass - 1)],
               r = law_of(scene_, stop).at_rest();
    return press / mass * (1 - r) / 2 * std::numeric_limits<double>::epsilon() * event.time;
  }

  void compare() {
    const Real off = beyond(
        std::sqrt(energy({state_of_run_.x - flown_.x, state_of_run_.v - flown_.v})), clock_apart_);
    note(apart_, off * off);
  }

  // The flight from the latest recorded state.
  struct Flight {
    const FreeModes &basis;
    const Motion from;
    const Held &held;
    std::vector<ModeMotion> modes = {};

    Motion after(Real t) const {
      const auto n = static_cast<Eigen::Index>(modes.size());
      RealVector at(n), speed(n);
      for (Eigen::Index j = 0; j < n; ++j) {
        const Place place = modes[static_cast<std::size_t>(j)].after(t);
        at(j) = place.at;
        speed(j) = place.speed;
      }
      Motion motion{basis.shape * at, basis.shape * speed};
      for (Eigen::Index i = 0; i < motion.x.size(); ++i)
        if (held[static_cast<std::size_t>(i)] != 0) motion.x(i) = from.x(i);
      return motion;
    }
  };
  // The steady response of a flight of length t counts at most with the energy that its forces give
  // to a mode at rest.
  Flight take_off(Real t) {
    auto known = modes_.find(held_);
    if (known == modes_.end()) known = modes_.emplace(held_, free_modes(scene_, held_)).first;
    const FreeModes &basis = known->second;
    Flight flight{basis, state_of_run_, held_};
    const RealVector q = basis.inverse * state_of_run_.x, v = basis.inverse * state_of_run_.v;
    Real steady = 0;
    for (Eigen::Index j = 0; j < q.size(); ++j) {
      const Real lambda = basis.lambda(j);
      flight.modes.emplace_back(scene_, lambda, Complex(basis.cosine(j), -basis.sine(j)),
                                basis.pull(j), since_.phase, Place{q(j), v(j)});
      const ModeMotion &mode = flight.modes.back();
      const Real force = std::abs(mode.drive) + std::abs(mode.pull);
      steady += std::min(std::max(lambda, mode.omega * mode.omega) * std::norm(mode.steady) / 2 +
                             lambda * mode.rest * mode.rest / 2,
                         force * t * force * t / 2);
    }
    steady_ = std::max(steady_, steady);
    return flight;
  }

  // Up to the next event: no stop may have been passed before. Where three looks show a dip, its
  // lowest point is looked for.
  void fly_to(const Instant &next) {
    const Real t = elapsed(since_, next, clock_);
    if (t > 0) compare();
    const Flight flight = take_off(t);
    const auto watched = [&](std::size_t k, const Motion &at, Real s) {
      const Stop &stop = scene_.stops[k];
      return held_at(stop) ? press(stop, at, since_.phase + s) : gap(stop, at);
    };
    constexpr double epsilon = std::numeric_limits<double>::epsilon();
    const Real unit = epsilon * std::max(since_.phase, next.phase),
               before = std::max<Real>(0, t - unit);
    const Motion start_of_unit = flight.after(before), end_of_unit = flight.after(before + unit);
    const Motion change{end_of_unit.x - start_of_unit.x, end_of_unit.v - start_of_unit.v};
    if (t > 0) {
      clock_speeds_.setZero();
      clock_apart_ = 0;
      std::ranges::fill(clock_rounding_, 0);
    }
    clock_speeds_ += change.v.cwiseAbs();
    clock_apart_ += std::sqrt(energy(change));
    for (std::size_t k = 0; k < scene_.stops.size(); ++k)
      clock_rounding_[k] +=
          std::abs(watched(k, end_of_unit, before + unit) - watched(k, start_of_unit, before));
    if (!(t > 0)) return;
    const int steps = 2 + static_cast<int>(std::min<Real>(1e6L, t * rate_ / radians_));
    std::vector<std::array<Real, 3>> last(scene_.stops.size());
    for (int n = 0; n <= steps; ++n) {
      const Real s = t * n / steps;
      flown_ = flight.after(s);
      greatest_ = std::max(greatest_, energy(flown_));
      farthest_ = std::max(farthest_, flown_.x.cwiseAbs().maxCoeff());
      fastest_ = std::max(fastest_, flown_.v.cwiseAbs().maxCoeff());
      for (std::size_t k = 0; k < scene_.stops.size(); ++k) {
        if (across(scene_.stops[k])) continue;
        Real &worst = held_at(scene_.stops[k]) ? weakest : deepest;
        auto &[first, second, third] = last[k];
        first = second, second = third, third = watched(k, flown_, s);
        note(worst, -third - (s > before ? clock_rounding_[k] : 0));
        const Real bend = first - 2 * second + third;
        if (n < 2 || !(second <= first && second <= third && second < bend)) continue;
        Real from = s - 2 * t / steps, to = s;
        for (int cut = 0; cut < 40; ++cut) {
          const Real left = from + (to - from) / 3, right = to - (to - from) / 3;
          const bool rises =
              watched(k, flight.after(left), left) < watched(k, flight.after(right), right);
          (rises ? to : from) = rises ? right : left;
        }
        note(worst, -watched(k, flight.after(from), from));
      }
    }
    since_ = next;
  }
  bool held_at(const Stop &stop) const {
    return held_[static_cast<std::size_t>(stop.mass - 1)] == static_cast<signed char>(stop.side);
  }
  // A stop across from the one its mass is held at.
  bool across(const Stop &stop) const {
    return held_[static_cast<std::size_t>(stop.mass - 1)] != 0 && !held_at(stop);
  }
};

}  // namespace vibro_impact::testing
