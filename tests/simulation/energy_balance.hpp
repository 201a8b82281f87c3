// The energy balance of a run, by a flow that shares nothing with the library's.
//
// Between two events the free masses obey Eq. 7, whose solution is a sum of exponentials; the work
// of the forcing, int A cos(Omega t) . x' dt, and the loss in the dampers, int x'^T C x' dt, are
// then integrals of products of two exponentials and known exactly: no quadrature, no step.
#pragma once

#include <map>
#include <vector>

#include "exponentials.hpp"
#include "vibro_impact/vibro_impact.hpp"

namespace vibro_impact::testing {

// Displacements, velocities, and the account of energy.
struct EnergyAccount {
  RealVector x, v;
  Real work = 0, dissipated = 0;
  Real turnover = 0;  // the work and the losses, each part counted positive
  Real rounding = 0;  // bound of this account's own rounding
};

// The rigid-body mode of a free chain: no link is strained, so that the work of the forcing is the
// change of its kinetic energy.
inline void move_rigid_body(const Scene &scene, Real force, Real phase, Real t, Real &q, Real &v,
                            EnergyAccount &account) {
  const Place after = rigid_body_after(scene, force, phase, t, {q, v});
  const Real work = (after.speed * after.speed - v * v) / 2;
  // What it gains on the way, at most, and gives back.
  const Real most = std::abs(force) * (scene.omega * t < 2 ? t : 2 / scene.omega);
  const Real turnover = most * (std::abs(v) + most);
  account.work += work;
  account.turnover += turnover;
  account.rounding += 16 * std::numeric_limits<Real>::epsilon() * (v * v + turnover);
  q = after.at;
  v = after.speed;
}

// One mode over the time t from phase time `phase` on: moves (q, v) and enters its energies.
inline void move_mode(const Scene &scene, Real lambda, Real force, Real pull, Real phase, Real t,
                      Real &q, Real &v, EnergyAccount &account) {
  if (lambda == 0) return move_rigid_body(scene, force, phase, t, q, v, account);
  const Real kappa = scene.beta * lambda;
  const std::vector<Exponential> parts =
      parts_of(scene, lambda, force, phase, {q - pull / lambda, v});
  const Exponential drive = drive_from(scene, phase);
  Real terms = 0, work = 0, loss = 0;
  std::vector<Exponential> speed;
  for (const Exponential &part : parts) speed.push_back({part.amplitude * part.rate, part.rate});
  for (const Exponential &a : speed) {
    Real sizes = 0;
    if (force != 0) work += force * integral(a, drive, t, sizes);
    terms += std::abs(force) * sizes;
    if (kappa == 0) continue;
    sizes = 0;
    for (const Exponential &b : speed) loss += kappa * integral(a, b, t, sizes);
    terms += kappa * sizes;
  }
  q = pull / lambda;
  v = 0;
  for (const Exponential &part : parts) {
    const Complex factor = std::exp(part.rate * t);
    q += (part.amplitude * factor).real();
    v += (part.amplitude * part.rate * factor).real();
    // Its share of the energy, with the rounding of the rate over the time t.
    terms += (1 + std::abs(part.rate) * t) * std::norm(part.amplitude) *
             (std::norm(part.rate) + lambda) * std::norm(factor);
  }
  account.work += work;
  account.dissipated += loss;
  account.turnover += std::abs(work) + loss;
  account.rounding += 16 * std::numeric_limits<Real>::epsilon() * terms;
}

// Energy at most of the steady response to the forcing and of the static positions. Where the
// forcing is next to a resonance there is no steady response to be split off; it is left out.
inline Real steady_energy(const Scene &scene, const FreeModes &basis) {
  Real sum = 0;
  const Real omega2 = Real(scene.omega) * scene.omega;
  for (Eigen::Index j = 0; j < basis.lambda.size(); ++j) {
    const Real lambda = basis.lambda(j);
    if (lambda == 0) continue;  // no steady response either
    const Complex detuning(lambda - omega2, scene.beta * lambda * scene.omega);
    const Real amplitude = std::abs(detuning) > 0.01L * (lambda + omega2)
                               ? std::abs(basis.force(j)) / std::abs(detuning)
                               : 0;
    const Real at = basis.pull(j) / lambda;
    sum += (std::max(lambda, omega2) * amplitude * amplitude + lambda * at * at) / 2;
  }
  return sum;
}

// A recorder that keeps the account from event to event. `scene` must outlive it; the losses at
// impacts are computed with coefficients of restitution that are `off` from those of the stops.
struct EnergyAudit {
  const Scene &scene;
  Real off = 0;
  Clock clock{scene.omega};
  Instant since = {};
  Held held = Held(scene.mass.size(), 0);
  EnergyAccount account = at_the_start(scene);
  Real start = energy(), lost = 0, greatest = start;
  Real noticed = 0;    // what the losses at impacts change by, per unit of `off`
  Real steady = 0;     // energy of the steady response and of the static positions
  Real apart = 0;      // elastic energy of neighbours as far apart as any mass is from zero
  Real misplaced = 0;  // largest elastic energy of the jump of the displacements at an event
  std::map<Held, FreeModes> modes = {};

  static EnergyAccount at_the_start(const Scene &scene) {
    const MotionState motion = start_of(scene);
    EnergyAccount account;
    const auto real = [](const std::vector<double> &values) -> RealVector {
      return Eigen::Map<const Eigen::VectorXd>(values.data(),
                                               static_cast<Eigen::Index>(values.size()))
          .cast<Real>();
    };
    account.x = real(motion.displacement);
    account.v = real(motion.velocity);
    return account;
  }

  Real elastic(const RealVector &x) const {
    Real sum = 0;
    for (Eigen::Index i = 0; i < x.size(); ++i) {
      const Real stretch = x(i) - (i > 0 ? x(i - 1) : 0);
      sum += scene.stiffness[static_cast<std::size_t>(i)] * stretch * stretch / 2;
    }
    return sum;
  }
  // Kinetic and elastic energy.
  Real energy() const {
    Real sum = elastic(account.x);
    for (Eigen::Index i = 0; i < account.v.size(); ++i)
      sum += scene.mass[static_cast<std::size_t>(i)] * account.v(i) * account.v(i) / 2;
    return sum;
  }

  // The modes of the masses that are free now.
  const FreeModes &basis_now() {
    auto found = modes.find(held);
    if (found == modes.end()) {
      found = modes.emplace(held, free_modes(scene, held)).first;
      steady = std::max(steady, steady_energy(scene, found->second));
    }
    return found->second;
  }

  void move_to(const Instant &instant) {
    const Real t = elapsed(since, instant, clock);
    const FreeModes &basis = basis_now();  // also of a mode that lasts no time: it is in `steady`
    if (t > 0) {
      RealVector q = basis.inverse * account.x, v = basis.inverse * account.v;
      for (Eigen::Index j = 0; j < q.size(); ++j)
        move_mode(scene, basis.lambda(j), basis.force(j), basis.pull(j), since.phase, t, q(j), v(j),
                  account);
      const RealVector x = basis.shape * q, velocity = basis.shape * v;
      for (std::size_t i = 0; i < held.size(); ++i) {
        if (held[i] != 0) continue;
        account.x(static_cast<Eigen::Index>(i)) = x(static_cast<Eigen::Index>(i));
        account.v(static_cast<Eigen::Index>(i)) = velocity(static_cast<Eigen::Index>(i));
      }
      greatest = std::max(greatest, energy());
    }
    since = instant;
  }

  // Takes over the state the run has: what it differs by from the account is the error sought.
  template <class Displacement, class Velocity>
  void take_over(const Displacement &displacement, const Velocity &velocity) {
    const RealVector expected = account.x;
    for (Eigen::Index i = 0; i < account.x.size(); ++i) {
      account.x(i) = displacement(static_cast<int>(i) + 1);
      account.v(i) = velocity(static_cast<int>(i) + 1);
    }
    misplaced = std::max(misplaced, elastic(account.x - expected));
    Real stiffness = 0;
    for (const double k : scene.stiffness) stiffness += k;
    const Real farthest = account.x.cwiseAbs().maxCoeff();
    apart = std::max(apart, stiffness * farthest * farthest / 2);
  }

  void event(const Event &event, const Moment &moment) {
    move_to(event.instant);
    if (event.kind == EventKind::impact) {
      const Real v = event.velocity_before;
      const Real energy = scene.mass[static_cast<std::size_t>(event.mass - 1)] * v * v / 2;
      const Real r = scene.stops[event.stop].restitution.value_or(scene.restitution) + off;
      const Real loss = (1 - r * r) * energy;
      noticed += 2 * r * energy;
      lost += loss;
      account.turnover += loss;
    }
    take_over([&](int i) { return moment.displacement(i); },
              [&](int i) { return moment.velocity(i); });
    held = event.held;
  }

  // Carries the account to the end of the run.
  void close(const MotionState &end) {
    move_to(end.instant);
    const auto of = [](const std::vector<double> &values) {
      return [&values](int i) { return values[static_cast<std::size_t>(i - 1)]; };
    };
    take_over(of(end.displacement), of(end.velocity));
  }

  // Change of energy - work + losses, up to the last event, or the end; zero but for rounding.
  Real imbalance() const {
    return energy() - start - account.work + account.dissipated + lost;
  }

  // What the imbalance is held against: every energy that took part. The library carries a motion
  // as its deviation from the steady response, and so the rounding of that counts too.
  Real scale() const {
    return account.turnover + greatest + start + steady;
  }
};

}  // namespace vibro_impact::testing
