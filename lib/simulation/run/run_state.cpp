#include "run_state.hpp"

#include <boost/crc.hpp>

namespace vibro_impact {

namespace {

// The line above these numbers.
std::string heading(std::string_view numbers) {
  boost::crc_32_type checksum;
  checksum.process_bytes(numbers.data(), numbers.size());
  return "vibro-impact run state 4, checksum " + std::to_string(checksum.checksum()) + "\n";
}

}  // namespace

std::string save(const RunState &state) {
  require_sound(!state.numbers.empty());
  std::string text;
  for (const double number : state.numbers) text += line(number, "\n");
  return heading(text) + text;
}

RunState load(const Scene &scene, std::string_view text) {
  std::string_view rest = text.substr(std::min(text.find('\n'), text.size() - 1) + 1);
  require_sound(!text.empty() && text.substr(0, text.size() - rest.size()) == heading(rest));
  RunState state;
  while (!rest.empty()) {
    const std::size_t end = rest.find('\n');
    require_sound(end != rest.npos);
    const auto [read, error] =
        std::from_chars(rest.data(), rest.data() + end, state.numbers.emplace_back());
    require_sound(error == std::errc() && read == rest.data() + end);
    rest.remove_prefix(end + 1);
  }
  // It is one of this scene if a run can go on from it.
  resume_seen(scene, state, time_of(instant_of(state), Clock(scene.omega)), {}, {});
  return state;
}

Instant instant_of(const RunState &state) {
  Row row{.numbers = state.numbers, .reads = true};
  Instant instant;
  row.pass(instant);
  return instant;
}

}  // namespace vibro_impact
