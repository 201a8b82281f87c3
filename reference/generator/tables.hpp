// The tables of events and of key numbers. In the table of checked numbers the generator fills in
// the references of the key numbers and leaves all else as it is.
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

double forcing_periods(double count, const vibro_impact::Scene &scene);

/// The table of a chain of stops (extreme_scenes.hpp) in two forcing periods.
std::string chain_table(int masses);

/// The digits of a key number, by a formula (kind `formula`) or by a run (kind `computed`). Throws
/// std::runtime_error naming the row.
std::string digits_of(DigitsEngine &engine, const numbers::CheckedNumber &number);

/// The digits of the key number with this id. Throws std::runtime_error if there is none.
std::string digits_of(const std::string &id);

/// The whole table.
std::string filled_table();

}  // namespace vibro_impact_reference
