// Who is held after an instant: all masses at rest on a stop decided together, order by order, by
// the first derivative of their force that is not zero (lib/README.md).
#pragma once

#include <vector>

#include "vibro_impact/scene.hpp"

namespace vibro_impact {

// A mass at rest on a stop: what is asked of it, and the answer.
struct Resting {
  std::size_t stop = 0, mass = 0;  // indices from 0
  double sigma = 1.0;              // the sign of the side of the stop
  bool was_held = false;
  bool force_is_zero = false;  // by definition: the instant is a root of the force
  // Held, or free, and the force that decided it, as in AtStop.
  bool held = false;
  int zeros = 0;
  double leading = 0.0;
};

// x, x', x'' of all masses, in units of rate^order, with bounds of their errors.
struct Derivatives {
  std::vector<double> x, v, a, x_error, v_error, a_error;
};

// A question to `decide`, its storage reused from instant to instant.
struct Question {
  std::vector<Resting> resting;  // the masses in question
  // How far the displacements, and the velocities in units of the rate, may be off by rounding.
  std::vector<double> error;
  // Of the decision.
  enum class Kind : char { moving, held, undecided };
  Derivatives at, looked_at;
  std::vector<Kind> kind;
};

// Decides the masses in `question.resting` of a chain in this motion, the contact mode of which
// says who else is held; `rate` is the unit of the derivatives. A mass on which no force acts to
// all orders (2 N + 4 of them: motion has passed along the chain by then) stays where it is, and
// counts as free: nothing presses it.
void decide(const Scene &scene, const MotionState &motion, double rate, Question &question);

}  // namespace vibro_impact
