// Changes of a motion between events: the unforced flow of a contact mode.
#pragma once

#include <Eigen/Core>

#include "simulation/for_analysis.hpp"

namespace vibro_impact {

// The chain without its forcing, and the contact modes that have been needed of it.
struct TangentFlow {
  Scene unforced;
  Modes<Eigen::Dynamic> modes = {};
  Counters counters = {};
};

TangentFlow tangent_flow(const Scene &scene);

// The Taylor terms of order n + 2 of motions or changes of them (columns), in units of tau^(n+2),
// from those of orders n and n + 1 (Eq. 4, but for its right-hand side):
//   x_(n+2) = -M^-1 K (tau^2 x_n + (n+1) tau beta x_(n+1)) / ((n+1) (n+2)).
Eigen::MatrixXd next_term(const Scene &scene, const Held &held, double tau, int n,
                          const Eigen::MatrixXd &before, const Eigen::MatrixXd &last);

// The rate of the fastest mode.
double fastest_rate(TangentFlow &flow, const Held &held);

// Carries changes (2N rows, any number of columns) through a time tau in the contact mode `held`.
void carry(TangentFlow &flow, const Held &held, double tau, Eigen::MatrixXd &changes);

}  // namespace vibro_impact
