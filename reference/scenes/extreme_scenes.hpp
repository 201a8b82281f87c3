// An extreme case is a row of the stability figure: a scene and the truth that it is compared with.
// Several programs share the scenes below, some of which have a free parameter.
//
// Included by the drivers, the tests and the 50-digit generator (which takes nothing but these
// numbers from the project), so that a scene is written down once.
#pragma once

#include <cmath>
#include <string>
#include <vector>

#include "paper_scenes.hpp"

namespace vibro_impact::figures {

// An event as it truly happens, of the 50-digit generator or of a closed formula: at cycle T + time
// with T the forcing period, a time that is known better than a double could hold after 1e6
// periods.
struct TrueEvent {
  long long cycle = 0;
  double time = 0.0;
  int mass = 1;
  std::string event;  // impact, stick, release
  double velocity_before = 0.0;
  std::string contact_mode;  // after it: `-`, `1`, `1+2`
};

}  // namespace vibro_impact::figures

namespace vibro_impact::extremes {

using figures::TrueEvent;

// The truth that a case is compared with.
enum class Truth {
  digits,   // the events of the 50-digit generator, reference/tables/extreme_events.csv
  exact,    // a closed formula, `events`
  grazing,  // a closed formula whose event lies within rounding of not happening, `events`
};

inline const char *name(Truth truth) {
  return truth == Truth::digits ? "digits" : truth == Truth::exact ? "exact" : "grazing";
}

struct Case {
  std::string name, group;
  Scene scene;
  double until = 0.0;
  Truth truth = Truth::digits;
  std::vector<TrueEvent> events = {};  // of the formula; none with `digits`
  double from = 0.0;                   // events before this are not compared (they are counted)
  // Speed at which the generator ends a chatter. Its flight is v^2 / a high and must stand above
  // the 50 digits of the displacement; what is left out lasts some v / a.
  double slowest_impact = 1e-20;
};

// --- Scenes -----------------------------------------------------------------------------------

// n unit masses on unit springs.
inline Scene chain(int n, double beta) {
  Scene scene;
  scene.mass.assign(static_cast<std::size_t>(n), 1.0);
  scene.stiffness = scene.mass;
  scene.beta = beta;
  return scene;
}

// One mass on a spring before an upper stop, forced by A cos(omega t).
inline Scene one_mass(double beta, double amplitude, double omega, double restitution, double stop,
                      double start = 0.0, double velocity = 0.0) {
  Scene scene = chain(1, beta);
  scene.amplitude = {amplitude};
  scene.omega = omega;
  scene.restitution = restitution;
  scene.stops = {{1, Side::upper, stop}};
  scene.displacement = {start};
  scene.velocity = {velocity};
  return scene;
}

// A chain of ten masses, with stops on three of them: no code may assume two.
// Equal masses and springs as the paper has them, forced at the beginning; stops at the beginning,
// in the middle and at the end. More damping than the paper's: the slowest mode, of natural
// frequency 0.149, would take thousands of forcing periods to settle at beta = 0.1.
inline Scene long_chain() {
  Scene scene = chain(10, 0.3);
  scene.amplitude.assign(10, 0.0);
  scene.amplitude.front() = 0.8;
  scene.omega = 0.3;
  scene.restitution = 0.7;
  scene.stops = {{1, Side::lower, -0.3}, {5, Side::upper, 0.1}, {10, Side::upper, 0.2}};
  return scene;
}

}  // namespace vibro_impact::extremes
