// The closed form of the motion between two events, written the obvious way: one mode after the
// other, at the time since the last event (Wagg 2006, Eqs. 7, 21, 24). For the plain event-driven
// scheme; it shares the scene with the library and nothing else. Every mode must be underdamped.
#pragma once

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <cmath>
#include <stdexcept>
#include <vector>

#include "plain_event_driven.hpp"

namespace vibro_impact::plain {

using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, 8, 8>;

// The closed form of the masses that are not held, from (x, v) at time `start` on.
struct Motion {
  Matrix shape;
  Vector rest, decay, frequency, a, b, in_phase, quadrature;
  double start, omega;

  void evaluate(double tau, Vector &x, Vector &v) const {
    Vector q(decay.size()), rate(decay.size());
    const double phase = omega * (start + tau), c = std::cos(phase), s = std::sin(phase);
    for (Eigen::Index j = 0; j < decay.size(); ++j) {
      const double e = std::exp(-decay(j) * tau), angle = frequency(j) * tau;
      const double cj = e * std::cos(angle), sj = e * std::sin(angle);
      q(j) = a(j) * cj + b(j) * sj + in_phase(j) * c + quadrature(j) * s;
      rate(j) = (frequency(j) * b(j) - decay(j) * a(j)) * cj -
                (frequency(j) * a(j) + decay(j) * b(j)) * sj +
                omega * (quadrature(j) * c - in_phase(j) * s);
    }
    x = rest + shape * q;
    v = shape * rate;
  }
};

// Throws std::invalid_argument for an overdamped mode.
inline Motion motion_from(const Scene &scene, const std::vector<int> &held, double start,
                          const Vector &x, const Vector &v) {
  const auto n = static_cast<Eigen::Index>(scene.mass.size());
  Matrix k = Matrix::Zero(n, n);
  std::vector<Eigen::Index> free;
  for (Eigen::Index i = 0; i < n; ++i) {
    const double link = scene.stiffness[static_cast<std::size_t>(i)];
    k(i, i) += link;
    if (i > 0) k(i - 1, i - 1) += link, k(i - 1, i) = k(i, i - 1) = -link;
    if (held[static_cast<std::size_t>(i)] == 0) free.push_back(i);
  }
  const auto modes = static_cast<Eigen::Index>(free.size());
  Motion motion{Matrix::Zero(n, modes), x, {}, {}, {}, {}, {}, {}, start, scene.omega};
  for (auto *u : {&motion.decay, &motion.frequency, &motion.a, &motion.b, &motion.in_phase,
                  &motion.quadrature})
    u->setZero(modes);
  if (modes == 0) return motion;
  for (Eigen::Index i : free) motion.rest(i) = 0.0;
  const Matrix k_free = k(free, free);
  motion.rest(free) = -k_free.inverse() * (k * motion.rest)(free);
  Vector root_mass(modes), force = Vector::Zero(modes);
  for (Eigen::Index i = 0; i < modes; ++i) {
    const auto at = static_cast<std::size_t>(free[static_cast<std::size_t>(i)]);
    root_mass(i) = std::sqrt(scene.mass[at]);
    if (!scene.amplitude.empty()) force(i) = scene.amplitude[at];
  }
  const Matrix scale = root_mass.cwiseInverse().asDiagonal();
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(scale * k_free * scale);
  const Matrix shape = scale * solver.eigenvectors();
  const Matrix inverse = solver.eigenvectors().transpose() * root_mass.asDiagonal();
  for (Eigen::Index i = 0; i < modes; ++i)
    motion.shape.row(free[static_cast<std::size_t>(i)]) = shape.row(i);
  for (Eigen::Index j = 0; j < modes; ++j) {
    const double lambda = solver.eigenvalues()(j), alpha = scene.beta * lambda / 2;
    if (!(alpha * alpha < lambda))
      throw std::invalid_argument("plain scheme: a mode is not underdamped");
    const double f = shape.col(j).dot(force), omega = scene.omega;
    const double detuning = lambda - omega * omega, loss = 2 * alpha * omega;
    const double modulus = detuning * detuning + loss * loss;
    motion.decay(j) = alpha;
    motion.frequency(j) = std::sqrt(lambda - alpha * alpha);
    motion.in_phase(j) = f * detuning / modulus;
    motion.quadrature(j) = f * loss / modulus;
  }
  const double c = std::cos(scene.omega * start), s = std::sin(scene.omega * start);
  motion.a = inverse * (x - motion.rest)(free)-motion.in_phase * c - motion.quadrature * s;
  motion.b = inverse * v(free) - scene.omega * (motion.quadrature * c - motion.in_phase * s);
  motion.b = (motion.b + motion.decay.cwiseProduct(motion.a)).cwiseQuotient(motion.frequency);
  return motion;
}

// The force that presses a mass at its stop into it (Eqs. 12-13 times the side of the stop).
inline double press(const Scene &scene, const Stop &stop, double t, const Vector &x,
                    const Vector &v) {
  const auto p = static_cast<std::size_t>(stop.mass - 1);
  double force = scene.amplitude.empty() ? 0.0 : scene.amplitude[p] * std::cos(scene.omega * t);
  for (std::size_t link : {p, p + 1}) {
    if (link == scene.mass.size()) continue;
    const auto other = static_cast<Eigen::Index>(link == p ? p - 1 : p + 1);  // -1: the ground
    const double to = other < 0 ? 0.0 : x(other), rate = other < 0 ? 0.0 : v(other);
    force += scene.stiffness[link] * (to - stop.position + scene.beta * rate);
  }
  return sign(stop.side) * force;
}

}  // namespace vibro_impact::plain
