// A contact mode: which masses are held at which stop, and the modal solution of the masses that
// are free (Eqs. 6-7 restricted to the free rows).
//
// Because C stays proportional to K on every sub-block, each of the contact modes has its own exact
// modal decomposition. It is built when a run first enters the mode (see `Modes`).
#pragma once

#include <Eigen/Core>
#include <Eigen/Eigenvalues>
#include <map>
#include <vector>

#include "counters.hpp"
#include "scene.hpp"

namespace vibro_impact {

// Per mass: 0 free, +1 held at its upper stop, -1 held at its lower stop.
using Held = std::vector<signed char>;

// A scalar that depends linearly on the lanes: offset + on_value . y + on_slope . y'.
template <int D>
struct Reading {
  Eigen::Array<double, D, 1> on_value, on_slope;
  double offset = 0.0;

  double operator()(const Eigen::Array<double, D, 1> &value,
                    const Eigen::Array<double, D, 1> &slope) const {
    return offset + (on_value * value).sum() + (on_slope * slope).sum();
  }
};

// A stop of a free mass: its gap sigma (s - x) >= 0, and the force that would press the mass into
// the stop if it were at rest there.
template <int D>
struct OpenStop {
  std::size_t stop = 0, mass = 0;  // indices from 0
  Reading<D> gap, press;
};

// A held mass: the force that presses it into its stop (Eqs. 12-13, sigma F_p >= 0 while it sticks).
template <int D>
struct ClosedStop {
  std::size_t stop = 0, mass = 0;
  Reading<D> press;
};

template <int D>
struct ContactMode {
  using Lanes = Eigen::Array<double, D, 1>;
  Held held;
  Lanes kappa, lambda;           // y'' + kappa y' + lambda y = 0 per lane
  double fastest = 0.0;          // largest modulus of a characteristic root over the lanes
  Eigen::VectorXd equilibrium;   // static position of every mass, N
  Eigen::MatrixXd shape;         // x = equilibrium + shape y, N x lanes; rows of held masses zero
  Eigen::MatrixXd to_modal;      // y = to_modal (x - equilibrium) - steady, lanes x N
  Lanes steady_cos, steady_sin;  // steady response of each lane to cos(Omega t)
  Lanes resonant;                // forcing of the lanes too close to resonance to be split off
  bool any_resonant = false;
  std::vector<OpenStop<D>> open;
  std::vector<ClosedStop<D>> closed;

  Eigen::Index lanes() const {
    return kappa.size();
  }
};

namespace detail {

// Static positions with the held masses at their stops: linear in the compliance between two
// anchors. Written so that two equal anchors give exactly their common position, which makes a
// zero hold force (Figure 5(c): s1 = s2) exactly zero.
inline Eigen::VectorXd static_positions(const Scene &scene, const Held &held,
                                        const std::vector<double> &held_at) {
  const std::size_t n = scene.mass.size();
  Eigen::VectorXd x(static_cast<Eigen::Index>(n));
  double left = 0.0;
  for (std::size_t i = 0; i < n;) {
    std::size_t anchor = i;
    while (anchor < n && held[anchor] == 0) ++anchor;
    const double right = anchor < n ? held_at[anchor] : left;
    double total = 0.0, reached = 0.0;
    for (std::size_t j = i; j <= anchor && j < n; ++j) total += 1.0 / scene.stiffness[j];
    for (std::size_t j = i; j < anchor; ++j) {
      reached += 1.0 / scene.stiffness[j];
      x(static_cast<Eigen::Index>(j)) = left + (right - left) * (reached / total);
    }
    if (anchor < n) x(static_cast<Eigen::Index>(anchor)) = right;
    left = right;
    i = anchor + 1;
  }
  return x;
}

// Largest modulus of a root of z^2 + kappa z + lambda.
inline double root_modulus(double kappa, double lambda) {
  const double alpha = kappa / 2, discriminant = alpha * alpha - lambda;
  return discriminant > 0 ? alpha + std::sqrt(discriminant) : std::sqrt(lambda);
}

}  // namespace detail

// The force on mass p towards +x from its neighbours and the forcing, with the mass itself at rest
// at its stop (Eqs. 12-13), times sigma: positive when it presses into the stop. Lanes of `mode`.
template <int D>
Reading<D> press_reading(const Scene &scene, const ContactMode<D> &mode, const Stop &stop) {
  const auto p = static_cast<Eigen::Index>(stop.mass - 1);
  const Eigen::Index n = mode.equilibrium.size();
  const double sigma = sign(stop.side), k_left = scene.stiffness[static_cast<std::size_t>(p)];
  Reading<D> reading;
  reading.on_value.setZero(mode.lanes());
  reading.on_slope.setZero(mode.lanes());
  const auto add_neighbour = [&](Eigen::Index j, double k) {
    reading.offset += sigma * k * (mode.equilibrium(j) - stop.position);
    reading.on_value += sigma * k * mode.shape.row(j).transpose().array();
    reading.on_slope += sigma * scene.beta * k * mode.shape.row(j).transpose().array();
  };
  if (p > 0) add_neighbour(p - 1, k_left);
  if (p == 0) reading.offset -= sigma * k_left * stop.position;
  if (p + 1 < n) add_neighbour(p + 1, scene.stiffness[static_cast<std::size_t>(p + 1)]);
  if (scene.forced())
    reading.on_value(mode.lanes() - 2) += sigma * scene.amplitude[static_cast<std::size_t>(p)];
  return reading;
}

// Decomposes the contact mode `held`. D is the number of lanes, or Eigen::Dynamic.
template <int D>
ContactMode<D> build_contact_mode(const Scene &scene, const Held &held) {
  using Eigen::Index;
  const std::size_t n = scene.mass.size();
  std::vector<std::size_t> free;
  std::vector<double> held_at(n, 0.0);
  for (std::size_t i = 0; i < n; ++i)
    if (held[i] == 0) free.push_back(i);
  for (const Stop &stop : scene.stops) {
    const auto i = static_cast<std::size_t>(stop.mass - 1);
    if (static_cast<double>(held[i]) == sign(stop.side)) held_at[i] = stop.position;
  }

  ContactMode<D> mode;
  const auto modes = static_cast<Index>(free.size());
  const Index forcing = scene.forced() ? 2 : 0;
  const Index lanes = D == Eigen::Dynamic ? modes + forcing : Index(D);
  mode.held = held;
  for (auto *array : {&mode.kappa, &mode.lambda, &mode.steady_cos, &mode.steady_sin, &mode.resonant})
    array->setZero(lanes);
  mode.equilibrium = detail::static_positions(scene, held, held_at);
  mode.shape.setZero(static_cast<Index>(n), lanes);
  mode.to_modal.setZero(lanes, static_cast<Index>(n));

  if (modes > 0) {
    // M^-1/2 K M^-1/2 on the free rows is tridiagonal; links to held masses only stiffen it.
    Eigen::VectorXd diagonal(modes), off(modes > 1 ? modes - 1 : 0);
    for (Index a = 0; a < modes; ++a) {
      const std::size_t i = free[static_cast<std::size_t>(a)];
      const double k_right = i + 1 < n ? scene.stiffness[i + 1] : 0.0;
      diagonal(a) = (scene.stiffness[i] + k_right) / scene.mass[i];
      if (a + 1 < modes)
        off(a) = free[static_cast<std::size_t>(a) + 1] == i + 1
                     ? -k_right / std::sqrt(scene.mass[i] * scene.mass[i + 1])
                     : 0.0;
    }
    Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver;
    solver.computeFromTridiagonal(diagonal, off);
    for (Index j = 0; j < modes; ++j) {
      const double orient = solver.eigenvectors()(modes - 1, j) < 0.0 ? -1.0 : 1.0;
      mode.lambda(j) = solver.eigenvalues()(j);
      mode.kappa(j) = scene.beta * mode.lambda(j);
      for (Index a = 0; a < modes; ++a) {
        const auto i = free[static_cast<std::size_t>(a)];
        const double u = orient * solver.eigenvectors()(a, j), root_m = std::sqrt(scene.mass[i]);
        mode.shape(static_cast<Index>(i), j) = u / root_m;
        mode.to_modal(j, static_cast<Index>(i)) = u * root_m;
      }
    }
  }

  if (forcing) {
    const double omega2 = scene.omega * scene.omega;
    for (Index j = 0; j < modes; ++j) {
      double force = 0.0;  // Psi^T A of Eq. 7
      for (std::size_t i : free)
        force += mode.shape(static_cast<Index>(i), j) * scene.amplitude[i];
      const double detuning = mode.lambda(j) - omega2, loss = mode.kappa(j) * scene.omega;
      const double squared = detuning * detuning + loss * loss;
      if (std::sqrt(squared) < 0.015625 * (mode.lambda(j) + omega2)) {
        mode.resonant(j) = force;  // splitting off the steady response would cancel digits
        mode.any_resonant = mode.any_resonant || force != 0.0;
      } else {
        mode.steady_cos(j) = force * detuning / squared;
        mode.steady_sin(j) = force * loss / squared;
      }
    }
    mode.lambda(lanes - 2) = mode.lambda(lanes - 1) = omega2;
    mode.shape.col(lanes - 2) = mode.shape.leftCols(modes) * mode.steady_cos.head(modes).matrix();
    mode.shape.col(lanes - 1) = mode.shape.leftCols(modes) * mode.steady_sin.head(modes).matrix();
  }
  for (Index j = 0; j < lanes; ++j)
    mode.fastest =
        std::max(mode.fastest, detail::root_modulus(mode.kappa(j), mode.lambda(j)));

  for (std::size_t k = 0; k < scene.stops.size(); ++k) {
    const Stop &stop = scene.stops[k];
    const auto i = static_cast<std::size_t>(stop.mass - 1);
    const double sigma = sign(stop.side);
    if (held[i] == 0) {
      const auto row = static_cast<Index>(i);
      Reading<D> gap{-sigma * mode.shape.row(row).transpose().array(), {},
                     sigma * (stop.position - mode.equilibrium(row))};
      gap.on_slope.setZero(lanes);
      mode.open.push_back({k, i, gap, press_reading(scene, mode, stop)});
    } else if (static_cast<double>(held[i]) == sigma) {
      mode.closed.push_back({k, i, press_reading(scene, mode, stop)});
    }
  }
  return mode;
}

// The contact modes of one scene, each built on first entry. Addresses stay valid.
template <int D>
struct Modes {
  std::map<Held, ContactMode<D>> built;

  const ContactMode<D> &enter(const Scene &scene, const Held &held, Counters &counters) {
    auto found = built.find(held);
    if (found == built.end()) {
      found = built.emplace(held, build_contact_mode<D>(scene, held)).first;
      ++counters.modes_built;
      counters.forcing_lanes = scene.forced() ? 2 : 0;
    }
    return found->second;
  }
};

}  // namespace vibro_impact
