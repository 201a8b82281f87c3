// This file is C++17: uBLAS, on which Odeint's Rosenbrock method rests, calls members of
// std::allocator (Boost 1.74) that C++20 no longer has.
#include "stiff_spring.hpp"

#include <algorithm>
#include <boost/numeric/odeint.hpp>
#include <cmath>
#include <functional>
#include <stdexcept>
#include <utility>

#include "rodas.hpp"

namespace vibro_impact::stiff_spring {

namespace {

using State = boost::numeric::ublas::vector<double>;
using Jacobian = boost::numeric::ublas::matrix<double>;

// M x'' + C x' + K x = A cos(Omega t) (Eqs. 1-4) with the springs of the stops, and its
// derivatives.
struct Equations {
  const Scene &scene;
  double kappa, zeta;
  long long *evaluations, *jacobians;

  double gap(const Stop &stop, const State &y) const {
    return sign(stop.side) * (stop.position - y(static_cast<std::size_t>(stop.mass - 1)));
  }
  double damper(std::size_t i) const {
    return 2.0 * zeta * std::sqrt(kappa * scene.mass[i]);
  }

  void operator()(const State &y, State &rate, double t) const {
    ++*evaluations;
    const std::size_t n = scene.mass.size();
    for (std::size_t i = 0; i < n; ++i) {
      rate(i) = y(n + i);
      rate(n + i) = scene.amplitude.empty() ? 0.0 : scene.amplitude[i] * std::cos(scene.omega * t);
    }
    for (std::size_t i = 0; i < n; ++i) {
      double stretch = y(i) + scene.beta * y(n + i);
      if (i > 0) stretch -= y(i - 1) + scene.beta * y(n + i - 1);
      rate(n + i) -= scene.stiffness[i] * stretch;
      if (i > 0) rate(n + i - 1) += scene.stiffness[i] * stretch;
    }
    for (const Stop &stop : scene.stops) {
      const auto i = static_cast<std::size_t>(stop.mass - 1);
      if (gap(stop, y) < 0.0) rate(n + i) -= kappa * (y(i) - stop.position) + damper(i) * y(n + i);
    }
    for (std::size_t i = 0; i < n; ++i) rate(n + i) /= scene.mass[i];
  }

  void operator()(const State &y, Jacobian &by_state, double t, State &by_time) const {
    ++*jacobians;
    const std::size_t n = scene.mass.size();
    by_state.clear();
    by_time.clear();
    // A spring `stiffness` and damper `loss` from mass i to mass j on the row of mass i.
    const auto link = [&](std::size_t i, std::size_t j, double stiffness, double loss) {
      by_state(n + i, j) += stiffness / scene.mass[i];
      by_state(n + i, n + j) += loss / scene.mass[i];
    };
    for (std::size_t i = 0; i < n; ++i) {
      const double k = scene.stiffness[i], c = scene.beta * k;
      by_state(i, n + i) = 1.0;
      link(i, i, -k, -c);
      if (i > 0) {
        link(i, i - 1, k, c);
        link(i - 1, i, k, c);
        link(i - 1, i - 1, -k, -c);
      }
      if (!scene.amplitude.empty())
        by_time(n + i) =
            -scene.amplitude[i] * scene.omega * std::sin(scene.omega * t) / scene.mass[i];
    }
    for (const Stop &stop : scene.stops) {
      const auto i = static_cast<std::size_t>(stop.mass - 1);
      if (gap(stop, y) < 0.0) link(i, i, -kappa, -damper(i));
    }
  }
};

// Steps `stepper` to `until`; the beginnings of contact are bisected on its dense output.
template <class DenseOutput, class System>
void step_through(DenseOutput &&stepper, const System &system, const Equations &equations,
                  double until, long long max_evaluations, Result &result) {
  const std::vector<Stop> &stops = equations.scene.stops;
  State y(2 * equations.scene.mass.size());
  for (std::size_t i = 0; i < y.size(); ++i) y(i) = result.state[i];
  stepper.initialize(y, 0.0, 1e-3);
  while (stepper.current_time() < until && result.broke.empty()) {
    const State before = stepper.current_state();
    try {
      stepper.do_step(system);
    } catch (const boost::numeric::odeint::step_adjustment_error &) {
      result.broke = "step size could not be found";
      break;
    }
    ++result.steps;
    const double left = stepper.previous_time(), right = stepper.current_time();
    if (!(right > left))
      result.broke = "step underflow";
    else if (result.evaluations >= max_evaluations)
      result.broke = "too many evaluations";
    for (const Stop &stop : stops) {
      if (!(equations.gap(stop, before) > 0.0) ||
          equations.gap(stop, stepper.current_state()) > 0.0)
        continue;
      double free = left, touching = right;
      while (true) {
        const double middle = free + (touching - free) / 2;
        if (!(middle > free && middle < touching)) break;
        stepper.calc_state(middle, y);
        (equations.gap(stop, y) > 0.0 ? free : touching) = middle;
      }
      if (touching <= until) result.contacts.push_back({touching, stop.mass});
    }
  }
  result.time = std::min(until, stepper.current_time());
  y = stepper.current_state();
  if (result.time > stepper.previous_time()) stepper.calc_state(result.time, y);
  result.state.assign(y.begin(), y.end());
  std::sort(result.contacts.begin(), result.contacts.end(),
            [](const Contact &a, const Contact &b) { return a.time < b.time; });
}

}  // namespace

double damping_ratio(double r) {
  const double log = std::log(r);
  return -log / std::hypot(std::acos(-1.0), log);
}

Result integrate(const Scene &scene, double until, const Options &options) {
  check(scene);
  if (!(scene.restitution > 0.0))
    throw std::invalid_argument("restitution = 0: no damper gives it to a stop");
  Result result;
  const std::size_t n = scene.mass.size();
  result.state.assign(2 * n, 0.0);
  std::copy(scene.displacement.begin(), scene.displacement.end(), result.state.begin());
  std::copy(scene.velocity.begin(), scene.velocity.end(),
            result.state.begin() + static_cast<std::ptrdiff_t>(n));
  const Equations equations{scene, options.kappa, damping_ratio(scene.restitution),
                            &result.evaluations, &result.jacobians};
  namespace odeint = boost::numeric::odeint;
  if (options.stepper == Stepper::dopri5)
    step_through(odeint::make_dense_output(options.tolerance, options.tolerance,
                                           odeint::runge_kutta_dopri5<State>()),
                 equations, equations, until, options.max_evaluations, result);
  else
    step_through(odeint::make_dense_output(options.tolerance, options.tolerance,
                                           odeint::rosenbrock4<double, Rodas>()),
                 std::make_pair(std::cref(equations), std::cref(equations)), equations, until,
                 options.max_evaluations, result);
  return result;
}

}  // namespace vibro_impact::stiff_spring
