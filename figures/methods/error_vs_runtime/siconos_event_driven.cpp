// Siconos, event-driven scheme: LsodarOSI between events, one LCP at impacts and one for the
// accelerations of masses in contact, set up as in its bouncing-ball examples.
//
// The tolerance is that of LSODAR; the tolerance of the index sets (EventDriven::setToleranceED),
// below which a gap or a gap speed counts as zero, is set in step with it.
//
// In those examples, one mass under a constant force, it goes through a chatter to rest; in the
// scenes here it ends in the first one (reference/README.md, published results).
#include <fmt/format.h>

#include <algorithm>

#include "siconos_model.hpp"

namespace vibro_impact::comparison {

namespace {

Result integrate(const Problem &problem, double tolerance) {
  const SiconosModel model = siconos_model(problem);
  // The user's grid of time points: none needed but the end.
  constexpr int points = 64;
  auto discretisation = std::make_shared<TimeDiscretisation>(
      problem.start.time, (problem.until - problem.start.time) / points);
  auto simulation = std::make_shared<EventDriven>(model.system, discretisation);
  auto integrator = std::make_shared<LsodarOSI>();
  simulation->insertIntegrator(integrator);
  simulation->insertNonSmoothProblem(std::make_shared<LCP>(), SICONOS_OSNSP_ED_IMPACT);
  simulation->insertNonSmoothProblem(std::make_shared<LCP>(), SICONOS_OSNSP_ED_SMOOTH_ACC);
  simulation->setToleranceED(tolerance);
  simulation->initialize();
  integrator->setTol(1, tolerance, tolerance);

  Result result;
  std::array<bool, 2> held = problem.start.held;
  double time = problem.start.time;
  const std::string why = failure_of([&] {
    while (simulation->hasNextEvent()) {
      simulation->advanceToEvent();
      ++result.work;
      const bool nonsmooth = simulation->eventsManager()->nextEvent()->getType() == NS_EVENT;
      const TwoMassState before = state_of(model, time);
      simulation->processEvents();
      time = simulation->startingTime();
      const TwoMassState after = state_of(model, time);
      if (!nonsmooth) continue;
      for (std::size_t i = 0; i < 2; ++i) {
        const int mass = static_cast<int>(i) + 1;
        const bool now_held = simulation->indexSet(2)->is_vertex(model.contact[i]);
        if (!held[i] && after.velocity[i] != before.velocity[i]) {
          result.events.push_back(impact_at(time, mass, before.velocity[i]));
          if (++result.impacts > impacts_at_most) {
            result.failure =
                fmt::format("more than {} impacts up to t = {:.6f}", impacts_at_most, time);
            return;
          }
        }
        if (now_held != held[i])
          result.events.push_back(now_held ? stick_at(time, mass) : release_at(time, mass));
        held[i] = now_held;
      }
    }
  });
  if (!why.empty()) result.failure = fmt::format("behind t = {:.6f}: {}", time, why);
  result.end = state_of(model, time);
  return result;
}

}  // namespace

std::vector<Method> siconos_event_driven() {
  return {{"Siconos LsodarOSI", "tolerance", "events", {1e-6, 1e-8, 1e-10, 1e-12}, integrate}};
}

}  // namespace vibro_impact::comparison
