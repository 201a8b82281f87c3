// A case is a scene with the true events of its motion.
#pragma once

#include <string>
#include <vector>

#include "vibro_impact/scene.hpp"

namespace vibro_impact::truth {

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

}  // namespace vibro_impact::truth
