#include "contact_mode.hpp"

#include <Eigen/Eigenvalues>
#include <cmath>
#include <limits>

#include "polynomial.hpp"

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
    double total = 0.0, reached = 0.0;
    for (std::size_t j = i; j <= anchor && j < n; ++j) total += 1.0 / scene.stiffness[j];
    for (std::size_t j = i; j < anchor; ++j) {
      reached += 1.0 / scene.stiffness[j];
      x(static_cast<Eigen::Index>(j)) = left + (right - left) * (reached / total);
    }
    if (anchor < n) x(static_cast<Eigen::Index>(anchor)) = right;
    left = right;
    i = anchor + 1;
  }
  return x;
}

// Modes of the free masses: M^-1/2 K M^-1/2 on the free rows is tridiagonal; links to held masses
// only stiffen it. `shape` is N x modes (zero rows for held masses), `inverse` its left inverse.
struct Decomposition {
  Eigen::VectorXd lambda;
  Eigen::MatrixXd shape, inverse;
};

Decomposition decompose(const Scene &scene, const std::vector<std::size_t> &free) {
  using Eigen::Index;
  const std::size_t n = scene.mass.size();
  const auto modes = static_cast<Index>(free.size());
  Decomposition basis;
  basis.lambda.setZero(modes);
  basis.shape.setZero(static_cast<Index>(n), modes);
  basis.inverse.setZero(modes, static_cast<Index>(n));
  if (modes == 0) return basis;
  Eigen::VectorXd diagonal(modes), off(modes - 1);
  for (Index a = 0; a < modes; ++a) {
    const std::size_t i = free[static_cast<std::size_t>(a)];
    const double k_right = i + 1 < n ? scene.stiffness[i + 1] : 0.0;
    diagonal(a) = (scene.stiffness[i] + k_right) / scene.mass[i];
    if (a + 1 < modes)
      off(a) = free[static_cast<std::size_t>(a) + 1] == i + 1
                   ? -k_right / std::sqrt(scene.mass[i] * scene.mass[i + 1])
                   : 0.0;
  }
  Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver;
  solver.computeFromTridiagonal(diagonal, off);
  basis.lambda = solver.eigenvalues();
  for (Index j = 0; j < modes; ++j) {
    const double orient = solver.eigenvectors()(modes - 1, j) < 0.0 ? -1.0 : 1.0;
    for (Index a = 0; a < modes; ++a) {
      const auto i = free[static_cast<std::size_t>(a)];
      const double u = orient * solver.eigenvectors()(a, j), root_m = std::sqrt(scene.mass[i]);
      basis.shape(static_cast<Index>(i), j) = u / root_m;
      basis.inverse(j, static_cast<Index>(i)) = u * root_m;
    }
    // The eigenvalue again as twice the energy in the links. The solver leaves it an error relative
    // to the largest one, which a soft mode beside a stiff link does not survive.
    double energy = 0.0;
    for (std::size_t i = 0; i < n; ++i) {
      const auto row = static_cast<Index>(i);
      const double stretch = basis.shape(row, j) - (i > 0 ? basis.shape(row - 1, j) : 0.0);
      energy += scene.stiffness[i] * stretch * stretch;
    }
    basis.lambda(j) = energy;
  }
  return basis;
}

}  // namespace

// The force on mass p towards +x from its neighbours and the forcing, with the mass itself at rest
// at its stop (Eqs. 12-13), times sigma: positive when it presses into the stop. Lanes of `mode`.
template <int D>
Reading<D> press_reading(const Scene &scene, const ContactMode<D> &mode, const Stop &stop) {
  const auto p = static_cast<Eigen::Index>(stop.mass - 1);
  const Eigen::Index n = mode.equilibrium.size();
  const double sigma = sign(stop.side), k_left = scene.stiffness[static_cast<std::size_t>(p)];
  Reading<D> reading;
  reading.on_value.setZero(mode.lanes());
  reading.on_slope.setZero(mode.lanes());
  const auto add_neighbour = [&](Eigen::Index j, double k) {
    reading.offset += sigma * k * (mode.equilibrium(j) - stop.position);
    reading.on_value += sigma * k * mode.shape.row(j).transpose().array();
    reading.on_slope += sigma * scene.beta * k * mode.shape.row(j).transpose().array();
  };
  if (p > 0) add_neighbour(p - 1, k_left);
  if (p == 0) reading.offset -= sigma * k_left * stop.position;
  if (p + 1 < n) add_neighbour(p + 1, scene.stiffness[static_cast<std::size_t>(p + 1)]);
  if (scene.forced())
    reading.on_value(mode.lanes() - 2) += sigma * scene.amplitude[static_cast<std::size_t>(p)];
  return reading;
}

template <int D>
ContactMode<D> build_contact_mode(const Scene &scene, const Held &held) {
  using Eigen::Index;
  const std::size_t n = scene.mass.size();
  std::vector<std::size_t> free;
  std::vector<double> held_at(n, 0.0);
  for (std::size_t i = 0; i < n; ++i)
    if (held[i] == 0) free.push_back(i);
  for (const Stop &stop : scene.stops) {
    const auto i = static_cast<std::size_t>(stop.mass - 1);
    if (static_cast<double>(held[i]) == sign(stop.side)) held_at[i] = stop.position;
  }

  const auto modes = static_cast<Index>(free.size());
  const Index forcing = scene.forced() ? 2 : 0;
  const Decomposition basis = decompose(scene, free);
  Index split = 0;
  for (Index j = 0; j < modes; ++j)
    if (strongly_damped(scene.beta, basis.lambda(j))) ++split;
  const Index lanes = D == Eigen::Dynamic ? modes + split + forcing : Index(D);

  ContactMode<D> mode;
  mode.held = held;
  mode.forcing_lanes = forcing;
  for (auto *array : {&mode.kappa, &mode.lambda, &mode.rate, &mode.resonant}) array->setZero(lanes);
  mode.decay.setConstant(lanes, false);
  mode.equilibrium = static_positions(scene, held, held_at);
  mode.shape.setZero(static_cast<Index>(n), lanes);
  mode.to_modal.setZero(lanes, static_cast<Index>(n));
  mode.velocity_to_modal.setZero(lanes, static_cast<Index>(n));

  const double omega2 = scene.omega * scene.omega;
  for (Index j = 0, lane = 0; j < modes; ++j, ++lane) {
    const double lambda = basis.lambda(j), kappa = scene.beta * lambda;
    mode.shape.col(lane) = basis.shape.col(j);
    mode.to_modal.row(lane) = basis.inverse.row(j);
    mode.kappa(lane) = kappa;
    mode.lambda(lane) = lambda;
    if (forcing) {
      double force = 0.0;  // Psi^T A of Eq. 7
      for (std::size_t i : free)
        force += basis.shape(static_cast<Index>(i), j) * scene.amplitude[i];
      const double detuning = lambda - omega2, loss = kappa * scene.omega;
      const double squared = detuning * detuning + loss * loss;
      if (std::sqrt(squared) < 0.015625 * (lambda + omega2)) {
        mode.resonant(lane) = force;  // splitting off the steady response would cancel digits
        mode.any_resonant = mode.any_resonant || force != 0.0;
      } else {
        mode.shape.col(lanes - 2) += basis.shape.col(j) * (force * (detuning / squared));
        mode.shape.col(lanes - 1) += basis.shape.col(j) * (force * (loss / squared));
      }
    }
    if (D == Eigen::Dynamic && strongly_damped(scene.beta, lambda)) {
      // y = y1 + y2 with decays fast > slow: y1 = (fast y + y') / (fast - slow), y2 = y - y1.
      const double fast = kappa / 2 + std::sqrt(kappa * kappa / 4 - lambda), slow = lambda / fast;
      const Index other = lane + 1;
      mode.shape.col(other) = basis.shape.col(j);
      mode.to_modal.row(lane) = basis.inverse.row(j) * (fast / (fast - slow));
      mode.velocity_to_modal.row(lane) = basis.inverse.row(j) / (fast - slow);
      mode.to_modal.row(other) = basis.inverse.row(j) * (-slow / (fast - slow));
      mode.velocity_to_modal.row(other) = -mode.velocity_to_modal.row(lane);
      mode.kappa(lane) = slow;
      mode.kappa(other) = fast;
      mode.lambda(lane) = mode.lambda(other) = 0.0;
      mode.decay(lane) = mode.decay(other) = mode.any_decay = true;
      lane = other;
    }
  }
  if (forcing) mode.lambda(lanes - 2) = mode.lambda(lanes - 1) = omega2;
  double slowest = std::numeric_limits<double>::infinity();
  for (Index j = 0; j < lanes; ++j) {
    mode.rate(j) = root_modulus(mode.kappa(j), mode.lambda(j));
    mode.fastest = std::max(mode.fastest, mode.rate(j));
    if (mode.rate(j) > 0.0) slowest = std::min(slowest, mode.rate(j));
  }
  mode.stiff = scene.beta > 0.0 && mode.fastest > 16.0 * slowest;
  mode.extent = mode.shape.cwiseAbs().colwise().maxCoeff().transpose().array();

  for (std::size_t k = 0; k < scene.stops.size(); ++k) {
    const Stop &stop = scene.stops[k];
    const auto i = static_cast<std::size_t>(stop.mass - 1);
    const double sigma = sign(stop.side);
    if (held[i] == 0) {
      const auto row = static_cast<Index>(i);
      Reading<D> gap{-sigma * mode.shape.row(row).transpose().array(),
                     {},
                     sigma * (stop.position - mode.equilibrium(row)),
                     {}};
      gap.on_slope.setZero(lanes);
      mode.open.push_back({k, i, gap, press_reading(scene, mode, stop)});
    } else if (static_cast<double>(held[i]) == sigma) {
      mode.closed.push_back({k, i, press_reading(scene, mode, stop)});
    }
  }
  return mode;
}

// Bernstein coefficients of (rate tau)^n over the longest span, n by n: b_i = (i over n) / (d over
// n) max_reach^n; and max_reach^n alone.
struct BernsteinTable {
  std::array<std::array<double, bernstein_degree + 1>, bernstein_degree + 1> coefficient{};
  detail::Powers power{};

  BernsteinTable() {
    detail::set_powers(power, max_reach, max_order);
    for (std::size_t i = 0; i <= bernstein_degree; ++i) {
      double ratio = 1.0;
      for (std::size_t n = 0; n <= i; ++n) {
        coefficient[n][i] = power[n] * ratio;
        ratio *= static_cast<double>(i - n) / static_cast<double>(bernstein_degree - n);
      }
    }
  }
};
const BernsteinTable bernstein_table;

void build_bernstein(ReadingSeries &series, Eigen::Index columns) {
  using detail::Four, detail::four;
  constexpr Eigen::Index groups = (bernstein_degree + 1) / 4;
  series.bernstein.setZero(4, groups * columns);
  series.cut_off.setZero(columns);
  for (Eigen::Index column = 0; column < columns; ++column) {
    Four size = Four::Zero(), cut_off = size;
    for (Eigen::Index group = 0; 4 * group <= max_order; ++group) {
      const Four terms = series.weight.col(group * columns + column).abs() *
                         four(bernstein_table.power.data() + 4 * group);
      size += terms;
      if (group >= groups) cut_off += terms;
    }
    series.cut_off(column) = cut_off.sum() + 0x1p-44 * size.sum();  // and rounding
    for (std::size_t n = 0; n <= bernstein_degree; ++n) {
      const auto k = static_cast<Eigen::Index>(n);
      const double weight = series.weight(k % 4, k / 4 * columns + column);
      for (Eigen::Index group = k / 4; group < groups; ++group)
        series.bernstein.col(group * columns + column) +=
            weight * four(bernstein_table.coefficient[n].data() + 4 * group);
    }
  }
}

// d/dt (P . y + Q . y') = P . y' + Q . (-kappa y' - lambda y + resonant c): the coefficients of the
// next derivative. For the forcing c' = -Omega s, s' = Omega c.
template <int D>
void build_series(const ContactMode<D> &mode, const Reading<D> &reading, double rate) {
  using Eigen::Index;
  using Column = Eigen::Array<double, Eigen::Dynamic, 1>;
  const Index lanes = mode.lanes(), modal = mode.modal_lanes(), columns = lanes + modal;
  ReadingSeries &series = reading.series;
  series.rate = rate;
  series.weight.setZero(4, (max_order / 4 + 1) * columns);
  if (rate == 0.0) return build_bernstein(series, columns);  // nothing moves
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
    series.weight.row(n % 4).segment(group, lanes) = p;
    series.weight.row(n % 4).segment(group + lanes, modal) = q;
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
  build_bernstein(series, columns);
}

template <int D>
void build_flow_series(const ContactMode<D> &mode, double rate) {
  using Eigen::Index;
  const Index modal = mode.modal_lanes();
  FlowSeries<D> &series = mode.series;
  series.rate = rate;
  series.response.setZero(modal + modal % 2, max_order + 2);
  series.rate_of_response = series.response;
  if (rate == 0.0) return;
  for (Index j = 0; j < modal; ++j) {
    if (!(mode.rate(j) <= rate)) continue;
    const double damping = mode.kappa(j) / rate, stiffness = mode.lambda(j) / rate / rate;
    series.response(j, 1) = 1.0;
    for (int n = 1; n <= max_order; ++n)
      series.response(j, n + 1) =
          -(damping * n * series.response(j, n) + stiffness * series.response(j, n - 1)) /
          (n * (n + 1.0));
    for (int n = 0; n <= max_order; ++n)
      series.rate_of_response(j, n) = (n + 1) * series.response(j, n + 1);
  }
  series.response /= rate;
}

template ContactMode<3> build_contact_mode<3>(const Scene &, const Held &);
template void build_series<3>(const ContactMode<3> &, const Reading<3> &, double);
template void build_flow_series<3>(const ContactMode<3> &, double);
template ContactMode<4> build_contact_mode<4>(const Scene &, const Held &);
template void build_series<4>(const ContactMode<4> &, const Reading<4> &, double);
template void build_flow_series<4>(const ContactMode<4> &, double);
template ContactMode<5> build_contact_mode<5>(const Scene &, const Held &);
template void build_series<5>(const ContactMode<5> &, const Reading<5> &, double);
template void build_flow_series<5>(const ContactMode<5> &, double);
template ContactMode<Eigen::Dynamic> build_contact_mode<Eigen::Dynamic>(const Scene &,
                                                                        const Held &);
template void build_series<Eigen::Dynamic>(const ContactMode<Eigen::Dynamic> &,
                                           const Reading<Eigen::Dynamic> &, double);
template void build_flow_series<Eigen::Dynamic>(const ContactMode<Eigen::Dynamic> &, double);

}  // namespace vibro_impact
