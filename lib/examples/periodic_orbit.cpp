// The periodic orbit of the paper's Figure 2 by Newton's method on the stroboscopic map, with its
// Floquet multipliers: two of the four are zero, since each mass sticks once per period.
#include <cstdio>

#include "paper_scene.hpp"
#include "vibro_impact/analysis/analysis.hpp"
#include "vibro_impact/vibro_impact.hpp"

int main() {
  using namespace vibro_impact;
  const Scene scene = paper_scene(0.2);

  const MotionState guess = at_quiet_phase(scene, state_after_periods(scene, 5));
  const PeriodicOrbit orbit = find_periodic_orbit(scene, guess);
  for (const double residual : orbit.residuals) std::printf("residual %.1e\n", residual);
  for (const auto &multiplier : orbit.multipliers)
    std::printf("multiplier %+.12f %+.12fi\n", multiplier.real(), multiplier.imag());
  std::printf("%s and %s\n", orbit.converged ? "converged" : "not converged",
              orbit.stable() ? "stable" : "unstable");
  return !(orbit.converged && orbit.stable());
}
