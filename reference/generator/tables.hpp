// The tables of events, of key numbers and of orbits with one impact. In the table of checked
// numbers the generator fills in the references of the key numbers and leaves all else as it is.
#pragma once

#include "digits_engine.hpp"
#include "reference/numbers/checked_number.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace vibro_impact_reference {

/// Impacts slower than this are left out of a complete chatter's table; in the extreme scenes, of
/// any scale, slower than this part of the mass's fastest impact.
inline const Real kept_speed = Real("1e-6");

/// The rows of the kept events, each after `lead`.
std::string event_rows(const std::vector<Event> &events, const Vector &slowest,
                       const std::string &lead);

const char *const columns = "time,mass,event,velocity_before,velocity_after,contact_mode\n";

/// The whole table of a scene of the paper.
std::string events_table(const std::vector<Event> &events, std::size_t masses);

/// The digits of a key number, by a formula (kind `formula`) or by a run (kind `computed`). Throws
/// std::runtime_error naming the row.
std::string digits_of(DigitsEngine &engine, const numbers::CheckedNumber &number);

/// The digits of the key number with this id. Throws std::runtime_error if there is none.
std::string digits_of(const std::string &id);

/// The whole table.
std::string filled_table();

struct OneImpactCase {
  std::string name;
  vibro_impact::Scene scene;
  int periods, branch;
  std::size_t stop = 0;  // the stop that is hit
};

/// Figure 3 at Omega = 2.4, and chains of two equal, three unequal and five equal masses before one
/// stop. Chains without forcing, damping and loss have nonsmooth modes (Gendelman and Manevitch
/// 2008; Thorin, Delezoide and Legrand 2017). The table has the mode with the period of Omega.
std::vector<OneImpactCase> one_impact_cases();

OneImpactOrbit one_impact_orbit(const OneImpactCase &given);

/// One row per case, numbers with 30 decimals. What is below 1e-40 is the rounding of a zero.
std::string one_impact_table();

}  // namespace vibro_impact_reference
