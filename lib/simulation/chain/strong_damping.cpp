#include "strong_damping.hpp"

#include <cmath>

#include "tolerances.hpp"

namespace vibro_impact::detail {

namespace {

using Eigen::Index;

// Sets a coordinate of (2).
void set_decay(const Scene &scene, double kappa, const ExternalForce &drive, Index j,
               ModalCoordinates &all) {
  all.kappa(j) = all.rate(j) = kappa;
  all.decay[static_cast<std::size_t>(j)] = all.any_decay = true;
  all.drive_re(j) = drive.turning.real();
  all.drive_im(j) = drive.turning.imag();
  all.pull(j) = drive.constant;
  all.static_value(j) = drive.constant / kappa;
  all.force_re(j) = -scene.omega * drive.turning.imag();
  all.force_im(j) = scene.omega * drive.turning.real();
  all.set_steady(drive.turning / std::complex<double>(kappa, scene.omega), j);
}

}  // namespace

bool strongly_damped(const Scene &scene, double lambda) {
  const double beta = scene.beta, forcing_rate = scene.forced() ? scene.omega : 0.0;
  return beta * beta * lambda > 4.0 * strong_damping * strong_damping &&
         beta * lambda > forcing_rate;
}

void set_decays(const Scene &scene, double kappa, double lambda, const ExternalForce &force,
                Index j, ModalCoordinates &all) {
  const double fast = kappa / 2 + std::sqrt(kappa * kappa / 4 - lambda), slow = lambda / fast;
  const ExternalForce drive{force.turning / (fast - slow), force.constant / (fast - slow)};
  set_decay(scene, slow, drive, j, all);
  set_decay(scene, fast, {-drive.turning, -drive.constant}, j + 1, all);
}

void start_decays(const ModalCoordinates &all, Index j, double value, double velocity,
                  PerCoordinate &y, PerCoordinate &dy) {
  const double slow = all.kappa(j), fast = all.kappa(j + 1);
  y(j) = (fast * value + velocity) / (fast - slow);
  y(j + 1) = -(slow * value + velocity) / (fast - slow);
  dy(j) = -slow * y(j);
  dy(j + 1) = -fast * y(j + 1);
}

}  // namespace vibro_impact::detail
