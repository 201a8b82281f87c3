// The extreme scenes, group by group: every event against its truth, no penetration, bounded work.
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <ostream>

#include "figures/methods/extreme_verdict.hpp"
#include "vibro_impact/analysis/analysis.hpp"
#include "vibro_impact/vibro_impact.hpp"

namespace {

using namespace vibro_impact;
using namespace vibro_impact::extremes;

const EventTables &reference() {
  static const EventTables tables = figures::read_event_tables(REFERENCE_DIR "/extreme_events.csv");
  return tables;
}

// Rate of the fastest mode of any contact mode or of the forcing.
double fastest_rate(const Scene &scene) {
  const double stiffest = largest_eigenvalue_bound(scene);
  return std::max(root_modulus(scene.beta * stiffest, stiffest), scene.omega);
}

// The longest expansion of a flight, in radians of its fastest rate.
constexpr double max_reach = 2.0;

// The work of a run is bounded by
//   expansions <= rate * until / max_reach + impacts + releases + limits + 1 :
// one per reach of the fastest rate, one per event that ends one early, one to look across the
// limit of a chatter, and
//   root iterations <= 12 * polynomials searched :
// few steps lead to a transversal root, and few over a dip that all but touches zero: stretches
// that are clear grow shorter by powers of two, until one carries over it.
void expect_bounded_work(const Case &extreme, const Counters &counters) {
  const double reaches = fastest_rate(extreme.scene) * extreme.until / max_reach;
  const auto events =
      static_cast<double>(counters.impacts + counters.releases + counters.chatter_limits);
  EXPECT_LE(static_cast<double>(counters.expansions), reaches + events + 1.0) << extreme.name;
  EXPECT_LE(counters.root_iterations, 12 * counters.roots_searched) << extreme.name;
}

std::vector<std::string> groups() {
  std::vector<std::string> names;
  for (const Case &extreme : all_cases())
    if (names.empty() || names.back() != extreme.group) names.push_back(extreme.group);
  return names;
}

class Group : public ::testing::TestWithParam<std::string> {};

// The verdict is that of figures/methods/extreme_verdict.hpp: every event has its counterpart, and
// its time is right to 1e-10 of the period or, where the scene amplifies a change of its start, to
// 100 roundings times that amplification.
TEST_P(Group, AgreesWithTheTruthWithinRounding) {
  for (const Case &extreme : all_cases()) {
    if (extreme.group != GetParam()) continue;
    const Measured measured = measure(extreme, reference());
    EXPECT_EQ(measured.differences.first, "") << extreme.name;
    EXPECT_TRUE(measured.finite) << extreme.name;
    EXPECT_LE(measured.penetration, 1e-12) << extreme.name;
    EXPECT_TRUE(measured.pass) << extreme.name << ": error " << measured.differences.time
                               << ", conditioning " << measured.conditioning;
    expect_bounded_work(extreme, measured.counters);
    // One impact each, of which the last ones are compared: none lost, none added.
    if (extreme.name == "1e+06 periods") {
      EXPECT_EQ(measured.counters.impacts, 1'000'000);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Extremes, Group, ::testing::ValuesIn(groups()), [](const auto &group) {
  std::string name;
  for (const char c : group.param)
    if (std::isalnum(static_cast<unsigned char>(c))) name.push_back(c);
  return name;
});

// A touch takes nothing from the motion: its amplitude stays to 1e-12 (an impact at sqrt(200 eps)
// takes 1e-14 of it), its phase to (1 + r) sqrt(200 eps) a touch.
TEST(Grazing, LeavesTheMotionAsItWas) {
  const double blur = std::sqrt(200.0 * std::numeric_limits<double>::epsilon());
  int touched = 0;
  for (const Case &extreme : all_cases()) {
    if (extreme.truth != Truth::grazing) continue;
    ++touched;
    const MotionState end = simulate(extreme.scene, extreme.until).state;
    const double x0 = extreme.scene.displacement[0];
    const double shift = 1.7 * blur * static_cast<double>(extreme.events.size());
    EXPECT_NEAR(std::hypot(end.displacement[0], end.velocity[0]), 1.0, 1e-12) << extreme.name;
    EXPECT_NEAR(end.displacement[0], x0 * std::cos(extreme.until), shift) << extreme.name;
    EXPECT_NEAR(end.velocity[0], -x0 * std::sin(extreme.until), shift) << extreme.name;
  }
  EXPECT_GE(touched, 4);
}

// A soft mode beside a link 1e6 or 1e12 times as stiff keeps its frequency: lambda_1 lambda_2 = k1
// k2 and lambda_1 + lambda_2 = k1 + 2 k2 for unit masses. A few roundings.
TEST(StiffLink, LeavesTheSoftModeItsFrequency) {
  for (const double stiff : {1e6, 1e12}) {
    Scene scene = chain(2, 0.0);
    scene.stiffness = {1.0, stiff};
    const NaturalModes modes = natural_modes(scene, Held(2, 0));
    const double sum = 1.0 + 2.0 * stiff;
    const double exact = 2.0 * stiff / (sum + std::sqrt(sum * sum - 4.0 * stiff));
    EXPECT_NEAR(modes.lambda.front() / exact, 1.0, 1e-14) << stiff;
  }
}

// At a hold force that is exactly zero a mass bounces for ever and never sticks; its speed falls to
// the smallest double. So it does beside a mass that is held at its own position, as in Figure
// 5(c), whatever the links: the two pulls on it are zero each.
TEST(ZeroHoldForce, NeverSticks) {
  const Outcome outcome = simulate(one_mass(0.0, 0.0, 1.0, 0.3, 0.0, -1.0), 1800.0);
  EXPECT_EQ(outcome.counters.sticks, 0);
  EXPECT_GT(outcome.counters.impacts, 500);
  for (const double s : {0.3, 0.1, 1.0 / 3.0}) {
    Scene scene = chain(2, 0.1);
    scene.stiffness = {1.3, 0.7};
    scene.amplitude = {1e3, 0.0};  // holds mass 1
    scene.omega = 0.0;
    scene.restitution = 0.7;
    scene.stops = {{1, Side::upper, s}, {2, Side::upper, s}};
    scene.displacement = {s, s - 0.5};
    EventRecorder recorder;
    require_complete(simulate(scene, 1000.0, {}, recorder));
    int sticks = 0;
    for (const Event &event : recorder.events) sticks += event.kind == EventKind::stick;
    EXPECT_EQ(sticks, 1) << s;
    EXPECT_GT(recorder.events.size(), 200u) << s;
  }
}

// r = 1 and a stop that presses: the flights shorten without limit towards none, each as fast as
// the one before. The run ends at the stated number of impacts, and says where it was.
TEST(EndlessImpacts, EndAtTheLimitWithTheState) {
  Scene scene = one_mass(0.0, 1.0, 0.0, 1.0, -1.0, -1.0 - 1e-9);
  EventRecorder recorder;
  const Outcome outcome = simulate(scene, 1e3, {.max_impacts_per_period = 5000}, recorder);
  EXPECT_EQ(outcome.ending, Ending::given_up);
  EXPECT_NE(outcome.reason.find("more than 5000 impacts in one period"), std::string::npos)
      << outcome.reason;
  EXPECT_NE(outcome.reason.find("t = "), std::string::npos) << outcome.reason;
  EXPECT_EQ(outcome.reason.find('\n'), std::string::npos) << outcome.reason;
  EXPECT_EQ(outcome.counters.impacts, 5001);  // the last is the one that was too many
  ASSERT_EQ(recorder.events.size(), 5001u);
  EXPECT_EQ(outcome.time, recorder.events.back().time);
  EXPECT_EQ(outcome.state.displacement[0], -1.0);
  EXPECT_EQ(outcome.state.velocity[0], recorder.events.back().velocity_after);
  EXPECT_THROW(require_complete(outcome), std::runtime_error);
}

}  // namespace
