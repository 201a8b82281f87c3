#include "tangent_flow.hpp"

#include <utility>

#include "simulation/for_analysis.hpp"

namespace vibro_impact {

namespace {

// A short time, in physical coordinates: late in a chatter the change of the chattering mass is
// small, and modal coordinates would lose it beside the others. For the same reason the series goes
// on until its terms lie below the rounding not of the sum but, in every column, of the first
// curved ones: the chatter is made of these. Two in a row, because without damping every other term
// of a column may be zero.
void carry_by_series(const Scene &scene, const Held &held, double tau, Eigen::MatrixXd &changes) {
  constexpr double below_rounding = 0x1p-56;
  const Eigen::Index n = changes.rows() / 2;
  Eigen::MatrixXd before = changes.topRows(n), last = tau * changes.bottomRows(n);
  Eigen::MatrixXd x = before + last, v = last;  // v in units of 1 / tau
  Eigen::RowVectorXd size_before = Eigen::RowVectorXd::Zero(changes.cols()), largest = size_before;
  for (int order = 0;; ++order) {
    Eigen::MatrixXd term = next_term(scene, held, tau, order, before, last);
    x += term;
    v += (order + 2) * term;
    const Eigen::RowVectorXd size = (order + 2) * term.cwiseAbs().colwise().maxCoeff();
    largest = largest.cwiseMax(size);
    const bool above =
        (size.cwiseMax(size_before).array() > below_rounding * largest.array()).any();
    if (order > 0 && !above) break;
    size_before = size;
    before = std::move(last);
    last = std::move(term);
  }
  changes << x, v / tau;
}

// Any time, in closed form: mode by mode, by the response to a unit change of value and of slope.
void carry_by_modes(const ContactMode<Eigen::Dynamic> &mode, double tau, Eigen::MatrixXd &changes) {
  const Eigen::Index n = changes.rows() / 2;
  const Eigen::MatrixXd x = changes.topRows(n), v = changes.bottomRows(n);
  const Eigen::MatrixXd value = mode.to_modal * x + mode.velocity_to_modal * v,
                        slope = mode.to_modal * v;
  const Eigen::ArrayXd one = Eigen::ArrayXd::Ones(mode.lanes()), none = 0.0 * one;
  Eigen::ArrayXd value_by_value, slope_by_value, value_by_slope, slope_by_slope;
  flow(mode, one, none, tau, value_by_value, slope_by_value);
  flow(mode, none, one, tau, value_by_slope, slope_by_slope);
  changes << mode.shape * (value_by_value.matrix().asDiagonal() * value +
                           value_by_slope.matrix().asDiagonal() * slope),
      mode.shape * (slope_by_value.matrix().asDiagonal() * value +
                    slope_by_slope.matrix().asDiagonal() * slope);
}

}  // namespace

Eigen::MatrixXd next_term(const Scene &scene, const Held &held, double tau, int n,
                          const Eigen::MatrixXd &before, const Eigen::MatrixXd &last) {
  using Eigen::Index;
  const Eigen::MatrixXd pulling = tau * tau * before + (tau * scene.beta * (n + 1)) * last;
  Eigen::MatrixXd term = Eigen::MatrixXd::Zero(before.rows(), before.cols());
  for (Index column = 0; column < term.cols(); ++column) {
    const auto pull = [&](std::size_t j) { return pulling(static_cast<Index>(j), column); };
    for (std::size_t i = 0; i < held.size(); ++i)
      if (held[i] == 0)
        term(static_cast<Index>(i), column) =
            link_force(scene, i, pull(i), pull) / (scene.mass[i] * (n + 1.0) * (n + 2.0));
  }
  return term;
}

TangentFlow tangent_flow(const Scene &scene) {
  TangentFlow flow{scene};
  flow.unforced.amplitude.clear();
  flow.unforced.stops.clear();  // they shift the static positions, not the changes
  return flow;
}

double fastest_rate(TangentFlow &flow, const Held &held) {
  return flow.modes.enter(flow.unforced, held, flow.counters).fastest;
}

void carry(TangentFlow &flow, const Held &held, double tau, Eigen::MatrixXd &changes) {
  if (!(tau > 0.0) || changes.cols() == 0) return;
  const auto &mode = flow.modes.enter(flow.unforced, held, flow.counters);
  if (mode.fastest * tau < 0.5)
    carry_by_series(flow.unforced, held, tau, changes);
  else
    carry_by_modes(mode, tau, changes);
}

}  // namespace vibro_impact
