// A family of periodic orbits followed by the speed of one of their impacts, through grazing, folds
// and period doublings.
//
// Where an impact grazes, the stroboscopic map has a square root: the time of the impact is found
// from a gap. Here nothing is found from a gap. The section stands at the impact itself: the
// unknowns are the phase of the forcing there, the state of the other masses, and one parameter of
// the scene; the closing speed v is given. From the state after the impact the motion goes on for
// the whole periods of the orbit without the stop, and must then be back at its position with the
// speed v. (Where other impacts at the same stop belong to the orbit, the stop is taken away only
// from the halves of the two flights that begin and end at the section.) All this is smooth in v,
// also at v = 0 and beyond, where the orbit is virtual. It is also regular at a fold, dp/dv = 0,
// and at a period doubling.
//
// The Floquet multipliers are those of the saltation at the impact times the tangent of the flight
// back to it: one of them grows as 1 / v towards grazing. With v det(1 + W), W that product, the
// period doubling has a function that is smooth through v = 0; the fold has dp/dv.
#pragma once

#include <complex>
#include <optional>
#include <vector>

#include "parameter.hpp"
#include "periodic_orbit.hpp"

namespace vibro_impact {

struct ImpactFamily {
  Scene scene;           // its value of the parameter is that of no orbit in particular
  Parameter parameter;   // the unknown; not an initial displacement or velocity
  std::size_t stop = 0;  // of the impact: index in Scene::stops
  int periods = 1;       // of the orbit, in those of the forcing
};

// An orbit of the family.
struct ImpactOrbit {
  double speed = 0.0;                             // v, just before the impact
  double parameter = 0.0;                         // p
  MotionState state;                              // right after the impact, in the first period
  double parameter_by_speed = 0.0;                // dp/dv: zero at a fold
  double doubling = 0.0;                          // v det(1 + W): zero at a period doubling
  std::vector<std::complex<double>> multipliers;  // largest modulus first; none at v = 0
  // The motion with its stop in place is this one: no other contact with it, and v >= 0.
  bool real = false;
  std::vector<double> residuals;  // largest component of what must be zero, per iterate
  // For what comes next: how the unknowns change with v (the angle of the forcing, the coordinates
  // of the other free masses, p), and the first and the last event at the stop in between, in
  // fractions of the orbit (1 and 0 where there is none).
  std::vector<double> by_speed;
  double first_other = 1.0, last_other = 0.0;
};

// The orbit of a converged periodic orbit of `scene` as one of the family: `impact` counts its
// impacts at the stop from 0, from the section on. Throws std::invalid_argument where there is none
// with this number, or another event at the same instant, std::runtime_error where Newton's method
// fails.
ImpactOrbit impact_orbit_of(const ImpactFamily &family, const PeriodicOrbit &orbit,
                            std::size_t impact = 0);

// The orbit with this speed, by Newton's method from a neighbour; nothing where that fails.
std::optional<ImpactOrbit> impact_orbit(const ImpactFamily &family, const ImpactOrbit &neighbour,
                                        double speed, const NewtonOptions &options = {});

// The orbits from `start` on to `speed`, `step` apart in speed or, where Newton's method fails,
// less (down to step / 1024, where the family is given up: it ends, or another event is met).
std::vector<ImpactOrbit> follow(const ImpactFamily &family, const ImpactOrbit &start, double speed,
                                double step);

// The fold and the period doubling between two orbits: where dp/dv or v det(1 + W) is zero. Nothing
// where it has the same sign at both. Throws std::runtime_error where Newton's method fails.
std::optional<ImpactOrbit> fold_between(const ImpactFamily &family, const ImpactOrbit &a,
                                        const ImpactOrbit &b);
std::optional<ImpactOrbit> doubling_between(const ImpactFamily &family, const ImpactOrbit &a,
                                            const ImpactOrbit &b);

}  // namespace vibro_impact
