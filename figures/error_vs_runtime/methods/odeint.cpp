// Boost.Odeint: runge_kutta_dopri5 with its dense output, and runge_kutta_fehlberg78, which has
// none.
#include <boost/numeric/odeint/stepper/controlled_runge_kutta.hpp>
#include <boost/numeric/odeint/stepper/dense_output_runge_kutta.hpp>
#include <boost/numeric/odeint/stepper/generation.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_dopri5.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_fehlberg78.hpp>
#include <utility>

#include "event_loop.hpp"

namespace vibro_impact::comparison {

namespace {

using namespace boost::numeric::odeint;

Result dormand_prince(const Problem &problem, double tolerance) {
  const auto stepper = make_dense_output(tolerance, tolerance, runge_kutta_dopri5<Vec>());
  using Steps = DenseOutput<std::decay_t<decltype(stepper)>, System>;
  return with_events(problem, stick_below(tolerance), [&](const System &system) {
    return Steps{system.now, stepper, system};
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

  void restart(double longest_first) {
    y_to = system.now.y;
    to = 0.0;
    step = length.first(longest_first);
  }
  std::pair<double, double> next() {
    y_from = y_to;
    from = to;
    while (controlled.try_step(system, y_from, to, y_to, step) == fail) continue;
    // A step is no longer than the distance of two looks at the guards. A longer one would have to
    // be repeated for the looks within it, which takes more time than it saves.
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
  return with_events(problem, stick_below(tolerance), [&](const System &system) {
    return Fehlberg{make_controlled(tolerance, tolerance, Fehlberg::Stepper()), system};
  });
}

}  // namespace

std::vector<Method> odeint() {
  const std::vector<double> tolerances{1e-4,  1e-5,  1e-6,  1e-7,  1e-8, 1e-9,
                                       1e-10, 1e-11, 1e-12, 1e-13, 1e-14};
  return {{"odeint runge_kutta_dopri5", tolerances, dormand_prince},
          {"odeint runge_kutta_fehlberg78", tolerances, fehlberg}};
}

}  // namespace vibro_impact::comparison
