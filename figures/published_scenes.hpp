// The scenes of published results, in the symbols of their sources, and how each published quantity
// is read off a run. A result is a row of reference/published.csv: `quantity` names one of the
// functions here, `parameters` is what it is given.
#pragma once

#include <cmath>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

#include "one_impact_orbit.hpp"
#include "reference/scenes/extreme_scenes.hpp"
#include "vibro_impact/analysis/analysis.hpp"
#include "vibro_impact/vibro_impact.hpp"

namespace vibro_impact::figures::published {

using extremes::one_mass;

// name -> value. Throws std::runtime_error naming a parameter that is asked for and not there.
class Parameters {
 public:
  Parameters() = default;
  explicit Parameters(std::map<std::string, double> values) : values_(std::move(values)) {
  }
  double operator[](const std::string &name) const {
    const auto found = values_.find(name);
    if (found == values_.end()) throw std::runtime_error("parameter " + name + " is missing");
    return found->second;
  }

 private:
  std::map<std::string, double> values_;
};

// --- Budd and Dux: x'' + x = cos(omega t), x <= stop ------------------------------------------

// Their closed form of the orbit with one impact in n forcing periods: its speed V at a stop, the
// time of the impact, and the speed at which it doubles its period as the stop is moved.
struct BuddDux {
  double omega, r;
  int n;
  double cosine, gamma, r_minus, cs;

  BuddDux(double omega_of_forcing, double restitution, int periods)
      : omega(omega_of_forcing), r(restitution), n(periods) {
    const double period = n * Clock(omega).period, sine = std::sin(period);
    cosine = std::cos(period);
    gamma = 1.0 / (1.0 - omega * omega);
    r_minus = (1.0 - r) / omega;
    cs = std::abs(sine) < 1e-14 ? 0.0 : sine * (1.0 + r) / (1.0 - cosine);
  }
  // The faster (branch 1) or the slower (-1) of the two orbits at a stop.
  double speed(double stop, int branch) const {
    const double square = cs * cs + r_minus * r_minus;
    const double discriminant =
        gamma * gamma * cs * cs - (stop * stop - gamma * gamma) * r_minus * r_minus;
    return 2.0 * (branch * std::sqrt(discriminant) - cs * stop) / square;
  }
  double time(double stop, double speed) const {
    const double angle = std::acos((stop + 0.5 * cs * speed) / gamma);
    const double turn = 2.0 * std::acos(-1.0);
    return (std::sin(angle) * speed / gamma > 0.0 ? turn - angle : angle) / omega;
  }
  double doubling_speed() const {
    const double sine = cs * (1.0 - cosine) / (1.0 + r), c2 = cs * cs;
    const double b =
        4.0 * r * cosine - 2.0 * (1.0 + r * r) + (omega * omega - 1.0) * c2 * (1.0 - cosine);
    const double s = (1.0 + r) * omega * sine;
    const double square =
        b * b + s * s * (omega * omega * (c2 + r_minus * r_minus) - 2.0 * b / (1.0 - cosine));
    return std::abs(2.0 * s * omega * gamma) / std::sqrt(square);
  }
  // The stop at which the faster orbit has this speed.
  double stop(double speed) const {
    const double root = std::sqrt(4.0 * gamma * gamma - r_minus * r_minus * speed * speed);
    const double near = 0.5 * (-root - cs * speed), far = 0.5 * (root - cs * speed);
    return std::abs(this->speed(near, 1) - speed) < 1e-9 ? near : far;
  }
};

// Speed of the impact of the periodic orbit, found by Newton's method on the stroboscopic map.
// The guess is the closed form, off by a percent.
inline double budd_dux_speed(const Parameters &p) {
  const int n = static_cast<int>(p["n"]);
  const BuddDux orbit(p["omega"], p["r"], n);
  const Scene scene = one_mass(0.0, 1.0, p["omega"], p["r"], p["stop"]);
  const double speed = orbit.speed(p["stop"], static_cast<int>(p["branch"]));
  return one_impact_orbit(scene, n, orbit.time(p["stop"], speed) + 0.01, 1.01 * speed).speed();
}

// Speed at which a multiplier of the orbit reaches -1 as the stop is moved.
inline double budd_dux_doubling_speed(const Parameters &p) {
  const int n = static_cast<int>(p["n"]);
  const BuddDux orbit(p["omega"], p["r"], n);
  const double speed = 1.001 * orbit.doubling_speed(), beside = orbit.stop(speed);
  const auto orbit_at = [&](double stop) {
    const Scene scene = one_mass(0.0, 1.0, p["omega"], p["r"], stop, stop - 1.0);
    return one_impact_orbit(scene, n, orbit.time(beside, speed), speed);
  };
  const auto doubling = [&](double stop) { return orbit_at(stop).doubling_multiplier() + 1.0; };
  return orbit_at(zero_near(doubling, beside, 1e-6)).speed();
}

// --- x'' + c x' + x = A cos(omega t), x <= 1 --------------------------------------------------

// Impacts in one forcing period of the motion that is periodic where there is no stop, from a phase
// at which it is on the far side.
inline int impacts_of_steady_motion(const Scene &scene) {
  Scene without = scene;
  without.stops.clear();
  MotionState state = find_periodic_orbit(without, start_of(without), 1).state;
  if (state.displacement.front() > 0.0)
    state = simulate_from(without, state, 0.5 * Clock(scene.omega).period).state;
  ImpactSpeedRecorder impacts{1, 0.0};
  stroboscopic_map(scene, state, 1, {}, impacts);
  return static_cast<int>(impacts.velocities.size());
}

// The amplitude A at which the motion without impact grazes the stop.
inline double grazing_amplitude(const Parameters &p) {
  const Change change = bisect(
      [&](double amplitude) {
        return impacts_of_steady_motion(one_mass(p["c"], amplitude, p["omega"], 0.8, 1.0)) > 0;
      },
      0.01, 4.0);
  return 0.5 * (change.below + change.above);
}

// The orbit of one impact per period that COCO's run starts from, from its authors' guess.
struct CocoOrbit {
  MotionState at_pi;  // forcing phase pi
  Event impact;
};

inline CocoOrbit coco_orbit() {
  const Scene scene = one_mass(0.1, 1.0, 1.0, 0.8, 1.0);
  MotionState guess = start_of(scene);
  guess.instant.phase = std::acos(-1.0);
  guess.displacement = {-0.98};
  guess.velocity = {-0.29};
  const PeriodicOrbit orbit = find_periodic_orbit(scene, guess, 1);
  EventRecorder events;
  stroboscopic_map(scene, orbit.state, 1, {}, events);
  if (!orbit.converged || events.events.size() != 1)
    throw std::runtime_error("no orbit of one impact");
  return {orbit.state, events.events.front()};
}

// --- Runs ------------------------------------------------------------------------------------

// A mass thrown at a lower stop at 0, under a constant force (omega = 0: the cosine is one) and,
// with k > 0, on a spring.
inline Scene ball(double mass, double k, double force, double restitution, double height,
                  double velocity) {
  return {.mass = {mass},
          .stiffness = {k},
          .amplitude = {force},
          .omega = 0.0,
          .restitution = restitution,
          .stops = {{1, Side::lower, 0.0}},
          .displacement = {height},
          .velocity = {velocity}};
}

// The scenes of the event-driven examples of Siconos, by the name of their table.
inline Scene siconos_scene(const std::string &table) {
  if (table == "BouncingBallED") return ball(1.0, 0.0, -9.81, 0.9, 1.0, 0.0);
  if (table == "BouncingBallED-initialImpact") return ball(1.0, 0.0, -9.81, 0.9, 0.0, -1.0);
  if (table == "LinearOscillatorED") return ball(1e-3, 100.0, -9.81e-3, 0.9, 1.0, 0.0);
  if (table == "BouncingBallED-TwoContacts") {
    Scene scene = ball(1.0, 0.0, -10.0, 0.8, 1.0, 10.0);
    scene.stops.push_back({1, Side::upper, 1.5});
    return scene;
  }
  throw std::runtime_error(table + ": not a table of Siconos that is known here");
}

// The events of a scene to `until`, every impact resolved or chatter carried to its limit.
inline std::vector<Event> events_to(const Scene &scene, double until, bool every_impact = false) {
  EventRecorder recorder;
  RunOptions options;
  if (every_impact) options.resolve_chatter = 0.0;
  require_complete(simulate(scene, until, options, recorder));
  return recorder.events;
}

inline double first_time_of(const std::vector<Event> &events, EventKind kind) {
  for (const Event &event : events)
    if (event.kind == kind) return event.time;
  throw std::runtime_error("the run has no such event");
}

// --- A bar of N elements thrown at a wall, r = 0 ------------------------------------------------

// E = 210e9, rho = 7800, section 3.14e-4, length 1, as in the example of Siconos. Masses lumped at
// the nodes, half of one at each end; `elements` of them have the length of 1 / `per_length`.
inline Scene bar(int elements, int per_length) {
  const double section = 0.000314, length = 1.0 / per_length;
  const auto nodes = static_cast<std::size_t>(elements) + 1;
  Scene scene;
  scene.mass.assign(nodes, 7800.0 * section * length);
  scene.mass.front() *= 0.5;
  scene.mass.back() *= 0.5;
  scene.stiffness.assign(nodes, 210e9 * section / length);
  scene.stiffness.front() = 0.0;
  scene.restitution = 0.0;
  scene.stops = {{1, Side::lower, 0.0}};
  scene.displacement.assign(nodes, 0.00005);
  scene.velocity.assign(nodes, -0.1);
  return scene;
}

inline double contact_time(int elements) {
  const auto events = events_to(bar(elements, elements), 0.0015);
  return first_time_of(events, EventKind::release) - first_time_of(events, EventKind::stick);
}

// The limit of the contact time of the lumped bar for N -> infinity, from N = 50, 100, 200, 400:
// its error is a series in N^(-2/3) (the front of the returning wave, dispersed by the lattice, is
// an Airy function of width N^(1/3)), of which three terms are eliminated.
inline double limit_of_contact_time() {
  std::vector<double> h, t;
  for (int n : {50, 100, 200, 400}) {
    h.push_back(std::pow(n, -2.0 / 3.0));
    t.push_back(contact_time(n));
  }
  for (std::size_t order = 1; order < t.size(); ++order)
    for (std::size_t i = t.size() - 1; i >= order; --i)
      t[i] += (t[i] - t[i - 1]) * h[i] / (h[i - order] - h[i]);
  return t.back();
}

// The power of 1 / N with which the contact time falls to that limit, between N = 200 and 400.
inline double rate_of_contact_time() {
  const double limit = 2.0 / std::sqrt(210e9 / 7800.0);
  return std::log2((contact_time(200) - limit) / (contact_time(400) - limit));
}

// The momentum that the wall gives to the bar.
inline double impulse_of_the_wall(int elements, int per_length) {
  const Scene scene = bar(elements, per_length);
  const MotionState end = require_complete(simulate(scene, 0.0015)).state;
  double impulse = 0.0;
  for (std::size_t i = 0; i < scene.mass.size(); ++i)
    impulse += scene.mass[i] * (end.velocity[i] - scene.velocity[i]);
  return impulse;
}

}  // namespace vibro_impact::figures::published
