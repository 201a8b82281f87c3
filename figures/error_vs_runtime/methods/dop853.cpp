// DOP853 with its dense output in the common event loop.
#include "dop853.hpp"

namespace vibro_impact::comparison {

namespace {

Result run_dop853(const Problem &problem, double tolerance) {
  if (problem.scene.masses() != 2) return dop853_of_chain(problem, tolerance);
  return with_events(problem, stick_below(tolerance),
                     [&](const TwoMasses &chain, const GapState &now, long long &work) {
                       return dop::Steps<Vec, System>{{chain, now, work}, tolerance, now.y};
                     });
}

}  // namespace

std::vector<Method> dop853() {
  return {{"DOP853",
           {1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9, 1e-10, 1e-11, 1e-12, 1e-13, 1e-14},
           run_dop853,
           true}};
}

}  // namespace vibro_impact::comparison
