// Boost.Odeint's rosenbrock4, with dense output. Its states are uBLAS vectors, and uBLAS as of
// Boost 1.74 is not C++20: this file is compiled as C++17.
#include <boost/numeric/odeint/stepper/generation.hpp>
#include <boost/numeric/odeint/stepper/rosenbrock4.hpp>
#include <boost/numeric/odeint/stepper/rosenbrock4_controller.hpp>
#include <boost/numeric/odeint/stepper/rosenbrock4_dense_output.hpp>
#include <utility>

#include "odeint_events.hpp"

namespace vibro_impact::comparison {

namespace {

namespace odeint = boost::numeric::odeint;

using UblasVector = boost::numeric::ublas::vector<double>;
using UblasMatrix = boost::numeric::ublas::matrix<double>;

// Odeint (Boost 1.74) has d4 of RODAS (Hairer and Wanner, Solving Ordinary Differential Equations
// II) with the wrong sign: the method is of order four for autonomous systems, but of order one
// under forcing.
struct Rodas : odeint::default_rosenbrock_coefficients<double> {
  const double d4 = -0.03620000000000023;
};

Result rosenbrock(const Problem &problem, double tolerance) {
  const auto system_for = [](const TwoMasses &chain, const std::array<bool, 2> &held,
                             long long &evaluations) {
    const auto rhs = [&chain, &held, &evaluations](const UblasVector &y, UblasVector &dydt,
                                                   double t) {
      ++evaluations;
      right_hand_side(chain, held, y, dydt, t);
    };
    const auto jacobian = [&chain, &held](const UblasVector &, UblasMatrix &jacobi, double t,
                                          UblasVector &dfdt) {
      for (std::size_t i = 0; i < 2; ++i) {
        const GapEquation &e = chain.equation[i];
        const double on = held[i] ? 0.0 : 1.0;
        for (std::size_t j = 0; j < 2; ++j) {
          jacobi(2 * i, 2 * j) = 0.0;
          jacobi(2 * i, 2 * j + 1) = i == j ? on : 0.0;
          jacobi(2 * i + 1, 2 * j) = on * e.gap[j];
          jacobi(2 * i + 1, 2 * j + 1) = on * e.speed[j];
        }
        dfdt[2 * i] = 0.0;
        dfdt[2 * i + 1] = -on * e.drive * chain.omega * std::sin(chain.omega * t);
      }
    };
    return std::pair(rhs, jacobian);
  };
  return guarded([&] {
    return run_with_dense_output<UblasVector>(
        problem,
        odeint::make_dense_output(tolerance, tolerance, odeint::rosenbrock4<double, Rodas>()),
        tolerance, system_for);
  });
}

}  // namespace

std::vector<Method> odeint_rosenbrock() {
  return {{"odeint rosenbrock4",
           "tolerance",
           "right-hand sides",
           {1e-4, 1e-6, 1e-8, 1e-10, 1e-12},
           rosenbrock}};
}

}  // namespace vibro_impact::comparison
