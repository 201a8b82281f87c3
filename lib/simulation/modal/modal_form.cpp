#include "modal_form.hpp"

#include <algorithm>
#include <cmath>

#include "simulation/chain/tolerances.hpp"

namespace vibro_impact::detail {

namespace {

using Eigen::Index;

Index as_index(std::size_t i) {
  return static_cast<Index>(i);
}

// The constant force on a free mass, with the pull of held neighbours.
Real constant_force(const Chain &chain, const Motion &motion, std::size_t i) {
  Real force = chain.p[i];
  chain.each_link(i, [&](double stiffness, std::size_t other) {
    if (motion.mode->held[other] != 0) force += stiffness * motion.x[other];
  });
  return force;
}

Watch watch_at(const Chain &chain, const ModalForm &form, const Contact &contact) {
  const std::size_t i = contact.mass;
  const double sign = contact.held ? contact.sigma : -contact.sigma;
  Watch watch{.row = std::vector<Real>(form.size(), Real(0.0))};
  const auto add = [&](double weight, std::size_t mass) {
    for (std::size_t j = 0; j < form.size(); ++j)
      watch.row[j] += sign * weight * form.shape(as_index(mass), as_index(j));
  };
  if (!contact.held) {
    add(1.0, i);
    return watch;
  }
  watch.damping = chain.beta;
  watch.a = sign * chain.a[i];
  watch.b = sign * chain.b[i];
  chain.each_link(i, add);
  return watch;
}

}  // namespace

ModalForm modal_form(const Chain &chain, const Motion &motion, Blocks &blocks) {
  const ContactMode &mode = *motion.mode;
  const auto &[cosine, sine] = motion.turn;
  ModalForm form;
  form.omega = form.fastest = chain.omega;
  const Index size = std::count(mode.held.begin(), mode.held.end(), 0);
  form.shape = RealMatrix::Constant(as_index(chain.masses), size, Real(0.0));
  form.start = {RealVector::Constant(size, Real(0.0)), RealVector::Constant(size, Real(0.0)),
                Eigen::VectorXd::Zero(size), Eigen::VectorXd::Zero(size)};
  Index column = 0;
  for (std::size_t first = 0; first < chain.masses; ++first) {
    if (mode.held[first] != 0) continue;
    std::size_t last = first;
    while (last + 1 < chain.masses && mode.held[last + 1] == 0) ++last;
    std::shared_ptr<const BlockModes> &block = blocks[{first, last}];
    if (!block) block = std::make_shared<const BlockModes>(modes_of_block(chain, first, last));
    const Index n = block->lambda.size();
    form.shape.block(as_index(first), column, n, n) = block->shape;
    for (Index j = 0; j < n; ++j, ++column) {
      const Real &lambda = block->lambda(j);
      form.oscillators.emplace_back(lambda, chain.beta * lambda);
      form.fastest = std::max(form.fastest, form.oscillators.back().rate);
      Real a = 0.0, b = 0.0, c = 0.0;
      for (std::size_t i = first; i <= last; ++i) {
        const Real &s = form.shape(as_index(i), column);
        a += s * chain.a[i];
        b += s * chain.b[i];
        c += s * constant_force(chain, motion, i);
        form.start.y(column) += s * (chain.mass[i] * motion.x[i]);
        form.start.dy(column) += s * (chain.mass[i] * motion.v[i]);
      }
      form.forces.push_back({a * cosine + b * sine, b * cosine - a * sine, c});
    }
    first = last;
  }
  for (const Contact &contact : mode.contacts)
    form.watches.push_back(watch_at(chain, form, contact));
  return form;
}

void fly(const ModalForm &form, const Real &tau, ModalState &to) {
  const ModalState &start = form.start;
  to = start;
  const ComplexOf<Real> wave = wave_at(tau * form.omega);
  for (std::size_t k = 0; k < form.size(); ++k) {
    const Index j = as_index(k);
    const Real travel = tau * start.dy(j);
    const ModalChange<Real> d =
        change(form.oscillators[k], start.y(j), start.dy(j), form.forces[k], form.omega, tau, wave);
    to.y(j) += travel + d.y;
    to.dy(j) += d.dy;
    to.y_terms(j) = std::abs(start.y(j).hi) + std::abs(travel.hi) + std::abs(d.y.hi);
    to.dy_terms(j) = std::abs(start.dy(j).hi) + std::abs(d.dy.hi);
  }
}

void set_masses(const ModalForm &form, const ModalState &state, Motion &motion) {
  for (std::size_t i = 0; i < motion.mode->held.size(); ++i) {
    if (motion.mode->held[i] != 0) continue;
    Real x = 0.0, v = 0.0;
    double x_terms = 0.0, v_terms = 0.0;
    for (Index j = 0; j < state.y.size(); ++j) {
      const Real &s = form.shape(as_index(i), j);
      x += s * state.y(j);
      v += s * state.dy(j);
      x_terms += std::abs(s.hi) * state.y_terms(j);
      v_terms += std::abs(s.hi) * state.dy_terms(j);
    }
    motion.x[i] = x;
    motion.v[i] = v;
    motion.x_terms[i] = x_terms;
    motion.v_terms[i] = v_terms;
  }
  motion.acceleration_known = false;
}

}  // namespace vibro_impact::detail
