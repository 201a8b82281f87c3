// The stops as stiff springs with dampers, integrated with runge_kutta_dopri5: what one does who
// has no event-driven code. What is swept is the stiffness kappa; the tolerance of the integrator
// is tight enough not to matter.
//
// A gap g < 0 is pushed open by -kappa g - 2 zeta sqrt(kappa m) g'; zeta = -ln r / sqrt(pi^2 +
// ln^2 r) gives the coefficient of restitution r in the limit of a stiff spring. The model has no
// events: an impact is the beginning of a contact, a stick one that lasts, a release its end. Its
// error is of the order of the duration of a contact, pi sqrt(m / kappa).

#include <boost/numeric/odeint/stepper/controlled_runge_kutta.hpp>
#include <boost/numeric/odeint/stepper/dense_output_runge_kutta.hpp>
#include <boost/numeric/odeint/stepper/generation.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_dopri5.hpp>
#include <numbers>

#include "event_loop.hpp"

namespace vibro_impact::comparison {

namespace {

// Half-periods of the spring that a contact must last to count as a stick. That of an impact lasts
// about one.
constexpr double half_periods_of_a_stick = 6.0;

struct Springs {
  TwoMasses chain;
  std::array<double, 2> stiffness, damping;  // per mass
  std::array<bool, 2> contact;
};

Result integrate(const Problem &problem, double kappa) {
  Result result;
  const double log_r = std::log(problem.scene.restitution);
  const double zeta = -log_r / std::hypot(std::numbers::pi, log_r);
  Springs springs{two_masses(problem.scene), {}, {}, problem.start.held};
  GapState now = gap_state(springs.chain, problem.start);
  std::array<double, 2> lasting{}, since{};
  for (std::size_t i = 0; i < 2; ++i) {
    springs.stiffness[i] = kappa / problem.scene.mass[i];
    springs.damping[i] = 2.0 * zeta * std::sqrt(springs.stiffness[i]);
    lasting[i] = half_periods_of_a_stick * std::numbers::pi / std::sqrt(springs.stiffness[i]);
    since[i] = problem.start.time - lasting[i];
  }
  for (std::size_t i = 0; i < 2; ++i)  // a held mass rests on its compressed spring
    if (now.held[i])
      now.y[2 * i] =
          springs.chain.acceleration(i, now.y, std::cos(springs.chain.omega * now.time)) /
          springs.stiffness[i];
  const auto system = [&](const Vec &y, Vec &dydt, double tau) {
    ++result.work;
    right_hand_side(springs.chain, {false, false}, y, dydt, now.time + tau);
    for (std::size_t i = 0; i < 2; ++i)
      if (springs.contact[i])
        dydt[2 * i + 1] -= springs.stiffness[i] * y[2 * i] + springs.damping[i] * y[2 * i + 1];
  };
  const auto stepper = boost::numeric::odeint::make_dense_output(
      1e-3 / kappa, 1e-9, boost::numeric::odeint::runge_kutta_dopri5<Vec>());
  DenseOutput<Vec, std::decay_t<decltype(stepper)>, decltype(system)> steps{now, stepper, system};
  const double first_step = 0.1 / std::sqrt(kappa);

  // A contact that has lasted counts as a stick from its beginning, unless it was there at first.
  const auto note_a_stick = [&](std::size_t i) {
    if (now.time - since[i] > lasting[i] && since[i] >= problem.start.time)
      result.events.push_back({since[i], static_cast<int>(i) + 1, stick});
  };
  const auto side_changes = [&](std::size_t i, const Vec &y, double) {
    return springs.contact[i] ? -y[2 * i] : y[2 * i];
  };
  const auto toggle = [&](std::size_t i) {
    const int mass = static_cast<int>(i) + 1;
    now.y[2 * i] = 0.0;
    if (!springs.contact[i]) {
      result.events.push_back({now.time, mass, impact});
      since[i] = now.time;
      if (++result.impacts > impacts_at_most)
        result.failure = lost_in_impacts(now.time, mass, now.y[2 * i + 1]);
    } else if (now.time - since[i] > lasting[i]) {
      note_a_stick(i);
      result.events.push_back({now.time, mass, release});
    }
    springs.contact[i] = !springs.contact[i];
    return first_step;
  };
  follow(steps, now, problem.until, first_step, side_changes, toggle, result.failure);
  for (std::size_t i = 0; i < 2; ++i)
    if (springs.contact[i]) note_a_stick(i);
  result.end = physical_state(springs.chain, now);
  return result;
}

}  // namespace

std::vector<Method> stiff_spring() {
  return {{"stiff spring (dopri5)",
           "stiffness",
           "right-hand sides",
           {1e4, 1e5, 1e6, 1e7, 1e8, 1e9},
           integrate}};
}

}  // namespace vibro_impact::comparison
