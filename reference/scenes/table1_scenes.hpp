// One scene for each pair of events of Table I: two masses of the paper's kind (m = k = 1, c = 0.1,
// A = (0.5, 0)) in which the pair occurs. All numbers that are not the paper's are ours.
//
// Sticking takes time, grazing and impact do not: DS and SI occur for open sets of parameters. The
// others need as many parameters as there are conditions beyond the unknown time: one for DI
// (x1 = s1, x2 = s2) and GS (x2 = s2, x2' = 0), two for GI (x1 = s1, x1' = 0, x2 = s2), three for
// DG (x_i = s_i, x_i' = 0). These parameters were solved for in 50 digits and are given to the last
// digit of a double.
#pragma once

#include <string>
#include <vector>

#include "paper_scenes.hpp"

namespace vibro_impact::paper {

// A scene, the pair of events that it shows, and the window of time in which it shows the pair.
struct PairScene {
  std::string pair;  // abbreviation of its events: D dual, G grazing, S sticking, I impact
  Scene scene;
  double from, to;
};

// A stop that a mass grazes which turns round at `turning_point`. The stop stands 1e-14 before that
// point, which the mass therefore reaches at some 1e-7. At the point itself rounding would decide
// whether the mass touches the stop.
inline Stop grazed_stop(int mass, Side side, double turning_point) {
  return {mass, side, turning_point - sign(side) * 1e-14};
}

// A contact at zero velocity and acceleration (Section 2.2), of mass 1 with an upper stop, from
// rest: the time and the frequency at which a minimum of its velocity is zero. The stop stands
// where mass 1 is then. Given to 15 digits.
struct NonGenericContact {
  double time, omega;
};
constexpr NonGenericContact non_generic_contact{3.06557694678915, 0.236067583611677};

// All six, in the order of Table I. DG, DI and GI happen on the way from rest.
inline std::vector<PairScene> table1_scenes() {
  constexpr Side lower = Side::lower, upper = Side::upper;
  const Scene sticking_impact = figure5a();
  constexpr double omega = 0.2561;  // of DS and DI: printed in the caption of Figure 4(b)

  // The first minima of both masses coincide at this frequency.
  const Scene dual_grazing =
      two_masses(grazed_stop(1, lower, -1.0428976840934368),
                 grazed_stop(2, lower, -1.4664190591028583), 0.7, 0.35234631236599962);
  // The stop of mass 2 stands below that of mass 1.
  const Scene dual_sticking = two_masses({1, upper, 0.3}, {2, upper, 0.25}, 0.7, omega);
  // The stop of mass 2 stands where mass 2 is when mass 1 first hits its own.
  const Scene double_impact =
      two_masses({1, upper, 0.5}, {2, upper, 0.3248709293854069}, 0.7, omega);
  // Figure 5(b) from near its settled motion, in the middle of a sticking phase of mass 1. The stop
  // of mass 2 stands at the maximum of mass 2 in the next phase.
  Scene grazing_sticking = figure5b();
  grazing_sticking.displacement = {grazing_sticking.stops[0].position, 0.17};
  grazing_sticking.velocity = {0.0, -0.003};
  grazing_sticking.stops[1] = grazed_stop(2, upper, 0.44910277073137423);
  // The stop of mass 1 stands at its first maximum, that of mass 2 at the place of mass 2 at that
  // instant.
  const Scene grazing_impact = two_masses(grazed_stop(1, upper, 0.43515458820109099),
                                          {2, upper, 0.31069573671990272}, 0.7, 0.5);

  return {{"DG", dual_grazing, 0.0, 14.0},  {"DS", dual_sticking, 42.0, 56.0},
          {"DI", double_impact, 0.0, 7.0},  {"GS", grazing_sticking, 12.0, 26.0},
          {"GI", grazing_impact, 0.0, 5.0}, {"SI", sticking_impact, 950.0, 964.0}};
}

}  // namespace vibro_impact::paper
