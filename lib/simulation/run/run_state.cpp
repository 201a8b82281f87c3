#include "run_state.hpp"

#include <algorithm>
#include <boost/crc.hpp>
#include <cmath>

namespace vibro_impact {

namespace {

constexpr int most_counted = 1 << 30;

void require_whole(bool holds) {
  require(holds, "state of a run: cut short or changed, or not saved by this version");
}

// The numbers of a state as text, one a line: written, or read back in the same order.
struct Lines {
  bool reads = false;
  std::string text = {};       // written
  std::string_view rest = {};  // to be read

  template <class Number>
  void pass(Number &value) {
    if (!reads) {
      append(text, value);
      return text.push_back('\n');
    }
    const std::size_t end = rest.find('\n');
    require_whole(end != rest.npos);
    const auto [read, error] = std::from_chars(rest.data(), rest.data() + end, value);
    require_whole(error == std::errc() && read == rest.data() + end &&
                  !std::isnan(static_cast<double>(value)));
    if constexpr (std::integral<Number> && !std::same_as<Number, signed char>)
      require_whole(value >= 0);  // all that counts; a mass may be held at its lower stop, as -1
    rest.remove_prefix(end + 1);
  }
  void pass(bool &value) {
    int as_number = value ? 1 : 0;
    pass(as_number);
    require_whole(as_number <= 1);
    value = as_number == 1;
  }
  void pass(AtStop &at) {
    pass(at.gap), pass(at.speed), pass(at.below_rounding);
    pass(at.decided), pass(at.zeros), pass(at.leading);
    pass(at.last_speed), pass(at.falling);
  }
  void pass(ChatterTable::Node &node) {
    pass(node.x), pass(node.predicted), pass(node.impact);
  }
  template <class Value>
  void pass(std::vector<Value> &values) {
    std::size_t size = values.size();
    pass(size);
    require_whole(!reads || size <= rest.size());
    values.resize(size);
    for (Value &value : values) pass(value);
  }
  void pass(RunState::Numbers &state) {
    pass(state.now.cycle), pass(state.now.phase);
    pass(state.held), pass(state.value), pass(state.slope), pass(state.stops);
    pass(state.next_flight), pass(state.clear);
    pass(state.window_start.cycle), pass(state.window_start.phase), pass(state.impacts_in_window);
    pass(state.chatter.contacts), pass(state.chatter.times), pass(state.chatter.jumps);
    pass(state.chatter.flight), pass(state.chatter.since), pass(state.nodes);
  }
};

// The line above these numbers.
std::string heading(std::string_view numbers) {
  boost::crc_32_type checksum;
  checksum.process_bytes(numbers.data(), numbers.size());
  return "vibro-impact run state 3, checksum " + std::to_string(checksum.checksum()) + "\n";
}

// What no run leaves behind: the checksum guards against slips only.
void check_numbers(const Scene &scene, const RunState::Numbers &from) {
  for (const AtStop &at : from.stops) {
    const bool finite = std::isfinite(at.gap + at.speed + at.leading + at.last_speed);
    const bool fits = at.decided ? at.gap == 0.0 && at.speed == 0.0 && at.zeros >= 0 &&
                                       at.zeros <= 2 * scene.masses() + 4
                                 : at.zeros == 0 && at.leading == 0.0;
    require(finite && fits && at.gap >= 0.0 && at.leading >= 0.0, "state: gap = ", at.gap,
            ", speed = ", at.speed, ", ", at.zeros, " zeros before ", at.leading,
            " at a stop: not those of a run");
    require(at.falling <= most_counted && at.last_speed >= 0.0, "state: ", at.falling,
            " falling impacts, the latest at ", at.last_speed, ": not those of a run");
  }
  require(from.next_flight >= 0.0 && from.impacts_in_window <= most_counted &&
              !(from.now < from.window_start),
          "state: next flight ", from.next_flight, ", ", from.impacts_in_window,
          " impacts in one period: not those of a run");
  const ChatterImpacts &chatter = from.chatter;
  const std::vector<ChatterTable::Node> &nodes = from.nodes;
  bool fits = chatter.jumps.size() == chatter.times.size() * chatter.contacts.size() &&
              chatter.times.empty() == nodes.empty() && nodes.size() <= max_chatter_nodes &&
              chatter.since >= 0.0 && std::is_sorted(chatter.times.begin(), chatter.times.end());
  for (const double jump : chatter.jumps) fits = fits && jump > 0.0;
  for (std::size_t k = 0; k < nodes.size(); ++k)
    fits = fits && nodes[k].impact < chatter.times.size() && nodes[k].x > 0.0 &&
           (k == 0 || (nodes[k].x < nodes[k - 1].x && nodes[k - 1].impact < nodes[k].impact));
  require(fits, "state: ", chatter.times.size(), " impacts of a chatter at ",
          chatter.contacts.size(), " stops with ", chatter.jumps.size(), " jumps and ",
          nodes.size(), " nodes: not those of a run");
}

}  // namespace

const RunState::Numbers &RunState::numbers() const {
  require(numbers_ != nullptr, "state of a run: that of no run");
  return *numbers_;
}

const Held &RunState::held() const {
  return numbers().held;
}

std::string save(const RunState &state) {
  RunState::Numbers numbers = state.numbers();
  Lines lines;
  lines.pass(numbers);
  return heading(lines.text) + lines.text;
}

RunState load(const Scene &scene, std::string_view text) {
  check(scene);
  const std::string_view rest = text.substr(std::min(text.find('\n'), text.size() - 1) + 1);
  require_whole(!text.empty() && text.substr(0, text.size() - rest.size()) == heading(rest));
  RunState::Numbers numbers;
  Lines lines{.reads = true, .rest = rest};
  lines.pass(numbers);
  require_whole(lines.rest.empty());
  check_place(scene, numbers.now, numbers.held);
  check_numbers(scene, numbers);
  if (has_four_lanes(scene))
    state_in(numbers, scene, build_contact_mode<4>(scene, numbers.held));
  else
    state_in(numbers, scene, build_contact_mode<any_lanes>(scene, numbers.held));
  return RunState(std::make_shared<const RunState::Numbers>(std::move(numbers)));
}

void check_place(const Scene &scene, const Instant &instant, const Held &held) {
  const Clock clock(scene.omega);
  require(static_cast<double>(instant.cycle) <= most_periods, "start: period ", instant.cycle,
          ": more forcing periods than double precision can count");
  require(instant.cycle >= 0 && instant.phase >= 0.0 && instant.phase < clock.period,
          "start: phase = ", instant.phase, " in period ", instant.cycle, ": must lie in [0, ",
          clock.period, ")");
  require(held.size() == scene.mass.size(), "start: the contact mode of ", held.size(),
          " masses given, the chain has ", scene.mass.size());
  for (std::size_t i = 0; i < held.size(); ++i)
    require(held[i] == 0 || std::any_of(scene.stops.begin(), scene.stops.end(),
                                        [&](const Stop &stop) {
                                          return static_cast<std::size_t>(stop.mass - 1) == i &&
                                                 held[i] == static_cast<signed char>(stop.side);
                                        }),
            "start: mass ", i + 1, " held as ", static_cast<int>(held[i]),
            ": it has no such stop (0 free, 1 upper, -1 lower)");
}

}  // namespace vibro_impact
