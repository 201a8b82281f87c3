// Who is held after an instant: all masses at rest on a stop decided together, order by order, by
// the first derivative of their force that is not zero (lib/README.md).
#pragma once

#include <vector>

#include "simulation/chain/motion.hpp"

namespace vibro_impact {

// A mass at rest on a stop: what is asked of it, and the answer.
struct Resting {
  std::size_t stop = 0, mass = 0;  // indices from 0
  double sigma = 1.0;              // the sign of the side of the stop
  bool was_held = false;
  bool force_is_zero = false;  // by definition: the instant is a root of the force
  // Held, or free. Of the pressing force of a mass held, `zeros` derivatives are zero, of the gap
  // of a mass let go `zeros`, and the next one is `leading` > 0, in units of the rate of the scene.
  bool held = false;
  int zeros = 0;
  double leading = 0.0;
};

// The rate in units of which derivatives are carried: a bound of that of every contact mode.
double rate_of(const Scene &scene);

// Decides the masses in `resting`, of a chain with these displacements and velocities (N each) at
// this phase of the forcing; `error` bounds how far they may be off by rounding (of velocities in
// units of the rate), not at all at the start of a run; `held` says which of the others are held. A
// mass on which no force acts to all orders (2 N + 4 of them: motion has passed along the chain by
// then) stays where it is, and counts as free: nothing presses it.
void decide(const Scene &scene, double phase, double rate, std::vector<double> x,
            std::vector<double> v, std::vector<double> error, const Held &held,
            std::vector<Resting> &resting);

}  // namespace vibro_impact
