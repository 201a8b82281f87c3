#include "mode_change.hpp"

#include <cmath>

namespace vibro_impact::detail {

namespace {

using Eigen::Index;
using Eigen::VectorXd;

// Sets the modal values phi_k^T M x = phi_k^T K x / lambda_k, (9) of lib/README.md, from
// displacements x and tensions t. The left side has an error of epsilon sqrt(x^T M x), and the
// right side, computed from the tensions, an error of epsilon |t| / sqrt(lambda_k). The right side
// is therefore used for the modes with lambda_k above the Rayleigh quotient t^T t / x^T M x of the
// motion. Rounding of a slow motion then does not set a stiff mode in motion.
void set_values(const ModalBasis &basis, const VectorXd &x, const VectorXd &t, VectorXd &values) {
  const Index modes = basis.lambda.size();
  for (Index k = 0; k < modes; ++k) values(k) = basis.inverse.row(k).dot(x);
  const double inertia = values.head(modes).stableNorm(), stretch = t.stableNorm();
  for (Index k = 0; k < modes; ++k)
    if (std::sqrt(basis.lambda(k)) * inertia > stretch)
      values(k) = basis.tension.col(k).dot(t) / basis.lambda(k);
}

void set_coordinates(const ContactMode &mode, ChainMotion &chain, Motion &motion) {
  motion.mode = &mode;
  motion.y.setZero(mode.padded());
  motion.dy.setZero(mode.padded());
  motion.y_low.setZero(mode.padded());
  motion.dy_low.setZero(mode.padded());
  set_values(mode.basis, chain.displacement, chain.tension, chain.value);
  set_values(mode.basis, chain.velocity, chain.tension_rate, chain.speed);
  for (Index k = 0; k < mode.basis.lambda.size(); ++k)
    set_mode(mode, k, chain.value(k), chain.speed(k), motion.y, motion.dy);
  motion.following.assign(static_cast<std::size_t>(mode.padded()), false);
  motion.any_following = false;
  complete_change(motion);
}

// Adds the motion about the static positions, and sets the rates.
void add_motion(const Motion &motion, ChainMotion &chain) {
  const ContactMode &mode = *motion.mode;
  chain.velocity.setZero(mode.equilibrium.size());
  chain.tension_rate.setZero(mode.tension.size());
  for (Index k = 0; k < mode.basis.lambda.size(); ++k) {
    const Index j = mode.first_coordinate[static_cast<std::size_t>(k)];
    double value = motion.y(j), velocity = motion.dy(j);
    if (mode.coordinates.decay[static_cast<std::size_t>(j)]) {
      value += motion.y(j + 1);
      velocity += motion.dy(j + 1);
    }
    chain.displacement += value * mode.basis.shape.col(k);
    chain.tension += value * mode.basis.tension.col(k);
    chain.velocity += velocity * mode.basis.shape.col(k);
    chain.tension_rate += velocity * mode.basis.tension.col(k);
  }
}

}  // namespace

void express(const Scene &scene, const MotionState &state, const ContactMode &mode,
             const Clock &clock, ChainMotion &chain, Motion &motion) {
  const auto n = static_cast<Index>(state.displacement.size());
  const Index rows = mode.tension.size();
  chain = {VectorXd(n), VectorXd(rows), VectorXd(n), VectorXd(rows), VectorXd(n), VectorXd(n)};
  double x_before = 0.0, v_before = 0.0;
  for (Index i = 0; i < n; ++i) {
    const double x = state.displacement[static_cast<std::size_t>(i)],
                 v = state.velocity[static_cast<std::size_t>(i)],
                 root = std::sqrt(scene.stiffness[static_cast<std::size_t>(i)]);
    chain.displacement(i) = x - mode.equilibrium(i);
    chain.tension(i) = root * (x - x_before) - mode.tension(i);
    chain.velocity(i) = v;
    chain.tension_rate(i) = root * (v - v_before);
    if (rows > n) {
      const double ground = std::sqrt(scene.ground[static_cast<std::size_t>(i)]);
      chain.tension(n + i) = ground * x - mode.tension(n + i);
      chain.tension_rate(n + i) = ground * v;
    }
    x_before = x;
    v_before = v;
  }
  set_clock(motion, clock, state.instant);
  set_coordinates(mode, chain, motion);
}

void set_chain(const Motion &motion, ChainMotion &chain) {
  const ContactMode &mode = *motion.mode;
  chain.displacement = mode.equilibrium;
  chain.tension = mode.tension;
  add_motion(motion, chain);
}

void change_mode(const ContactMode &mode, ChainMotion &chain, Motion &motion) {
  chain.displacement = motion.mode->equilibrium - mode.equilibrium;
  chain.tension = motion.mode->tension - mode.tension;
  add_motion(motion, chain);
  set_coordinates(mode, chain, motion);
}

}  // namespace vibro_impact::detail
