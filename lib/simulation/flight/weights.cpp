#include "expansion.hpp"

namespace vibro_impact {

// d/dt (P . y + Q . y') = P . y' + Q . (-kappa y' - lambda y + resonant c): the coefficients of the
// next derivative. For the forcing c' = -Omega s, s' = Omega c.
template <int D>
void build_weights(const ContactMode<D> &mode, const Reading<D> &reading, double rate,
                   ReadingWeights &weights) {
  using Eigen::Index;
  using Column = Eigen::Array<double, Eigen::Dynamic, 1>;
  const Index lanes = mode.lanes(), modal = mode.modal_lanes(), columns = lanes + modal;
  weights.rate = rate;
  weights.weight.setZero(4, (max_order / 4 + 1) * columns);
  const auto takes_part = [&](Index j) { return mode.rate(j) <= rate; };
  Column p = reading.on_value, q = reading.on_slope.head(modal);
  const double omega = lanes > modal ? std::sqrt(mode.lambda(lanes - 1)) : 0.0;
  if (lanes > modal) {
    p(modal) += omega * reading.on_slope(modal + 1);
    p(modal + 1) -= omega * reading.on_slope(modal);
  }
  for (Index j = 0; j < modal; ++j)
    if (!takes_part(j)) p(j) = q(j) = 0.0;
  for (int n = 0; n <= max_order; ++n) {
    const Index group = (n / 4) * columns;
    weights.weight.row(n % 4).segment(group, lanes) = p;
    weights.weight.row(n % 4).segment(group + lanes, modal) = q;
    const double scale = 1.0 / (rate * (n + 1));
    double on_cosine = 0.0, on_sine = 0.0;
    if (lanes > modal) {
      on_cosine = omega * p(modal + 1) + (q * mode.resonant.head(modal)).sum();
      on_sine = -omega * p(modal);
    }
    for (Index j = 0; j < modal; ++j) {
      const double before = p(j);
      p(j) = takes_part(j) ? -mode.lambda(j) * q(j) * scale : 0.0;
      q(j) = takes_part(j) ? (before - mode.kappa(j) * q(j)) * scale : 0.0;
    }
    if (lanes > modal) p.tail(2) << on_cosine * scale, on_sine * scale;
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
    for (int n = 0; n <= max_order; ++n)
      weights.rate_of_response(j, n) = (n + 1) * weights.response(j, n + 1);
  }
  weights.response /= rate;
}

template void build_weights(const ContactMode<4> &, const Reading<4> &, double, ReadingWeights &);
template void build_flow_weights(const ContactMode<4> &, double, FlowWeights<4> &);
template void build_weights(const ContactMode<Eigen::Dynamic> &, const Reading<Eigen::Dynamic> &,
                            double, ReadingWeights &);
template void build_flow_weights(const ContactMode<Eigen::Dynamic> &, double,
                                 FlowWeights<Eigen::Dynamic> &);

}  // namespace vibro_impact
