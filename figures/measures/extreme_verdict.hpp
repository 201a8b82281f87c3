// Runs one extreme case and judges it by its errors and its sensitivity to the start.
#pragma once

#include <string>

#include "reference/truth/event_reader.hpp"
#include "reference/truth/extreme_cases.hpp"
#include "vibro_impact/simulate.hpp"

namespace vibro_impact::stability {

using truth::Case, truth::Truth, truth::EventTables;

// Samples of the motion between its events: the largest displacement and speed, and the deepest
// penetration of a stop of `scene`.
struct Samples : Recorder {
  const Scene *scene;
  double until;
  std::size_t taken = 0;
  double penetration = 0.0, size = 0.0, speed = 0.0;
  bool finite = true;

  Samples(const Scene &run, double end) : scene(&run), until(end) {
  }
  double next_time() const override {
    return sample_time(0.0, until, until / 1000, taken);
  }
  void sample(const Moment &moment) override;
};

// Times relative to `period`, velocities relative to the largest speed, displacements relative to
// the largest one.
struct Relative {
  double time = 0.0, velocity = 0.0;
};

struct ExtremeErrors {
  std::string difference;  // the first event without a counterpart; empty when all agree
  std::size_t events = 0;  // compared
  Relative error;          // largest, of the events
  Relative sensitivity;    // largest change of an event per relative change of the start
  double penetration = 0.0;
  bool finite = true;
  Counters counters;
};

// A case passes when every event has its counterpart, all numbers are finite, no stop is penetrated
// by more than 1e-12 of the motion, and times and velocities are right to 1e-10, or to 100
// roundings times the sensitivity where the scene amplifies a change of its start. The events of a
// touch pass by having counterparts: compare_grazing allows them no more than a stop some roundings
// away does.
bool passes(const ExtremeErrors &measured, Truth truth);

// The largest change of an event per relative change of the start, over a motion whose samples are
// given.
Relative sensitivity_of(const Scene &scene, double until, double period, const Samples &motion);

// Runs a case once as it is, once sampled, and perturbed. `tables` holds the events of the cases
// that are compared with the 50-digit generator.
ExtremeErrors measure(const Case &extreme, const EventTables &tables);

}  // namespace vibro_impact::stability
