// A contact mode: which masses are held at which stop, and the modal solution of the masses that
// are free (Eqs. 6-7 restricted to the free rows), as independent lanes y'' + kappa y' + lambda y =
// 0: one per free mode (its deviation from the steady response), two for the forcing itself.
#pragma once

#include <Eigen/Core>
#include <map>
#include <vector>

#include "vibro_impact/counters.hpp"
#include "vibro_impact/scene.hpp"

namespace vibro_impact {

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

// Taylor coefficients of a reading, per unit of every lane: those of order n, in units of rate^-n.
// Orders come in packets of four; per packet one column for every y, then for every y' of a mode
// (y' of the forcing lanes is known from their values).
struct ReadingWeights {
  double rate = -1.0;  // of the fastest lane that may be in motion; -1 before they are built
  Eigen::Array<double, 4, Eigen::Dynamic> weight;
};

// Taylor coefficients of the solution S of every mode with S(0) = 0, S'(0) = 1, and of S' - 1, in
// terms of rate * time: column n is of order n, with the rows filled up to an even number.
template <int D>
struct FlowWeights {
  static constexpr int rows = D == Eigen::Dynamic ? Eigen::Dynamic : (D - 1) / 2 * 2;
  double rate = -1.0;
  Eigen::Array<double, rows, Eigen::Dynamic> response, rate_of_response;
};

// A stop that a mass of this contact mode may come to or is held at, with what stays positive until
// something happens there: the gap sigma (s - x) of a free mass, the pressing force of a held one.
template <int D>
struct Contact {
  std::size_t stop = 0, mass = 0;  // indices from 0
  double sigma = 1.0;              // the sign of its side
  bool held = false;
  Reading<D> watched;
  // Force that would press a free mass into the stop if it were at rest there.
  Reading<D> press;
  // Bound of the rate of what is watched, per unit bound of the speed of every lane; and what a
  // unit jump of the gap speed does to the lanes.
  Eigen::Array<double, D, 1> reach, jump_value, jump_slope;
  double restitution = 0.0;  // r at rest
  // Of what it watches: built when first asked for, and again when lanes that moved have died out
  // or others have come to move.
  mutable ReadingWeights weights = {};
};

template <int D>
struct ContactMode {
  static constexpr int masses = D == Eigen::Dynamic ? Eigen::Dynamic : D - 2;
  using Lanes = Eigen::Array<double, D, 1>;
  Held held;
  Lanes kappa, lambda;
  Lanes rate;            // largest modulus of a characteristic root of each lane
  Lanes extent;          // largest modulus in each column of `shape`
  double fastest = 0.0;  // the largest rate
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
  // Forcing of the lanes too close to resonance for a steady response, and of the rigid-body mode
  // of a free chain, which has none.
  Lanes resonant;
  bool any_resonant = false;
  Eigen::Index forcing_lanes = 0;  // 2 at the end, cos(Omega t) and sin(Omega t), or none
  std::vector<Contact<D>> contacts;
  mutable FlowWeights<D> flow_weights = {};  // built as those of the contacts

  Eigen::Index lanes() const {
    return kappa.size();
  }
  // The lanes that are not of the forcing.
  Eigen::Index modal_lanes() const {
    return D == Eigen::Dynamic ? lanes() - forcing_lanes : D - 2;
  }
};

// Decomposes the contact mode `held`. D is the number of lanes, N + 2 for N masses under forcing,
// or Eigen::Dynamic; compiled for the lanes of a run (run/lanes.hpp).
template <int D>
ContactMode<D> build_contact_mode(const Scene &scene, const Held &held);

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
