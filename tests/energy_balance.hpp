// The energy balance of a run, by a flow that shares nothing with the library's.
//
// Between two events the free masses obey Eq. 7, whose solution is a sum of exponentials; the work
// of the forcing, int A cos(Omega t) . x' dt, and the loss in the dampers, int x'^T C x' dt, are
// then integrals of products of two exponentials and known exactly: no quadrature, no step. The
// modes come from an eigenvalue problem solved to 33 digits, so that a soft link among stiff ones
// keeps its digits, and are used in extended precision.
#pragma once

#include <Eigen/Eigenvalues>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <complex>
#include <map>
#include <vector>

#include "vibro_impact/vibro_impact.hpp"

namespace vibro_impact::testing {

using Real = long double;
using Complex = std::complex<Real>;
using RealVector = Eigen::Matrix<Real, Eigen::Dynamic, 1>;

// Modes of the free masses, normalised to unit modal mass: x = shape q on the free masses.
struct FreeModes {
  RealVector lambda;  // w_j^2
  RealVector force;   // of the forcing, per cos(Omega t)
  RealVector pull;    // of the held masses, constant
  Eigen::Matrix<Real, Eigen::Dynamic, Eigen::Dynamic> shape, inverse;  // N x modes, modes x N
};

inline FreeModes free_modes(const Scene &scene, const Held &held) {
  using Quad = boost::multiprecision::cpp_bin_float_quad;
  using Eigen::Index;
  std::vector<std::size_t> free;
  std::vector<double> held_at(held.size(), 0.0);
  for (std::size_t i = 0; i < held.size(); ++i)
    if (held[i] == 0) free.push_back(i);
  for (const Stop &stop : scene.stops) {
    const auto i = static_cast<std::size_t>(stop.mass - 1);
    if (held[i] == static_cast<int>(stop.side)) held_at[i] = stop.position;
  }
  const auto n = static_cast<Index>(held.size()), modes = static_cast<Index>(free.size());
  Eigen::Matrix<Quad, Eigen::Dynamic, Eigen::Dynamic> k =
      Eigen::Matrix<Quad, Eigen::Dynamic, Eigen::Dynamic>::Zero(modes, modes);
  RealVector pull = RealVector::Zero(modes);
  for (Index a = 0; a < modes; ++a) {
    const std::size_t i = free[static_cast<std::size_t>(a)];
    const auto link = [&](std::size_t other, double stiffness) {  // to a neighbour
      k(a, a) += Quad(stiffness) / scene.mass[i];
      if (held[other] != 0)
        pull(a) += static_cast<Real>(stiffness) * held_at[other];
      else
        k(a, other > i ? a + 1 : a - 1) =
            -Quad(stiffness) / sqrt(Quad(scene.mass[i]) * Quad(scene.mass[other]));
    };
    if (i == 0)
      k(a, a) += Quad(scene.stiffness[0]) / scene.mass[0];
    else
      link(i - 1, scene.stiffness[i]);
    if (i + 1 < held.size()) link(i + 1, scene.stiffness[i + 1]);
  }
  FreeModes basis;
  basis.lambda.setZero(modes);
  basis.force.setZero(modes);
  basis.pull.setZero(modes);
  basis.shape.setZero(n, modes);
  basis.inverse.setZero(modes, n);
  if (modes == 0) return basis;
  const Eigen::SelfAdjointEigenSolver<decltype(k)> solver(k);
  for (Index j = 0; j < modes; ++j) {
    basis.lambda(j) = static_cast<Real>(solver.eigenvalues()(j));
    for (Index a = 0; a < modes; ++a) {
      const std::size_t i = free[static_cast<std::size_t>(a)];
      const auto row = static_cast<Index>(i);
      const Quad root = sqrt(Quad(scene.mass[i])), u = solver.eigenvectors()(a, j);
      basis.shape(row, j) = static_cast<Real>(Quad(u / root));
      basis.inverse(j, row) = static_cast<Real>(Quad(u * root));
      basis.pull(j) += basis.shape(row, j) * pull(a);
      if (!scene.amplitude.empty()) basis.force(j) += basis.shape(row, j) * scene.amplitude[i];
    }
  }
  return basis;
}

// Re(amplitude exp(rate t)).
struct Exponential {
  Complex amplitude, rate;
};

// int_0^t exp(rate s) ds, exact as rate t -> 0.
inline Complex integral(Complex rate, Real t) {
  const Complex z = rate * t;
  if (z == Complex(0)) return t;
  const Real half = std::sin(z.imag() / 2), growth = std::exp(z.real());
  return Complex(std::expm1(z.real()) * std::cos(z.imag()) - 2 * half * half,
                 growth * std::sin(z.imag())) /
         rate;
}

// int_0^t a b ds; `terms` gathers the size of what was added, the scale of its rounding.
inline Real integral(const Exponential &a, const Exponential &b, Real t, Real &terms) {
  const Complex with = a.amplitude * b.amplitude * integral(a.rate + b.rate, t);
  const Complex against =
      a.amplitude * std::conj(b.amplitude) * integral(a.rate + std::conj(b.rate), t);
  terms += std::abs(with) + std::abs(against);
  return (with.real() + against.real()) / 2;
}

// Displacements, velocities, and the account of energy.
struct EnergyAccount {
  RealVector x, v;
  Real work = 0, dissipated = 0;
  Real turnover = 0;  // the work and the losses, each part counted positive
  Real rounding = 0;  // bound of this account's own rounding
};

// One mode over the time t from phase time `phase` on: moves (q, v) and enters its energies.
inline void move_mode(const Scene &scene, Real lambda, Real force, Real pull, Real phase, Real t,
                      Real &q, Real &v, EnergyAccount &account) {
  const Real omega = scene.omega, kappa = scene.beta * lambda, alpha = kappa / 2;
  std::vector<Exponential> parts;  // of q - pull / lambda
  const Exponential drive{std::polar<Real>(1, omega * phase), Complex(0, omega)};
  Real free_q = q - pull / lambda, free_v = v;
  if (force != 0) {
    const Complex steady = drive.amplitude * force / Complex(lambda - omega * omega, kappa * omega);
    parts.push_back({steady, drive.rate});
    free_q -= steady.real();
    free_v -= (steady * drive.rate).real();
  }
  const Real discriminant = alpha * alpha - lambda;
  if (discriminant < 0) {
    const Real w = std::sqrt(-discriminant);
    parts.push_back({Complex(free_q, -(free_v + alpha * free_q) / w), Complex(-alpha, w)});
  } else {
    const Real fast = alpha + std::sqrt(discriminant), slow = lambda / fast;
    parts.push_back({Complex((fast * free_q + free_v) / (fast - slow)), Complex(-slow)});
    parts.push_back({Complex(-(slow * free_q + free_v) / (fast - slow)), Complex(-fast)});
  }
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
    const Complex detuning(lambda - omega2, scene.beta * lambda * scene.omega);
    const Real amplitude = std::abs(detuning) > 0.01L * (lambda + omega2)
                               ? std::abs(basis.force(j)) / std::abs(detuning)
                               : 0;
    const Real at = basis.pull(j) / lambda;
    sum += (std::max(lambda, omega2) * amplitude * amplitude + lambda * at * at) / 2;
  }
  return sum;
}

// A recorder that keeps the account from event to event. `scene` must outlive it; `restitution` is
// the coefficient the losses at impacts are computed with, the scene's unless a test says
// otherwise.
struct EnergyAudit {
  const Scene &scene;
  Real restitution;
  Clock clock{scene.omega};
  Instant since = {};
  Held held = Held(scene.mass.size(), 0);
  EnergyAccount account = at_the_start(scene);
  Real start = energy(), lost = 0, greatest = start;
  Real in_impacts = 0;  // kinetic energy brought into the impacts
  Real steady = 0;      // energy of the steady response and of the static positions
  Real misplaced = 0;   // largest elastic energy of the jump of the displacements at an event
  std::map<Held, FreeModes> modes = {};

  static EnergyAccount at_the_start(const Scene &scene) {
    const MotionState motion = start_of(scene);
    EnergyAccount account;
    account.x = motion.displacement.cast<Real>();
    account.v = motion.velocity.cast<Real>();
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

  void move_to(const Instant &instant) {
    const Real t = elapsed(since, instant, clock);
    // Also of a mode that lasts no time: its rounding outlasts it.
    auto found = modes.find(held);
    if (found == modes.end()) {
      found = modes.emplace(held, free_modes(scene, held)).first;
      steady = std::max(steady, steady_energy(scene, found->second));
    }
    if (t > 0) {
      const FreeModes &basis = found->second;
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
  }

  void event(const Event &event, const Moment &moment) {
    move_to(event.instant);
    if (event.kind == EventKind::impact) {
      const Real v = event.velocity_before;
      const Real energy = scene.mass[static_cast<std::size_t>(event.mass - 1)] * v * v / 2;
      const Real loss = (1 - restitution * restitution) * energy;
      in_impacts += energy;
      lost += loss;
      account.turnover += loss;
    }
    take_over(moment.displacement, moment.velocity);
    held = event.held;
  }

  // Carries the account to the end of the run.
  void close(const MotionState &end) {
    move_to(end.instant);
    take_over([&](int i) { return end.displacement(i - 1); },
              [&](int i) { return end.velocity(i - 1); });
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
