// The modal coordinates of a motion in the contact mode in which it starts, or which it enters.
#pragma once

#include "motion.hpp"

namespace vibro_impact::detail {

// The motion of the chain about the static positions of a contact mode, or about the unstretched
// chain: displacements x_i and
// tensions of the springs as in `ModalBasis`, and the rates of both.
struct ChainMotion {
  Eigen::VectorXd displacement, tension, velocity, tension_rate;
  Eigen::VectorXd value, speed;  // modal displacements and velocities
};

// Sets the modal coordinates of `motion` in `mode` from displacements and velocities. `chain` is
// scratch.
void express(const Scene &scene, const MotionState &state, const ContactMode &mode,
             const Clock &clock, ChainMotion &chain, Motion &motion);

// Sets displacements and tensions, and the rates of both, about the unstretched chain.
void set_chain(const Motion &motion, ChainMotion &chain);

// Converts the modal coordinates of `motion` to those of another mode. `chain` is scratch.
void change_mode(const ContactMode &mode, ChainMotion &chain, Motion &motion);

}  // namespace vibro_impact::detail
