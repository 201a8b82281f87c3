// The first event along one step: impacts, and hold forces that come to zero, of one mass or of
// several at the same instant.
#pragma once

#include <optional>
#include <vector>

#include "simulation/chain/stop_state.hpp"
#include "taylor_table.hpp"

namespace vibro_impact::detail {

// A contact along the step.
struct Approach {
  bool out_of_reach = false;  // certain to stay positive over the step
  Polynomial polynomial;      // else (3) along the step
  std::optional<Root> root;   // and its first root, where the flight ends
};

// One step of a flight, its storage reused: no allocation between events.
struct Flight {
  Step step;
  TaylorTable table, moduli;
  PerCoordinate travel, rate_travel;  // bounds of what y and y' can change by over the step
  std::vector<Approach> approaches;   // by contact of the mode
  double u = 1.0;                     // of the first event, or the end of the step
  bool event = false;
  bool any_near = false;  // some contact was within reach
};

// Bounds the travel of all coordinates in `time`: |y'| stays below |y'| + sqrt(lambda) |y| +
// |force| time, because y'^2 + lambda y^2 grows by the forcing alone.
void bound_travel(const Motion &motion, double time, PerCoordinate &speed);

// True when (3) of a contact, now `value`, is certain to stay positive for `time`, by this share of
// its terms, at such speeds of the coordinates. `jumps` is what impacts to come may take off it at
// once: a hold force jumps with the speeds of the neighbours.
bool stays_out_of_reach(const Motion &motion, const Contact &contact, double value,
                        const PerCoordinate &speed, double omega, double time, double margin,
                        double jumps);

// How long no contact can come to zero, whatever the time: the amplitudes of the coordinates, which
// never grow, bound what each contact swings by, and the rigid-body mode drifts. Infinite for a
// motion in which nothing can happen any more.
double quiet_time(const Motion &motion, const std::vector<StopState> &stops, double omega);

// Finds the first event in (0, 1] of the flight's step, along which the motion goes. `rate_bound`
// is the unit of leading derivatives.
void find_first_event(const Motion &motion, const std::vector<StopState> &stops, const Clock &clock,
                      bool forced, double rate_bound, Flight &flight, Counters &counters);

// Moves motion and stops to u of the step.
void move_along(const Flight &flight, double u, const Clock &clock, Motion &motion,
                std::vector<StopState> &stops);

// Moves motion and stops to `target`, in closed form. `change` is scratch.
void fly_along(const Instant &target, const Clock &clock, Motion &motion,
               std::vector<StopState> &stops, PerCoordinate &change);

// The gap of a contact, along a table or by a change of the coordinates.
double gap_of(const StopState &stop);

}  // namespace vibro_impact::detail
