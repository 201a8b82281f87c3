#include "contact_mode.hpp"

#include <cmath>
#include <limits>

#include "forces.hpp"
#include "modes.hpp"
#include "tolerances.hpp"

namespace vibro_impact {

namespace {

// Static positions with the held masses at their stops: linear in the compliance between two
// anchors. Written so that two equal anchors give exactly their common position, which makes a
// zero hold force (Figure 5(c): s1 = s2) exactly zero.
Eigen::VectorXd static_positions(const Scene &scene, const Held &held,
                                 const std::vector<double> &held_at) {
  const std::size_t n = scene.mass.size();
  Eigen::VectorXd x(static_cast<Eigen::Index>(n));
  double left = 0.0;
  for (std::size_t i = 0; i < n;) {
    std::size_t anchor = i;
    while (anchor < n && held[anchor] == 0) ++anchor;
    const double right = anchor < n ? held_at[anchor] : left;
    if (i == 0 && scene.stiffness[0] == 0.0) left = right;  // not tied to the ground
    double total = 0.0, reached = 0.0;
    for (std::size_t j = i; j <= anchor && j < n; ++j) total += 1.0 / scene.stiffness[j];
    for (std::size_t j = i; j < anchor; ++j) {
      reached += 1.0 / scene.stiffness[j];
      x(static_cast<Eigen::Index>(j)) =
          left == right ? left : left + (right - left) * (reached / total);
    }
    if (anchor < n) x(static_cast<Eigen::Index>(anchor)) = right;
    left = right;
    i = anchor + 1;
  }
  return x;
}

// The force that presses a mass, at rest at its stop, into it (Eqs. 12-13 times sigma), in the
// lanes of `mode`: the forces of the neighbours' static positions, and of every lane's shape.
template <int D>
Reading<D> press_reading(const Scene &scene, const ContactMode<D> &mode, const Stop &stop) {
  using Eigen::Index;
  const auto p = static_cast<std::size_t>(stop.mass - 1);
  const double sigma = sign(stop.side);
  // A coordinate j of all masses, as the force on this one sees it: itself at rest at `here`.
  const auto beside = [&](double here, const auto &row_of) {
    return [&, here](std::size_t j) { return j == p ? here : row_of(static_cast<Index>(j)); };
  };
  const auto none = [](std::size_t) { return 0.0; };
  Reading<D> press;
  press.offset = sigma * force_on(scene, p, beside(stop.position, mode.equilibrium), none, 0.0);
  press.on_value.setZero(mode.lanes());
  press.on_slope.setZero(mode.lanes());
  for (Index lane = 0; lane < mode.lanes(); ++lane) {
    const auto shape = [&](Index j) { return mode.shape(j, lane); };
    const double cosine = scene.forced() && lane == mode.lanes() - 2 ? 1.0 : 0.0;
    press.on_value(lane) = sigma * force_on(scene, p, beside(0.0, shape), none, cosine);
    press.on_slope(lane) = sigma * force_on(scene, p, none, beside(0.0, shape), 0.0);
  }
  return press;
}

template <int D>
void add_contacts(const Scene &scene, ContactMode<D> &mode) {
  using Lanes = typename ContactMode<D>::Lanes;
  for (std::size_t k = 0; k < scene.stops.size(); ++k) {
    const Stop &stop = scene.stops[k];
    const auto i = static_cast<std::size_t>(stop.mass - 1);
    const auto row = static_cast<Eigen::Index>(i);
    const double sigma = sign(stop.side);
    const bool held = static_cast<double>(mode.held[i]) == sigma;
    if (mode.held[i] != 0 && !held) continue;  // held at the stop across
    const Reading<D> press = press_reading(scene, mode, stop),
                     gap{-sigma * mode.shape.row(row).transpose().array(),
                         Lanes::Zero(mode.lanes()),
                         sigma * (stop.position - mode.equilibrium(row))},
                     &watched = held ? press : gap;
    // |y''| = |kappa y' + lambda y| is at most three times the rate times |y'| + rate |y|.
    const Lanes reach = watched.on_value.abs() + 3.0 * mode.rate * watched.on_slope.abs(),
                jump_value = -sigma * mode.velocity_to_modal.col(row).array(),
                jump_slope = mode.decay.select(-mode.kappa * jump_value,
                                               -sigma * mode.to_modal.col(row).array());
    mode.contacts.push_back({k, i, sigma, held, watched, press, reach, jump_value, jump_slope,
                             law_of(scene, stop).at_rest()});
  }
}

// Enters mode j of the basis as a lane, or as two where it is strongly damped; returns the next
// lane. Its share in the steady response goes to the lanes of the forcing.
template <int D>
Eigen::Index add_mode(const Scene &scene, const ModalBasis &basis, Eigen::Index j,
                      Eigen::Index lane, ContactMode<D> &mode) {
  const double lambda = basis.lambda(j), kappa = scene.beta * lambda;
  mode.shape.col(lane) = basis.shape.col(j);
  mode.to_modal.row(lane) = basis.inverse.row(j);
  mode.kappa(lane) = kappa;
  mode.lambda(lane) = lambda;
  if (mode.forcing_lanes > 0) {
    double force = 0.0;  // Psi^T A of Eq. 7
    for (std::size_t i = 0; i < scene.mass.size(); ++i)
      force += basis.shape(static_cast<Eigen::Index>(i), j) * scene.amplitude[i];
    const double omega2 = scene.omega * scene.omega;
    const double detuning = lambda - omega2, loss = kappa * scene.omega;
    const double squared = detuning * detuning + loss * loss;
    // Splitting off the steady response would cancel digits. That of the rigid-body mode, force /
    // Omega^2, is large beside the others where the forcing is slow.
    const bool cancels = lambda == 0.0 ? omega2 <= wide * basis.lambda.maxCoeff()
                                       : std::sqrt(squared) < near_resonance * (lambda + omega2);
    if (cancels) {
      mode.resonant(lane) = force;
      mode.any_resonant = mode.any_resonant || force != 0.0;
    } else {
      mode.shape.col(mode.lanes() - 2) += basis.shape.col(j) * (force * (detuning / squared));
      mode.shape.col(mode.lanes() - 1) += basis.shape.col(j) * (force * (loss / squared));
    }
  }
  if (D != Eigen::Dynamic || !strongly_damped(scene.beta, lambda)) return lane + 1;
  // y = y1 + y2 with decays fast > slow: y1 = (fast y + y') / (fast - slow), y2 = y - y1.
  const double fast = kappa / 2 + std::sqrt(kappa * kappa / 4 - lambda), slow = lambda / fast;
  const Eigen::Index other = lane + 1;
  mode.shape.col(other) = basis.shape.col(j);
  mode.to_modal.row(lane) = basis.inverse.row(j) * (fast / (fast - slow));
  mode.velocity_to_modal.row(lane) = basis.inverse.row(j) / (fast - slow);
  mode.to_modal.row(other) = basis.inverse.row(j) * (-slow / (fast - slow));
  mode.velocity_to_modal.row(other) = -mode.velocity_to_modal.row(lane);
  mode.kappa(lane) = slow;
  mode.kappa(other) = fast;
  mode.lambda(lane) = mode.lambda(other) = 0.0;
  mode.decay(lane) = mode.decay(other) = mode.any_decay = true;
  return lane + 2;
}

}  // namespace

template <int D>
ContactMode<D> build_contact_mode(const Scene &scene, const Held &held) {
  using Eigen::Index;
  const auto n = static_cast<Index>(scene.mass.size());
  std::vector<std::size_t> free;
  std::vector<double> held_at(held.size(), 0.0);
  for (std::size_t i = 0; i < held.size(); ++i)
    if (held[i] == 0) free.push_back(i);
  for (const Stop &stop : scene.stops) {
    const auto i = static_cast<std::size_t>(stop.mass - 1);
    if (static_cast<double>(held[i]) == sign(stop.side)) held_at[i] = stop.position;
  }
  const ModalBasis basis = modal_basis(scene, free);

  ContactMode<D> mode;
  mode.held = held;
  mode.forcing_lanes = scene.forced() ? 2 : 0;
  Index lanes = basis.lambda.size() + mode.forcing_lanes;
  for (const double lambda : basis.lambda)
    if (strongly_damped(scene.beta, lambda)) ++lanes;
  if (D != Eigen::Dynamic) lanes = D;
  for (auto *array : {&mode.kappa, &mode.lambda, &mode.rate, &mode.resonant}) array->setZero(lanes);
  mode.decay.setConstant(lanes, false);
  mode.equilibrium = static_positions(scene, held, held_at);
  mode.shape.setZero(n, lanes);
  mode.to_modal.setZero(lanes, n);
  mode.velocity_to_modal.setZero(lanes, n);
  for (Index j = 0, lane = 0; j < basis.lambda.size(); ++j)
    lane = add_mode(scene, basis, j, lane, mode);
  mode.lambda.tail(mode.forcing_lanes).setConstant(scene.omega * scene.omega);

  double slowest = std::numeric_limits<double>::infinity();
  for (Index j = 0; j < lanes; ++j) {
    mode.rate(j) = root_modulus(mode.kappa(j), mode.lambda(j));
    mode.fastest = std::max(mode.fastest, mode.rate(j));
    if (mode.rate(j) > 0.0) slowest = std::min(slowest, mode.rate(j));
  }
  if (mode.fastest == 0.0) mode.fastest = 1.0;  // free fall: a parabola, any rate will do
  mode.stiff = scene.beta > 0.0 && mode.fastest > stiff_ratio * slowest;
  mode.extent = mode.shape.cwiseAbs().colwise().maxCoeff().transpose().array();
  add_contacts(scene, mode);
  return mode;
}

template ContactMode<4> build_contact_mode<4>(const Scene &, const Held &);
template ContactMode<Eigen::Dynamic> build_contact_mode<Eigen::Dynamic>(const Scene &,
                                                                        const Held &);

}  // namespace vibro_impact
