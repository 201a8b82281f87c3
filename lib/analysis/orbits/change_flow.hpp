// Changes of a motion between events: by its start, the unforced flow of the contact mode; by
// parameters of its scene, at a fixed phase of the forcing, the same linear equations with an
// inhomogeneous term that the motion itself, or its forcing, supplies.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "simulation/for_analysis.hpp"
#include "vibro_impact/analysis/parameter.hpp"
#include "vibro_impact/record.hpp"

namespace vibro_impact {

// Throws std::invalid_argument for a parameter that the scene does not have, for initial values (to
// a motion with a start of its own they mean nothing), and for omega where there is no forcing
// period.
void require_differentiable(const Scene &scene, const std::vector<Parameter> &by);

// One in the columns of the parameters that act on this scalar of the scene: its own, and for the
// restitution of a stop that has none of its own that of the scene. The last of the columns belong
// to `by`.
Eigen::RowVectorXd columns_of(const Scene &scene, const std::vector<Parameter> &by,
                              Parameter::Kind kind, std::size_t index, Eigen::Index columns);

// Displacements and velocities of all masses.
struct PlainMotion {
  Eigen::VectorXd displacement, velocity;
};

// Carries a motion that is at this phase (a time) of the forcing, and its changes (2N rows, any
// number of columns of which the last by.size() belong to the parameters; rows of held masses: the
// change of their stops), through a time tau in the contact mode `held`, by Taylor series.
void carry(const Scene &scene, const std::vector<Parameter> &by, const Held &held, double phase,
           double tau, PlainMotion &motion, Eigen::MatrixXd &changes);

// The same of changes by the start alone, for any time, in closed form.
void carry_by_modes(const ContactMode<Eigen::Dynamic> &mode, double tau, Eigen::MatrixXd &changes);

// The change of the force on mass p (from 0) at rest (Eqs. 12-13, towards +x), the
// changes of the motion given.
Eigen::RowVectorXd force_change(const Scene &scene, const std::vector<Parameter> &by, std::size_t p,
                                double phase, const PlainMotion &motion,
                                const Eigen::MatrixXd &changes);

}  // namespace vibro_impact
