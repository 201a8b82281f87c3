// The weights of an expansion, by the adjoint recurrence (lib/README.md): of what is read of the
// lanes, and of the flow of the lanes themselves.
#pragma once

#include <cmath>

#include "polynomial.hpp"
#include "simulation/chain/contact_mode.hpp"

namespace vibro_impact {

// d/dt (P . y + Q . y') = P . y' + Q . (-kappa y' - lambda y + resonant c): the coefficients of the
// next derivative. For the forcing c' = -Omega s, s' = Omega c.
template <int D>
void build_weights(const ContactMode<D> &mode, const Reading<D> &reading, double rate,
                   ReadingWeights &weights) {
  using Eigen::Index;
  const Index lanes = mode.lanes(), modal = mode.modal_lanes(), columns = lanes + modal;
  weights.rate = rate;
  weights.weight.setZero(4, (max_order / 4 + 1) * columns);
  // P and Q of order n; zero of lanes that take no part.
  const auto p = [&](int n, Index j) -> double & {
    return weights.weight(n % 4, (n / 4) * columns + j);
  };
  const auto q = [&](int n, Index j) -> double & { return p(n, lanes + j); };
  for (Index j = 0; j < lanes; ++j)
    if (j >= modal || mode.rate(j) <= rate) p(0, j) = reading.on_value(j);
  for (Index j = 0; j < modal; ++j)
    if (mode.rate(j) <= rate) q(0, j) = reading.on_slope(j);
  const double omega = lanes > modal ? std::sqrt(mode.lambda(lanes - 1)) : 0.0;
  const Index c = modal, s = modal + 1;
  if (lanes > modal) {
    p(0, c) += omega * reading.on_slope(s);
    p(0, s) -= omega * reading.on_slope(c);
  }
  for (int n = 0; n < max_order; ++n) {
    const double scale = 1.0 / (rate * (n + 1));
    double driven = 0.0;
    for (Index j = 0; j < modal; ++j) {
      p(n + 1, j) = -mode.lambda(j) * q(n, j) * scale;
      q(n + 1, j) = (p(n, j) - mode.kappa(j) * q(n, j)) * scale;
      driven += q(n, j) * mode.resonant(j);
    }
    if (lanes == modal) continue;
    p(n + 1, c) = (omega * p(n, s) + driven) * scale;
    p(n + 1, s) = -omega * p(n, c) * scale;
  }
}

template <int D>
void build_flow_weights(const ContactMode<D> &mode, double rate, FlowWeights<D> &weights) {
  using Eigen::Index;
  const Index modal = mode.modal_lanes();
  weights.rate = rate;
  weights.response.setZero(modal + modal % 2, max_order + 2);
  weights.rate_of_response = weights.response;
  for (Index j = 0; j < modal; ++j) {
    if (!(mode.rate(j) <= rate)) continue;
    const double damping = mode.kappa(j) / rate, stiffness = mode.lambda(j) / rate / rate;
    weights.response(j, 1) = 1.0;
    for (int n = 1; n <= max_order; ++n)
      weights.response(j, n + 1) =
          -(damping * n * weights.response(j, n) + stiffness * weights.response(j, n - 1)) /
          (n * (n + 1.0));
    for (int n = 1; n <= max_order; ++n)
      weights.rate_of_response(j, n) = (n + 1) * weights.response(j, n + 1);
  }
  weights.response /= rate;
}

}  // namespace vibro_impact
