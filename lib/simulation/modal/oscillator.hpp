// One modal coordinate in closed form:
//
//   y'' + kappa y' + lambda y = a cos(Omega t) + b sin(Omega t) + c,   kappa = beta lambda    (9)
//
// with t from the start of the flight. The change over any time is found without cancellation, in
// twice the precision, and the response to an impulse in either precision. The paper prints the
// under-damped case only (Eqs. 6-7).
#pragma once

#include <algorithm>
#include <cmath>

#include "simulation/chain/twofold.hpp"

namespace vibro_impact::detail {

struct ModalForce {
  Real a, b, c;
};

// y(tau) - y - tau y' and y'(tau) - y', or y and y' of a response.
template <class T>
struct ModalChange {
  T y, dy;
};

template <class T>
struct ComplexOf {
  T re, im;

  friend ComplexOf operator*(const ComplexOf &p, const ComplexOf &q) {
    return {p.re * q.re - p.im * q.im, p.re * q.im + p.im * q.re};
  }
  friend ComplexOf operator/(const ComplexOf &p, const ComplexOf &q) {
    const T n = q.re * q.re + q.im * q.im;
    return {(p.re * q.re + p.im * q.im) / n, (p.im * q.re - p.re * q.im) / n};
  }
  friend ComplexOf operator-(const ComplexOf &p, const ComplexOf &q) {
    return {p.re - q.re, p.im - q.im};
  }
};

// e^(i angle).
template <class T>
ComplexOf<T> wave_at(const T &angle) {
  ComplexOf<T> wave;
  sincos(angle, wave.im, wave.re);
  return wave;
}

template <class T>
struct Oscillator {
  T lambda = 0.0, kappa = 0.0;
  // The characteristic roots are -half +- sqrt(square), and root is |square|^(1/2).
  T half = 0.0, square = 0.0, root = 0.0;
  T fast = 0.0, slow = 0.0;  // the roots if they are real
  double rate = 0.0;         // the modulus of the faster root

  Oscillator() = default;
  Oscillator(const T &stiffness, const T &damping) : lambda(stiffness), kappa(damping) {
    using std::sqrt;
    half = 0.5 * kappa;
    square = half * half - lambda;
    root = sqrt(rounded(square) < 0.0 ? -square : square);
    rate = std::sqrt(rounded(lambda));
    if (!has_two_decays()) return;
    fast = -(half + root);
    slow = lambda / fast;  // without cancellation
    rate = -rounded(fast);
  }
  bool has_two_decays() const {
    return rounded(square) > 0.0;
  }
};

// The motion after tau from y = 0 and y' = 1, without force. It is analytic in the discriminant, so
// that its series there serves next to critical damping.
template <class T>
ModalChange<T> impulse_response(const Oscillator<T> &o, const T &tau) {
  using std::exp;
  const T w = o.square * tau * tau;
  if (std::abs(rounded(w)) < 0.25) {
    T odd = 1.0, even = 1.0, term = 1.0;
    for (int k = 1; k < 16; ++k) {  // the next term is below 2^-106
      term = term * w / (2.0 * k - 1.0) / (2.0 * k);
      even += term;
      odd += term / (2.0 * k + 1.0);
    }
    const T e = exp(-o.half * tau);
    return {e * tau * odd, e * (even - o.half * tau * odd)};
  }
  if (rounded(w) < 0.0) {
    const T e = exp(-o.half * tau);
    const ComplexOf<T> turn = wave_at(o.root * tau);
    const T s = turn.im / o.root;
    return {e * s, e * (turn.re - o.half * s)};
  }
  const T f = exp(o.fast * tau), s = exp(o.slow * tau);
  return {(s - f) / (2.0 * o.root), (o.slow * s - o.fast * f) / (2.0 * o.root)};
}

// The Taylor series, for times of at most a radian of the oscillator and of the forcing.
inline ModalChange<Real> change_by_series(const Oscillator<Real> &o, const Real &y, const Real &dy,
                                          const ModalForce &f, double omega, const Real &tau) {
  const Real square = tau * tau, stiff = o.lambda * square, damp = o.kappa * tau,
             turn = omega * tau;
  const double radians = std::max(o.rate, omega) * std::abs(rounded(tau));
  // Terms n and n + 1 of y, and those of the forces. `slope` is tau times the derivative.
  Real term = y, next = tau * dy, a = square * f.a, b = square * f.b, force = a + square * f.c;
  Real sum = 0.0, slope = 0.0;
  double bound = 1.0;
  for (double n = 0.0; n < 50.0 && bound > 1e-34; ++n) {
    const Real after = ((force - stiff * term) / (n + 1.0) - damp * next) / (n + 2.0), old = a;
    sum += after;
    slope += after * (n + 2.0);
    term = next;
    next = after;
    a = turn * b / (n + 1.0);
    b = -(turn * old) / (n + 1.0);
    force = a;
    bound *= radians / (n + 1.0);
  }
  return {sum, slope / tau};
}

// The response, from rest, to the force e^(i Omega t): its value, from that `h` of an impulse and
// from e^(i Omega tau).
inline ComplexOf<Real> forced_response(const Oscillator<Real> &o, const ModalChange<Real> &h,
                                       double omega, const Real &tau, const ComplexOf<Real> &wave) {
  const Real off = o.root - omega;
  const bool oscillates = rounded(o.square) < 0.0;
  if (oscillates && std::hypot(rounded(o.half), rounded(off)) * rounded(tau) < 1.0) {
    // Near resonance the usual form cancels. With q = -half + i root, the response is
    // (near - far) / (2 i root), near = (e^(q tau) - e^(i Omega tau)) / (q - i Omega) by its
    // series.
    const ComplexOf<Real> z{-o.half * tau, off * tau};
    ComplexOf<Real> sum{1.0, 0.0}, term{1.0, 0.0};
    for (double k = 2.0; k < 30.0; ++k) {
      term = term * z;
      term = {term.re / k, term.im / k};
      sum = {sum.re + term.re, sum.im + term.im};
    }
    const ComplexOf<Real> near = wave * ComplexOf<Real>{sum.re * tau, sum.im * tau};
    // e^(q* tau) from the response to an impulse: h' + half h = e cos, root h = e sin.
    const ComplexOf<Real> mirror{h.dy + o.half * h.y, -(o.root * h.y)};
    const ComplexOf<Real> far = (mirror - wave) / ComplexOf<Real>{-o.half, -(o.root + omega)};
    return (near - far) / ComplexOf<Real>{0.0, 2.0 * o.root};
  }
  const Real w = omega;
  const ComplexOf<Real> free{h.dy + o.kappa * h.y, w * h.y};
  return (wave - free) / ComplexOf<Real>{o.lambda - w * w, o.kappa * w};
}

// The change over the time tau, with wave = e^(i Omega tau).
inline ModalChange<Real> change(const Oscillator<Real> &o, const Real &y, const Real &dy,
                                const ModalForce &f, double omega, const Real &tau,
                                const ComplexOf<Real> &wave) {
  const bool forced = rounded(f.a) != 0.0 || rounded(f.b) != 0.0;
  const bool short_time = o.rate * rounded(tau) <= 1.0;
  if (short_time && (!forced || omega * rounded(tau) <= 1.0))
    return change_by_series(o, y, dy, f, forced ? omega : 0.0, tau);
  const ModalChange<Real> h = impulse_response(o, tau);
  ModalChange<Real> result;
  if (short_time) {
    result = change_by_series(o, y, dy, {0.0, 0.0, f.c}, 0.0, tau);
  } else {
    const Real decay = h.dy + o.kappa * h.y;  // y(tau) from y = 1 and y' = 0
    result.y = y * decay + dy * h.y + f.c * (Real(1.0) - decay) / o.lambda - y - tau * dy;
    result.dy = (f.c - o.lambda * y) * h.y + dy * (h.dy - 1.0);
  }
  if (!forced) return result;
  const ComplexOf<Real> g = forced_response(o, h, omega, tau, wave);
  result.y += f.a * g.re + f.b * g.im;
  result.dy += f.a * (h.y - omega * g.im) + f.b * omega * g.re;
  return result;
}

}  // namespace vibro_impact::detail
