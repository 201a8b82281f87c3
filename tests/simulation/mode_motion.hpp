// The motion of one mode of the free masses, in extended precision: closed formulas that keep their
// digits at critical damping and in resonance.
#pragma once

#include <cmath>
#include <complex>

#include "free_modes.hpp"

namespace vibro_impact::testing {

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

  ModeMotion(const Scene &scene, Real lambda_of_mode, Complex force, Real constant, Real phase,
             Place from)
      : lambda(lambda_of_mode),
        kappa(scene.beta * lambda),
        omega(scene.omega),
        drive(std::polar<Real>(1, omega * phase) * force),
        pull(constant),
        rest(lambda > 0 ? pull / lambda : 0),
        free{from.at - rest, from.speed} {
    const Complex detuning(lambda - omega * omega, kappa * omega);
    if (lambda == 0 || std::abs(detuning) < 0.01L * (lambda + omega * omega)) return;
    steady = drive / detuning;
    free.at -= steady.real();
    free.speed -= (steady * Complex(0, omega)).real();
  }

  Place after(Real t) const {
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
