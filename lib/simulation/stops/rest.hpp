// The decision which masses stick after an instant. All masses at rest at a stop are decided
// together, order by order, each by the first non-zero derivative of its force (lib/README.md,
// "Held masses").
#pragma once

#include <vector>

#include "simulation/chain/stop_state.hpp"
#include "vibro_impact/scene.hpp"

namespace vibro_impact::detail {

// A mass at rest at a stop that may stick or leave.
struct RestingMass {
  std::size_t stop = 0, mass = 0;  // indices from 0
  double sigma = 1.0;              // the sign of the side of the stop
  bool was_held = false;
  bool force_is_zero = false;  // the force is exactly zero: the instant is a root of the force
  // The decision.
  bool held = false;
  LeadingDerivative leading = {};
};

// The masses in question, the decision about them, and its storage, which is reused.
class RestDecision {
 public:
  std::vector<RestingMass> masses;
  std::vector<double> state_error;  // error bounds of x_i, and of x_i' / rate

  // Decides whether each of `masses` is held. The other masses are free or held as in motion.held.
  // The unit of a derivative of order n is rate^n. A mass on which no force acts in the first
  // 2 N + 4 orders is free and stays at rest: by these orders motion has passed along the chain.
  void decide(const Scene &scene, const MotionState &motion, double rate);

 private:
  enum class Kind : char { moving, held, undecided };
  // x, x' / rate and x'' / rate^2 of all masses, or their derivatives of one order, with error
  // bounds.
  struct Derivatives {
    std::vector<double> x, v, a, x_error, v_error, a_error;
  };
  Derivatives start_, current_;
  std::vector<Kind> kind_;

  std::size_t decide_by_order(const Scene &scene, double phase, double rate);
};

}  // namespace vibro_impact::detail
