#include "vibro_impact/analysis/chatters.hpp"

#include <map>

#include "simulation/for_analysis.hpp"
#include "vibro_impact/analysis/locate.hpp"

namespace vibro_impact {

std::vector<Chatter> chatters_of(const std::vector<Event> &events) {
  std::vector<Chatter> chatters;
  std::map<int, std::size_t> open;  // by mass, where it is among them
  for (std::size_t k = 0; k < events.size(); ++k) {
    const Event &event = events[k];
    const auto now = open.find(event.mass);
    if (event.kind != EventKind::impact) {
      if (now == open.end()) continue;
      chatters[now->second].complete = event.kind == EventKind::stick;
      open.erase(now);
      continue;
    }
    if (now == open.end() || event.falling == 0 || chatters[now->second].stop != event.stop) {
      open[event.mass] = chatters.size();
      chatters.push_back({event.stop, {}});
    }
    chatters[open[event.mass]].impacts.push_back(k);
  }
  return chatters;
}

BorderChatter border_chatter(double r) {
  require(r > 0.0 && r < 1.0, "restitution = ", r, ": a border chatter needs 0 < r < 1");
  const auto balance = [r](double s) { return (3 - s) * (1 - s) * (1 - s) - r * (3 - 2 * s); };
  const double s = zero(balance, 0.0, 1.0).value, q = 1 - s;
  const double by_flight =
      r * ((0.5 - 2 * s / 3) / (q * q) + 2 * (s / 2 - s * s / 3) / (q * q * q));
  return {s, q, q * q, by_flight / (0.5 - s / 3)};
}

}  // namespace vibro_impact
