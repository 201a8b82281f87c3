// Random scenes of long flights, with their events from solutions in extended precision: weak
// links, behind which a mass moves by less than the rounding of the one before it, and a hold force
// beside a mode that decays fast.
#pragma once

#include <array>
#include <cmath>
#include <complex>
#include <numbers>
#include <vector>

#include "scene_properties.hpp"

namespace vibro_impact::testing {

// A chain whose last mass alone has a stop, at zero, where it starts, with r = 0. Only the first
// mass is forced, by a cos(Omega t). In extended precision its motion is a Taylor series of step
// after step. No sum in it has two large terms that cancel: each displacement is known relative to
// itself, however weak its links are.
class ChainBySeries {
 public:
  explicit ChainBySeries(const Scene &scene)
      : scene_(scene),
        sigma_(sign(scene.stops[0].side)),
        last_(scene.mass.size() - 1),
        held_(scene.amplitude[0] * sigma_ > 0.0) {
    for (auto &order : x_) order.assign(scene.mass.size(), 0.0L);
    const double fastest =
        frequency_bound(scene) * std::max(1.0, scene.beta * frequency_bound(scene));
    step_ = 0.5L / fastest;
  }

  // The instants up to the end at which the mass comes to its stop or is released, in turn.
  std::vector<Real> events(Real until) {
    std::vector<Real> found;
    while (t_ < until) {
      expand();
      Real before = 0.0L, after = 0.0L;
      bool changed = false;
      while (after < step_ && !changed) {
        before = after;
        after += step_ / parts;
        changed = contact(after) < 0.0L || falls_between(before, after);
      }
      if (changed) {
        const Real root = root_between(before, after);
        found.push_back(t_ + root);
        move(root);
        if (!held_) x_[0][last_] = x_[1][last_] = 0.0L;
        held_ = !held_ && force(0.0L) > 0.0L;
      }
      if (!changed) move(step_);
    }
    while (!found.empty() && found.back() > until) found.pop_back();
    return found;
  }

 private:
  static constexpr std::size_t orders = 24;  // 0.5^24 / 24! is 1e-31
  static constexpr int parts = 4;

  const Scene &scene_;
  Real sigma_;
  std::size_t last_;
  bool held_;
  Real t_ = 0.0L, step_ = 0.0L;
  std::array<std::vector<Real>, orders + 1> x_;  // the coefficients of s^n

  // x + beta v at order n of mass i, counted from 1; the ground is mass 0.
  Real z(std::size_t n, std::size_t i) const {
    if (i == 0) return 0.0L;
    return x_[n][i - 1] + scene_.beta * static_cast<Real>(n + 1) * x_[n + 1][i - 1];
  }
  Real springs(std::size_t n, std::size_t i) const {
    Real force = scene_.stiffness[i] * (z(n, i) - z(n, i + 1)) - scene_.ground[i] * z(n, i + 1);
    if (i < last_) force += scene_.stiffness[i + 1] * (z(n, i + 2) - z(n, i + 1));
    return force;
  }
  void expand() {
    Real wave = scene_.amplitude[0] * std::cos(scene_.omega * t_),
         next = -scene_.amplitude[0] * scene_.omega * std::sin(scene_.omega * t_);
    for (std::size_t n = 0; n + 2 <= orders; ++n) {
      const auto order = static_cast<Real>(n);
      for (std::size_t i = 0; i <= last_; ++i) {
        const Real force = springs(n, i) + (i == 0 ? wave : 0.0L);
        const bool is_held = held_ && i == last_;
        x_[n + 2][i] = is_held ? 0.0L : force / scene_.mass[i] / ((order + 1) * (order + 2));
      }
      const Real after = -wave * scene_.omega * scene_.omega / ((order + 1) * (order + 2));
      wave = std::exchange(next, after);
    }
  }
  // The displacement, and the speed, of a mass counted from 0.
  Real at(std::size_t i, Real s) const {
    Real sum = 0.0L;
    for (std::size_t n = orders + 1; n-- > 0;) sum = sum * s + x_[n][i];
    return sum;
  }
  Real speed(std::size_t i, Real s) const {
    Real sum = 0.0L;
    for (std::size_t n = orders; n > 0; --n) sum = sum * s + static_cast<Real>(n) * x_[n][i];
    return sum;
  }
  // The force that presses the mass to its stop, over the stiffness of its link.
  Real force(Real s) const {
    return sigma_ * (at(last_ - 1, s) + scene_.beta * speed(last_ - 1, s));
  }
  Real contact(Real s) const {
    return held_ ? force(s) : -sigma_ * at(last_, s);
  }
  // If the contact falls after one point and rises before the other, the lowest point between them
  // is looked at. It becomes the second of them where it lies below zero.
  bool falls_between(Real before, Real &after) const {
    const Real little = (after - before) / 64;
    if (!(contact(before + little) < contact(before) && contact(after - little) < contact(after)))
      return false;
    Real from = before, to = after;
    for (int cut = 0; cut < 30; ++cut) {
      const Real third = (to - from) / 3;
      const bool rises = contact(from + third) < contact(to - third);
      (rises ? to : from) = rises ? to - third : from + third;
    }
    if (!(contact(from) < 0.0L)) return false;
    after = from;
    return true;
  }
  Real root_between(Real before, Real after) const {
    for (int cut = 0; cut < 64; ++cut) {
      const Real middle = (before + after) / 2;
      (contact(middle) < 0.0L ? after : before) = middle;
    }
    return after;
  }
  void move(Real s) {
    for (std::size_t i = 0; i <= last_; ++i) {
      const Real x = at(i, s), v = speed(i, s);
      x_[0][i] = x;
      x_[1][i] = v;
    }
    t_ += s;
  }
};

// Two to four damped oscillators of their own springs to the ground, of which the first is forced
// slowly. Each drives the next through a weak link. Half of the chains are identical oscillators on
// links down to 1e-18, whose modes differ in their last digits and cancel at the last mass. Others
// have links whose product is as small as 1e-150: the square of a displacement is still a number.
inline Trial weak_links(unsigned seed) {
  Draw draw{std::mt19937(seed)};
  Scene scene;
  const bool identical = draw.one_in(2);
  const int masses = draw.between(2, identical ? 3 : 4);
  const double weakest = std::pow(identical ? 1e-18 : 1e-150, 1.0 / (masses - 1));
  const double mass = draw.uniform(0.5, 2.0), ground = draw.uniform(0.5, 2.0);
  for (int i = 1; i <= masses; ++i) {
    scene.mass.push_back(identical ? mass : draw.uniform(0.5, 2.0));
    scene.ground.push_back(identical ? ground : draw.uniform(0.3, 3.0));
    scene.stiffness.push_back(i == 1 ? 0.0 : draw.spread(weakest, 1e-6));
    scene.amplitude.push_back(i == 1 ? 1.0 : 0.0);
  }
  scene.beta = draw.spread(0.05, 2.0);
  scene.omega = draw.spread(1e-3, 1e-2);
  scene.restitution = 0.0;
  scene.stops = {{masses, draw.one_in(2) ? Side::lower : Side::upper, 0.0}};
  return {scene, draw.uniform(1.2, 1.4) * Clock(scene.omega).period, {}, true};
}

// The impacts and releases are those of the series, to the rounding of a gap over its slope: 1e-30
// of the first mass, of which the last moves by the product of the links.
inline std::string broken_by_series(const Run &run) {
  std::vector<Event> ours = run.events;
  std::erase_if(ours, [](const Event &event) { return event.kind == EventKind::stick; });
  const std::vector<Real> exact = ChainBySeries(run.scene).events(run.until);
  if (ours.size() != exact.size())
    return fmt::format("{} impacts and releases instead of {}", ours.size(), exact.size());
  for (std::size_t i = 0; i < ours.size(); ++i) {
    const double off = std::abs(static_cast<double>(exact[i] - ours[i].time));
    if (!(off <= 1e-9 * ours[i].time))
      return fmt::format("{} at {} off by {:.3g}", name(ours[i].kind), ours[i].time, off);
  }
  return "";
}

// Two masses of 1, of which a constant force holds the first at its stop. The second is forced, and
// its damped link pulls the first one with a force of modulus R once in each period: the hold force
// falls to -depth R there. The fastest rate is that of the damper, or of the link.
//
// This is the hold force of such a scene in extended precision.
class ForceBesideAFastMode {
 public:
  // The link pulls with k (x + beta x') = a cos(Omega t) - x''. Of this, a mode e^(q t) of x is
  // -q^2 e^(q t). The mass starts at rest.
  explicit ForceBesideAFastMode(const Scene &scene) : omega_(scene.omega) {
    const Real k = scene.stiffness[1], damping = scene.beta * k;
    const Wave steady =
        static_cast<Real>(scene.amplitude[1]) / Wave(k - omega_ * omega_, damping * omega_);
    pull_ = Wave(k, damping * omega_) * steady;
    constant_ = scene.constant.empty() ? 0.0L : static_cast<Real>(scene.constant[0]);
    fast_ = -damping / 2 - std::sqrt(Wave(damping * damping / 4 - k));
    slow_ = k / fast_;
    const Wave x = -steady.real(), v = omega_ * steady.imag();
    of_fast_ = (v - slow_ * x) / (fast_ - slow_);
    of_slow_ = x - of_fast_;
  }
  Real pull() const {
    return std::abs(pull_);
  }
  // The time at which the first dip is deepest.
  Real first_dip() const {
    return (std::numbers::pi_v<Real> - std::arg(pull_)) / omega_;
  }
  Real at(Real t) const {
    const Wave modes = of_fast_ * fast_ * fast_ * std::exp(fast_ * t) +
                       of_slow_ * slow_ * slow_ * std::exp(slow_ * t);
    return constant_ + (pull_ * std::exp(Wave(0.0L, omega_ * t)) - modes).real();
  }
  Real slope_at(Real t) const {
    return std::abs(pull_ * omega_ * std::sin(omega_ * (t - first_dip())));
  }
  Real first_release() const {
    Real before = first_dip() / 4, after = first_dip();
    for (int cut = 0; cut < 80; ++cut) {
      const Real middle = (before + after) / 2;
      (at(middle) < 0.0L ? after : before) = middle;
    }
    return after;
  }

 private:
  using Wave = std::complex<Real>;

  Real omega_, constant_;
  Wave pull_, fast_, slow_, of_fast_, of_slow_;
};

// Such a scene.
inline Scene dip_beside_a_fast_mode(double stiffness, double beta, double amplitude, double omega,
                                    double depth) {
  Scene scene{.mass = {1.0, 1.0},
              .stiffness = {1.0, stiffness},
              .beta = beta,
              .amplitude = {0.0, amplitude},
              .omega = omega,
              .restitution = 0.0,
              .stops = {{1, Side::upper, 0.0}}};
  const Real constant = ForceBesideAFastMode(scene).pull() * (1.0L - static_cast<Real>(depth));
  scene.constant = {static_cast<double>(constant), 0.0};
  return scene;
}

// Four of five links are ordinary beside a damper of up to 1e13; others are stiff. Most dips are as
// shallow as 1e-13.
inline Trial fast_modes(unsigned seed) {
  Draw draw{std::mt19937(seed)};
  const bool stiff = draw.one_in(5);
  const double stiffness = stiff ? draw.spread(1e8, 1e12) : draw.uniform(0.5, 2.0),
               beta =
                   stiff ? draw.spread(1e-2, 10.0) / std::sqrt(stiffness) : draw.spread(1e4, 1e13),
               depth = draw.one_in(4) ? draw.uniform(0.1, 0.9) : draw.spread(1e-13, 1e-4),
               omega = draw.uniform(0.1, 1.0);
  const Scene scene = dip_beside_a_fast_mode(stiffness, beta, draw.spread(0.1, 10.0), omega, depth);
  const auto dip = static_cast<double>(ForceBesideAFastMode(scene).first_dip());
  return {scene, dip + draw.uniform(0.1, 2.6) / omega, {}, true};
}

// The first release may be off by eight roundings of the force over its slope, and of the clock.
inline std::string broken_by_a_release(const Run &run) {
  const ForceBesideAFastMode force(run.scene);
  const auto exact = static_cast<double>(force.first_release()),
             slope = static_cast<double>(force.slope_at(exact) / force.pull());
  for (const Event &event : run.events)
    if (event.kind == EventKind::release)
      return std::abs(event.time - exact) <= 0x1p-50 * (2.0 / slope + exact)
                 ? ""
                 : fmt::format("release at {} instead of {}", event.time, exact);
  return fmt::format("no release, which is at {}", exact);
}

}  // namespace vibro_impact::testing
