#include "change_flow.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <utility>

namespace vibro_impact {

namespace {

using Eigen::Index;
using Kind = Parameter::Kind;

// The coordinate j (from 0) that link_force asks for.
template <class Vector>
auto of(const Vector &values) {
  return [&values](std::size_t j) { return values(static_cast<Index>(j)); };
}

// The motion as far as the forces depend on it.
struct Position {
  const Eigen::VectorXd &displacement, &velocity, &acceleration;
  double forcing;  // cos(Omega t)
};

// The inhomogeneous term: the force on mass i by one parameter, at given displacements, velocities
// and phase. Omega, at a fixed phase, is a change of the unit of time: with x as a function of
// Omega t, Omega^2 M x'' + beta Omega K x' + K x = A cos(Omega t), so that
// -(2 M x'' + beta K x') / Omega remains.
double force_by(const Scene &scene, const Parameter &by, std::size_t i, const Position &at) {
  const auto row = static_cast<Index>(i);
  const auto damping = [&] { return link_force(scene, i, at.velocity(row), of(at.velocity)); };
  const std::size_t k = by.index > 0 ? static_cast<std::size_t>(by.index - 1) : 0;
  switch (by.kind) {
    case Kind::omega:
      return (scene.beta * damping() - 2.0 * scene.mass[i] * at.acceleration(row)) / scene.omega;
    case Kind::beta:
      return damping();
    case Kind::amplitude:
      return i == k ? at.forcing : 0.0;
    case Kind::mass:
      return i == k ? -at.acceleration(row) : 0.0;
    case Kind::stiffness: {
      if (i != k && i + 1 != k) return 0.0;
      const auto stretch = [&](const Eigen::VectorXd &x) {
        return (k > 0 ? x(static_cast<Index>(k - 1)) : 0.0) - x(static_cast<Index>(k));
      };
      const double pull = stretch(at.displacement) + scene.beta * stretch(at.velocity);
      return i == k ? pull : -pull;
    }
    default:
      return 0.0;  // restitution and stops act at events and through what is held
  }
}

// The changes of x by omega, at a fixed phase, move with x' + x' / omega.
double slip(const Scene &scene, const Parameter &by) {
  return by.kind == Kind::omega ? 1.0 / scene.omega : 0.0;
}

// The Taylor terms of order n + 2 of motions or changes of them (columns), in units of tau^(n+2),
// from those of orders n and n + 1 (Eq. 4, but for its right-hand side):
//   x_(n+2) = -M^-1 K (tau^2 x_n + (n+1) tau beta x_(n+1)) / ((n+1) (n+2)).
Eigen::MatrixXd next_term(const Scene &scene, const Held &held, double tau, int n,
                          const Eigen::MatrixXd &before, const Eigen::MatrixXd &last) {
  const Eigen::MatrixXd pulling = tau * tau * before + (tau * scene.beta * (n + 1)) * last;
  Eigen::MatrixXd term = Eigen::MatrixXd::Zero(before.rows(), before.cols());
  for (Index column = 0; column < term.cols(); ++column) {
    const auto pull = [&](std::size_t j) { return pulling(static_cast<Index>(j), column); };
    for (std::size_t i = 0; i < held.size(); ++i)
      if (held[i] == 0)
        term(static_cast<Index>(i), column) =
            link_force(scene, i, pull(i), pull) / (scene.mass[i] * (n + 1.0) * (n + 2.0));
  }
  return term;
}

// The order at which Taylor terms lie below rounding, those of order n being at most reach^n / n!:
// below the rounding not of the sum but of the first curved ones, of order 2 or, where these are
// zero, 3. Late in a chatter the change of the chattering mass is small beside those of the others,
// and made of these.
int order_for(double reach) {
  constexpr int highest = 20;  // enough for a reach of 1
  int order = 3;
  for (double size = 1.0; order < highest && size > lost; ++order) size *= reach / (order + 1);
  return order;
}

// One step, in physical coordinates: the motion is the first column, its changes the others.
void step(const Scene &scene, const std::vector<Parameter> &by, const Held &held, double phase,
          double h, int order, PlainMotion &motion, Eigen::MatrixXd &changes) {
  const Index n = motion.displacement.size(),
              first = 1 + changes.cols() - static_cast<Index>(by.size());
  const auto column = [first](std::size_t k) { return first + static_cast<Index>(k); };
  Eigen::MatrixXd before(n, 1 + changes.cols()), last = before;
  before << motion.displacement, changes.topRows(n);
  last << motion.velocity, changes.bottomRows(n);
  for (std::size_t k = 0; k < by.size(); ++k)
    last.col(column(k)) -= slip(scene, by[k]) * motion.velocity;
  last *= h;
  Eigen::MatrixXd value = before + last, slope = last;  // slope: in units of 1 / h
  std::complex<double> forcing = std::polar(1.0, scene.omega * phase);
  for (int m = 0; m + 2 <= order; ++m) {
    const double scale = (m + 1.0) * (m + 2.0) / (h * h);  // of accelerations
    Eigen::MatrixXd term = next_term(scene, held, h, m, before, last);
    const auto push = [&](Index at, const auto &force) {
      for (std::size_t i = 0; i < held.size(); ++i)
        if (held[i] == 0) term(static_cast<Index>(i), at) += force(i) / (scene.mass[i] * scale);
    };
    push(0, [&](std::size_t i) { return amplitude_on(scene, i) * forcing.real(); });
    if (!by.empty()) {
      const Eigen::VectorXd x_m = before.col(0), v_m = ((m + 1) / h) * last.col(0),
                            a_m = scale * term.col(0);
      const Position at{x_m, v_m, a_m, forcing.real()};
      for (std::size_t k = 0; k < by.size(); ++k)
        push(column(k), [&](std::size_t i) { return force_by(scene, by[k], i, at); });
    }
    value += term;
    slope += (m + 2) * term;
    before = std::move(last);
    last = std::move(term);
    forcing *= std::complex<double>(0.0, scene.omega * h / (m + 1));
  }
  motion = {value.col(0), slope.col(0) / h};
  changes << value.rightCols(changes.cols()), slope.rightCols(changes.cols()) / h;
  for (std::size_t k = 0; k < by.size(); ++k)
    changes.col(column(k) - 1).tail(n) += slip(scene, by[k]) * motion.velocity;
}

}  // namespace

void require_differentiable(const Scene &scene, const std::vector<Parameter> &by) {
  for (const Parameter &parameter : by) {
    get(scene, parameter);
    require(parameter.kind != Kind::displacement && parameter.kind != Kind::velocity,
            name(parameter), ": a change of the start, not of the scene");
    require(parameter.kind != Kind::omega || scene.omega > 0.0, "omega = ", scene.omega,
            ": changes at a fixed phase need a forcing period");
  }
}

Eigen::RowVectorXd columns_of(const Scene &scene, const std::vector<Parameter> &by, Kind kind,
                              std::size_t index, Index columns) {
  const bool of_all = kind == Kind::restitution && !scene.stops[index - 1].restitution;
  Eigen::RowVectorXd ones = Eigen::RowVectorXd::Zero(columns);
  for (Index k = columns - static_cast<Index>(by.size()); const auto &[what, number] : by) {
    const bool own = number == static_cast<int>(index);
    ones(k++) = what == kind && (own || (of_all && number == 0)) ? 1.0 : 0.0;
  }
  return ones;
}

void carry(const Scene &scene, const std::vector<Parameter> &by, const Held &held, double phase,
           double tau, PlainMotion &motion, Eigen::MatrixXd &changes) {
  if (!(tau > 0.0)) return;
  const double reach = rate_of(scene) * tau, steps = std::max(1.0, std::ceil(reach));
  const int order = order_for(reach / steps);
  for (double k = 0.0; k < steps; ++k)
    step(scene, by, held, phase + tau * (k / steps), tau / steps, order, motion, changes);
}

// Mode by mode, by the response to a unit change of value and of slope.
void carry_by_modes(const ContactMode<Eigen::Dynamic> &mode, double tau, Eigen::MatrixXd &changes) {
  const Eigen::Index n = changes.rows() / 2;
  const Eigen::MatrixXd x = changes.topRows(n), v = changes.bottomRows(n);
  const Eigen::MatrixXd value = mode.to_modal * x + mode.velocity_to_modal * v,
                        slope = mode.to_modal * v;
  Eigen::ArrayXd value_by_value = Eigen::ArrayXd::Ones(mode.lanes()),
                 slope_by_value = 0.0 * value_by_value, value_by_slope = slope_by_value,
                 slope_by_slope = value_by_value;
  flow(mode, value_by_value, slope_by_value, tau);
  flow(mode, value_by_slope, slope_by_slope, tau);
  changes << mode.shape * (value_by_value.matrix().asDiagonal() * value +
                           value_by_slope.matrix().asDiagonal() * slope),
      mode.shape * (slope_by_value.matrix().asDiagonal() * value +
                    slope_by_slope.matrix().asDiagonal() * slope);
}

Eigen::RowVectorXd force_change(const Scene &scene, const std::vector<Parameter> &by, std::size_t p,
                                double phase, const PlainMotion &motion,
                                const Eigen::MatrixXd &changes) {
  const Index n = motion.displacement.size(), row = static_cast<Index>(p);
  const Eigen::VectorXd at_rest = Eigen::VectorXd::Zero(n);
  const Position at{motion.displacement, motion.velocity, at_rest, std::cos(scene.omega * phase)};
  Eigen::RowVectorXd change(changes.cols());
  for (Index k = 0; k < changes.cols(); ++k) {
    const Eigen::VectorXd x = changes.col(k).head(n), v = changes.col(k).tail(n);
    change(k) =
        link_force(scene, p, x(row), of(x)) + scene.beta * link_force(scene, p, v(row), of(v));
    const Index parameter = k - (changes.cols() - static_cast<Index>(by.size()));
    if (parameter < 0) continue;
    // The velocities are those in time: at a fixed state the force does not depend on omega.
    const Parameter &named = by[static_cast<std::size_t>(parameter)];
    if (named.kind != Kind::omega) change(k) += force_by(scene, named, p, at);
  }
  return change;
}

}  // namespace vibro_impact
