// The totals of the stops: closed forms of a bouncing mass, no dependence on the cut of chatter,
// additivity over time, and the pressing force of the library summed up.
#include <cmath>
#include <string>
#include <vector>

#include "program/summary.hpp"
#include "reference/scenes/paper_scenes.hpp"
#include "tests/support/runner_program.hpp"
#include "vibro_impact/simulate.hpp"

namespace {

using namespace vibro_impact;

truth::Rows totals(const Scene &scene, double from, double to, const RunOptions &options = {}) {
  runner::Summary summary(scene, from, to);
  require_complete(simulate(scene, to, options, summary));
  return vibro_impact::testing::rows_in(summary.table().text);
}

// Both stops of the first of three masses, all terms of the equation of motion, and sticking.
Scene rich_scene() {
  return {.mass = {1.0, 2.0, 0.5},
          .stiffness = {1.0, 2.0, 0.7},
          .beta = 0.1,
          .amplitude = {0.5, 0.0, 0.2},
          .sine = {0.0, 0.3, 0.0},
          .constant = {0.0, 0.1, 0.0},
          .ground = {0.3, 0.2, 0.1},
          .omega = 0.3,
          .restitution = 0.6,
          .stops = {{1, Side::lower, -0.3}, {1, Side::upper, 0.2}, {3, Side::upper, 0.25}}};
}

// A mass of weight m falls from height 1/2 in a field of strength 1, half of it a forcing that does
// not turn, and comes to rest at the time (1 + r) / (1 - r). Up to then the impulse is the weight
// times the time; all energy is lost. The n impacts that were resolved have the speeds 1, r, r^2,
// .... The tolerance is that of the extrapolation over the ten impacts of r = 0.9.
TEST(Summary, ABouncingMassHasItsClosedForms) {
  for (const double r : {0.0, 0.5, 0.9}) {
    const double m = 2.0, rest = (1.0 + r) / (1.0 - r), to = 30.0;
    const truth::Row row = totals({.mass = {m},
                                   .stiffness = {0.0},
                                   .amplitude = {-m / 2.0},
                                   .constant = {-m / 2.0},
                                   .omega = 0.0,
                                   .restitution = r,
                                   .stops = {{1, Side::lower, 0.0}},
                                   .displacement = {0.5}},
                                  0.0, to)
                               .at(0);
    const double n = row.number("impacts"),
                 mean_square = (1.0 - std::pow(r, 2.0 * n)) / (1.0 - r * r) / n;
    EXPECT_NEAR(row.number("mean_speed"), (1.0 - std::pow(r, n)) / (1.0 - r) / n, 1e-14) << r;
    EXPECT_NEAR(row.number("rms_speed"), std::sqrt(mean_square), 1e-14) << r;
    EXPECT_NEAR(row.number("largest_speed"), 1.0, 1e-15) << r;
    EXPECT_EQ(row.number("sticks"), 1.0);
    EXPECT_NEAR(row.number("impulse"), m * rest, 1e-13 * m * rest) << r;
    EXPECT_NEAR(row.number("energy_lost"), m / 2.0, 1e-14) << r;
    EXPECT_NEAR(row.number("contact_time"), to - rest, 1e-13 * to) << r;
    EXPECT_NEAR(row.number("pressing_impulse"), m * (to - rest), 1e-13 * m * to) << r;
  }
}

// A limit is accepted at an error of 1e-13 of its time. Five orders more are left for the states at
// the limit, which have the errors of lib/README.md.
TEST(Summary, ImpulseAndEnergyDoNotDependOnTheCutOfChatter) {
  for (const Scene &scene : {paper::figure2(), rich_scene()}) {
    const auto resolved = totals(scene, 0.0, 100.0, {.limit_below_speed = 0.0});
    for (const double cut : {1e-3, infinity}) {
      const auto rows = totals(scene, 0.0, 100.0, {.limit_below_speed = cut});
      for (std::size_t k = 0; k < rows.size(); ++k) {
        EXPECT_EQ(rows.at(k).cell("sticks"), resolved.at(k).cell("sticks"));
        EXPECT_LE(rows.at(k).number("impacts"), resolved.at(k).number("impacts"));
        for (const char *column : {"impulse", "energy_lost", "contact_time", "pressing_impulse"})
          EXPECT_NEAR(rows.at(k).number(column), resolved.at(k).number(column),
                      1e-10 * resolved.at(k).number(column))
              << "stop " << k + 1 << ", column " << column;
      }
    }
  }
}

// The pressing force that the library reports, on the side of each stop, summed up at distances h.
struct Press : Recorder {
  const Scene &scene;
  static constexpr double h = 1e-3;
  double taken = 0.0;
  std::vector<double> sum;

  explicit Press(const Scene &of) : scene(of), sum(of.stops.size(), 0.0) {
  }
  double next_time() const override {
    return (taken + 0.5) * h < 100.0 ? (taken + 0.5) * h : infinity;
  }
  void sample(const Moment &moment) override {
    ++taken;
    for (std::size_t k = 0; k < sum.size(); ++k)
      if (const double press = sign(scene.stops[k].side) * moment.hold_force(scene.stops[k].mass);
          press > 0.0)
        sum[k] += h * press;
  }
};

// The sum misses at most h times the force at the ends of each phase, which stays below 1.
TEST(Summary, StopsPressAsTheForceDoes) {
  for (const Scene &scene : {paper::figure2(), rich_scene()}) {
    Press press(scene);
    require_complete(simulate(scene, 100.0, press));
    const auto rows = totals(scene, 0.0, 100.0);
    for (std::size_t k = 0; k < rows.size(); ++k) {
      EXPECT_GT(rows.at(k).number("sticks"), 0.0) << k;
      EXPECT_NEAR(rows.at(k).number("pressing_impulse"), press.sum[k],
                  Press::h * rows.at(k).number("sticks"))
          << "stop " << k + 1;
    }
  }
}

// The window ends in flight (t = 28), or while a mass sticks (t = 35).
TEST(Summary, PartsOfTheTimeAddUp) {
  const Scene scene = paper::figure2();
  const auto whole = totals(scene, 0.0, 100.0);
  for (const double cut : {28.0, 35.0}) {
    const auto first = totals(scene, 0.0, cut), second = totals(scene, cut, 100.0);
    for (std::size_t k = 0; k < whole.size(); ++k)
      for (const char *column :
           {"impacts", "sticks", "impulse", "energy_lost", "contact_time", "pressing_impulse"})
        EXPECT_NEAR(first.at(k).number(column) + second.at(k).number(column),
                    whole.at(k).number(column), 1e-12 * whole.at(k).number(column))
            << cut << ", stop " << k + 1 << ", column " << column;
  }
}

}  // namespace
