// The decision which masses stick after an instant. All masses at rest at a stop are decided
// together, order by order, each by the first non-zero derivative of its force (lib/README.md,
// "Held masses").
#pragma once

#include <vector>

#include "simulation/chain/mode_change.hpp"
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
  DecidedForce force = {};
};

// The masses in question, the decision about them, and its storage, which is reused.
class RestDecision {
 public:
  std::vector<RestingMass> masses;
  int orders = 0;  // that the decision took

  // Decides whether each of `masses` is held. The other masses are free or held as in `held`.
  // `phase` is that of the forcing, and `rate` the unit of time. A mass on which no force acts in
  // the first 2 N + 4 orders is free and stays at rest: by these orders motion has passed along the
  // chain. The motion is exact, as at the start of a run, or given by tensions, with their
  // rounding.
  void decide(const Scene &scene, const MotionState &exact, double rate);
  void decide(const Scene &scene, const Held &held, const ChainMotion &chain, double phase,
              double rate);

 private:
  enum class Kind : char { moving, held, undecided };
  // Derivatives of order n are carried in units of rate^n. Their range is that of the power: beside
  // a link of 1e9, those of mass 36 differ by more than a double can hold.
  using Real = long double;
  // A number with a bound of its error.
  struct Bounded {
    Real value = 0.0, error = 0.0;
  };
  // The forces k_i (x_i - x_(i-1)) of the links, below them those of the springs to the ground, and
  // their next derivative.
  struct SpringForces {
    std::vector<Bounded> force, rate;
  };
  SpringForces start_, current_;
  std::vector<Bounded> acceleration_;
  std::vector<Kind> kind_;
  std::vector<double> positions_;

  void set_kinds(const Scene &scene, const Held &held);
  void set_exact_link(const Scene &scene, std::size_t i, double rate, double x_before,
                      double v_before, double x, double v);
  void decide_from_start(const Scene &scene, double phase, double rate);
  std::size_t decide_by_order(const Scene &scene, double phase, double rate);
  Bounded force_on(const Scene &scene, std::size_t mass, double rate) const;
};

}  // namespace vibro_impact::detail
