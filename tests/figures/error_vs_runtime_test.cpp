// The methods of error against run time are correct implementations, the measure of their errors
// sees what it should, and the committed table has their errors. No test asserts a run time.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "figures/error_vs_runtime/methods/dop853.hpp"
#include "figures/error_vs_runtime/methods/method.hpp"
#include "figures/measures/measured.hpp"
#include "tests/support/refusals.hpp"

namespace {

using namespace vibro_impact;
using namespace vibro_impact::comparison;

const std::vector<Problem> &all_problems() {
  static const std::vector<Problem> all = [] {
    std::vector<Problem> read = problems(REFERENCE_DIR);
    for (const int masses : {10, 200}) read.push_back(chain_problem(REFERENCE_DIR, masses));
    return read;
  }();
  return all;
}

Problem problem_named(const std::string &name) {
  for (const Problem &problem : all_problems())
    if (problem.name == name) return problem;
  throw std::invalid_argument(name);
}

// The committed table is of this code. Rounding and the engine move an error by less than a factor
// of two, or by some roundings of t = 200; the picture shows fifteen decades.
TEST(ErrorAgainstRunTime, EveryMethodHasTheErrorsOfTheCommittedTable) {
  const std::vector<Method> methods = all_methods();
  std::map<std::string, int> compared;
  for (const Measured &run : read_measured(SOURCE_DIR "/figures/error_vs_runtime/measured.csv")) {
    SCOPED_TRACE(fmt::format("{} at {} on {}", run.method, run.setting, run.problem));
    const auto method = std::ranges::find(methods, run.method, &Method::name);
    ASSERT_NE(method, methods.end());
    ++compared[run.method];
    const Problem problem = problem_named(run.problem);
    const Error error = error_of(method->run(problem, run.setting), problem);
    EXPECT_LE(error.time, 2.0 * run.error + 1e-12) << error.failure;
    EXPECT_GE(error.time, 0.5 * run.error - 1e-12) << error.failure;
  }
  for (const Method &method : methods) EXPECT_GE(compared[method.name], 5) << method.name;
}

// The motions of two figures last ten forcing periods, the others less than one, the chains two.
// The ends of the problems are given to 1e-15 of their length.
TEST(ErrorAgainstRunTime, TheTimeOfARunIsForAForcingPeriodOrForAShorterRun) {
  for (const Problem &problem : all_problems()) {
    const bool ten = problem.name == "figure2" || problem.name == "figure4";
    const bool two = problem.name.starts_with("chain");
    EXPECT_NEAR(runs_counted(problem), ten ? 10.0 : two ? 2.0 : 1.0, 1e-12) << problem.name;
  }
}

// A method that would leave out a force refuses the scene in one line, which names the force.
TEST(ErrorAgainstRunTime, AMethodThatDoesNotKnowAForceRefusesTheScene) {
  for (const auto &[name, force] : {std::pair{"sine", &Scene::sine},
                                    {"constant", &Scene::constant},
                                    {"ground", &Scene::ground}}) {
    Problem problem = problem_named("flight");
    problem.scene.*force = {0.0, 0.1};
    for (const Method &method : all_methods()) {
      const std::string said =
          vibro_impact::testing::refusal([&] { method.run(problem, method.settings.front()); });
      EXPECT_EQ(said, method.name.starts_with("this library")
                          ? "accepted"
                          : fmt::format("the comparison takes no scene with forces '{}'", name))
          << method.name;
    }
  }
}

// A rival knows one coefficient of restitution, that of the scene.
TEST(ErrorAgainstRunTime, AMethodThatDoesNotKnowTheRestitutionOfAStopRefusesTheScene) {
  Problem problem = problem_named("flight");
  problem.scene.stops[1].restitution = 0.1;
  for (const Method &method : all_methods())
    if (!method.name.starts_with("this library")) {
      EXPECT_THROW(method.run(problem, method.settings.front()), std::invalid_argument)
          << method.name;
    }
}

// The estimators of orders 3 and 5 give no error for polynomials of these degrees. The rounded
// coefficients are as large as 528, so that sums of them are off by 1e-13.
TEST(Dop853, EstimatesNoErrorOfPolynomials) {
  for (int degree = 1; degree <= 5; ++degree) {
    const auto slope = [&](std::size_t stage) { return std::pow(dop::C[0][stage], degree - 1); };
    EXPECT_NEAR((dop::sum<dop::E5, 0>(slope)), 0.0, 1e-13) << degree;
    if (degree <= 3) {
      EXPECT_NEAR((dop::sum<dop::E3, 0>(slope)), 0.0, 1e-13) << degree;
    }
  }
}

// A contact with a spring lasts pi sqrt(m / kappa), and its effect on the motion is of that order:
// a hundred times the stiffness for one digit more.
TEST(ErrorAgainstRunTime, TheErrorOfAStiffSpringFallsWithTheRootOfItsStiffness) {
  const Problem problem = problem_named("figure2");
  const Method spring = stiff_spring().front();
  const double soft = error_of(spring.run(problem, 1e5), problem).time;
  const double stiff = error_of(spring.run(problem, 1e7), problem).time;
  EXPECT_NEAR(soft / stiff, 10.0, 2.0) << "sqrt(100), but for the next order in kappa^-1/2";
}

// A gap is known to the rounding of x, 5e-17, and a mass pressed by a = 0.055 falls through that at
// sqrt(2 a 5e-17) = 2.3e-9: impacts of a chatter slower than this are rounding. So a threshold of
// speed has to be chosen. Far below 1e-6 it makes the stick worse; without one no chatter ends.
TEST(ErrorAgainstRunTime, ThePlainSchemeStallsNearTheRootOfRoundingUnlessGivenAThreshold) {
  const Problem problem = problem_named("chatter");
  const Method plain = plain_event_driven().front();
  const double chosen = error_of(plain.run(problem, 1e-6), problem).time;
  EXPECT_LT(chosen, 1e-8);
  EXPECT_GT(error_of(plain.run(problem, 1e-4), problem).time, 100.0 * chosen);
  EXPECT_GT(error_of(plain.run(problem, 1e-9), problem).time, 100.0 * chosen);
  const Result stalled = plain.run(problem, 0.0);
  EXPECT_EQ(stalled.failure.find("more than 20000 impacts"), 0u) << stalled.failure;
}

// The comparison of events is that of reference_test. Here the reference's own events, of which the
// first release is late, are compared.
TEST(Measure, IsTheLargestErrorOfATimeOrTheFailureOfTheMethod) {
  const Problem problem = problem_named("figure2");
  Result late{.events = problem.reference_events};
  EXPECT_EQ(error_of(late, problem).time, 0.0);
  std::ranges::find(late.events, EventKind::release, &Event::kind)->instant.phase += 1e-3;
  EXPECT_NEAR(error_of(late, problem).time, 1e-3, 1e-13);  // rounding of t = 14
  late.failure = "stalled";
  EXPECT_EQ(error_of(late, problem).failure, "stalled");
}

}  // namespace
