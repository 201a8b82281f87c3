// The stroboscopic map differentiated by the start and by parameters of the scene: against
// identities that hold exactly, and differences.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "reference/paper_scenes.hpp"
#include "vibro_impact/analysis/analysis.hpp"
#include "vibro_impact/vibro_impact.hpp"

namespace {

using namespace vibro_impact;
using Kind = Parameter::Kind;
using Values = std::vector<double>;

// Five unequal masses, three of them forced, three stops of which the first has its own r.
Scene chain_of_five() {
  Scene scene;
  scene.mass = {1.0, 1.2, 0.8, 1.0, 0.9};
  scene.stiffness = {1.0, 0.9, 1.1, 1.3, 1.0};
  scene.beta = 0.1;
  scene.amplitude = {0.5, 0.0, 0.1, 0.0, -0.2};
  scene.omega = 0.3;
  scene.restitution = 0.6;
  scene.stops = {{1, Side::lower, -0.3, 0.7}, {3, Side::upper, 0.2}, {5, Side::upper, 0.15}};
  return scene;
}

Scene with_restitution(Scene scene, double r) {
  scene.restitution = r;
  return scene;
}

// r = 0 with stops that differ: at equal ones (Figure 5(a)) the force on a second mass held is
// zero.
Scene plastic() {
  Scene scene = with_restitution(paper::figure5a(), 0.0);
  scene.stops[1].position = 0.28;
  return scene;
}

// A scene and a quiet section of its settled motion.
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
          case_of("impacts only", paper::stops_of_different_sign(0.6)),
          case_of("Figure 5(a)", paper::figure5a()),
          case_of("r = 0", plastic()),
          case_of("r = 0.001", with_restitution(plastic(), 0.001)),
          case_of("r = 0.95", with_restitution(paper::figure5a(), 0.95)),
          case_of("chain of five", chain_of_five())};
}

std::vector<Parameter> all_of(const Scene &scene, const std::vector<Kind> &kinds) {
  std::vector<Parameter> all;
  for (const Kind kind : kinds) {
    const bool bare = kind == Kind::omega || kind == Kind::beta || kind == Kind::restitution;
    const int count = kind == Kind::stop ? static_cast<int>(scene.stops.size()) : scene.masses();
    for (int i = 1; i <= (bare ? 1 : count); ++i) all.push_back({kind, bare ? 0 : i});
  }
  return all;
}

std::size_t index_of(const Parameter &by) {
  return static_cast<std::size_t>(by.index - 1);
}

double largest(const Values &values) {
  double most = 0.0;
  for (const double value : values) most = std::max(most, std::abs(value));
  return most;
}

// The change of the image when all parameters of these kinds, and the displacements and velocities
// at the start, change by the given multiples of themselves.
Values rescaled(const Case &of, const std::vector<std::pair<Kind, double>> &multiples,
                double displacements, double velocities) {
  std::vector<Kind> kinds;
  for (const auto &[kind, multiple] : multiples) kinds.push_back(kind);
  const auto by = all_of(of.scene, kinds);
  const StroboscopicImage image = stroboscopic_map_and_derivative(of.scene, of.at, 1, {}, by);
  EXPECT_TRUE(image.differentiable) << of.name;
  EXPECT_LT(image.chatter_error, 1e-12) << of.name;
  const Values start = coordinates(of.at);
  Values sum(start.size(), 0.0);
  for (std::size_t i = 0; i < sum.size(); ++i) {
    for (std::size_t k = 0; k < start.size(); ++k)
      sum[i] += image.derivative(i, k) * start[k] *
                (k < of.scene.mass.size() ? displacements : velocities);
    for (std::size_t k = 0; k < by.size(); ++k)
      for (const auto &[kind, multiple] : multiples)
        if (by[k].kind == kind)
          sum[i] += multiple * get(of.scene, by[k]) * image.by_parameters(i, k);
  }
  return sum;
}

// Exact identities: other units of length, of time and of mass do not change the motion. They hold
// to rounding and to the error of the chatter limits (up to 4e-13): 1e-12 of values of size one.
constexpr double exact = 1e-12;

// - of length: all stops, amplitudes and the start times c; the image times c;
// - of time: Omega times c, stiffness and amplitudes times c^2, beta over c, the velocities at the
//   start times c; the same motion at the same phase, with velocities times c;
// - of mass: masses, stiffness and amplitudes times c; the same motion.
TEST(MapByParameters, KeepsTheUnits) {
  struct Unit {
    const char *of;
    std::vector<std::pair<Kind, double>> multiples;
    double displacements, velocities;  // at the start, and of the image
  };
  const Unit units[] = {
      {"length", {{Kind::stop, 1.0}, {Kind::amplitude, 1.0}}, 1.0, 1.0},
      {"time",
       {{Kind::omega, 1.0}, {Kind::beta, -1.0}, {Kind::stiffness, 2.0}, {Kind::amplitude, 2.0}},
       0.0,
       1.0},
      {"mass", {{Kind::mass, 1.0}, {Kind::stiffness, 1.0}, {Kind::amplitude, 1.0}}, 0.0, 0.0}};
  for (const Case &of : cases())
    for (const auto &[unit, multiples, displacements, velocities] : units) {
      Values sum = rescaled(of, multiples, displacements, velocities);
      const Values end = coordinates(stroboscopic_map(of.scene, of.at, 1).state);
      for (std::size_t i = 0; i < end.size(); ++i)
        sum[i] -= end[i] * (i < of.scene.mass.size() ? displacements : velocities);
      EXPECT_LT(largest(sum), exact) << of.name << ", unit of " << unit;
    }
}

// The image of the same start at the same phase with a parameter moved, or a coordinate of the
// start itself; held masses stay at stops.
Values image_at(const Case &of, const Parameter &by, double step) {
  MotionState at = of.at;
  if (by.kind == Kind::displacement) at.displacement[index_of(by)] += step;
  if (by.kind == Kind::velocity) at.velocity[index_of(by)] += step;
  const Scene moved = with(of.scene, by, get(of.scene, by) + step);
  at.instant.phase *= of.scene.omega / moved.omega;
  for (const Stop &stop : moved.stops) {
    const auto i = static_cast<std::size_t>(stop.mass - 1);
    if (at.held[i] == static_cast<signed char>(stop.side)) at.displacement[i] = stop.position;
  }
  return coordinates(stroboscopic_map(moved, at, 1).state);
}

// The sum of coefficients times the images at multiples of h.
Values combined(const Case &of, const Parameter &by, double h,
                const std::vector<std::pair<double, double>> &coefficients) {
  Values sum(2 * of.scene.mass.size(), 0.0);
  for (const auto &[multiple, coefficient] : coefficients) {
    const Values image = image_at(of, by, multiple * h);
    for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += coefficient / h * image[i];
  }
  return sum;
}

// Central differences at h, 2 h and 4 h, Richardson's extrapolation twice: order six.
Values by_differences(const Case &of, const Parameter &by, double h) {
  Values sum(2 * of.scene.mass.size(), 0.0);
  const double weights[] = {64.0 / 45.0, -20.0 / 45.0, 1.0 / 45.0};
  double multiple = 1.0;
  for (const double weight : weights) {
    const Values part = combined(
        of, by, h, {{multiple, 0.5 * weight / multiple}, {-multiple, -0.5 * weight / multiple}});
    for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += part[i];
    multiple *= 2.0;
  }
  return sum;
}

double distance(const Values &a, const Matrix &b, std::size_t column) {
  double most = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) most = std::max(most, std::abs(a[i] - b(i, column)));
  return most;
}

// The image is good to some 1e-15 times what the motion amplifies, about ten; over h = 2e-5 that
// is 1e-9 at most, and the remainder h^6 P^(7) far below. The derivative itself is far better.
TEST(MapByParameters, EqualsDifferencesByEveryParameter) {
  for (const Case &of : cases()) {
    std::vector<Parameter> by =
        all_of(of.scene, {Kind::omega, Kind::beta, Kind::restitution, Kind::stop, Kind::amplitude,
                          Kind::mass, Kind::stiffness});
    by.push_back({Kind::restitution, 1});
    const StroboscopicImage image = stroboscopic_map_and_derivative(of.scene, of.at, 1, {}, by);
    for (std::size_t k = 0; k < by.size(); ++k) {
      if (get(of.scene, by[k]) == 0.0 && by[k].kind == Kind::restitution) {
        // One-sided, of second order, remainder h^2 P'''.
        const Values slope = combined(of, by[k], 1e-5, {{0.0, -1.5}, {1.0, 2.0}, {2.0, -0.5}});
        EXPECT_LT(distance(slope, image.by_parameters, k), 1e-8) << of.name << " " << name(by[k]);
        continue;
      }
      EXPECT_LT(distance(by_differences(of, by[k], 2e-5), image.by_parameters, k), 2e-9)
          << of.name << " " << name(by[k]);
    }
  }
}

// By the start likewise: every displacement and velocity of a free mass.
TEST(MapByTheStart, EqualsDifferences) {
  for (const Case &of : cases()) {
    const Matrix derivative = stroboscopic_map_and_derivative(of.scene, of.at, 1).derivative;
    const std::vector<Parameter> start = all_of(of.scene, {Kind::displacement, Kind::velocity});
    for (const std::size_t k : free_coordinates(of.at.held))
      EXPECT_LT(distance(by_differences(of, start[k], 2e-5), derivative, k), 2e-9)
          << of.name << " " << name(start[k]);
  }
}

// Columns of the start are the same bits whether or not parameters are asked for; nothing is kept
// that was not.
TEST(MapByParameters, CostsNothingWhereItIsNotAskedFor) {
  const Case of = case_of("Figure 2", paper::figure2());
  const auto by = all_of(of.scene, {Kind::omega, Kind::restitution});
  const StroboscopicImage plain = stroboscopic_map_and_derivative(of.scene, of.at, 1),
                          with_parameters =
                              stroboscopic_map_and_derivative(of.scene, of.at, 1, {}, by);
  EXPECT_EQ(plain.derivative.values, with_parameters.derivative.values);
  EXPECT_EQ(plain.counters.expansions, with_parameters.counters.expansions);
  EXPECT_TRUE(plain.by_parameters.values.empty());
  TangentRecorder tangents(of.scene, of.at, Matrix(4, 1));
  const Outcome end = simulate_from(of.scene, of.at, 60.0, {}, tangents);
  EXPECT_TRUE(tangents.finish(end.state.instant).events.empty());
}

}  // namespace
