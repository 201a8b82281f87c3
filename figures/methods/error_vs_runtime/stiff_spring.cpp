// The stops as stiff springs with dampers, integrated with runge_kutta_dopri5: what one does who
// has no event-driven code. What is swept is the stiffness kappa; the tolerance of the integrator
// is tight enough not to matter.
//
// A gap g < 0 is pushed open by -kappa g - 2 zeta sqrt(kappa m) g'; zeta = -ln r / sqrt(pi^2 +
// ln^2 r) gives the coefficient of restitution r in the limit of a stiff spring. The model has no
// events: an impact is the beginning of a contact, a stick one that lasts, a release its end. Its
// error is of the order of the duration of a contact, pi sqrt(m / kappa).
#include <fmt/format.h>

#include <algorithm>
#include <boost/numeric/odeint/stepper/controlled_runge_kutta.hpp>
#include <boost/numeric/odeint/stepper/dense_output_runge_kutta.hpp>
#include <boost/numeric/odeint/stepper/generation.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_dopri5.hpp>
#include <cmath>
#include <numbers>

#include "two_masses.hpp"

namespace vibro_impact::comparison {

namespace {

// Half-periods of the spring that a contact must last to count as a stick. That of an impact lasts
// about one.
constexpr double half_periods_of_a_stick = 6.0;

constexpr double longest_step = 0.25;

struct Springs {
  TwoMasses chain;
  std::array<double, 2> stiffness, damping;  // per mass
  std::array<bool, 2> contact;
  long long *evaluations;

  void operator()(const Vec &y, Vec &dydt, double t) const {
    ++*evaluations;
    right_hand_side(chain, {false, false}, y, dydt, t);
    for (std::size_t i = 0; i < 2; ++i)
      if (contact[i]) dydt[2 * i + 1] -= stiffness[i] * y[2 * i] + damping[i] * y[2 * i + 1];
  }
};

Result integrate(const Problem &problem, double kappa) {
  Result result;
  const double log_r = std::log(problem.scene.restitution);
  const double zeta = -log_r / std::hypot(std::numbers::pi, log_r);
  Springs springs{two_masses(problem.scene), {}, {}, problem.start.held, &result.work};
  std::array<double, 2> lasting{}, since{};
  for (std::size_t i = 0; i < 2; ++i) {
    springs.stiffness[i] = kappa / problem.scene.mass[i];
    springs.damping[i] = 2.0 * zeta * std::sqrt(springs.stiffness[i]);
    lasting[i] = half_periods_of_a_stick * std::numbers::pi / std::sqrt(springs.stiffness[i]);
    since[i] = problem.start.time - lasting[i];
  }
  GapState now = gap_state(springs.chain, problem.start);
  for (std::size_t i = 0; i < 2; ++i)  // a held mass rests on its compressed spring
    if (now.held[i])
      now.y[2 * i] =
          springs.chain.acceleration(i, now.y, std::cos(springs.chain.omega * now.time)) /
          springs.stiffness[i];
  auto stepper = boost::numeric::odeint::make_dense_output(
      1e-3 / kappa, 1e-9, boost::numeric::odeint::runge_kutta_dopri5<Vec>());
  double step = 0.1 / std::sqrt(kappa);
  stepper.initialize(now.y, now.time, step);
  while (now.time < problem.until) {
    const auto [from, to] = stepper.do_step(springs);
    double end = std::min({to, problem.until, from + longest_step}), b = end;
    Vec y;
    stepper.calc_state(end, y);
    std::size_t who = 2;
    for (std::size_t i = 0; i < 2; ++i) {
      if ((y[2 * i] < 0.0) == springs.contact[i]) continue;
      double a = from;
      Vec between;
      b = end;
      while (true) {  // the side of the stop changes in (a, b]
        const double middle = 0.5 * (a + b);
        if (middle <= a || middle >= b) break;
        stepper.calc_state(middle, between);
        ((between[2 * i] < 0.0) == springs.contact[i] ? a : b) = middle;
      }
      end = b;
      who = i;
    }
    now.time = end;
    if (who == 2 && end == to) continue;
    stepper.calc_state(end, now.y);
    if (who != 2) {
      const int mass = static_cast<int>(who) + 1;
      now.y[2 * who] = 0.0;
      if (springs.contact[who] && end - since[who] > lasting[who]) {
        if (since[who] >= problem.start.time) result.events.push_back(stick_at(since[who], mass));
        result.events.push_back(release_at(end, mass));
      } else if (!springs.contact[who]) {
        result.events.push_back(impact_at(end, mass));
        since[who] = end;
        ++result.impacts;
      }
      springs.contact[who] = !springs.contact[who];
      step = 0.1 / std::sqrt(kappa);
    } else {
      step = std::min(longest_step, stepper.current_time_step());
    }
    if (result.impacts > impacts_at_most) {
      result.failure = fmt::format("more than {} contacts up to t = {:.6f}", impacts_at_most, end);
      break;
    }
    stepper.initialize(now.y, now.time, step);
  }
  for (std::size_t i = 0; i < 2; ++i)
    if (springs.contact[i] && now.time - since[i] > lasting[i] && since[i] >= problem.start.time)
      result.events.push_back(stick_at(since[i], static_cast<int>(i) + 1));
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
