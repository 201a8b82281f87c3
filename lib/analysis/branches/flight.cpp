#include "flight.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "simulation/for_analysis.hpp"
#include "tolerances.hpp"
#include "vibro_impact/analysis/parameter.hpp"

namespace vibro_impact::branches {

namespace {

constexpr double longest_step = 1.5;  // in radians of the fastest rate
constexpr double most_steps = 1e6;    // of a flight, which bounds the work beside a stiff link
// A law that is linear in the parameter has an exact difference over this step.
constexpr double law_step = 0x1p-10;

}  // namespace

Model::Model(const Scene &scene, const std::string &parameter, double q) {
  // A number that follows the parameter differs in a scene with another value of it.
  const Scene at = with(scene, parameter, q), other = with(scene, parameter, q + 1.0 + std::abs(q));
  const auto coefficient = [](double value, double with_other) {
    return Coefficient{value, value == with_other ? 0.0 : 1.0};
  };
  const auto list = [&](std::vector<double> Scene::*field) {
    std::vector<Coefficient> numbers(at.mass.size());
    for (size_t i = 0; i < (at.*field).size(); ++i)
      numbers[i] = coefficient((at.*field)[i], (other.*field)[i]);
    return numbers;
  };
  inverse_mass = list(&Scene::mass);
  for (Coefficient &m : inverse_mass) m = {1.0 / m.value, -m.slope / (m.value * m.value)};
  link = list(&Scene::stiffness);
  ground = list(&Scene::ground);
  cosine = list(&Scene::amplitude);
  sine = list(&Scene::sine);
  constant = list(&Scene::constant);
  beta = coefficient(at.beta, other.beta);
  omega = coefficient(at.omega, other.omega);
  const Scene below = with(scene, parameter, q - law_step),
              above = with(scene, parameter, q + law_step);
  for (size_t k = 0; k < at.stops.size(); ++k) {
    const Stop &stop = at.stops[k];
    stops.push_back({static_cast<size_t>(stop.mass - 1), sign(stop.side),
                     coefficient(stop.position, other.stops[k].position), law_of(at, stop),
                     law_of(below, below.stops[k]), law_of(above, above.stops[k])});
  }
  rate = rate_bound(at);
}

Coefficient ModelStop::ratio_at_rest() const {
  return {law.at_rest(), (law_above.at_rest() - law_below.at_rest()) / (2.0 * law_step)};
}

Rebound rebound(const ModelStop &stop, double closing) {
  const double speed = std::abs(closing), side = std::copysign(1.0, closing),
               difference = stop.law_above.after(speed) - stop.law_below.after(speed);
  return {side * stop.law.after(speed), stop.law.slope(speed),
          side * difference / (2.0 * law_step)};
}

Flow::Flow(const Model &model, Eigen::Index columns)
    : model_(model),
      masses_(index(model.masses())),
      x_(most_orders * masses_, columns),
      force_(most_orders * masses_, columns),
      z_(masses_, columns),
      wave_(2, columns) {
}

void Flow::expand(const State &state, Eigen::Index columns, int order) {
  const double unit = radian(), beta = model_.beta.value / unit,
               beta_slope = model_.beta.slope / unit;
  const bool derived = columns > 1;
  const auto row = [columns](Rows &rows, Eigen::Index k) { return rows.row(k).head(columns); };
  auto cosine = row(wave_, 0), sine = row(wave_, 1);
  const double c = std::cos(state.angle(0)), s = std::sin(state.angle(0));
  cosine = -s * state.angle.head(columns);
  sine = c * state.angle.head(columns);
  cosine(0) = c;
  sine(0) = s;
  for (Eigen::Index i = 0; i < masses_; ++i) {
    row(x_, i) = state.y.row(i).head(columns);
    row(x_, masses_ + i) = unit * state.v.row(i).head(columns);
    const int touched = state.touched[static_cast<size_t>(i)];
    if (touched < 0) continue;
    const Coefficient &position = model_.stop(touched).position;
    x_(i, 0) += position.value;
    if (derived) x_(i, 1) += position.slope;
  }
  for (int k = 0; k + 2 <= order; ++k) {
    const Eigen::Index at = k * masses_;
    for (Eigen::Index i = 0; i < masses_; ++i) {
      row(z_, i) = row(x_, at + i) + (beta * (k + 1)) * row(x_, at + masses_ + i);
      if (derived) z_(i, 1) += beta_slope * (k + 1) * x_(at + masses_ + i, 0);
    }
    for (Eigen::Index i = 0; i < masses_; ++i) {
      const auto mass = static_cast<size_t>(i);
      const Coefficient &a = model_.cosine[mass], &b = model_.sine[mass], &g = model_.ground[mass],
                        &below = model_.link[mass], &p = model_.constant[mass];
      auto f = row(force_, at + i);
      f = a.value * cosine + b.value * sine - g.value * row(z_, i);
      if (i > 0)
        f -= below.value * (row(z_, i) - row(z_, i - 1));
      else
        f -= below.value * row(z_, i);
      if (i + 1 < masses_) f += model_.link[mass + 1].value * (row(z_, i + 1) - row(z_, i));
      if (k == 0) f(0) += p.value;
      if (derived) {
        f(1) += a.slope * cosine(0) + b.slope * sine(0) - g.slope * z_(i, 0) -
                below.slope * (z_(i, 0) - (i > 0 ? z_(i - 1, 0) : 0.0));
        if (i + 1 < masses_) f(1) += model_.link[mass + 1].slope * (z_(i + 1, 0) - z_(i, 0));
        if (k == 0) f(1) += p.slope;
      }
      const double factor = state.held[mass] >= 0 ? 0.0 : unit * unit / ((k + 1) * (k + 2));
      row(x_, at + 2 * masses_ + i) = (factor * model_.inverse_mass[mass].value) * f;
      if (derived) x_(at + 2 * masses_ + i, 1) += factor * model_.inverse_mass[mass].slope * f(0);
    }
    const double turn = unit * model_.omega.value / (k + 1),
                 by_parameter = unit * model_.omega.slope / (k + 1), c0 = cosine(0), s0 = sine(0);
    for (Eigen::Index j = 0; j < columns; ++j) {
      const double before = cosine(j);
      cosine(j) = -turn * sine(j);
      sine(j) = turn * before;
    }
    if (derived) {
      cosine(1) -= by_parameter * s0;
      sine(1) += by_parameter * c0;
    }
  }
}

void Flow::move(State &state, double time, Eigen::Index columns, const Watch &watch) {
  const double radians = std::abs(time) * model_.rate;
  if (!(radians <= most_steps * longest_step))
    throw std::runtime_error(
        line("a flight of ", time, " takes more than ", most_steps, " steps of the fastest mode"));
  const int steps = std::max(1, static_cast<int>(std::ceil(radians / longest_step)));
  const double h = time / steps;
  // The terms fall as those of the exponential series.
  int order = 3;
  double term = 1.0;
  for (int k = 1; k <= order || 2.0 * term > 0.2 * rounding; ++k) {
    term *= radians / steps / k;
    order = std::max(order, k);
    if (order + 2 >= most_orders) break;
  }
  for (int step = 0; step < steps; ++step) {
    expand(state, columns, order);
    if (watch) watch(step * h, h, order);
    const double u = h / radian();
    for (Eigen::Index i = 0; i < masses_; ++i) {
      if (state.held[static_cast<size_t>(i)] >= 0) continue;
      for (Eigen::Index j = 0; j < columns; ++j) {
        double y = x_(order * masses_ + i, j), v = order * y;
        for (int k = order - 1; k >= 1; --k) {
          const double coefficient = x_(k * masses_ + i, j);
          y = coefficient + u * y;
          if (k >= 2) v = k * coefficient + u * v;
        }
        state.y(i, j) += u * y;
        state.v(i, j) += u * v / radian();
      }
    }
    state.angle(0) += model_.omega.value * h;
    if (columns > 1) state.angle(1) += model_.omega.slope * h;
  }
}

void Flow::fly(State &state, double time, const Watch &watch) {
  move(state, time, 1, watch);
}

// The flight is derived by the parameter and by the state at its start alone. The chain rule gives
// the derivatives by all unknowns before.
void Flow::fly(State &state, double time, Eigen::Index by, Eigen::Index columns) {
  const Eigen::Index own = 3 + 2 * masses_;  // value, q, angle, y, v
  State local{Rows::Zero(masses_, own), Rows::Zero(masses_, own), Row::Zero(own), state.touched,
              state.held};
  Rows at_start(1 + 2 * masses_, columns - 1);
  local.angle(0) = state.angle(0);
  local.angle(2) = 1.0;
  at_start.row(0) = state.angle.segment(1, columns - 1);
  for (Eigen::Index i = 0; i < masses_; ++i) {
    local.y(i, 0) = state.y(i, 0);
    local.v(i, 0) = state.v(i, 0);
    at_start.row(1 + i) = state.y.row(i).segment(1, columns - 1);
    at_start.row(1 + masses_ + i) = state.v.row(i).segment(1, columns - 1);
    if (state.held[static_cast<size_t>(i)] >= 0) continue;
    local.y(i, 3 + i) = 1.0;
    local.v(i, 3 + masses_ + i) = 1.0;
  }
  move(local, time, own, {});
  expand(local, 1, 2);
  state.angle(0) = local.angle(0);
  state.angle(1) += local.angle(1);
  state.angle(by) += model_.omega.value;
  for (Eigen::Index i = 0; i < masses_; ++i) {
    if (state.held[static_cast<size_t>(i)] >= 0) continue;
    const auto chain_rule = [&](Rows &to, const Rows &from) {
      to.row(i).segment(1, columns - 1) =
          (from.row(i).tail(own - 2).matrix() * at_start.matrix()).array();
      to(i, 0) = from(i, 0);
      to(i, 1) += from(i, 1);
    };
    chain_rule(state.y, local.y);
    chain_rule(state.v, local.v);
    state.y(i, by) += local.v(i, 0);
    state.v(i, by) += 2.0 * displacement(2, static_cast<size_t>(i))(0) / (radian() * radian());
  }
}

}  // namespace vibro_impact::branches
