// A contact mode: which masses are held at which stop, and the modal solution of the masses that
// are free (Eqs. 6-7 restricted to the free rows).
//
// Because C stays proportional to K on every sub-block, each of the contact modes has its own exact
// modal decomposition. It is built when a run first enters the mode (see `Modes`).
#pragma once

#include <Eigen/Core>
#include <Eigen/Eigenvalues>
#include <limits>
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

// A held mass: the force that presses it into its stop (Eqs. 12-13, sigma F_p >= 0 while it
// sticks).
template <int D>
struct ClosedStop {
  std::size_t stop = 0, mass = 0;
  Reading<D> press;
};

template <int D>
struct ContactMode {
  using Lanes = Eigen::Array<double, D, 1>;
  Held held;
  Lanes kappa, lambda;   // y'' + kappa y' + lambda y = 0 per lane
  Lanes rate;            // largest modulus of a characteristic root of each lane
  double fastest = 0.0;  // the largest of them
  bool stiff = false;    // some lanes are much faster than others
  // x = equilibrium + shape y, N x lanes; rows of held masses are zero. The last two columns are
  // the steady response to cos(Omega t) and sin(Omega t) where there is forcing.
  Eigen::VectorXd equilibrium;  // static position of every mass, N
  Eigen::MatrixXd shape;
  Eigen::MatrixXd to_modal;           // y per displacement (and y' per velocity), lanes x N
  Eigen::MatrixXd velocity_to_modal;  // y per velocity: of the lanes of split modes only
  // A strongly over-damped mode is split into its two decays, one lane each (lambda = 0, y' =
  // -kappa y), so that the fast one can be dropped once it has died out.
  Eigen::Array<bool, D, 1> decay;
  bool any_decay = false;
  Lanes resonant;  // forcing of the lanes too close to resonance for a steady response
  bool any_resonant = false;
  Eigen::Index forcing_lanes = 0;  // 2 at the end, cos(Omega t) and sin(Omega t), or none
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

// Modes of the free masses: M^-1/2 K M^-1/2 on the free rows is tridiagonal; links to held masses
// only stiffen it. `shape` is N x modes (zero rows for held masses), `inverse` its left inverse.
struct Decomposition {
  Eigen::VectorXd lambda;
  Eigen::MatrixXd shape, inverse;
};

inline Decomposition decompose(const Scene &scene, const std::vector<std::size_t> &free) {
  using Eigen::Index;
  const std::size_t n = scene.mass.size();
  const auto modes = static_cast<Index>(free.size());
  Decomposition basis;
  basis.lambda.setZero(modes);
  basis.shape.setZero(static_cast<Index>(n), modes);
  basis.inverse.setZero(modes, static_cast<Index>(n));
  if (modes == 0) return basis;
  Eigen::VectorXd diagonal(modes), off(modes - 1);
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
  basis.lambda = solver.eigenvalues();
  for (Index j = 0; j < modes; ++j) {
    const double orient = solver.eigenvectors()(modes - 1, j) < 0.0 ? -1.0 : 1.0;
    for (Index a = 0; a < modes; ++a) {
      const auto i = free[static_cast<std::size_t>(a)];
      const double u = orient * solver.eigenvectors()(a, j), root_m = std::sqrt(scene.mass[i]);
      basis.shape(static_cast<Index>(i), j) = u / root_m;
      basis.inverse(j, static_cast<Index>(i)) = u * root_m;
    }
    // The eigenvalue again as twice the energy in the links. The solver leaves it an error relative
    // to the largest one, which a soft mode beside a stiff link does not survive.
    double energy = 0.0;
    for (std::size_t i = 0; i < n; ++i) {
      const auto row = static_cast<Index>(i);
      const double stretch = basis.shape(row, j) - (i > 0 ? basis.shape(row - 1, j) : 0.0);
      energy += scene.stiffness[i] * stretch * stretch;
    }
    basis.lambda(j) = energy;
  }
  return basis;
}

// Damping ratio above 1.5 (Eq. 7: zeta = beta sqrt(lambda) / 2): the two decays are well apart.
inline bool strongly_damped(double beta, double lambda) {
  return beta * beta * lambda > 9.0;
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

  const auto modes = static_cast<Index>(free.size());
  const Index forcing = scene.forced() ? 2 : 0;
  const detail::Decomposition basis = detail::decompose(scene, free);
  Index split = 0;
  for (Index j = 0; j < modes; ++j)
    if (detail::strongly_damped(scene.beta, basis.lambda(j))) ++split;
  const Index lanes = D == Eigen::Dynamic ? modes + split + forcing : Index(D);

  ContactMode<D> mode;
  mode.held = held;
  mode.forcing_lanes = forcing;
  for (auto *array : {&mode.kappa, &mode.lambda, &mode.rate, &mode.resonant}) array->setZero(lanes);
  mode.decay.setConstant(lanes, false);
  mode.equilibrium = detail::static_positions(scene, held, held_at);
  mode.shape.setZero(static_cast<Index>(n), lanes);
  mode.to_modal.setZero(lanes, static_cast<Index>(n));
  mode.velocity_to_modal.setZero(lanes, static_cast<Index>(n));

  const double omega2 = scene.omega * scene.omega;
  for (Index j = 0, lane = 0; j < modes; ++j, ++lane) {
    const double lambda = basis.lambda(j), kappa = scene.beta * lambda;
    mode.shape.col(lane) = basis.shape.col(j);
    mode.to_modal.row(lane) = basis.inverse.row(j);
    mode.kappa(lane) = kappa;
    mode.lambda(lane) = lambda;
    if (forcing) {
      double force = 0.0;  // Psi^T A of Eq. 7
      for (std::size_t i : free)
        force += basis.shape(static_cast<Index>(i), j) * scene.amplitude[i];
      const double detuning = lambda - omega2, loss = kappa * scene.omega;
      const double squared = detuning * detuning + loss * loss;
      if (std::sqrt(squared) < 0.015625 * (lambda + omega2)) {
        mode.resonant(lane) = force;  // splitting off the steady response would cancel digits
        mode.any_resonant = mode.any_resonant || force != 0.0;
      } else {
        mode.shape.col(lanes - 2) += basis.shape.col(j) * (force * (detuning / squared));
        mode.shape.col(lanes - 1) += basis.shape.col(j) * (force * (loss / squared));
      }
    }
    if (D == Eigen::Dynamic && detail::strongly_damped(scene.beta, lambda)) {
      // y = y1 + y2 with decays fast > slow: y1 = (fast y + y') / (fast - slow), y2 = y - y1.
      const double fast = kappa / 2 + std::sqrt(kappa * kappa / 4 - lambda), slow = lambda / fast;
      const Index other = lane + 1;
      mode.shape.col(other) = basis.shape.col(j);
      mode.to_modal.row(lane) = basis.inverse.row(j) * (fast / (fast - slow));
      mode.velocity_to_modal.row(lane) = basis.inverse.row(j) / (fast - slow);
      mode.to_modal.row(other) = basis.inverse.row(j) * (-slow / (fast - slow));
      mode.velocity_to_modal.row(other) = -mode.velocity_to_modal.row(lane);
      mode.kappa(lane) = slow;
      mode.kappa(other) = fast;
      mode.lambda(lane) = mode.lambda(other) = 0.0;
      mode.decay(lane) = mode.decay(other) = mode.any_decay = true;
      lane = other;
    }
  }
  if (forcing) mode.lambda(lanes - 2) = mode.lambda(lanes - 1) = omega2;
  double slowest = std::numeric_limits<double>::infinity();
  for (Index j = 0; j < lanes; ++j) {
    mode.rate(j) = detail::root_modulus(mode.kappa(j), mode.lambda(j));
    mode.fastest = std::max(mode.fastest, mode.rate(j));
    if (mode.rate(j) > 0.0) slowest = std::min(slowest, mode.rate(j));
  }
  mode.stiff = scene.beta > 0.0 && mode.fastest > 16.0 * slowest;

  for (std::size_t k = 0; k < scene.stops.size(); ++k) {
    const Stop &stop = scene.stops[k];
    const auto i = static_cast<std::size_t>(stop.mass - 1);
    const double sigma = sign(stop.side);
    if (held[i] == 0) {
      const auto row = static_cast<Index>(i);
      Reading<D> gap{-sigma * mode.shape.row(row).transpose().array(),
                     {},
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
