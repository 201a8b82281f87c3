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

// The rate of the fastest mode.
double fastest_rate(TangentFlow &flow, const Held &held);

// Carries changes (2N rows, any number of columns) through a time tau in the contact mode `held`.
void carry(TangentFlow &flow, const Held &held, double tau, Eigen::MatrixXd &changes);

}  // namespace vibro_impact
