// The corrections to the paper's print. Each has the printed form beside the right one, and the
// library's motion tells them apart.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "figures/panel.hpp"
#include "figures/printed.hpp"
#include "reference/paper_scenes.hpp"
#include "tests/events.hpp"
#include "vibro_impact/analysis/analysis.hpp"
#include "vibro_impact/vibro_impact.hpp"

namespace {

using namespace vibro_impact;

MotionState state_at(const Scene &scene, double time) {
  return require_complete(simulate(scene, time)).state;
}

// Eq. 24: mass 1, while mass 2 sticks at s2, oscillates about + s2 / 2, not about - s2 / 2. The
// first sticking phase of mass 2 in Figure 2 is compared, from a tenth of it on.
TEST(Corrections, Equation24EndsWithPlusHalfOfS2) {
  const Scene scene = paper::figure2();
  const auto events = vibro_impact::testing::events_of(scene, 0.0, 50.0);
  const auto stick = std::find_if(events.begin(), events.end(), [](const Event &event) {
    return event.kind == EventKind::stick && event.mass == 2;
  });
  ASSERT_LT(stick, events.end() - 1);
  const double phase = (stick + 1)->time - stick->time, begin = stick->time + 0.1 * phase;
  const MotionState start = state_at(scene, begin);
  ASSERT_EQ(start.held, (Held{0, 1}));
  // Steady response of x1'' + kappa x1' + lambda x1 = 0.5 cos(Omega t) + s2.
  const double s2 = scene.stops[1].position, omega = scene.omega, lambda = 2.0, kappa = 0.2;
  const double detuning = lambda - omega * omega, drag = kappa * omega,
               size = 0.5 / (detuning * detuning + drag * drag);
  const auto steady = [&](double t) {
    return size * (detuning * std::cos(omega * t) + drag * std::sin(omega * t));
  };
  const double steady_velocity =
      size * omega * (drag * std::cos(omega * begin) - detuning * std::sin(omega * begin));
  // The free motion x'' + kappa x' + lambda x = 0 from x0, v0.
  const double decay = kappa / 2, damped = std::sqrt(lambda - decay * decay);
  const auto free = [&](double x0, double v0, double t) {
    return std::exp(-decay * t) *
           (x0 * std::cos(damped * t) + (v0 + decay * x0) / damped * std::sin(damped * t));
  };
  for (const double part : {0.3, 0.6, 0.9}) {
    const double time = stick->time + part * phase, x1 = state_at(scene, time).displacement[0];
    const auto equation24 = [&](double offset) {
      const double x0 = start.displacement[0] - offset - steady(begin);
      return free(x0, start.velocity[0] - steady_velocity, time - begin) + steady(time) + offset;
    };
    EXPECT_NEAR(equation24(s2 / 2), x1, 1e-14);
    EXPECT_GT(std::abs(equation24(-s2 / 2) - x1), 1e-3);
  }
}

// Eqs. 17-18: the stiffness term of a modal equation is omega_n^2 q, as in Eq. 7.
TEST(Corrections, Equations17And18NeedTheSquareOfTheNaturalFrequency) {
  const double t = 3.0;
  Scene scene = paper::figure2();
  scene.stops.clear();
  const NaturalModes modes = natural_modes(scene, Held{0, 0});
  const MotionState state = state_at(scene, t);
  const std::vector<double> a = acceleration(scene, state);
  for (std::size_t j : {0u, 1u}) {
    const double psi1 = modes.shape(0, j), psi2 = modes.shape(1, j), lambda = modes.lambda.at(j),
                 natural = std::sqrt(lambda), zeta = 0.05 * natural;
    const double q = psi1 * state.displacement[0] + psi2 * state.displacement[1],
                 dq = psi1 * state.velocity[0] + psi2 * state.velocity[1],
                 ddq = psi1 * a[0] + psi2 * a[1];
    const double rest = ddq + 2 * zeta * natural * dq - psi1 * 0.5 * std::cos(scene.omega * t);
    EXPECT_NEAR(rest + natural * natural * q, 0.0, 1e-14);
    EXPECT_GT(std::abs(rest + natural * q), 1e-3);
  }
}

// The force of Eq. 20, printed as F2, acts on mass 1, and the force of Eq. 23, printed as F1, on
// mass 2. At a release the force on the released mass is zero and the other one is not.
struct Releases {
  double omega;
  std::vector<std::array<double, 3>> values = {};  // mass, Eq. 20, Eq. 23

  void event(const Event &event, const Moment &moment) {
    if (event.kind != EventKind::release || event.by_a_jump || event.mass > 2) return;
    const double x1 = moment.displacement(1), x2 = moment.displacement(2), v1 = moment.velocity(1),
                 v2 = moment.velocity(2);
    values.push_back({static_cast<double>(event.mass),
                      0.1 * v2 + x2 - 2 * -0.3 + 0.5 * std::cos(omega * moment.instant.phase),
                      0.1 * v1 + x1 - 0.1});
  }
};

TEST(Corrections, Equation20IsTheForceOnMass1AndEquation23ThatOnMass2) {
  const Scene scene = paper::figure2();
  Releases releases{scene.omega};
  require_complete(simulate(scene, 750.0, releases));
  ASSERT_FALSE(releases.values.empty());
  for (const auto &[mass, equation20, equation23] : releases.values) {
    EXPECT_NEAR(mass == 1.0 ? equation20 : equation23, 0.0, 1e-14);
    EXPECT_GT(std::abs(mass == 1.0 ? equation23 : equation20), 1e-3);
  }
}

// "F_p s_p > 0 holds the mass" reads the side of a stop from the sign of its position. At a lower
// stop above the origin, or at zero, a mass sticks with F_p s_p <= 0.
TEST(Corrections, TheSideOfAStopIsNotTheSignOfItsPosition) {
  for (double place : {0.2, 0.0}) {
    Scene scene{.mass = {1.0}, .stiffness = {1.0}, .amplitude = {-0.5}, .omega = 0.1};
    scene.stops = {{1, Side::lower, place}};
    scene.displacement = {place};
    scene.restitution = 0.5;
    figures::StickingPhaseRecorder force;
    force.to = 5.0;
    force.every = 0.5;
    const Outcome outcome = simulate(scene, 5.0, force);
    EXPECT_EQ(outcome.state.held, Held{-1});
    ASSERT_GT(force.rows.size(), 5u);
    for (const auto &row : force.rows) EXPECT_LE(row.force * place, 0.0);
    for (const auto &row : force.rows) EXPECT_LT(row.force, 0.0);  // presses downwards
  }
}

// The force that presses mass 2 into its stop while both masses stick. It does not depend on the
// forcing, which acts on mass 1 only.
double press_on_second(const Scene &scene) {
  MotionState at_stops = start_of(scene);
  at_stops.displacement = {scene.stops[0].position, scene.stops[1].position};
  return pressing_force(scene, scene.stops[1], at_stops);
}

// Figure 5(b), "subsequent dynamics involve dual sticking": with s1 < s2 the force on mass 2, both
// at rest at their upper stops, is k (s1 - s2) < 0 at every phase. (That none occurs in the run is
// the key number figure5b_dual_sticks.)
TEST(Corrections, Figure5bHasNoDualSticking) {
  EXPECT_NEAR(press_on_second(paper::figure5b()), -0.15, 1e-15);
}

// Figure 5(c), "reduction of Omega and/or r leads to dual sticking": with s1 = s2 the force on
// mass 2 is zero, whatever Omega and r are. (That none occurs when both are reduced is the key
// number figure5c_dual_sticks.)
TEST(Corrections, Figure5cHasNoDualStickingAtLowerFrequencyOrRestitution) {
  EXPECT_EQ(press_on_second(paper::figure5c()), 0.0);
}

// Half a period of the damped mass on its own spring, zeta = 0.05, and the decay over it; 1e-12 is
// a few units in the last place of t.
TEST(Corrections, Figure5cBouncesOnAtAConstantInterval) {
  const auto events = vibro_impact::testing::events_of(paper::figure5c(), 920.0, 985.0);
  const double zeta = 0.05, interval = std::acos(-1.0) / std::sqrt(1.0 - zeta * zeta),
               ratio = 0.7 * std::exp(-zeta * interval);
  ASSERT_GE(events.size(), 20u);
  for (std::size_t i = 1; i < events.size(); ++i) {
    EXPECT_NEAR(events[i].time - events[i - 1].time, interval, 1e-12);
    EXPECT_NEAR(events[i].velocity_before / events[i - 1].velocity_before, ratio, 1e-9);
  }
}

// Section 3.2, "the region of sticking motions all exist at forcing frequencies < 0.5": mass 1
// sticks again between 0.632 and about 0.69, every period or every other one, with gaps; mass 2
// does not.
TEST(Corrections, Mass1SticksAgainAboveTheFrequencyOneHalf) {
  using namespace vibro_impact::testing;
  const auto sticks_in_ten_periods = [](double omega, int mass) {
    const double until = 200.0 * Clock(omega).period, from = until - 10.0 * Clock(omega).period;
    return select(events_of(paper::figure3(omega), from, until), EventKind::stick, mass).size();
  };
  for (const double omega : {0.48, 0.51, 0.6, 0.63, 0.68, 0.695})
    EXPECT_EQ(sticks_in_ten_periods(omega, 1), 0u) << omega;
  for (const double omega : {0.633, 0.65, 0.685})  // every other period
    EXPECT_EQ(sticks_in_ten_periods(omega, 1), 5u) << omega;
  EXPECT_EQ(sticks_in_ten_periods(0.665, 1), 10u);
  for (const double omega : {0.51, 0.6, 0.65, 0.665, 0.695})
    EXPECT_EQ(sticks_in_ten_periods(omega, 2), 0u) << omega;
}

// The bounds in the table follow from the paper's words: half a unit of the last digit, the ticks
// that a value lies between, a twentieth of a tick where it is read off Figure 3. A number without
// words has no bounds.
TEST(Verdicts, TheTableSaysWhatThePrintCanTell) {
  const auto numbers = figures::read_key_numbers(REFERENCE_DIR "/key_numbers.csv");
  ASSERT_FALSE(numbers.empty());
  for (const figures::KeyNumber &number : numbers) {
    const figures::Printed &printed = number.printed;
    const std::string &words = printed.words;
    const auto to = words.find(" to ");
    double from = printed.from, until = printed.from;  // a count, or a mass that touches its stop
    if (const auto value = figures::as_number(words)) {
      const auto point = words.find('.');
      const std::size_t decimals = point == std::string::npos ? 0 : words.size() - point - 1;
      const double half = 0.5 * std::pow(10.0, -static_cast<double>(decimals));
      from = *value - half;
      until = *value + half;
    } else if (words.starts_with("about ")) {
      from = std::stod(words.substr(6)) - 0.05 / 20.0;
      until = from + 0.1 / 20.0;
    } else if (!words.empty() && std::isinf(printed.to)) {  // the statement that it happens
      from = 1.0;
      until = printed.to;
    } else if (words.empty()) {
      from = until = std::numeric_limits<double>::infinity();
    } else if (to != std::string::npos) {
      from = std::stod(words);
      until = std::stod(words.substr(to + 4));
    }
    EXPECT_DOUBLE_EQ(printed.from, from) << number.symbol;
    EXPECT_DOUBLE_EQ(printed.to, until) << number.symbol;
  }
}

TEST(Verdicts, FollowFromTheBounds) {
  const std::string agrees = "agrees with the paper", differs = "differs from the paper by ";
  const figures::Printed value{"0.382", 0.3815, 0.3825}, count{"dual sticking", 1.0, HUGE_VAL};
  EXPECT_EQ(value.sentence(0.38197), agrees);
  EXPECT_EQ(value.sentence(0.38251), differs + "+0.00051");
  EXPECT_EQ(value.sentence(0.38149), differs + "-0.00051");
  EXPECT_EQ(count.sentence(0.0), "differs from the paper: never");
  EXPECT_EQ(count.sentence(3.0), agrees);
  EXPECT_EQ(figures::Printed().sentence(1.0), "not in the paper");
}

}  // namespace
