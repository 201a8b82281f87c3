// The first event along one step: an impact, or a root of a hold force, or several of these at the
// same instant.
#pragma once

#include <vector>

#include "simulation/chain/stop_state.hpp"
#include "taylor_table.hpp"

namespace vibro_impact::detail {

// The knowledge of a contact at the start of a flight.
struct Start {
  double value = 0.0;       // infinite if no flight searches the contact (stop_state.hpp)
  double derivative = 0.0;  // the slope, or with exact zeros the derivative of order `zeros`
  int zeros = 0;            // the number of derivatives, from the value on, that are exactly zero
};

// The place of a contact at the end of a flight. At its root a contact is zero by definition. At
// the start of a run and the end of a long flight others may be so within rounding. Two are zero
// with their slope: a hold force that touches zero and stays positive but for rounding, and the gap
// of a mass that has come to rest at its stop.
enum class Near : char { no, perhaps, zero, touch, rest };

// True if a hold force falls to less than the rounding of its terms, and not below zero by more,
// near a place where it has this value, this slope and this half of the second derivative.
bool only_touches(double value, double slope, double second, double terms);

// A flight that ends at the time tau, with or without an event: where a gap closes, at its root in
// twice the precision. With an event, tau is NaN if the motion leaves the range of double
// precision, and infinite if the search for a root did not end.
struct FlightEnd {
  Real tau = 0.0;
  bool event = false;
};

// The start of the flight of a contact from the motion, and from what is known of its stop.
Start contact_start(const Chain &chain, const Contact &contact, const AtStop &at,
                    const Motion &motion);

// The search along one step. Its storage is reused, so that steps allocate no memory.
struct StepSearch {
  TaylorTable table;
  std::vector<Polynomial> polynomials;  // one for each contact of the mode,
  std::vector<double> roots;            // with its first root in the step

  // Finds the first event of the step, which begins at `motion`, whose acceleration is known.
  // `starts` and `near` have one entry for each contact.
  FlightEnd find_first_event(const Chain &chain, const Motion &motion, const Step &step,
                             const std::vector<Start> &starts, std::vector<Near> &near,
                             Counters &counters);
};

}  // namespace vibro_impact::detail
