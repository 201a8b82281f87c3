// The coordinates of a motion in a contact mode that it starts in, or changes to.
#pragma once

#include "motion.hpp"

namespace vibro_impact::detail {

// The motion of the chain about the static positions of a contact mode: displacements x_i and
// tensions of the springs as in `ModalBasis`, and the rates of both.
struct ChainMotion {
  Eigen::VectorXd displacement, tension, velocity, tension_rate;
  Eigen::VectorXd value, speed;  // of the modes
};

// Expresses a motion in the coordinates of `mode`. `chain` is scratch.
void express(const Scene &scene, const MotionState &state, const ContactMode &mode,
             const Clock &clock, ChainMotion &chain, Motion &motion);

// Expresses the motion in the coordinates of another mode. `chain` is scratch.
void change_mode(const ContactMode &mode, ChainMotion &chain, Motion &motion);

}  // namespace vibro_impact::detail
