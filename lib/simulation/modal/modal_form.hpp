// A contact mode in modal coordinates, for flights without an event over any time. The modes are
// made when such a flight asks for them, block by block: a block lies between held masses.
#pragma once

#include <map>
#include <memory>
#include <utility>
#include <vector>

#include "modes.hpp"
#include "oscillator.hpp"
#include "simulation/chain/motion.hpp"

namespace vibro_impact::detail {

// A contact without its constant part, as a sum over the coordinates:
// row . (y + damping y') + a cos + b sin. It is -sigma x of a free mass, or sigma times the force
// on a held one.
struct Watch {
  std::vector<Real> row;
  double damping = 0.0, a = 0.0, b = 0.0;
};

// The modal coordinates and their velocities, y = shape^T M x. A flight sets the sums of the moduli
// of the terms of each.
struct ModalState {
  RealVector y, dy;
  Eigen::VectorXd y_terms, dy_terms;
};

// The modal form of a flight.
struct ModalForm {
  RealMatrix shape;                           // x = shape y for the free masses, N x coordinates
  std::vector<Oscillator<Real>> oscillators;  // one for each coordinate,
  std::vector<ModalForce> forces;             // with the force on it over the flight
  ModalState start;                           // of the flight
  std::vector<Watch> watches;                 // one for each contact of the mode
  double omega = 0.0;                         // of the forcing
  double fastest = 0.0;                       // the largest rate of a coordinate and of the forcing

  std::size_t size() const {
    return oscillators.size();
  }
};

// The blocks of one run by their first and last masses. Copies of a run share them.
using Blocks = std::map<std::pair<std::size_t, std::size_t>, std::shared_ptr<const BlockModes>>;

// The modal form of a flight of N masses from this motion, in O(N^2). A block that is new is added
// in O(N^3).
ModalForm modal_form(const Chain &chain, const Motion &motion, Blocks &blocks);

// Sets `to` to the state at the time tau > 0 of the flight.
void fly(const ModalForm &form, const Real &tau, ModalState &to);

// Sets the free masses of a motion to a modal state.
void set_masses(const ModalForm &form, const ModalState &state, Motion &motion);

}  // namespace vibro_impact::detail
