// The derivative of the stroboscopic map by the start: against identities that hold exactly, and
// against differences.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "analysis/orbits/tangents.hpp"
#include "reference/scenes/paper_scenes.hpp"
#include "tests/support/events.hpp"
#include "vibro_impact/analysis/analysis.hpp"
#include "vibro_impact/vibro_impact.hpp"

namespace {

using namespace vibro_impact;
using Values = std::vector<double>;

// Five unequal masses under all forces, three stops of which the first has its own r.
Scene chain_of_five() {
  Scene scene;
  scene.mass = {1.0, 1.2, 0.8, 1.0, 0.9};
  scene.stiffness = {1.0, 0.9, 1.1, 1.3, 1.0};
  scene.beta = 0.1;
  scene.amplitude = {0.5, 0.0, 0.1, 0.0, -0.2};
  scene.sine = {0.1, -0.3, 0.0, 0.0, 0.2};
  scene.constant = {-0.05, 0.1, 0.02, 0.0, 0.0};
  scene.ground = {0.0, 0.4, 0.2, 0.0, 0.1};
  scene.omega = 0.3;
  scene.restitution = 0.6;
  scene.stops = {{1, Side::lower, -0.3, 0.7}, {3, Side::upper, 0.2}, {5, Side::upper, 0.15}};
  return scene;
}

// r = 0 with stops that differ. At equal stops (Figure 5(a)) the force on a second held mass is
// zero.
Scene plastic() {
  Scene scene = with(paper::figure5a(), "restitution", 0.0);
  scene.stops[1].position = 0.28;
  return scene;
}

// A slow forcing leaves a slow chatter the time to complete.
Scene slow_chatter() {
  Scene scene = with(paper::figure2(), "restitution", 0.95);
  scene.omega = 0.05;
  return scene;
}

// A scene and a quiet section of its motion after 30 periods.
struct Case {
  std::string name;
  Scene scene;
  MotionState at;
};

Case case_of(const std::string &name, const Scene &scene) {
  return {name, scene, at_quiet_phase(scene, state_after_periods(scene, 30))};
}

// Complete chatter and sticking of one and of two masses, a section inside a sticking phase, two
// sticking phases a period, impacts only, plastic impacts, r near 1, a longer chain.
std::vector<Case> cases() {
  return {case_of("Figure 2", paper::figure2()),
          case_of("Figure 4(b)", paper::figure4b()),
          case_of("impacts only", paper::figure3(0.6)),
          case_of("Figure 5(a)", paper::figure5a()),
          case_of("r = 0", plastic()),
          case_of("r = 0.001", with(plastic(), "restitution", 0.001)),
          case_of("r = 0.95", with(paper::figure5a(), "restitution", 0.95)),
          case_of("slow chatter", slow_chatter()),
          case_of("released by a jump", vibro_impact::testing::released_by_a_jump()),
          case_of("chain of five", chain_of_five())};
}

// The image of the start with one coordinate moved by `step`.
Values image_of(const Case &of, std::size_t row, double step) {
  MotionState at = of.at;
  const std::size_t n = at.held.size();
  (row < n ? at.displacement[row] : at.velocity[row - n]) += step;
  return coordinates(stroboscopic_map(of.scene, at, 1));
}

// Central differences at h, 2 h and 4 h, with Richardson's extrapolation twice: order six. The
// image is good to some 1e-15 times what the motion amplifies, about ten. Over h = 2e-5 that makes
// an error of at most 1e-9, and the remainder h^6 P^(7) lies far below.
TEST(Tangents, EqualDifferences) {
  const double h = 2e-5;
  for (const Case &of : cases()) {
    const StroboscopicImage image = stroboscopic_map_and_derivative(of.scene, of.at, 1);
    ASSERT_TRUE(image.derivative.exists()) << of.name << ": " << image.derivative.why_not();
    for (const std::size_t k : free_coordinates(of.at.held)) {
      Values difference(2 * of.scene.mass.size(), 0.0);
      double step = h;
      for (const double weight : {64.0 / 45.0, -20.0 / 45.0, 1.0 / 45.0}) {
        const Values right = image_of(of, k, step), left = image_of(of, k, -step);
        for (std::size_t i = 0; i < difference.size(); ++i)
          difference[i] += weight * (right[i] - left[i]) / (2.0 * step);
        step *= 2.0;
      }
      for (std::size_t i = 0; i < difference.size(); ++i)
        EXPECT_NEAR(difference[i], (*image.derivative)(i, k), 2e-9)
            << of.name << " " << i << " " << k;
    }
  }
}

// A chatter limit extrapolated from early impacts, and one from impacts that are a thousand times
// slower, agree relative to the derivative: measured 3e-14 for r up to 0.7, and 2e-11 for r = 0.95.
TEST(Tangents, DoNotDependOnWhereChatterIsCarriedToItsLimit) {
  for (const Case &of : {case_of("Figure 2", paper::figure2()),
                         case_of("r = 0.5", with(paper::figure5a(), "restitution", 0.5)),
                         case_of("slow chatter", slow_chatter())}) {
    const StroboscopicImage early = stroboscopic_map_and_derivative(of.scene, of.at, 1);
    const StroboscopicImage late =
        stroboscopic_map_and_derivative(of.scene, of.at, 1, {.limit_below_speed = 1e-6});
    const double tolerance = of.name == "slow chatter" ? 1e-10 : 1e-12;
    const Values &a = early.derivative->values, &b = late.derivative->values;
    double largest = 0.0, difference = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) {
      largest = std::max(largest, std::abs(b[i]));
      difference = std::max(difference, std::abs(a[i] - b[i]));
    }
    EXPECT_LT(difference, tolerance * largest) << of.name;
  }
}

struct BriefEvent {
  double time;
  EventKind kind;
  int mass;
  double speed = 0.3;
};

// Whether the tangents exist after these events of two masses, wherever they are.
bool differentiable_after(const std::vector<BriefEvent> &events) {
  const Scene scene = paper::figure5a();  // stop k is that of mass k
  MotionState state{{}, {0.1, 0.1}, {0.2, 0.2}, {0, 0}};
  std::vector<Knot> knots = {{state}};
  for (const auto &[time, kind, mass, speed] : events) {
    if (changes_contact_mode(kind))
      state.held[static_cast<std::size_t>(mass - 1)] = kind == EventKind::stick ? 1 : 0;
    state.instant = {0, time};
    knots.push_back({state, Event{kind, mass, mass, Side::upper, state.instant, time, speed, -speed,
                                  0, false, state.held}});
  }
  state.instant = {0, 5.0};
  knots.push_back({state});
  Tangents tangents(scene, knots.front().state, Eigen::MatrixXd::Identity(4, 4));
  tangents.pass(knots);
  return tangents.get().exists();
}

// A mass comes to rest differentiably by a plastic impact, or after impacts at its own stop with
// nothing else in between. Neither two impacts at once nor a contact without speed are
// differentiable.
TEST(Tangents, SayWhereTheMotionIsNotDifferentiable) {
  using enum EventKind;
  EXPECT_TRUE(differentiable_after({{1, impact, 1}, {2, stick, 1}}));
  EXPECT_TRUE(differentiable_after({{1, impact, 1}, {1, stick, 1}}));
  EXPECT_TRUE(differentiable_after({{0, stick, 1}}));  // as it starts
  EXPECT_FALSE(differentiable_after({{2, stick, 1}}));
  EXPECT_FALSE(differentiable_after({{1, impact, 2}, {2, stick, 1}}));
  EXPECT_FALSE(differentiable_after({{1, impact, 1}, {1.5, release, 1}, {2, stick, 1}}));
  EXPECT_FALSE(differentiable_after({{1, impact, 1}, {2, stick, 1}, {2, stick, 2}}));
  EXPECT_FALSE(differentiable_after({{1, impact, 1}, {1, release, 2}, {2, stick, 1}}));
  EXPECT_FALSE(differentiable_after({{1, impact, 1}, {1, impact, 2}}));
  EXPECT_FALSE(differentiable_after({{1, impact, 1, 0.0}}));
}

}  // namespace
