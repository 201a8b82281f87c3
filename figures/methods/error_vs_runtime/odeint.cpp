// Boost.Odeint: its explicit steppers with dense output, rosenbrock4, and runge_kutta_fehlberg78,
// which has no dense output. The states of rosenbrock4 are uBLAS vectors, and uBLAS as of
// Boost 1.74 is not C++20: this file is compiled as C++17.
#include <boost/numeric/odeint/stepper/bulirsch_stoer_dense_out.hpp>
#include <boost/numeric/odeint/stepper/controlled_runge_kutta.hpp>
#include <boost/numeric/odeint/stepper/dense_output_runge_kutta.hpp>
#include <boost/numeric/odeint/stepper/generation.hpp>
#include <boost/numeric/odeint/stepper/rosenbrock4.hpp>
#include <boost/numeric/odeint/stepper/rosenbrock4_controller.hpp>
#include <boost/numeric/odeint/stepper/rosenbrock4_dense_output.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_dopri5.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_fehlberg78.hpp>
#include <utility>

#include "event_loop.hpp"

namespace vibro_impact::comparison {

namespace {

using namespace boost::numeric::odeint;

using UblasVector = boost::numeric::ublas::vector<double>;
using UblasMatrix = boost::numeric::ublas::matrix<double>;

// The right-hand side as Odeint calls it.
struct System {
  const TwoMasses &chain;
  const GapState &now;
  long long &evaluations;

  template <class State>
  void operator()(const State &y, State &dydt, double tau) const {
    ++evaluations;
    right_hand_side(chain, now.held, y, dydt, now.time + tau);
  }
};

// Its derivatives by the state and by the time.
struct Jacobian {
  const TwoMasses &chain;
  const GapState &now;

  void operator()(const UblasVector &, UblasMatrix &jacobi, double tau, UblasVector &dfdt) const {
    jacobi.clear();
    set_jacobian(chain, now.held, [&](std::size_t row, std::size_t column, double value) {
      jacobi(row, column) = value;
    });
    for (std::size_t i = 0; i < 2; ++i) {
      dfdt[2 * i] = 0.0;
      dfdt[2 * i + 1] = now.held[i] ? 0.0
                                    : -chain.equation[i].drive * chain.omega *
                                          std::sin(chain.omega * (now.time + tau));
    }
  }
};

template <class Stepper>
Result run_explicit(const Problem &problem, const Stepper &stepper, double tolerance) {
  return with_events(problem, stick_below(tolerance),
                     [&](const TwoMasses &chain, const GapState &now, long long &work) {
                       return DenseOutput<Vec, Stepper, System>{now, stepper, {chain, now, work}};
                     });
}

Result dormand_prince(const Problem &problem, double tolerance) {
  return run_explicit(problem, make_dense_output(tolerance, tolerance, runge_kutta_dopri5<Vec>()),
                      tolerance);
}

// Steps are kept below a quarter of the fastest cycle, and the interpolant is put under the error
// control too.
Result bulirsch_stoer(const Problem &problem, double tolerance) {
  constexpr double longest_step = 1.0;
  return run_explicit(
      problem, bulirsch_stoer_dense_out<Vec>(tolerance, tolerance, 1.0, 0.0, longest_step, true),
      tolerance);
}

// Odeint (Boost 1.74) has d4 of RODAS (Hairer and Wanner, Solving Ordinary Differential Equations
// II) with the wrong sign: the method is of order four for autonomous systems, but of order one
// under forcing.
struct Rodas : default_rosenbrock_coefficients<double> {
  const double d4 = -0.03620000000000023;
};

Result rosenbrock(const Problem &problem, double tolerance) {
  const auto stepper = make_dense_output(tolerance, tolerance, rosenbrock4<double, Rodas>());
  using Stepper = std::decay_t<decltype(stepper)>;
  return with_events(problem, stick_below(tolerance),
                     [&](const TwoMasses &chain, const GapState &now, long long &work) {
                       const std::pair system(System{chain, now, work}, Jacobian{chain, now});
                       return DenseOutput<UblasVector, Stepper, decltype(system)>{
                           now, stepper, system, UblasVector(4)};
                     });
}

// An event within a step is located by repeating the step from its beginning with the trial length.
struct Fehlberg {
  using Stepper = runge_kutta_fehlberg78<Vec>;
  using Controlled = decltype(make_controlled(1.0, 1.0, Stepper()));

  Controlled controlled;
  System system;
  Stepper plain = {};
  Vec y_from = {}, y_to = {};
  double from = 0.0, to = 0.0, step = 0.0;
  StepLength length = {};

  void restart(double at_most) {
    y_to = system.now.y;
    to = 0.0;
    step = length.first(at_most);
  }
  std::pair<double, double> next() {
    y_from = y_to;
    from = to;
    while (controlled.try_step(system, y_from, to, y_to, step) == fail) continue;
    length.chosen(std::min(step, longest_unseen));
    step = length.usual;
    return {from, to};
  }
  Vec at(double tau) {
    if (tau == from) return y_from;
    if (tau == to) return y_to;
    Vec y;
    plain.do_step(system, y_from, from, y, tau - from);
    return y;
  }
};

Result fehlberg(const Problem &problem, double tolerance) {
  return with_events(problem, stick_below(tolerance),
                     [&](const TwoMasses &chain, const GapState &now, long long &work) {
                       return Fehlberg{make_controlled(tolerance, tolerance, Fehlberg::Stepper()),
                                       {chain, now, work}};
                     });
}

}  // namespace

std::vector<Method> odeint() {
  std::vector<double> tolerances{1e-4, 1e-6, 1e-8, 1e-10, 1e-12};
  const auto named = [&](const char *name, auto run) {
    return Method{name, "tolerance", "right-hand sides", tolerances, run};
  };
  const Method of_order_four = named("odeint rosenbrock4", rosenbrock);
  tolerances.push_back(1e-14);
  return {named("odeint runge_kutta_dopri5", dormand_prince),
          named("odeint bulirsch_stoer_dense_out", bulirsch_stoer),
          named("odeint runge_kutta_fehlberg78", fehlberg), of_order_four};
}

}  // namespace vibro_impact::comparison
