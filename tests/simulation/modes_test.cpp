// The motion of graded chains without stops, of which every natural mode is right relative to its
// own frequency: 3 to 12 masses of 1e-6 to 1e6 on links of 1e-9 to 1e9. Rounding does not set a
// stiff link in motion at a change of the contact mode, and its force keeps its digits.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "reference/generator/closed_form.hpp"
#include "tests/support/random_scenes.hpp"

namespace {

using namespace vibro_impact;
using namespace vibro_impact::testing;

constexpr double epsilon = std::numeric_limits<double>::epsilon();

// The length of what is a displacement, or a velocity, of every mass, each times the root of its
// mass.
double length(const Scene &scene, const std::vector<double> &x) {
  double squared = 0.0;
  for (std::size_t i = 0; i < x.size(); ++i) squared += scene.mass[i] * x[i] * x[i];
  return std::sqrt(squared);
}

// The length of the difference. The modes are orthonormal in this measure, which keeps the digits
// of a heavy mass and not those of a light one beside it: x_light is known to epsilon
// sqrt(m_heavy / m_light).
double distance(const Scene &scene, std::vector<double> a, const std::vector<double> &b) {
  for (std::size_t i = 0; i < a.size(); ++i) a[i] -= b[i];
  return length(scene, a);
}

// The motion of chains without stops, every other one forced, against the closed form in 50 digits.
// Rounding of the frequencies moves the phases: those of a mode of rate w have the size w t
// exp(-beta w^2 t / 2), at most sqrt(t / (e beta)). Times are chosen so that they are below a
// thousand radians. Where a displacement is small and the velocity is not, the phases of an
// undamped chain move it by epsilon t of the velocity. A strongly damped mode is the sum of two
// decays, each as large as its velocity over the faster rate, which is at least 7.8 / beta: the sum
// loses epsilon beta of the velocity.
TEST(Modes, TheMotionOfAChainWithoutStopsAgreesWith50Digits) {
  using namespace vibro_impact_reference;
  constexpr double radians = 1000.0;
  double worst = 0.0;
  for (unsigned seed = 1; seed <= 400; ++seed) {
    const auto scene = seed % 2 == 0 ? forced_chain(seed) : graded_chain(seed);
    Draw draw{std::mt19937(seed)};
    const double fastest = frequency_bound(scene), longest = std::exp(1.0) * scene.beta;
    const double until = std::min(draw.spread(1.0, 1e12) / fastest,
                                  std::max(radians / fastest, radians * radians * longest));
    const double phase =
        scene.beta > 0.0 ? std::min(fastest * until, std::sqrt(until / longest)) : fastest * until;
    const auto exact = in_digits(scene, until);
    Eigensystems known;
    const Flow flow = flow_from(exact, 0, exact.displacement, exact.velocity,
                                std::vector<bool>(scene.mass.size()), known);
    double size = 0.0, speed = 0.0, error = 0.0;
    for (const double time : {0.0, until / 3.0, until / 2.0, until}) {
      const auto truth = motion_at(flow, time);
      const std::vector<double> x(truth.x.begin(), truth.x.end()),
          v(truth.v.begin(), truth.v.end());
      size = std::max(size, length(scene, x));
      speed = std::max(speed, length(scene, v));
      error = std::max(error, distance(scene, simulate(scene, time).state.displacement, x));
    }
    const double allowed =
        ((32.0 + 2.0 * phase) * size + (scene.beta > 0.0 ? scene.beta : until) * speed) * epsilon;
    EXPECT_LE(error, allowed) << seed << " until " << until;
    worst = std::max(worst, error / allowed);
  }
  fmt::print("400 chains, the motion is off by at most {:.2g} of what is allowed\n", worst);
}

// Masses 1 and 2 swing together as cos t, and their link of 1e9 carries no force, while mass 4
// beyond the held mass 3 sticks and is released. The rounding of their displacements would set the
// link in motion at each of these changes, at some 1e-12. 1e-15: some ten roundings of their
// speeds.
TEST(StiffLink, StaysAtRestOverAChangeOfTheContactMode) {
  const Scene scene{.mass = {1.3, 2.1, 1.0, 1.0},
                    .stiffness = {1.3, 1e9, 2.1, 1.0},
                    .amplitude = {0.0, 0.0, 0.0, 0.5},
                    .constant = {0.0, 0.0, 5.0, 0.0},
                    .omega = 0.3,
                    .restitution = 0.0,
                    .stops = {{3, Side::upper, 0.0}, {4, Side::upper, 0.2}},
                    .displacement = {0.1, 0.1, 0.0, 0.0}};
  struct Stretch : Recorder {
    double time = 0.0, largest = 0.0;
    double next_time() const override {
      return time;
    }
    void sample(const Moment &moment) override {
      largest = std::max(largest, std::abs(moment.velocity(2) - moment.velocity(1)));
      time += 0.37;
    }
  } link;
  const Outcome outcome = require_complete(simulate(scene, 100.0, link));
  EXPECT_GE(outcome.counters.releases, 3);
  EXPECT_NEAR(outcome.state.displacement[0], 0.1 * std::cos(100.0), 1e-14);
  EXPECT_LE(link.largest, 1e-15);
}

// Mass 1 is pressed against mass 2, which is held at its stop, through a link of 1e9. It stands
// still while mass 3 sticks and is released. The rounding of its displacement, 1e-17, would be 1e-8
// of the force.
TEST(StiffLink, KeepsItsForceOverAChangeOfTheContactMode) {
  const Scene scene{.mass = {1.0, 1.0, 1.0},
                    .stiffness = {1.0, 1e9, 1.0},
                    .beta = 1e-3,
                    .amplitude = {0.0, 0.0, 0.5},
                    .constant = {2.0, 0.0, 0.0},
                    .omega = 0.3,
                    .restitution = 0.0,
                    .stops = {{2, Side::upper, 0.1}, {3, Side::upper, 0.3}},
                    .displacement = {0.1, 0.1, 0.0}};
  struct Releases : Recorder {
    std::vector<double> forces;
    void event(const Event &event, const Moment &moment) override {
      if (event.mass == 3 && event.kind == EventKind::release)
        forces.push_back(moment.hold_force(2));
    }
  } releases;
  require_complete(simulate(scene, 100.0, releases));
  const double x1 = (1e9 * 0.1 + 2.0) / (1e9 + 1.0);
  ASSERT_GE(releases.forces.size(), 3u);
  for (const double force : releases.forces) EXPECT_NEAR(force, 2.0 - x1 + (0.3 - 0.1), 1e-12);
}

}  // namespace
