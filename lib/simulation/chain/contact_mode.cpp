#include "contact_mode.hpp"

#include <algorithm>
#include <cmath>

#include "forces.hpp"
#include "modes.hpp"
#include "pair.hpp"
#include "strong_damping.hpp"
#include "tolerances.hpp"

namespace vibro_impact::detail {

namespace {

using Complex = std::complex<double>;
using Eigen::Index;

void resize(ContactMode &mode, std::size_t size, Index masses) {
  ModalCoordinates &all = mode.coordinates;
  all.size = size;
  const auto padded = static_cast<Index>(std::max<std::size_t>(2, size + size % 2));
  for (auto *array :
       {&all.kappa, &all.lambda, &all.force_re, &all.force_im, &all.constant, &all.force,
        &all.steady_re, &all.steady_im, &all.steady, &all.frequency, &all.inverse_frequency,
        &all.rate, &all.drive_re, &all.drive_im, &all.pull, &all.static_value})
    array->setZero(padded);
  all.decay.assign(static_cast<std::size_t>(padded), false);
  all.slow = all.decay;
  mode.shape.setZero(masses, padded);
}

// Psi^T A of Eq. 7, and the same of the other forces. The reference positions leave the springs to
// the ground out, which adds their forces there.
ExternalForce modal_force(const Scene &scene, const ContactMode &mode, Index k) {
  ExternalForce force{0.0, 0.0};
  for (std::size_t i = 0; i < scene.mass.size(); ++i) {
    const double shape = mode.basis.shape(static_cast<Index>(i), k);
    const ExternalForce own = external_force_of(scene, i);
    force.turning += shape * own.turning;
    force.constant += shape * (own.constant -
                               entry_of(scene.ground, i) * mode.equilibrium(static_cast<Index>(i)));
  }
  return force;
}

// Sets a coordinate of (1), with its steady response.
void set_oscillator(const Scene &scene, double kappa, double lambda, const ExternalForce &force,
                    Index j, ModalCoordinates &all) {
  all.kappa(j) = kappa;
  all.lambda(j) = lambda;
  all.frequency(j) = std::sqrt(lambda);
  all.rate(j) = root_modulus(kappa, lambda);
  all.force_re(j) = force.turning.real();
  all.force_im(j) = force.turning.imag();
  all.constant(j) = force.constant;
  if (lambda > 0.0) all.static_value(j) = force.constant / lambda;
  if (force.turning == 0.0) return;
  const Complex detuning(lambda - scene.omega * scene.omega, kappa * scene.omega);
  all.set_steady(detuning == 0.0 ? infinity : force.turning / detuning, j);
}

// Enters mode `k` of the basis as coordinate `j`, or as two where it is strongly damped. Returns
// the next coordinate.
Index add_mode(const Scene &scene, Index k, Index j, ContactMode &mode) {
  ModalCoordinates &all = mode.coordinates;
  const double lambda = mode.basis.lambda(k), kappa = scene.beta * lambda;
  const ExternalForce force = modal_force(scene, mode, k);
  mode.first_coordinate.push_back(j);
  mode.shape.col(j) = mode.basis.shape.col(k);
  if (!strongly_damped(scene, lambda)) {
    set_oscillator(scene, kappa, lambda, force, j, all);
    if (lambda == 0.0) mode.drift = j;
    return j + 1;
  }
  set_decays(scene, kappa, lambda, force, j, all);
  mode.shape.col(j + 1) = mode.basis.shape.col(k);
  return j + 2;
}

// The weights of (3) of a mass held at its stop: the forces that the static positions, and each
// mode, exert on it (Eqs. 12-13 times sigma).
void set_hold_force(const Scene &scene, const ContactMode &mode, Contact &contact) {
  const auto pressed_by = [&](const auto &tension) {
    return contact.sigma * force_of_tensions(scene, contact.mass, tension);
  };
  const ExternalForce force = external_force_of(scene, contact.mass);
  contact.offset = pressed_by(mode.tension) + contact.sigma * force.constant;
  for (Index k = 0; k < mode.basis.lambda.size(); ++k) {
    const Index j = mode.first_coordinate[static_cast<std::size_t>(k)];
    contact.row(j) = pressed_by(mode.basis.tension.col(k));
    if (mode.coordinates.decay[static_cast<std::size_t>(j)]) contact.row(j + 1) = contact.row(j);
  }
  contact.damping = scene.beta;
  contact.forcing = contact.sigma * force.turning;
  contact.forcing_modulus = std::abs(contact.forcing);
}

SpeedChange no_change(const ContactMode &mode) {
  return {PerCoordinate::Zero(mode.padded()), PerCoordinate::Zero(mode.padded())};
}

// Sets the jumps of the coordinates for a unit jump of the gap speed.
void set_impulse(const ContactMode &mode, Contact &contact) {
  SpeedChange &impulse = contact.impulse = no_change(mode);
  for (Index k = 0; k < mode.basis.lambda.size(); ++k)
    set_mode(mode, k, 0.0, -contact.sigma * mode.basis.inverse(k, static_cast<Index>(contact.mass)),
             impulse.value, impulse.slope);
  if (!mode.coordinates.any_decay) impulse.value.resize(0);
}

// Sets the static deflection by a force at the mass that widens the gap by one, and its speeds.
// Stiff coordinates hardly take part in it. With a rigid-body mode it is a displacement of the
// whole chain.
void set_placement(const ContactMode &mode, Contact &contact) {
  const auto &basis = mode.basis;
  const auto mass = static_cast<Index>(contact.mass);
  SpeedChange &drift = contact.drift = no_change(mode);
  PerCoordinate velocity = drift.slope;
  contact.placement.setZero(mode.padded());
  double deflection = 0.0;
  for (Index k = 0; k < basis.lambda.size(); ++k) {
    // Relative to the softest mode, since 1 / lambda may not be finite. A rigid-body mode alone
    // takes part.
    const double compliance = k == 0 ? 1.0 : basis.lambda(0) / basis.lambda(k);
    const double value = basis.shape(mass, k) * compliance;
    set_mode(mode, k, value, 0.0, contact.placement, velocity);
    set_mode(mode, k, 0.0, value, drift.value, drift.slope);
    deflection += basis.shape(mass, k) * value;
  }
  for (PerCoordinate *change : {&contact.placement, &drift.slope, &drift.value})
    *change *= -contact.sigma / deflection;
  if (!mode.coordinates.any_decay) drift.value.resize(0);
}

void add_contacts(const Scene &scene, ContactMode &mode) {
  const ModalCoordinates &all = mode.coordinates;
  mode.highest.setConstant(mode.equilibrium.size(), infinity);
  mode.lowest = -mode.highest;
  for (std::size_t k = 0; k < scene.stops.size(); ++k) {
    const Stop &stop = scene.stops[k];
    const auto i = static_cast<std::size_t>(stop.mass - 1);
    const auto mass = static_cast<Index>(i);
    (stop.side == Side::upper ? mode.highest : mode.lowest)(mass) = stop.position;
    const bool held = mode.held[i] == static_cast<signed char>(stop.side);
    if (mode.held[i] != 0 && !held) continue;  // held at the stop across
    Contact &contact = mode.contacts.emplace_back();
    contact.stop = k;
    contact.mass = i;
    contact.sigma = sign(stop.side);
    contact.held = held;
    contact.restitution = law_of(scene, stop).at_rest();
    contact.row.setZero(mode.padded());
    if (held) {
      set_hold_force(scene, mode, contact);
    } else {
      const Twofold<double> offset = exact_sum(stop.position, -mode.equilibrium(mass));
      contact.offset = contact.sigma * offset.value;
      contact.offset_low = contact.sigma * offset.low;
      contact.row = -contact.sigma * mode.shape.row(mass).transpose().array();
      set_impulse(mode, contact);
      set_placement(mode, contact);
    }
    contact.modulus = contact.row.abs();
    contact.steady = contact.forcing;
    for (Index j = 0; j < mode.padded(); ++j) {
      if (j == mode.drift && scene.omega == 0.0) continue;
      contact.static_value += contact.row(j) * all.static_value(j);
      if (all.steady(j) > 0.0)
        contact.steady +=
            contact.row(j) * Complex(1.0, contact.damping * scene.omega) * all.steady_of(j);
    }
  }
}

}  // namespace

void set_mode(const ContactMode &mode, Index k, double value, double velocity, PerCoordinate &y,
              PerCoordinate &dy) {
  const ModalCoordinates &all = mode.coordinates;
  const Index j = mode.first_coordinate[static_cast<std::size_t>(k)];
  if (!all.decay[static_cast<std::size_t>(j)]) {
    y(j) = value;
    dy(j) = velocity;
    return;
  }
  start_decays(all, j, value, velocity, y, dy);
}

ContactMode build_contact_mode(const Scene &scene, const Held &held) {
  std::vector<std::size_t> free;
  for (std::size_t i = 0; i < held.size(); ++i)
    if (held[i] == 0) free.push_back(i);

  ContactMode mode;
  mode.basis = modal_basis(scene, free);
  ModalCoordinates &all = mode.coordinates;
  mode.held = held;
  set_static_positions(scene, held, mode.equilibrium, mode.tension);
  std::size_t size = free.size();
  for (const double lambda : mode.basis.lambda)
    if (strongly_damped(scene, lambda)) ++size;
  resize(mode, size, static_cast<Index>(held.size()));
  for (Index k = 0, j = 0; k < mode.basis.lambda.size(); ++k) j = add_mode(scene, k, j, mode);
  for (Index j = 0; j < static_cast<Index>(size); ++j) {
    const auto k = static_cast<std::size_t>(j);
    mode.by_rate.push_back(j);
    all.slow[k] = all.force_of(j) != 0.0 && all.rate(j) < slow_rate * scene.omega && !all.decay[k];
  }
  std::stable_sort(mode.by_rate.begin(), mode.by_rate.end(),
                   [&all](Index i, Index j) { return all.rate(i) > all.rate(j); });
  mode.any_slow = std::find(all.slow.begin(), all.slow.end(), true) != all.slow.end();
  all.inverse_frequency = 1.0 / all.frequency.max(1e-300);
  all.force = all.force_re.abs() + all.force_im.abs() + all.constant.abs();
  all.any_beside_cosine = all.any_decay || !scene.sine.empty() || (all.constant != 0.0).any();
  for (Index j = 0; j < static_cast<Index>(size); ++j) {
    all.steady(j) = std::hypot(all.steady_re(j), all.steady_im(j));
    mode.fastest = std::max(mode.fastest, all.rate(j));
  }
  mode.forcing_rate = scene.forced() ? scene.omega : 0.0;
  mode.fastest = std::max(mode.fastest, mode.forcing_rate);
  mode.falls = mode.fastest == 0.0;
  if (mode.falls) mode.fastest = 1.0;  // any unit of time will do
  mode.damped = scene.beta > 0.0;
  mode.extent = mode.shape.cwiseAbs().colwise().maxCoeff().transpose().array();
  const PerCoordinate rate =
      all.rate.max((all.force > 0.0)
                       .select(PerCoordinate::Constant(all.rate.size(), scene.omega),
                               PerCoordinate::Zero(all.rate.size())));
  mode.speed_weight = mode.extent * rate;
  mode.acceleration_weight = mode.speed_weight * rate;
  add_contacts(scene, mode);
  return mode;
}

}  // namespace vibro_impact::detail
