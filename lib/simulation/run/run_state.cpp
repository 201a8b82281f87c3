#include "run_state.hpp"

namespace vibro_impact {

namespace {

// The text of a state, line by line: written, or read where there is a text to read.
struct Lines {
  bool reads = false;
  std::string text = {};
  int number = 0;              // of the current line
  std::string_view rest = {};  // of the text; of the current line while it is read

  template <class... Pieces>
  void require_line(bool holds, const Pieces &...pieces) const {
    require(holds, "state of a run, line ", number, ": ", pieces...);
  }
  template <class... Values>
  void line(std::string_view key, Values &...values) {
    ++number;
    if (!reads) {
      text += key;
      (pass(values), ...);
      text.push_back('\n');
      return;
    }
    const std::size_t end = rest.find('\n');
    require_line(end != rest.npos, "cut short");
    const std::string_view after = rest.substr(end + 1);
    rest = rest.substr(0, end);
    const bool found =
        rest.starts_with(key) && (rest.size() == key.size() || rest[key.size()] == ' ');
    require_line(found, "'", key, "' expected, not '", rest.substr(0, 40), "'");
    rest.remove_prefix(key.size());
    (pass(values), ...);
    require_line(rest.empty(), "more than expected");
    rest = after;
  }
  template <class Number>
  void pass(Number &value) {
    if (!reads) {
      text.push_back(' ');
      return append(text, value);
    }
    require_line(!rest.empty(), "fewer numbers than expected");
    const std::string_view word = rest.substr(1, rest.find(' ', 1) - 1);
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    require_line(error == std::errc() && end == word.data() + word.size(), "'", word.substr(0, 40),
                 "' is not a number of its kind");
    rest.remove_prefix(1 + word.size());
  }
  void pass(bool &value) {
    int as_number = value ? 1 : 0;
    pass(as_number);
    require_line(as_number == 0 || as_number == 1, as_number, " is neither 0 nor 1");
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
    while (reads && !rest.empty()) pass(values.emplace_back());
    if (!reads)
      for (Value &value : values) pass(value);
  }
  void pass_state(RunState::Numbers &state) {
    line("vibro-impact run state 2");
    line("instant", state.now.cycle, state.now.phase);
    line("held", state.held);
    line("values", state.value);
    line("slopes", state.slope);
    line("stops", state.stops);
    line("next_flight", state.next_flight);
    line("clear", state.clear);
    line("window", state.window_start.cycle, state.window_start.phase, state.impacts_in_window);
    line("chatter_contacts", state.chatter.contacts);
    line("chatter_times", state.chatter.times);
    line("chatter_jumps", state.chatter.jumps);
    line("chatter_flight", state.chatter.flight, state.chatter.since);
    line("chatter_nodes", state.nodes);
  }
};

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
  lines.pass_state(numbers);
  return lines.text;
}

RunState load(const Scene &scene, std::string_view text) {
  check(scene);
  RunState::Numbers numbers;
  Lines lines{.reads = true, .rest = text};
  lines.pass_state(numbers);
  require(lines.rest.empty(), "state of a run: something follows its last line");
  check_place(scene, numbers.now, numbers.held);
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

void check_numbers(const RunState::Numbers &from) {
  for (const AtStop &at : from.stops) {
    const bool finite = std::isfinite(at.gap + at.speed + at.leading + at.last_speed);
    const bool fits = at.decided ? at.gap == 0.0 && at.speed == 0.0 && !at.below_rounding
                                 : at.zeros == 0 && at.leading == 0.0;
    require(finite && fits && at.gap >= 0.0 && at.zeros >= 0 && at.leading >= 0.0,
            "state: gap = ", at.gap, ", speed = ", at.speed, ", ", at.zeros, " zeros before ",
            at.leading, " at a stop: not those of a run");
    require(at.falling >= 0 && at.last_speed >= 0.0, "state: ", at.falling,
            " falling impacts, the latest at ", at.last_speed, ": not those of a run");
  }
  require(from.next_flight >= 0.0 && from.impacts_in_window >= 0, "state: next flight ",
          from.next_flight, ", ", from.impacts_in_window, " impacts: not those of a run");
  require(!(from.now < from.window_start), "state: impacts are counted from a later time");
  const ChatterImpacts &chatter = from.chatter;
  const std::vector<ChatterTable::Node> &nodes = from.nodes;
  bool fits = chatter.jumps.size() == chatter.times.size() * chatter.contacts.size() &&
              chatter.contacts.empty() == chatter.times.empty() &&
              nodes.empty() == chatter.times.empty() && nodes.size() <= max_chatter_nodes &&
              chatter.since >= 0.0 && std::is_sorted(chatter.times.begin(), chatter.times.end());
  for (const double jump : chatter.jumps) fits = fits && jump > 0.0;
  for (std::size_t k = 0; k < nodes.size(); ++k)
    fits = fits && nodes[k].impact < chatter.times.size() && nodes[k].x > 0.0 &&
           (k == 0 || (nodes[k].x < nodes[k - 1].x && nodes[k - 1].impact < nodes[k].impact));
  require(fits, "state: the impacts of a chatter that are not those of a run");
}

}  // namespace vibro_impact
