// Orbits of a chain with one impact in n forcing periods, in closed form: the sum of the modes
// (Shaw and Shaw 1989; Natsiavas 1993; Pun et al. 1998).
#pragma once

#include "closed_form.hpp"
#include "reference/scenes/extreme_scenes.hpp"

#include <string>
#include <vector>

namespace vibro_impact_reference {

struct OneImpactCase {
  std::string name;
  vibro_impact::Scene scene;
  int periods,
      branch;  // branch: +1 the faster orbit, -1 the slower one, 0 the fold where they meet
  std::size_t stop = 0;  // the stop that is hit; a fold has its own position of it
};

/// Figure 3 at Omega = 2.4, and chains of two equal, three unequal and five equal masses before one
/// stop. Chains without forcing, damping and loss have nonsmooth modes (Gendelman and Manevitch
/// 2008; Thorin, Delezoide and Legrand 2017). The table has the mode with the period of Omega.
std::vector<OneImpactCase> one_impact_cases();

/// The impact, the sum of the multipliers, and the state just after the impact.
struct OneImpactOrbit {
  Real stop, time, velocity_before, trace;
  Vector x, v;
};

/// A unit impulse at every impact alone would give the mass that hits the displacement g and the
/// velocity b just after it. Let the forcing alone move that mass by Re X exp(i Omega t), let
/// Z = X exp(i Omega t) at the impact and d be the stop. The impulse p = -m (1 + r) v then has
/// Re Z = d - p g and Im Z = p h, where Omega h = b - r / (m (1 + r)). So |X|^2 = (d - p g)^2 +
/// (p h)^2. The two roots meet at the fold, d^2 = |X|^2 (1 + (g / h)^2). All modes are underdamped.
OneImpactOrbit one_impact_orbit(const OneImpactCase &given);

/// One row per case, numbers with 30 decimals. What is below 1e-40 is the rounding of a zero.
std::string one_impact_table();

}  // namespace vibro_impact_reference
