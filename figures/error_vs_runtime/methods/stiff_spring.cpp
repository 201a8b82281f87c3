// The stops as stiff springs with dampers, integrated with runge_kutta_dopri5, as one does who has
// no event-driven code. The stiffness kappa is swept; the tolerance of the integrator is tight
// enough not to matter.
//
// A gap g < 0 is pushed open by -kappa g - 2 zeta sqrt(kappa m) g'; zeta = -ln r / sqrt(pi^2 +
// ln^2 r) gives the coefficient of restitution r in the limit of a stiff spring. The model has no
// events. The beginning of a contact counts as an impact, a contact that lasts as a stick, and the
// end of such a contact as a release. The error is of the order of the duration of a contact,
// pi sqrt(m / kappa).
#include <boost/numeric/odeint/stepper/controlled_runge_kutta.hpp>
#include <boost/numeric/odeint/stepper/dense_output_runge_kutta.hpp>
#include <boost/numeric/odeint/stepper/generation.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_dopri5.hpp>
#include <functional>
#include <numbers>

#include "event_loop.hpp"

namespace vibro_impact::comparison {

namespace {

// Half-periods of the spring that a contact must last to count as a stick. That of an impact lasts
// about one.
constexpr double half_periods_of_a_stick = 6.0;

// The springs at the two stops, per mass, and the contacts with them.
struct Springs {
  TwoMasses chain;
  GapState now;
  std::array<double, 2> stiffness = {}, damping = {};
  std::array<double, 2> stick = {};  // the duration of a contact that counts as a stick
  std::array<bool, 2> contact = {};
  std::array<double, 2> since = {};  // beginning of the last contact
  Result result = {};

  Springs(const Problem &problem, double kappa)
      : chain(two_masses(problem.scene)),
        now(gap_state(chain, problem.from, problem.start)),
        contact(now.held) {
    const double log_r = std::log(problem.scene.restitution);
    const double zeta = -log_r / std::hypot(std::numbers::pi, log_r);
    const double cosine = std::cos(chain.omega * now.time);
    for (std::size_t i = 0; i < 2; ++i) {
      stiffness[i] = kappa / problem.scene.mass[i];
      damping[i] = 2.0 * zeta * std::sqrt(stiffness[i]);
      stick[i] = half_periods_of_a_stick * std::numbers::pi / std::sqrt(stiffness[i]);
      since[i] = -infinity;
    }
    for (std::size_t i = 0; i < 2; ++i)  // A held mass rests on its compressed spring.
      if (now.held[i]) now.y[2 * i] = chain.acceleration(i, now.y, cosine) / stiffness[i];
  }

  void operator()(const Vec &y, Vec &dydt, double tau) {
    right_hand_side(chain, {false, false}, y, dydt, now.time + tau);
    for (std::size_t i = 0; i < 2; ++i)
      if (contact[i]) dydt[2 * i + 1] -= stiffness[i] * y[2 * i] + damping[i] * y[2 * i + 1];
  }

  // A contact that has lasted counts as a stick from its beginning, unless the run began in it.
  void record_stick(std::size_t i) {
    if (contact[i] && now.time - since[i] > stick[i] && std::isfinite(since[i]))
      result.record(since[i], i, EventKind::stick);
  }

  // Begins or ends the contact of mass i + 1.
  void toggle(std::size_t i) {
    now.y[2 * i] = 0.0;
    if (!contact[i]) {
      result.record(now.time, i, EventKind::impact);
      result.count_impact(now.time, i, now.y[2 * i + 1]);
      since[i] = now.time;
    } else if (now.time - since[i] > stick[i]) {
      record_stick(i);
      result.record(now.time, i, EventKind::release);
    }
    contact[i] = !contact[i];
  }
};

Result integrate(const Problem &problem, double kappa) {
  Springs springs(problem, kappa);
  const auto stepper = boost::numeric::odeint::make_dense_output(
      1e-3 / kappa, 1e-9, boost::numeric::odeint::runge_kutta_dopri5<Vec>());
  DenseOutput<std::decay_t<decltype(stepper)>, std::reference_wrapper<Springs>> steps{
      springs.now, stepper, std::ref(springs)};
  const double first_step = 0.1 / std::sqrt(kappa);
  const auto guard = [&](std::size_t i, const Vec &y, double) {
    return springs.contact[i] ? -y[2 * i] : y[2 * i];
  };
  const auto event_of = [&](std::size_t i) {
    springs.toggle(i);
    return first_step;
  };
  Result &result = springs.result;
  advance(steps, springs.now, problem.until, first_step, 2, guard, event_of, result.failure);
  for (std::size_t i = 0; i < 2; ++i) springs.record_stick(i);
  return result;
}

}  // namespace

std::vector<Method> stiff_spring() {
  return {{"stiff spring (dopri5)", {1e4, 1e5, 1e6, 1e7}, integrate}};
}

}  // namespace vibro_impact::comparison
