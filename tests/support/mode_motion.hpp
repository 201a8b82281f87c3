// The motion of the free masses in extended precision. Their modes follow from the decomposition of
// the generator, which shares nothing with the library's: an eigenvalue problem solved in 50
// digits, so that links of 1e-9 to 1e9 between masses of 1e-6 to 1e6 leave 20 of them. The closed
// formulas of a mode keep their digits at critical damping and in resonance.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <complex>
#include <vector>

#include "reference/generator/closed_form.hpp"
#include "vibro_impact/record.hpp"
#include "vibro_impact/scene.hpp"

namespace vibro_impact::testing {

using Real = long double;
using RealVector = Eigen::Matrix<Real, Eigen::Dynamic, 1>;

// Modes of the free masses, normalised to unit modal mass: x = shape q on the free masses.
struct FreeModes {
  RealVector lambda;        // w_j^2
  RealVector cosine, sine;  // of the forcing
  RealVector pull;          // of the held masses and the constant forces
  Eigen::Matrix<Real, Eigen::Dynamic, Eigen::Dynamic> shape, inverse;  // N x modes, modes x N
};

inline FreeModes free_modes(const Scene &scene, const Held &held) {
  using Eigen::Index;
  const auto digits = vibro_impact_reference::in_digits(scene, 0.0);
  const vibro_impact_reference::Matrix k = vibro_impact_reference::stiffness_matrix(digits);
  std::vector<std::size_t> free;
  for (std::size_t i = 0; i < held.size(); ++i)
    if (held[i] == 0) free.push_back(i);
  const auto n = static_cast<Index>(held.size()), modes = static_cast<Index>(free.size());
  RealVector pull = RealVector::Zero(n);
  for (const std::size_t i : free)
    pull(static_cast<Index>(i)) = static_cast<Real>(digits.constant[i]);
  for (const Stop &stop : scene.stops) {
    const auto s = static_cast<std::size_t>(stop.mass - 1);
    if (held[s] != static_cast<signed char>(stop.side)) continue;
    for (const std::size_t i : free)
      pull(static_cast<Index>(i)) -= static_cast<Real>(k[i][s]) * stop.position;
  }
  FreeModes basis;
  basis.lambda.setZero(modes);
  basis.cosine.setZero(modes);
  basis.sine.setZero(modes);
  basis.pull.setZero(modes);
  basis.shape.setZero(n, modes);
  basis.inverse.setZero(modes, n);
  if (modes == 0) return basis;
  const bool tied = scene.stiffness[0] > 0.0 ||
                    std::ranges::any_of(scene.ground, [](double g) { return g > 0.0; });
  // The frequency of the rigid-body mode is zero exactly.
  auto eigen = vibro_impact_reference::free_eigensystem(digits, k, free);
  if (!tied && free.size() == held.size()) *std::ranges::min_element(eigen.values) = 0;
  for (Index j = 0; j < modes; ++j) {
    const auto mode = static_cast<std::size_t>(j);
    basis.lambda(j) = static_cast<Real>(eigen.values[mode]);
    for (std::size_t a = 0; a < free.size(); ++a) {
      const std::size_t i = free[a];
      const auto row = static_cast<Index>(i);
      basis.shape(row, j) = static_cast<Real>(eigen.vectors[a][mode]);
      basis.inverse(j, row) = basis.shape(row, j) * scene.mass[i];
      basis.pull(j) += basis.shape(row, j) * pull(row);
      basis.cosine(j) += basis.shape(row, j) * static_cast<Real>(digits.amplitude[i]);
      basis.sine(j) += basis.shape(row, j) * static_cast<Real>(digits.sine[i]);
    }
  }
  return basis;
}

using Complex = std::complex<Real>;

// The displacement and velocity of a mode.
struct Place {
  Real at = 0, speed = 0;
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

// int_0^1 (1 - u) exp(z u) du = (exp(z) - 1 - z) / z^2 for imaginary z.
inline Complex ramp(Complex z) {
  if (std::abs(z) > 1) return (std::exp(z) - Real(1) - z) / (z * z);
  Complex sum = 0, term = 0.5L;
  for (int n = 3; n < 30; ++n) {
    sum += term;
    term *= z / static_cast<Real>(n);
  }
  return sum;
}

// q'' + kappa q' + lambda q = 0, lambda > 0: all follows from the solution with S(0) = 0, S'(0)
// = 1.
inline Place free_after(Real kappa, Real lambda, Place from, Real t) {
  const Real alpha = kappa / 2, discriminant = alpha * alpha - lambda;
  Place s;
  if (discriminant < 0) {
    const Real w = std::sqrt(-discriminant), decay = std::exp(-alpha * t);
    s.at = decay * std::sin(w * t) / w;
    s.speed = decay * std::cos(w * t) - alpha * s.at;
  } else {
    const Real root = std::sqrt(discriminant), fast = alpha + root, slow = lambda / fast;
    s.at = std::exp(-slow * t) * (root > 0 ? -std::expm1(-2 * root * t) / (2 * root) : t);
    s.speed = std::exp(-fast * t) - slow * s.at;
  }
  return {(s.speed + kappa * s.at) * from.at + s.at * from.speed,
          -lambda * s.at * from.at + s.speed * from.speed};
}

// q'' + beta lambda q' + lambda q = Re(force exp(i Omega t)) + pull, from phase time `phase` on.
struct ModeMotion {
  Real lambda, kappa, omega;
  Complex drive;  // force exp(i Omega phase)
  Real pull;
  Real rest;           // where the pull alone takes it
  Complex steady = 0;  // response to the forcing; not split off where that is next to a resonance
  Place free;          // what moves about these
  Place start;         // of the flight

  ModeMotion(const Scene &scene, Real lambda_of_mode, Complex force, Real constant, Real phase,
             Place from)
      : lambda(lambda_of_mode),
        kappa(scene.beta * lambda),
        omega(scene.omega),
        drive(std::polar<Real>(1, omega * phase) * force),
        pull(constant),
        rest(lambda > 0 ? pull / lambda : 0),
        free{from.at - rest, from.speed},
        start(from) {
    const Complex detuning(lambda - omega * omega, kappa * omega);
    if (lambda == 0 || std::abs(detuning) < 0.01L * (lambda + omega * omega)) return;
    steady = drive / detuning;
    free.at -= steady.real();
    free.speed -= (steady * Complex(0, omega)).real();
  }

  // The Taylor series about the start. Where rates times t are small, the formulas of `after` would
  // subtract responses that are many times the motion. For lambda t^2, kappa t and omega t below
  // 0.01, the terms that are left out lie below rounding.
  bool has_series(Real t) const {
    return std::max({lambda * t * t, kappa * t, omega * t}) < 0.01L;
  }
  Place series(Real t) const {
    Complex turning = drive;  // derivative of the forcing, over n!
    Real derivative = start.speed, previous = start.at, power = 1;
    Place sum = start;
    for (int n = 0; n < 16; ++n) {  // coefficients of t^n and t^(n+1) give that of t^(n+2)
      const Real next = (turning.real() + (n == 0 ? pull : 0) -
                         kappa * static_cast<Real>(n + 1) * derivative - lambda * previous) /
                        static_cast<Real>((n + 1) * (n + 2));
      sum.speed += next * static_cast<Real>(n + 2) * power * t;
      sum.at += n == 0 ? derivative * t + next * t * t : next * power * t * t;
      turning *= Complex(0, omega) / static_cast<Real>(n + 1);
      previous = derivative;
      derivative = next;
      power *= t;
    }
    return sum;
  }

  Place after(Real t) const {
    if (lambda > 0 && has_series(t)) return series(t);
    const Complex rate(0, omega);
    Complex at = 0, speed = 0;  // what the forcing does
    if (lambda == 0) {          // the rigid-body mode of a free chain, which nothing holds back
      at = free.at + free.speed * t + drive * t * t * ramp(rate * t) + pull * t * t / 2;
      speed = free.speed + drive * integral(rate, t) + pull * t;
      return {at.real(), speed.real()};
    }
    if (steady != Complex(0)) {
      at = steady * std::exp(rate * t);
      speed = rate * at;
    } else if (drive != Complex(0)) {
      // int_0^t S(t - s) drive exp(i Omega s) ds; S is the sum over its two roots.
      const Real w = std::sqrt(lambda - kappa * kappa / 4);
      for (const Real sign : {1, -1}) {
        const Complex root(-kappa / 2, sign * w);
        const Complex part =
            drive * std::exp(root * t) * integral(rate - root, t) / Complex(0, 2 * sign * w);
        at += part;
        speed += root * part;
      }
    }
    const Place moved = free_after(kappa, lambda, free, t);
    return {rest + moved.at + at.real(), moved.speed + speed.real()};
  }
};

}  // namespace vibro_impact::testing
