#include "parameter_flow.hpp"

#include <algorithm>
#include <cmath>
#include <complex>

#include "tangent_flow.hpp"

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

// The term of order n + 2 with the forces `extra` of order n on the right-hand side.
template <class Extra>
Eigen::VectorXd forced_term(const Scene &scene, const Held &held, double h, int n,
                            const Eigen::VectorXd &before, const Eigen::VectorXd &last,
                            const Extra &extra) {
  Eigen::VectorXd term = next_term(scene, held, h, n, before, last);
  for (std::size_t i = 0; i < held.size(); ++i)
    if (held[i] == 0)
      term(static_cast<Index>(i)) += h * h * extra(i) / (scene.mass[i] * (n + 1.0) * (n + 2.0));
  return term;
}

// A Taylor series as it is summed: the last two terms, the value and the slope times the step.
struct Series {
  Eigen::VectorXd before, last, value, slope;

  Series(const Eigen::VectorXd &start, const Eigen::VectorXd &rate, double h)
      : before(start), last(h * rate), value(start + last), slope(last) {
  }
  void add(Eigen::VectorXd term, int order) {
    value += term;
    slope += order * term;
    before = std::move(last);
    last = std::move(term);
  }
};

// One step, of which rate * h is at most 1: the terms fall as 1 / n!.
void step(const Scene &scene, const std::vector<Parameter> &by, const Held &held, double phase,
          double h, PlainMotion &motion, Eigen::MatrixXd &changes) {
  constexpr int order = 20;
  const Index n = motion.displacement.size();
  Series x(motion.displacement, motion.velocity, h);
  std::vector<Series> moved;
  for (std::size_t k = 0; k < by.size(); ++k) {
    const auto column = changes.col(static_cast<Index>(k));
    moved.emplace_back(column.head(n), column.tail(n) - slip(scene, by[k]) * motion.velocity, h);
  }
  std::complex<double> forcing = std::polar(1.0, scene.omega * phase);
  for (int m = 0; m + 2 <= order; ++m) {
    const Eigen::VectorXd x_m = x.before, v_m = ((m + 1) / h) * x.last;
    x.add(forced_term(scene, held, h, m, x.before, x.last,
                      [&](std::size_t i) { return amplitude_on(scene, i) * forcing.real(); }),
          m + 2);
    const Eigen::VectorXd a_m = ((m + 1) * (m + 2) / (h * h)) * x.last;
    const Position at{x_m, v_m, a_m, forcing.real()};
    for (std::size_t k = 0; k < by.size(); ++k)
      moved[k].add(forced_term(scene, held, h, m, moved[k].before, moved[k].last,
                               [&](std::size_t i) { return force_by(scene, by[k], i, at); }),
                   m + 2);
    forcing *= std::complex<double>(0.0, scene.omega * h / (m + 1));
  }
  motion = {x.value, x.slope / h};
  for (std::size_t k = 0; k < by.size(); ++k)
    changes.col(static_cast<Index>(k)) << moved[k].value,
        moved[k].slope / h + slip(scene, by[k]) * motion.velocity;
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

bool is_of_stop(const Scene &scene, const Parameter &parameter, Kind kind, std::size_t stop) {
  const auto &[what, index] = parameter;
  const bool of_all = kind == Kind::restitution && index == 0 && !scene.stops[stop].restitution;
  return what == kind && (of_all || index == static_cast<int>(stop) + 1);
}

void carry(const Scene &scene, const std::vector<Parameter> &by, const Held &held, double phase,
           double tau, PlainMotion &motion, Eigen::MatrixXd &changes) {
  if (!(tau > 0.0)) return;
  const double steps = std::max(1.0, std::ceil(rate_of(scene) * tau));
  for (double k = 0.0; k < steps; ++k)
    step(scene, by, held, phase + tau * (k / steps), tau / steps, motion, changes);
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
