// A case is a scene with the true events of its motion.
#pragma once

#include <stdexcept>
#include <string>
#include <vector>

#include "vibro_impact/event.hpp"

namespace vibro_impact::truth {

// An event as a table, a closed formula or another method has it, at a time counted from t = 0. Its
// instant has the whole time as phase. Neither the stop nor the velocity after it is known.
inline Event event_at(double time, int mass, EventKind kind, double velocity_before = 0.0) {
  return {.kind = kind,
          .mass = mass,
          .instant = {0, time},
          .time = time,
          .velocity_before = velocity_before};
}

// The kind of event that a table names. Throws std::runtime_error naming `place` and the word.
inline EventKind kind_in(const std::string &place, const std::string &word) {
  for (const EventKind kind : all_event_kinds)
    if (word == name(kind)) return kind;
  throw std::runtime_error(place + ": '" + word + "' must be impact, stick or release");
}

// The truth that a case is compared with.
enum class Truth : std::size_t {
  digits,   // the events of the 50-digit generator, reference/tables/extreme_events.csv
  exact,    // a closed formula, `events`
  grazing,  // a closed formula whose event lies within rounding of not happening, `events`
};
constexpr const char *truth_words[] = {"digits", "exact", "grazing"};

struct Case {
  std::string name, group;
  Scene scene;
  double until = 0.0;
  Truth truth = Truth::digits;
  std::vector<Event> events = {};  // of the formula; none with `digits`
  double from = 0.0;               // events before this are not compared (they are counted)
  // Speed at which the generator ends a chatter. Its flight is v^2 / a high and must stand above
  // the 50 digits of the displacement; what is left out lasts some v / a.
  double slowest_impact = 1e-20;
};

}  // namespace vibro_impact::truth
