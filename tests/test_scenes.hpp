// What the tests of the library share: small scenes, and an integration of the equations of motion
// that knows nothing of modes (Boost.Odeint in extended precision).
#pragma once

#include <algorithm>
#include <boost/numeric/odeint.hpp>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "vibro_impact/vibro_impact.hpp"

namespace vibro_impact::testing {

constexpr double epsilon = std::numeric_limits<double>::epsilon();

// n unit masses on unit springs, no stops, unforced, at rest.
inline Scene equal_chain(int n, double beta) {
  Scene scene;
  scene.mass.assign(static_cast<std::size_t>(n), 1.0);
  scene.stiffness = scene.mass;
  scene.beta = beta;
  return scene;
}

// n masses and springs drawn from [0.2, 5], start and forcing drawn from [-1, 1]; no stops.
inline Scene random_chain(int n, unsigned seed, double beta) {
  std::mt19937 generator(seed);
  std::uniform_real_distribution<double> logarithm(std::log(0.2), std::log(5.0)), even(-1.0, 1.0);
  Scene scene;
  for (int i = 0; i < n; ++i) {
    scene.mass.push_back(std::exp(logarithm(generator)));
    scene.stiffness.push_back(std::exp(logarithm(generator)));
    scene.amplitude.push_back(even(generator));
    scene.displacement.push_back(even(generator));
    scene.velocity.push_back(even(generator));
  }
  scene.beta = beta;
  scene.omega = 0.7;
  return scene;
}

// One mass pressed by the constant force `force` onto an upper stop at 0, started `height` away
// from it at rest: the bouncing ball, with a spring.
inline Scene pressed_mass(double force, double stiffness, double beta, double height, double r) {
  Scene scene = equal_chain(1, beta);
  scene.stiffness = {stiffness};
  scene.amplitude = {force};
  scene.omega = 0.0;
  scene.restitution = r;
  scene.stops = {{1, Side::upper, 0.0}};
  scene.displacement = {-height};
  return scene;
}

inline std::vector<Event> of_kind(const std::vector<Event> &events, EventKind kind, int mass) {
  std::vector<Event> selected;
  for (const Event &event : events)
    if (event.kind == kind && event.mass == mass) selected.push_back(event);
  return selected;
}

// --- The equations of motion (Eqs. 1-4) link by link, in extended precision ----------------------

using Extended = std::vector<long double>;  // x_1 .. x_N, x_1' .. x_N'

struct Equations {
  const Scene &scene;
  Held held;

  void operator()(const Extended &y, Extended &rate, long double t) const {
    const std::size_t n = scene.mass.size();
    rate.assign(2 * n, 0.0L);
    const auto stretch = [&](std::size_t at, std::size_t i) {  // of link i, or its rate
      return y[at + i] - (i > 0 ? y[at + i - 1] : 0.0L);
    };
    const auto pull = [&](std::size_t i) {  // of link i on mass i - 1
      return scene.stiffness[i] * (stretch(0, i) + scene.beta * stretch(n, i));
    };
    for (std::size_t i = 0; i < n; ++i) {
      if (held[i] != 0) continue;
      long double force = -pull(i);
      if (i + 1 < n) force += pull(i + 1);
      if (!scene.amplitude.empty()) force += scene.amplitude[i] * std::cos(scene.omega * t);
      rate[i] = y[n + i];
      rate[n + i] = force / scene.mass[i];
    }
  }
};

inline Extended extended(const MotionState &motion) {
  Extended y;
  for (double x : motion.displacement) y.push_back(x);
  for (double v : motion.velocity) y.push_back(v);
  return y;
}

using FehlbergStep =
    boost::numeric::odeint::runge_kutta_fehlberg78<Extended, long double, Extended, long double>;

// The flow of one contact mode from time `from` to `to`: Runge-Kutta-Fehlberg 7(8), local error
// below 1e-18, far less than the rounding of the doubles compared with it.
inline Extended integrate(const Scene &scene, const Held &held, Extended y, long double from,
                          long double to) {
  using namespace boost::numeric::odeint;
  if (to > from)
    integrate_adaptive(make_controlled(1e-18L, 1e-18L, FehlbergStep()), Equations{scene, held}, y,
                       from, to, std::min(0.01L, to - from));
  return y;
}

}  // namespace vibro_impact::testing
