// The methods of error against run time are correct implementations, the measure of their errors
// sees what it should, and the committed table has their errors. No test asserts a run time.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
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
  static const std::vector<Problem> all = problems(REFERENCE_DIR);
  return all;
}

Problem problem_named(const std::string &name) {
  for (const Problem &problem : all_problems())
    if (problem.name == name) return problem;
  throw std::invalid_argument(name);
}

const char *const methods[] = {"this library",
                               "this library (every impact)",
                               "by hand",
                               "plain event-driven",
                               "DOP853",
                               "odeint runge_kutta_dopri5",
                               "odeint runge_kutta_fehlberg78",
                               "ARKODE ERKStep",
                               "stiff spring (dopri5)"};

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

// The committed table is of this code. Rounding and the engine move an error by less than a factor
// of two, or by some roundings of t = 200; the picture shows fifteen decades.
TEST_P(OfMethod, HasTheErrorsOfTheCommittedTable) {
  int compared = 0;
  for (const Measured &run : read_measured(SOURCE_DIR "/figures/error_vs_runtime/measured.csv")) {
    if (run.method != method.name || run.problem.starts_with("chain")) continue;
    ++compared;
    const Problem problem = problem_named(run.problem);
    const Error error = error_of(method.run(problem, run.setting), problem);
    SCOPED_TRACE(fmt::format("{} at {} on {}", run.method, run.setting, run.problem));
    EXPECT_LE(error.time, 2.0 * run.error + 1e-12) << error.failure;
    EXPECT_GE(error.time, 0.5 * run.error - 1e-12) << error.failure;
  }
  EXPECT_GE(compared, 5);
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

// A rooted tree by the subtrees of its root.
struct Tree {
  std::vector<Tree> subtrees = {};
  int order = 1;
};

// Every rooted tree with `order` nodes once. The subtrees of a root do not grow along their list.
void add_trees(std::vector<std::vector<Tree>> &of_order, int order, Tree root, std::size_t largest,
               std::size_t last) {
  if (root.order == order) return of_order.back().push_back(root);
  for (std::size_t size =
           std::min<std::size_t>(largest, static_cast<std::size_t>(order - root.order));
       size >= 1; --size)
    for (std::size_t k = 0; k < of_order[size].size() && (size < largest || k <= last); ++k) {
      Tree grown = root;
      grown.subtrees.push_back(of_order[size][k]);
      grown.order += static_cast<int>(size);
      add_trees(of_order, order, grown, size, k);
    }
}

std::vector<std::vector<Tree>> trees_to(int highest) {
  std::vector<std::vector<Tree>> of_order(2);
  of_order[1] = {Tree{}};
  for (int order = 2; order <= highest; ++order) {
    of_order.emplace_back();
    add_trees(of_order, order, Tree{}, static_cast<std::size_t>(order) - 1,
              std::numeric_limits<std::size_t>::max());
  }
  return of_order;
}

// The weight of the exact solution at the end of a step of length one (Butcher): 1 / the product of
// the orders of all subtrees.
double exact_weight(const Tree &tree) {
  double weight = 1.0 / tree.order;
  for (const Tree &subtree : tree.subtrees) weight *= exact_weight(subtree);
  return weight;
}

// The slopes of the stages for the differential of a tree.
std::array<double, dop::stages> slopes_for(const Tree &tree) {
  std::array<double, dop::stages> slopes;
  slopes.fill(1.0);
  for (const Tree &subtree : tree.subtrees) {
    const auto inner = slopes_for(subtree);
    for (std::size_t i = 0; i < dop::stages; ++i) {
      double argument = 0.0;
      for (std::size_t j = 0; j < i; ++j) argument += dop::A[i][j] * inner[j];
      slopes[i] *= argument;
    }
  }
  return slopes;
}

// A Runge-Kutta method has order p if its weight of each of the trees with up to p nodes is exact.
// The coefficients are rounded and as large as 528, so that sums of them are off by 1e-13. A wrong
// digit before the last three of any coefficient shows.
TEST(Dop853, ItsCoefficientsSatisfyTheOrderConditions) {
  const auto trees = trees_to(8);
  std::size_t count = 0;
  for (const auto &of_order : trees)
    for (const Tree &tree : of_order) {
      ++count;
      const auto slopes = slopes_for(tree);
      const auto slope = [&](std::size_t j) { return slopes[j]; };
      const double exact = exact_weight(tree);
      EXPECT_NEAR((dop::sum<dop::A, 12>(slope)), exact, 1e-13) << "order 8, tree " << count;
      if (tree.order <= 5) {
        EXPECT_NEAR((dop::sum<dop::E5, 0>(slope)), 0.0, 1e-13) << "error, tree " << count;
      }
      if (tree.order <= 3) {
        EXPECT_NEAR((dop::sum<dop::E3, 0>(slope)), 0.0, 1e-13) << "error, tree " << count;
      }
      for (const double theta : {0.25, 0.5, 0.9})
        if (tree.order <= 7) {
          EXPECT_NEAR(dop::change_after(theta, dop::dense_output(slope)),
                      exact * std::pow(theta, tree.order), 1e-13)
              << "dense output, tree " << count;
        }
    }
  EXPECT_EQ(count, 200u) << "1 + 1 + 2 + 4 + 9 + 20 + 48 + 115 trees";
  for (std::size_t i = 1; i < dop::stages; ++i)
    EXPECT_NEAR(std::accumulate(dop::A[i].begin(), dop::A[i].end(), 0.0), dop::C[0][i], 1e-14) << i;
}

// DOP853 in `long double` gives the true events of a chain. It shares no code with the library, and
// with the event times rounded to 1e-14 both are off by less than 1e-11.
TEST(ErrorAgainstRunTime, TheLibraryAndDop853HaveTheSameEventsOfAChain) {
  const Problem problem = chain_problem(10);
  EXPECT_EQ(problem.reference_events.size(), 142u);
  for (const Method &method : {this_library().front(), dop853().front()}) {
    const Error error = error_of(method.run(problem, method.settings.back()), problem);
    EXPECT_EQ(error.failure, "") << method.name;
    EXPECT_LT(error.time, 1e-11) << method.name;
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

// The reference's own events, with the first release late by `delay`.
Result exact(const Problem &problem, double delay = 0.0) {
  Result result;
  result.events = problem.reference_events;
  for (Event &event : result.events)
    if (event.kind == EventKind::release) {
      event.instant.phase += delay;
      break;
    }
  return result;
}

// The events are compared as in reference_test. The first one is an impact, for which the next one
// is taken when it is missing.
TEST(Measure, IsTheLargestErrorOfATimeAndFailsForEventsThatDiffer) {
  const Problem problem = problem_named("figure2");
  EXPECT_EQ(error_of(exact(problem), problem).failure, "");
  EXPECT_EQ(error_of(exact(problem), problem).time, 0.0);
  EXPECT_NEAR(error_of(exact(problem, 1e-3), problem).time, 1e-3, 1e-13);  // rounding of t = 14
  Result missing = exact(problem), given_up = missing;
  missing.events.erase(missing.events.begin());
  EXPECT_NE(error_of(missing, problem).failure, "");
  given_up.failure = "stalled";
  EXPECT_EQ(error_of(given_up, problem).failure, "stalled");
}

}  // namespace
