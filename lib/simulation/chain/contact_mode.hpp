// A contact mode: which masses are held at which stop, and the modal solution of the masses that
// are free (Eqs. 6-7 restricted to the free rows). Numbers such as (1) are those of lib/README.md.
#pragma once

#include <Eigen/Core>
#include <complex>
#include <cstddef>
#include <vector>

#include "modes.hpp"
#include "vibro_impact/scene.hpp"

namespace vibro_impact::detail {

// One number for each modal coordinate. The number of coordinates is padded to an even number, at
// least two, by coordinates that never move: loops take two at a time.
using PerCoordinate = Eigen::ArrayXd;

// The modal coordinates: y'' + kappa y' + lambda y = Re(force e^(i Omega t)) + constant (1). A
// strongly damped mode is carried as its two decays, so that the fast one can die out: there lambda
// = 0, and (1), without its constant, is the derivative of y' + kappa y = Re(drive e^(i Omega t)) +
// pull (2), with force = i Omega drive.
struct ModalCoordinates {
  std::size_t size = 0;  // without padding
  PerCoordinate kappa, lambda;
  PerCoordinate force_re, force_im, constant;  // of (1)
  PerCoordinate force;                 // >= |Re(force e^(i Omega t)) + constant| at all times
  PerCoordinate steady_re, steady_im;  // the steady response to it is Re(steady e^(i Omega t))
  PerCoordinate steady;                // its modulus; infinite where there is none
  PerCoordinate frequency, inverse_frequency;  // sqrt(lambda), and 1e300 for 1 / 0
  PerCoordinate rate;                          // largest modulus of a characteristic root
  std::vector<char> decay;                     // true of a coordinate of (2)
  PerCoordinate drive_re, drive_im, pull;      // of (2)
  PerCoordinate static_value;  // constant / lambda, or pull / kappa: the constant part of the
                               // steady response
  std::vector<char> slow;      // true of a forced coordinate far slower than the forcing
  bool any_decay = false;
  bool any_beside_cosine = false;  // some force is not a cosine

  std::complex<double> force_of(Eigen::Index j) const {
    return {force_re(j), force_im(j)};
  }
  std::complex<double> steady_of(Eigen::Index j) const {
    return {steady_re(j), steady_im(j)};
  }
  void set_steady(std::complex<double> response, Eigen::Index j) {
    steady_re(j) = response.real();
    steady_im(j) = response.imag();
  }
};

// A change of y', and of y, which only decays have; else that is empty.
struct SpeedChange {
  PerCoordinate slope, value;
};

// A stop that a mass of this contact mode may come to, or is held at, with what stays positive
// until something happens there: the gap sigma (s - x) of a free mass, or the force that presses a
// held one. Both are offset + row . y + damping row . y' + Re(forcing e^(i Omega t)) (3); a gap has
// damping = forcing = 0.
struct Contact {
  std::size_t stop = 0, mass = 0;  // indices from 0
  double sigma = 1.0;              // the sign of its side
  bool held = false;
  double offset = 0.0, offset_low = 0.0, damping = 0.0;  // offset + offset_low of a gap is exact
  std::complex<double> forcing = 0.0;
  double forcing_modulus = 0.0;
  PerCoordinate row;
  PerCoordinate modulus;  // |row|
  // Changes of y that widen the gap by 1, and of y' that add 1 to its speed: the static deflection
  // by a force at the mass, in which stiff modes hardly move, and the same shape of the velocities.
  PerCoordinate placement;
  SpeedChange drift;
  SpeedChange impulse;  // by an impulse on the mass that adds 1 to the gap speed
  // (3) in the steady response is offset + static_value + Re(steady e^(i Omega t)).
  std::complex<double> steady = 0.0;
  double static_value = 0.0;
  double restitution = 0.0;  // the limit of r as the closing speed falls to 0
};

struct ContactMode {
  Held held;
  ModalBasis basis;  // the modes of the free masses
  // The first coordinate of each mode; the other decay of a strongly damped mode follows it.
  std::vector<Eigen::Index> first_coordinate;
  ModalCoordinates coordinates;
  double fastest = 0.0;       // the largest rate of a coordinate and of the forcing
  double forcing_rate = 0.0;  // Omega of a forced scene, else 0
  bool falls = false;         // every rate is 0, as in a free fall; `fastest` is then 1
  bool damped = false;
  bool any_slow = false;              // see ModalCoordinates::slow
  std::vector<Eigen::Index> by_rate;  // the coordinates, the fastest first
  Eigen::Index drift = -1;            // the rigid-body mode y'' = f cos(Omega t), if there is one
  Eigen::VectorXd equilibrium;        // N: static positions without forcing
  Eigen::VectorXd tension;            // N: sqrt(k_i) (x_i - x_(i-1)) at the static positions
  Eigen::VectorXd lowest, highest;    // N: the stops of each mass, or -infinity and infinity
  // x = equilibrium + shape y, N x coordinates, with zero rows for held masses.
  Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> shape;
  PerCoordinate extent;  // largest modulus in each column of `shape`
  // Bounds of |x''| by |y| and by |y'|: extent times a rate and its square.
  PerCoordinate acceleration_weight, speed_weight;
  std::vector<Contact> contacts;

  Eigen::Index padded() const {
    return coordinates.kappa.size();
  }
};

// Sets the coordinate of mode k, or its two decays, to this value and velocity.
void set_mode(const ContactMode &mode, Eigen::Index k, double value, double velocity,
              PerCoordinate &y, PerCoordinate &dy);

ContactMode build_contact_mode(const Scene &scene, const Held &held);

}  // namespace vibro_impact::detail
