// Boost.Odeint's explicit steppers with dense output.
#include <boost/numeric/odeint/stepper/bulirsch_stoer_dense_out.hpp>
#include <boost/numeric/odeint/stepper/controlled_runge_kutta.hpp>
#include <boost/numeric/odeint/stepper/dense_output_runge_kutta.hpp>
#include <boost/numeric/odeint/stepper/generation.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_dopri5.hpp>

#include "odeint_events.hpp"

namespace vibro_impact::comparison {

namespace {

namespace odeint = boost::numeric::odeint;

template <class Stepper>
Result run_explicit(const Problem &problem, const Stepper &stepper, double tolerance) {
  return guarded([&] {
    return run_with_dense_output<Vec>(
        problem, stepper, tolerance,
        [](const TwoMasses &chain, const std::array<bool, 2> &held, long long &evaluations) {
          return [&chain, &held, &evaluations](const Vec &y, Vec &dydt, double t) {
            ++evaluations;
            right_hand_side(chain, held, y, dydt, t);
          };
        });
  });
}

Result dormand_prince(const Problem &problem, double tolerance) {
  return run_explicit(
      problem, odeint::make_dense_output(tolerance, tolerance, odeint::runge_kutta_dopri5<Vec>()),
      tolerance);
}

// Steps are kept below a quarter of the fastest cycle, and the interpolant is put under the error
// control too.
Result bulirsch_stoer(const Problem &problem, double tolerance) {
  constexpr double longest_step = 1.0;
  return run_explicit(
      problem,
      odeint::bulirsch_stoer_dense_out<Vec>(tolerance, tolerance, 1.0, 0.0, longest_step, true),
      tolerance);
}

}  // namespace

std::vector<Method> odeint_with_dense_output() {
  const std::vector<double> tolerances{1e-4, 1e-6, 1e-8, 1e-10, 1e-12, 1e-14};
  return {
      {"odeint runge_kutta_dopri5", "tolerance", "right-hand sides", tolerances, dormand_prince},
      {"odeint bulirsch_stoer_dense_out", "tolerance", "right-hand sides", tolerances,
       bulirsch_stoer}};
}

}  // namespace vibro_impact::comparison
