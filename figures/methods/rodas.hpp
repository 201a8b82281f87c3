// The coefficients of Boost.Odeint's rosenbrock4, put right.
#pragma once

#include <boost/numeric/odeint/stepper/rosenbrock4.hpp>

namespace vibro_impact {

// Odeint (Boost 1.74) has d4 of RODAS (Hairer and Wanner, Solving Ordinary Differential Equations
// II) with the wrong sign: the method is of order four for autonomous systems, but of order one
// under forcing.
struct Rodas : boost::numeric::odeint::default_rosenbrock_coefficients<double> {
  const double d4 = -0.03620000000000023;
};

}  // namespace vibro_impact
