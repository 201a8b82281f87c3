// The events of a run as a table.
#pragma once

#include "event_driven.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace vibro_impact_reference {

/// Impacts slower than this are left out of a complete chatter's table; in the extreme scenes, of
/// any scale, slower than this part of the mass's fastest impact.
inline const Real kept_speed = Real("1e-6");

/// The masses that stick, as `1+2`; `-` if none does.
std::string contact_mode(const std::vector<bool> &stuck);

/// The rows of the kept events, each after `lead`.
std::string event_rows(const std::vector<Event> &events, const Vector &slowest,
                       const std::string &lead);

const char *const columns = "time,mass,event,velocity_before,velocity_after,contact_mode\n";

/// The whole table of a scene of the paper.
std::string events_table(const std::vector<Event> &events, std::size_t masses);

}  // namespace vibro_impact_reference
