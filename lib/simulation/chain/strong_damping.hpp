// A strongly damped mode is carried as its two decays, in the coordinates j (slow) and j + 1
// (fast). A scene without stiff or strongly damped links has no such mode.
#pragma once

#include "contact_mode.hpp"
#include "forces.hpp"

namespace vibro_impact::detail {

// A mode of which the two decays are well apart, with the damping ratio beta sqrt(lambda) / 2 (Eq.
// 7), and the fast one, about beta lambda, is faster than the forcing. The drives f / (fast - slow)
// of two slower decays are larger than the velocity f / Omega, which would lose digits as their
// sum.
bool strongly_damped(const Scene &scene, double lambda);

// Sets both coordinates, with their steady responses.
void set_decays(const Scene &scene, double kappa, double lambda, const ExternalForce &force,
                Eigen::Index j, ModalCoordinates &all);

// Sets both to the value and velocity of their mode. It has the value y_slow + y_fast and, without
// its forcing, the velocity -slow y_slow - fast y_fast.
void start_decays(const ModalCoordinates &all, Eigen::Index j, double value, double velocity,
                  PerCoordinate &y, PerCoordinate &dy);

}  // namespace vibro_impact::detail
