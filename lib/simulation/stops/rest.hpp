// Which masses are held after an instant: all masses at rest on a stop are decided together, order
// by order, each by the first derivative of its force that is not zero (lib/README.md, "Held
// masses").
#pragma once

#include <vector>

#include "simulation/chain/stop_state.hpp"
#include "vibro_impact/scene.hpp"

namespace vibro_impact::detail {

// A mass at rest on a stop whose force is in question.
struct RestingMass {
  std::size_t stop = 0, mass = 0;  // indices from 0
  double sigma = 1.0;              // the sign of the side of the stop
  bool was_held = false;
  bool force_is_zero = false;  // by definition: the instant is a root of the force
  // The decision.
  bool held = false;
  LeadingDerivative leading = {};
};

// The motion that a decision starts from, and its storage, reused from instant to instant.
class RestDecision {
 public:
  std::vector<RestingMass> masses;  // in question, with the decision
  std::vector<double> state_error;  // of the displacements, and the velocities over the rate

  // Decides all masses in question of a chain in this motion, the contact mode of which says who
  // else is held; `rate` is the unit of the derivatives. A mass on which no force acts in the first
  // 2 N + 4 orders stays where it is, and counts as free: motion has passed along the chain by
  // then.
  void decide(const Scene &scene, const MotionState &motion, double rate);

 private:
  enum class Kind : char { moving, held, undecided };
  // x, x', x'' of all masses, in units of rate^order, with bounds of their errors.
  struct Derivatives {
    std::vector<double> x, v, a, x_error, v_error, a_error;
  };
  Derivatives start_, current_;
  std::vector<Kind> kind_;

  std::size_t decide_by_order(const Scene &scene, double phase, double rate);
};

}  // namespace vibro_impact::detail
