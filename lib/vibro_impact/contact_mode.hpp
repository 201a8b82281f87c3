// A contact mode: which masses are held at which stop, and the modal solution of the masses that
// are free (Eqs. 6-7 restricted to the free rows).
//
// Because C stays proportional to K on every sub-block, each of the contact modes has its own exact
// modal decomposition. It is built when a run first enters the mode (see `Modes`).
#pragma once

#include <Eigen/Core>
#include <boost/container/small_vector.hpp>
#include <cmath>
#include <map>
#include <vector>

#include "counters.hpp"
#include "scene.hpp"

namespace vibro_impact {

// Largest fastest * span of one expansion. Rounding grows like exp(reach), cost like 1 / reach.
constexpr double max_reach = 2.5;

constexpr std::size_t bernstein_degree = 11;

// Per mass: 0 free, +1 held at its upper stop, -1 held at its lower stop. Short ones need no heap:
// every event carries one.
using Held = boost::container::small_vector<signed char, 16>;

// Taylor coefficients of a reading, per unit of every lane: those of order n, in units of rate^-n.
// Orders come in groups of four; per group one column for every y, then for every y' of a mode (y'
// of the forcing lanes is known from their values).
struct ReadingSeries {
  double rate = -1.0;  // of the fastest lane that may be in motion; -1 before it is built
  Eigen::Array<double, 4, Eigen::Dynamic> weight;
  // Bernstein coefficients of the terms up to `bernstein_degree` over the longest span, likewise,
  // and per column what the other terms come to at most.
  Eigen::Array<double, 4, Eigen::Dynamic> bernstein;
  Eigen::Array<double, Eigen::Dynamic, 1> cut_off;
};

// A scalar that depends linearly on the lanes: offset + on_value . y + on_slope . y'.
template <int D>
struct Reading {
  Eigen::Array<double, D, 1> on_value, on_slope;
  double offset = 0.0;
  mutable ReadingSeries series;  // built when the reading is first followed along a flight

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

// Taylor coefficients of the solution S of every mode with S(0) = 0, S'(0) = 1, and of S', in terms
// of rate * time: column n is of order n, with the rows filled up to an even number.
template <int D>
struct FlowSeries {
  static constexpr int rows = D == Eigen::Dynamic ? Eigen::Dynamic : (D - 1) / 2 * 2;
  double rate = -1.0;
  Eigen::Array<double, rows, Eigen::Dynamic> response, rate_of_response;
};

template <int D>
struct ContactMode {
  static constexpr int masses = D == Eigen::Dynamic ? Eigen::Dynamic : D - 2;
  using Lanes = Eigen::Array<double, D, 1>;
  Held held;
  Lanes kappa, lambda;   // y'' + kappa y' + lambda y = 0 per lane
  Lanes rate;            // largest modulus of a characteristic root of each lane
  Lanes extent;          // largest modulus in each column of `shape`
  double fastest = 0.0;  // the largest of them
  bool stiff = false;    // some lanes are much faster than others
  // x = equilibrium + shape y, N x lanes; rows of held masses are zero. The last two columns are
  // the steady response to cos(Omega t) and sin(Omega t) where there is forcing.
  Eigen::Matrix<double, masses, 1> equilibrium;  // static position of every mass, N
  Eigen::Matrix<double, masses, D> shape;
  Eigen::Matrix<double, D, masses> to_modal;           // y per displacement (and y' per velocity)
  Eigen::Matrix<double, D, masses> velocity_to_modal;  // y per velocity: of split modes only
  // A strongly over-damped mode is split into its two decays, one lane each (lambda = 0, y' =
  // -kappa y), so that the fast one can be dropped once it has died out.
  Eigen::Array<bool, D, 1> decay;
  bool any_decay = false;
  Lanes resonant;  // forcing of the lanes too close to resonance for a steady response
  bool any_resonant = false;
  Eigen::Index forcing_lanes = 0;  // 2 at the end, cos(Omega t) and sin(Omega t), or none
  std::vector<OpenStop<D>> open;
  std::vector<ClosedStop<D>> closed;
  mutable FlowSeries<D> series;  // built with the first flight

  Eigen::Index lanes() const {
    return kappa.size();
  }
  // The lanes that are not of the forcing.
  Eigen::Index modal_lanes() const {
    return D == Eigen::Dynamic ? lanes() - forcing_lanes : D - 2;
  }
};

// Largest modulus of a root of z^2 + kappa z + lambda.
inline double root_modulus(double kappa, double lambda) {
  const double alpha = kappa / 2, discriminant = alpha * alpha - lambda;
  return discriminant > 0 ? alpha + std::sqrt(discriminant) : std::sqrt(lambda);
}

// Damping ratio above 1.5 (Eq. 7: zeta = beta sqrt(lambda) / 2): the two decays are well apart.
inline bool strongly_damped(double beta, double lambda) {
  return beta * beta * lambda > 9.0;
}

// Decomposes the contact mode `held`. D is the number of lanes, N + 2 for N masses under forcing,
// or Eigen::Dynamic; compiled for N = 1, 2, 3 and Eigen::Dynamic.
template <int D>
ContactMode<D> build_contact_mode(const Scene &scene, const Held &held);

// Builds the series of a reading, or of the flow, for motion in which no lane faster than `rate`
// takes part: those are at rest for good, and have coefficients zero.
template <int D>
void build_series(const ContactMode<D> &mode, const Reading<D> &reading, double rate);
template <int D>
void build_flow_series(const ContactMode<D> &mode, double rate);

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
