// The motion of one free mode as a sum of exponentials, in extended precision.
#pragma once

#include <cmath>
#include <complex>
#include <vector>

#include "free_modes.hpp"

namespace vibro_impact::testing {

using Complex = std::complex<Real>;

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

// Where a mode, or a mass, is and how fast.
struct Place {
  Real at = 0, speed = 0;
};

// The forcing cos(Omega t) from phase time `phase` on.
inline Exponential drive_from(const Scene &scene, Real phase) {
  return {std::polar<Real>(1, scene.omega * phase), Complex(0, scene.omega)};
}

// The parts of q'' + beta lambda q' + lambda q = force cos(Omega t) from a place, lambda > 0: of
// the steady response and of the free motion.
inline std::vector<Exponential> parts_of(const Scene &scene, Real lambda, Real force, Real phase,
                                         Place free) {
  const Real omega = scene.omega, kappa = scene.beta * lambda, alpha = kappa / 2;
  std::vector<Exponential> parts;
  if (force != 0) {
    const Exponential drive = drive_from(scene, phase);
    const Complex steady = drive.amplitude * force / Complex(lambda - omega * omega, kappa * omega);
    parts.push_back({steady, drive.rate});
    free.at -= steady.real();
    free.speed -= (steady * drive.rate).real();
  }
  const Real discriminant = alpha * alpha - lambda;
  if (discriminant < 0) {
    const Real w = std::sqrt(-discriminant);
    parts.push_back({Complex(free.at, -(free.speed + alpha * free.at) / w), Complex(-alpha, w)});
  } else {
    const Real fast = alpha + std::sqrt(discriminant), slow = lambda / fast;
    const Real apart = fast - slow;
    parts.push_back({Complex((fast * free.at + free.speed) / apart), Complex(-slow)});
    parts.push_back({Complex(-(slow * free.at + free.speed) / apart), Complex(-fast)});
  }
  return parts;
}

inline Place place_after(const std::vector<Exponential> &parts, Real t) {
  Place place;
  for (const Exponential &part : parts) {
    const Complex now = part.amplitude * std::exp(part.rate * t);
    place.at += now.real();
    place.speed += (part.rate * now).real();
  }
  return place;
}

// q'' = force cos(Omega t): the rigid-body mode of a free chain, which nothing holds back.
inline Place rigid_body_after(const Scene &scene, Real force, Real phase, Real t, Place from) {
  const Complex drive = force * drive_from(scene, phase).amplitude, rate(0, scene.omega);
  return {from.at + from.speed * t + (drive * t * t * ramp(rate * t)).real(),
          from.speed + (drive * integral(rate, t)).real()};
}

}  // namespace vibro_impact::testing
