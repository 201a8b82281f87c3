// The derivatives of the equations of a branch are those of their values, by every unknown and for
// every parameter.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "analysis/branches/sequence.hpp"
#include "vibro_impact/analysis/analysis.hpp"
#include "vibro_impact/vibro_impact.hpp"

namespace {

using namespace vibro_impact;
using namespace vibro_impact::branches;

// Two masses under all forces: mass 1 chatters, sticks and is released, mass 2 hits. 1e-7 of the
// largest derivative: central differences over 1e-5 leave out their third order, and have 1e-11 of
// rounding.
TEST(BranchEquations, HaveTheDerivativesOfTheirValues) {
  const Scene scene{.mass = {1.0, 1.3},
                    .stiffness = {1.0, 0.8},
                    .beta = 0.2,
                    .amplitude = {0.5, 0.1},
                    .sine = {0.1, 0.05},
                    .constant = {-0.05, 0.02},
                    .ground = {0.2, 0.3},
                    .omega = 0.3,
                    .restitution = 0.5,
                    .stops = {{1, Side::lower, -0.2}, {2, Side::upper, 0.1}}};
  const SettledMotion settled = settle(scene, {.longest = 300});
  ASSERT_GT(settled.period, 0);
  for (const char *name : {"mass1", "mass2", "stiffness1", "stiffness2", "beta", "amplitude1",
                           "amplitude2", "sine1", "sine2", "constant1", "constant2", "ground1",
                           "ground2", "omega", "restitution", "stop1", "stop2"}) {
    const Problem problem{scene, name};
    const auto orbit = sequence_from_run(problem, settled.orbit.state, settled.period);
    ASSERT_TRUE(orbit.has_value());
    const auto &[s, u] = *orbit;
    const Dense jacobian = evaluate(problem, s, u, nullptr, true).jacobian;
    for (Eigen::Index j = 0; j < u.size(); ++j) {
      const double step = 1e-5;
      const Vector unit = Vector::Unit(u.size(), j);
      const Vector difference = (evaluate(problem, s, u + step * unit, nullptr, false).values -
                                 evaluate(problem, s, u - step * unit, nullptr, false).values) /
                                (2.0 * step);
      EXPECT_LT((jacobian.col(j) - difference).lpNorm<Eigen::Infinity>(),
                1e-7 * jacobian.col(j).lpNorm<Eigen::Infinity>())
          << name << " " << j;
    }
  }
}

}  // namespace
