// The decision which masses stick after an instant. All masses at rest at a stop are decided
// together, order by order, each by the first non-zero derivative of its force
// (lib/README.md, "Held masses").
#pragma once

#include <vector>

#include "simulation/chain/motion.hpp"
#include "simulation/chain/stop_state.hpp"

namespace vibro_impact::detail {

// A mass at rest at a stop that may stick or leave.
struct RestingMass {
  Contact contact;      // before the decision: of a held mass or of a free one
  int known_zeros = 0;  // derivatives of the force, from order 0 on, that are exactly zero
  // The decision.
  bool held = false;
  AtStop at = Forceless{};  // the mass is free then, and stays at rest
};

// The storage of a decision, which is reused.
class RestDecision {
 public:
  // Decides whether each of `masses` is held. The other masses are free or held as in the mode of
  // the motion. Returns how many orders this took. A mass on which no force acts in the first
  // 2 N + 4 orders is free and stays at rest: by these orders motion has passed along the chain.
  int decide(const Chain &chain, const Motion &motion, std::vector<RestingMass> &masses);

 private:
  enum class Kind : char { moving, held, undecided };
  // A derivative with the sum of the moduli of its terms.
  struct Term {
    Real value = 0.0;
    double terms = 0.0;
  };
  // Derivatives of order n, n + 1 and n + 2 of the displacements.
  std::vector<Term> order_n_, order_n_plus_1_, order_n_plus_2_;
  std::vector<Kind> kind_;

  Term springs_on(const Chain &chain, std::size_t i) const;
};

}  // namespace vibro_impact::detail
