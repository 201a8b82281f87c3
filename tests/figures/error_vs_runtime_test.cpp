// The methods of error against run time are correct implementations, the measure of their errors
// sees what it should, and the README has their errors. No test asserts a run time.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "figures/error_vs_runtime/methods/method.hpp"
#include "tests/support/refusals.hpp"
#include "tests/support/tables.hpp"

namespace {

using namespace vibro_impact;
using namespace vibro_impact::comparison;

const std::vector<Problem> &all_problems() {
  static const std::vector<Problem> all = problems(REFERENCE_DIR);
  return all;
}

Problem problem_named(const std::string &name) {
  for (const Problem &problem : all_problems())
    if (problem.name == name) return problem;
  throw std::invalid_argument(name);
}

// A row of the table in a README: what it is about, the method and its setting, and the error
// shown.
struct ReadmeRow {
  std::string problem, method;
  double setting, error;
};

std::vector<ReadmeRow> rows_of(const std::string &file) {
  const std::map<std::string, std::string> problems{{"ten periods of Figure 2", "figure2"},
                                                    {"one flight", "flight"},
                                                    {"one sticking phase", "sticking"}};
  std::vector<ReadmeRow> rows;
  for (const truth::Row &row : vibro_impact::testing::rows_in_document(file))
    if (problems.contains(row[0]))
      rows.push_back({problems.at(row[0]), row[1], std::stod(row[2]), std::stod(row[3])});
  return rows;
}

const char *const methods[] = {"this library",
                               "this library (every impact)",
                               "plain event-driven",
                               "odeint runge_kutta_dopri5",
                               "odeint runge_kutta_fehlberg78",
                               "stiff spring (dopri5)",
                               "CVODE Adams",
                               "Siconos Moreau-Jean"};

// A method of the list; the test is skipped where the method is not installed.
class OfMethod : public ::testing::TestWithParam<const char *> {
 protected:
  Method method = {};

  void SetUp() override {
    const Methods all = all_methods();
    for (const std::string &family : all.left_out)
      if (std::string(GetParam()).starts_with(family))
        GTEST_SKIP() << family << " is not installed";
    for (const Method &found : all.methods)
      if (found.name == GetParam()) method = found;
    ASSERT_EQ(method.name, GetParam());
  }
};

// The rounding of another compiler moves an error by less than 10 percent, or by some roundings of
// t = 200. Speeds are below one, so that the state at the end is off by about as much as a time.
TEST_P(OfMethod, HasTheErrorsThatTheReadmesShow) {
  int shown = 0;
  for (const char *file : {"figures/error_vs_runtime/README.md", "README.md"})
    for (const ReadmeRow &row : rows_of(file)) {
      if (row.method != method.name) continue;
      ++shown;
      const Problem problem = problem_named(row.problem);
      const Errors errors = errors_of(method.run(problem, row.setting), problem);
      SCOPED_TRACE(fmt::format("{}: {} at {} on {}", file, row.method, row.setting, row.problem));
      EXPECT_NEAR(row.error, errors.time, 0.1 * errors.time + 1e-13) << errors.failure;
      EXPECT_LE(errors.state, 10.0 * errors.time + 1e-13);
    }
  EXPECT_GE(shown, 1);
}

INSTANTIATE_TEST_SUITE_P(Methods, OfMethod, ::testing::ValuesIn(methods), [](const auto &method) {
  std::string name = method.param;
  std::erase_if(name, [](char c) { return !std::isalnum(static_cast<unsigned char>(c)); });
  return name;
});

// A method that would leave out a force refuses the scene in one line, which names the force.
TEST(ErrorAgainstRunTime, AMethodThatDoesNotKnowAForceRefusesTheScene) {
  for (const auto &[name, force] : {std::pair{"sine", &Scene::sine},
                                    {"constant", &Scene::constant},
                                    {"ground", &Scene::ground}}) {
    Problem problem = problem_named("flight");
    problem.scene.*force = {0.0, 0.1};
    for (const Method &method : all_methods().methods) {
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
  for (const Method &method : all_methods().methods)
    if (!method.name.starts_with("this library")) {
      EXPECT_THROW(method.run(problem, method.settings.front()), std::invalid_argument)
          << method.name;
    }
}

TEST(ErrorAgainstRunTime, EveryMethodIsInTheListOfThisTest) {
  for (const Method &method : all_methods().methods)
    EXPECT_EQ(std::count(std::begin(methods), std::end(methods), method.name), 1) << method.name;
}

// A contact with a spring lasts pi sqrt(m / kappa), and its effect on the motion is of that order:
// a hundred times the stiffness for one digit more.
TEST(ErrorAgainstRunTime, TheErrorOfAStiffSpringFallsWithTheRootOfItsStiffness) {
  const Problem problem = problem_named("figure2");
  const Method spring = stiff_spring().front();
  const double soft = errors_of(spring.run(problem, 1e6), problem).time;
  const double stiff = errors_of(spring.run(problem, 1e8), problem).time;
  EXPECT_NEAR(soft / stiff, 10.0, 2.0) << "sqrt(100), but for the next order in kappa^-1/2";
}

// A gap is known to the rounding of x, 5e-17, and a mass pressed by a = 0.055 falls through that at
// sqrt(2 a 5e-17) = 2.3e-9: impacts of a chatter slower than this are rounding. So a threshold of
// speed has to be chosen. Far below 1e-6 it makes the stick worse; without one no chatter ends.
TEST(ErrorAgainstRunTime, ThePlainSchemeStallsNearTheRootOfRoundingUnlessGivenAThreshold) {
  const Problem problem = problem_named("chatter");
  const Method plain = plain_event_driven().front();
  const double chosen = errors_of(plain.run(problem, 1e-6), problem).time;
  EXPECT_LT(chosen, 1e-8);
  EXPECT_GT(errors_of(plain.run(problem, 1e-4), problem).time, 100.0 * chosen);
  EXPECT_GT(errors_of(plain.run(problem, 1e-9), problem).time, 100.0 * chosen);
  const Result stalled = plain.run(problem, 0.0);
  EXPECT_EQ(stalled.failure.find("more than 20000 impacts"), 0u) << stalled.failure;
  EXPECT_LT(stalled.end.time, problem.until);
}

// The reference's own events and end, with the first release late by `delay`.
Result exact(const Problem &problem, double delay = 0.0) {
  Result result;
  result.events = problem.reference_events;
  result.end = problem.reference_end;
  for (Event &event : result.events)
    if (event.kind == EventKind::release) {
      event.instant.phase += delay;
      break;
    }
  return result;
}

TEST(Measure, IsTheLargestErrorOfATimeAndOfTheState) {
  const Problem problem = problem_named("figure2");
  EXPECT_EQ(errors_of(exact(problem), problem).failure, "");
  EXPECT_EQ(errors_of(exact(problem), problem).time, 0.0);
  EXPECT_EQ(errors_of(exact(problem), problem).state, 0.0);
  EXPECT_NEAR(errors_of(exact(problem, 1e-3), problem).time, 1e-3, 1e-13);  // rounding of t = 14
  Result result = exact(problem);
  result.end.displacement[1] += 1e-4;
  EXPECT_NEAR(errors_of(result, problem).state, 1e-4, 1e-15);
  result.end.velocity[0] -= 1e-2;
  EXPECT_NEAR(errors_of(result, problem).state, 1e-2, 1e-15);
}

// The events are compared as in reference_test.
TEST(Measure, FailsForEventsThatDifferAnEndThatIsNoNumberAndAMethodThatGaveUp) {
  const Problem problem = problem_named("figure2");
  Result missing = exact(problem), no_number = missing, given_up = missing;
  missing.events.erase(missing.events.begin());  // an impact, for which the next one is taken
  EXPECT_NE(errors_of(missing, problem).failure, "");
  no_number.end.velocity[1] = NAN;
  EXPECT_NE(errors_of(no_number, problem).failure, "");
  given_up.failure = "stalled";
  EXPECT_EQ(errors_of(given_up, problem).failure, "stalled");
}

}  // namespace
