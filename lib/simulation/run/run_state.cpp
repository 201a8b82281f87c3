#include "run_state.hpp"

#include "start.hpp"

namespace vibro_impact {

namespace {

constexpr std::string_view kind = "vibro-impact run state 1";

// The lines of the text in their order, once for both directions: `lines` writes or reads them.
template <class Lines, class Numbers>
void pass(Lines &lines, Numbers &state) {
  lines.line(kind);
  lines.line("instant", state.instant.cycle, state.instant.phase);
  lines.line("held", state.held);
  lines.line("values", state.value);
  lines.line("slopes", state.slope);
  lines.line("stops", state.stops);
  lines.line("next_flight", state.next_flight);
  lines.line("clear", state.clear);
  lines.line("window", state.window_start.cycle, state.window_start.phase, state.impacts_in_window);
  lines.line("chatter_contacts", state.chatter.contacts);
  lines.line("chatter_times", state.chatter.times);
  lines.line("chatter_jumps", state.chatter.jumps);
  lines.line("chatter_flight", state.chatter.flight, state.chatter.since);
  lines.line("chatter_nodes", state.nodes);
}

// The numbers of what a line holds several of.
template <class Lines, class Stop>
void pass_stop(Lines &lines, Stop &at) {
  lines.all(at.gap, at.speed, at.zeros, at.leading, at.below_rounding, at.last_speed, at.falling);
}
template <class Lines, class Node>
void pass_node(Lines &lines, Node &node) {
  lines.all(node.x, node.predicted, node.impact);
}

struct Writer {
  std::string text = {};

  template <class... Values>
  void line(std::string_view key, const Values &...values) {
    text += key;
    all(values...);
    text.push_back('\n');
  }
  template <class... Values>
  void all(const Values &...values) {
    (put(values), ...);
  }
  template <class Number>
  void put(Number number) {
    text.push_back(' ');
    append(text, number);
  }
  void put(bool value) {
    put(value ? 1 : 0);
  }
  void put(const AtStop &stop) {
    pass_stop(*this, stop);
  }
  void put(const ChatterTable::Node &node) {
    pass_node(*this, node);
  }
  template <class Value>
  void put(const std::vector<Value> &values) {
    for (const Value &value : values) put(value);
  }
};

struct Reader {
  std::string_view text;
  int number = 0;              // of the current line
  std::string_view rest = {};  // of the current line, with the space before it

  template <class... Pieces>
  void require_line(bool holds, const Pieces &...pieces) const {
    require(holds, "state of a run, line ", number, ": ", pieces...);
  }
  template <class... Values>
  void line(std::string_view key, Values &...values) {
    ++number;
    const std::size_t end = text.find('\n');
    require_line(end != text.npos, "cut short");
    rest = text.substr(0, end);
    text.remove_prefix(end + 1);
    const bool found =
        rest.starts_with(key) && (rest.size() == key.size() || rest[key.size()] == ' ');
    require_line(found, "'", key, "' expected, not '", rest.substr(0, 40), "'");
    rest.remove_prefix(key.size());
    all(values...);
    require_line(rest.empty(), "more than expected");
  }
  template <class... Values>
  void all(Values &...values) {
    (take(values), ...);
  }
  template <class Number>
  void take(Number &value) {
    require_line(!rest.empty(), "fewer numbers than expected");
    const std::string_view word = rest.substr(1, rest.find(' ', 1) - 1);
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    require_line(error == std::errc() && end == word.data() + word.size(), "'", word.substr(0, 40),
                 "' is not a number of its kind");
    rest.remove_prefix(1 + word.size());
  }
  void take(bool &value) {
    int number_of_it = 0;
    take(number_of_it);
    require_line(number_of_it == 0 || number_of_it == 1, number_of_it, " is neither 0 nor 1");
    value = number_of_it == 1;
  }
  void take(AtStop &stop) {
    pass_stop(*this, stop);
  }
  void take(ChatterTable::Node &node) {
    pass_node(*this, node);
  }
  template <class Value>
  void take(std::vector<Value> &values) {
    while (!rest.empty()) take(values.emplace_back());
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
  Writer writer;
  pass(writer, state.numbers());
  return writer.text;
}

RunState load(const Scene &scene, std::string_view text) {
  check(scene);
  RunState::Numbers numbers;
  Reader reader{text};
  pass(reader, numbers);
  require(reader.text.empty(), "state of a run: something follows its last line");
  check_place(scene, numbers.instant, numbers.held);
  if (has_four_lanes(scene))
    require_consistent(numbers, scene, build_contact_mode<4>(scene, numbers.held));
  else
    require_consistent(numbers, scene, build_contact_mode<any_lanes>(scene, numbers.held));
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

void check_stop_state(const AtStop &stop, bool held) {
  const bool at_rest = stop.gap == 0.0 && stop.speed == 0.0;
  const bool finite = std::isfinite(stop.gap + stop.speed + stop.leading + stop.last_speed);
  // Of a free mass: the gap where one zero is known, and its speed where there are more.
  const bool zeros_fit = held              ? at_rest
                         : stop.zeros == 0 ? stop.leading == 0.0
                                           : stop.gap == 0.0 && (stop.zeros == 1 || at_rest);
  require(finite && stop.gap >= 0.0 && stop.zeros >= 0 && stop.zeros <= all_zeros &&
              stop.leading >= 0.0 && zeros_fit,
          "state: gap = ", stop.gap, ", speed = ", stop.speed, ", ", stop.zeros, " zeros before ",
          stop.leading, " at a stop: not those of a run");
  require(stop.falling >= 0 && stop.last_speed >= 0.0, "state: ", stop.falling,
          " falling impacts, the latest at ", stop.last_speed, ": not those of a run");
}

void check_chatter(const ChatterImpacts &chatter, const std::vector<ChatterTable::Node> &nodes) {
  bool fits = chatter.jumps.size() == chatter.times.size() * chatter.contacts.size() &&
              chatter.contacts.empty() == chatter.times.empty() &&
              nodes.empty() == chatter.times.empty() && nodes.size() <= max_chatter_nodes &&
              chatter.since >= 0.0 && std::isfinite(chatter.since);
  for (std::size_t k = 0; k < chatter.times.size(); ++k)
    fits = fits && (k == 0 ? chatter.times[k] == 0.0 : chatter.times[k - 1] <= chatter.times[k]);
  for (const double jump : chatter.jumps) fits = fits && jump > 0.0 && std::isfinite(jump);
  for (std::size_t k = 0; k < nodes.size(); ++k)
    fits = fits && nodes[k].x > 0.0 && nodes[k].impact < chatter.times.size() &&
           chatter.times[nodes[k].impact] <= nodes[k].predicted &&
           (k == 0 || (nodes[k].x < nodes[k - 1].x && nodes[k - 1].impact < nodes[k].impact));
  require(fits, "state: the impacts of a chatter that are not those of a run");
}

}  // namespace vibro_impact
