// Siconos, Moreau-Jean time stepping: theta = 1/2 (no numerical damping), one LCP a step for the
// impulses of the active contacts, Lemke's algorithm.
//
// The scheme has no events; they are read off the impulses. An impact is a step with an impulse
// behind one without; a run of steps with an impulse in each is contact, its first step the stick
// and the step behind its last one the release.
#include "siconos_model.hpp"

namespace vibro_impact::comparison {

namespace {

// Shorter runs of steps with an impulse are impacts that took more than one step.
constexpr int steps_of_a_stick = 8;

Result integrate(const Problem &problem, double step) {
  const SiconosModel model = siconos_model(problem);
  const auto steps = static_cast<long long>(std::ceil((problem.until - problem.start.time) / step));
  const double h = (problem.until - problem.start.time) / static_cast<double>(steps);
  auto discretisation = std::make_shared<TimeDiscretisation>(problem.start.time, h);
  auto integrator = std::make_shared<MoreauJeanOSI>(0.5);
  auto impulses = std::make_shared<LCP>();
  const auto simulation =
      std::make_shared<TimeStepping>(model.system, discretisation, integrator, impulses);
  // A contact at rest stays one when its gap speed comes out as a rounding above zero.
  integrator->setConstraintActivationThreshold(1e-10);

  Result result;
  std::array<int, 2> in_contact{};  // steps in a row with an impulse
  for (std::size_t i = 0; i < 2; ++i)
    if (problem.start.held[i]) in_contact[i] = steps_of_a_stick;
  for (long long n = 1; n <= steps; ++n) {
    simulation->computeOneStep();
    const double time = problem.start.time + h * static_cast<double>(n);
    for (std::size_t i = 0; i < 2; ++i) {
      const int mass = static_cast<int>(i) + 1;
      if ((*model.contact[i]->lambda(1))(0) > 0.0) {
        if (++in_contact[i] == 1) {
          // The impulse of the step from time - h to time stands for one at its middle.
          result.events.push_back(impact_at(time - 0.5 * h, mass));
          ++result.impacts;
        } else if (in_contact[i] == steps_of_a_stick) {
          result.events.push_back(stick_at(time - (steps_of_a_stick - 0.5) * h, mass));
        }
      } else {
        if (in_contact[i] >= steps_of_a_stick)
          result.events.push_back(release_at(time - 0.5 * h, mass));
        in_contact[i] = 0;
      }
    }
    simulation->nextStep();
  }
  result.work = steps;
  result.end = state_of(model, problem.until);
  return result;
}

Result moreau_jean(const Problem &problem, double step) {
  Result result;
  const std::string why = failure_of([&] { result = integrate(problem, step); });
  if (!why.empty()) result.failure = why;
  return result;
}

}  // namespace

std::vector<Method> siconos_time_stepping() {
  return {
      {"Siconos Moreau-Jean", "time step", "time steps", {2e-2, 1e-2, 5e-3, 2e-3}, moreau_jean}};
}

}  // namespace vibro_impact::comparison
