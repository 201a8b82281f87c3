#include "event_table.hpp"

#include <fmt/ranges.h>

#include <sstream>

namespace vibro_impact_reference {

std::string contact_mode(const std::vector<bool> &stuck) {
  std::vector<std::size_t> masses;
  for (std::size_t p = 0; p < stuck.size(); ++p)
    if (stuck[p]) masses.push_back(p + 1);
  return masses.empty() ? "-" : fmt::format("{}", fmt::join(masses, "+"));
}

namespace {

/// Which events go to the table. Before a stick, the impacts of that mass slower than `slowest`
/// (per mass) are left out, back to the first faster one or to the first event of another mass: an
/// interrupted or incomplete chatter stays whole.
std::vector<bool> kept(const std::vector<Event> &events, const Vector &slowest) {
  std::vector<bool> keep(events.size(), true);
  for (std::size_t i = 0; i < events.size(); ++i) {
    if (events[i].kind != EventKind::stick) continue;
    for (std::size_t j = i; j-- > 0;) {
      const Event &earlier = events[j];
      if (earlier.kind != EventKind::impact || earlier.mass != events[i].mass) break;
      if (abs(earlier.velocity_before) >= slowest[earlier.mass]) break;
      keep[j] = false;
    }
  }
  return keep;
}

}  // namespace

std::string event_rows(const std::vector<Event> &events, const Vector &slowest,
                       const std::string &lead) {
  std::ostringstream table;
  const std::vector<bool> keep = kept(events, slowest);
  for (std::size_t i = 0; i < events.size(); ++i) {
    if (!keep[i]) continue;
    const Event &e = events[i];
    table << lead << e.time.str(30) << ',' << e.mass + 1 << ',' << name(e.kind) << ','
          << e.velocity_before.str(30) << ',' << e.velocity_after.str(30) << ','
          << contact_mode(e.stuck) << '\n';
  }
  return table.str();
}

std::string events_table(const std::vector<Event> &events, std::size_t masses) {
  return columns + event_rows(events, Vector(masses, kept_speed), "");
}

}  // namespace vibro_impact_reference
