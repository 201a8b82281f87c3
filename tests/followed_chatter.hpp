// A mass that has just left its stop and is pressed back, and its chatter followed step by step.
#pragma once

#include "vibro_impact/chatter_tail.hpp"
#include "vibro_impact/vibro_impact.hpp"

namespace vibro_impact::testing {

constexpr int dynamic = Eigen::Dynamic;

// Three masses of which the second has just left its stop and is pressed back by its neighbours.
struct Pressed {
  Scene scene;
  ContactMode<dynamic> mode;
  State<dynamic> state;
  Counters counters;

  double speed;

  Pressed(double beta, double omega, double restitution) : speed(beta > 10.0 ? 1e-3 : 0.06) {
    scene.mass = {1.0, 0.8, 1.3};
    scene.stiffness = {1.0, 1.2, 0.9};
    scene.beta = beta;
    scene.amplitude = {0.3, 0.0, 0.2};
    scene.omega = omega;
    scene.restitution = restitution;
    scene.stops = {{2, Side::upper, 0.1}, {3, Side::upper, 5.0}};
    mode = build_contact_mode<dynamic>(scene, Held(3, 0));
    MotionState motion = start_of(scene);
    motion.displacement << 0.7, 0.1, 0.6;
    motion.velocity << 0.05, -speed, -0.04;
    motion.instant.phase = 0.3;
    state.now = motion.instant;
    set_lanes(state, scene, mode, motion);
    state.stops = {{0.0, speed, 1, speed}, {4.4, 0.04, 0, 0.0}};
  }
  double flight() const {
    return 2.0 * speed * scene.mass[1] / mode.open[0].press(state.value, state.slope);
  }
  // In closed form and in the lanes.
  void fly(double tau) {
    const State<dynamic> from = state;
    flow(mode, scene, from.value, from.slope, tau, state.value, state.slope);
    state.now.phase += tau;
    set_forcing(state, scene);
  }
};

struct Followed {
  Pressed &at;
  Bounces<dynamic> bounces = {};
  ChatterTable table = {};
  std::vector<double> closing = {};
  bool started, goes_on = true;

  explicit Followed(Pressed &pressed) : at(pressed) {
    at.state.mode = &at.mode;
    started = follow(bounces, at.state, at.scene, {0}, at.flight(), at.counters);
    extend(table, predict_limit(bounces));
  }
  bool find() {
    return goes_on && find_next(bounces, at.state, at.counters);
  }
  void apply() {
    fly(bounces, at.state, at.scene, later(at.state.now, bounces.flight, Clock(at.scene.omega)));
    goes_on = bounce(bounces, at.state, at.scene, closing);
    look_on(bounces, at.state, at.counters);
    extend(table, predict_limit(bounces));
  }
  // Up to so many impacts; returns how many.
  int go_on(int most) {
    int impacts = 0;
    for (; impacts < most && find(); ++impacts) apply();
    return impacts;
  }
};

}  // namespace vibro_impact::testing
