// What a run starts from: a motion, or where another run stood, as a row of numbers with everything
// that makes a resumed run the same as one that never ended.
#pragma once

#include <concepts>

#include "run.hpp"

namespace vibro_impact {

// Runs a scene, checked, from a motion or from where another run stood (the other is null), on D
// lanes: N + 2 for N masses under forcing, or any number.
template <int D>
Outcome run_lanes(const Scene &scene, const MotionState *motion, const RunState *state,
                  double until, const RunOptions &options, std::span<const RecorderRef> recorders);

// When the run stood there.
Instant instant_of(const RunState &state);

// Throws std::invalid_argument for numbers that no run has left: a checksum guards against slips.
inline void require_sound(bool sound) {
  require(sound, "state of a run: none, cut short or changed, or not saved by this version");
}

// The numbers of a run: written, or read back in the same order.
struct Row {
  std::vector<double> numbers = {};
  bool reads = false;
  std::size_t next = 0;  // to be read

  void pass(auto &...values) {
    (one(values), ...);
  }

  void one(std::floating_point auto &value) {
    if (!reads) return numbers.push_back(value);
    require_sound(next < numbers.size() && !std::isnan(numbers[next]));
    value = numbers[next++];
  }
  // Counts, all of which a double holds; and -1, for a mass held at its lower stop.
  template <std::integral Number>
  void one(Number &value) {
    auto number = static_cast<double>(value);
    one(number);
    if (!reads) return;
    const double least = std::same_as<Number, signed char> ? -1.0 : 0.0,
                 half = static_cast<double>(std::numeric_limits<Number>::max() / 2),
                 most = std::clamp(half, 1.0, most_periods);
    require_sound(number >= least && number <= most && number == std::floor(number));
    value = static_cast<Number>(number);
  }
  void one(Instant &instant) {
    pass(instant.cycle, instant.phase);
  }
  void one(AtStop &at) {
    pass(at.gap, at.speed, at.below_rounding, at.decided, at.zeros, at.leading, at.last_speed,
         at.falling);
  }
  void one(ChatterTable::Node &node) {
    pass(node.x, node.predicted, node.impact);
  }
  template <class Value>
  void one(std::vector<Value> &values) {
    std::size_t size = values.size();
    pass(size);
    require_sound(!reads || size <= numbers.size());
    values.resize(size);
    for (Value &value : values) pass(value);
  }
};

// Throws std::invalid_argument where the lanes, what is known of the stops, and the impacts of a
// chatter contradict the scene or each other.
template <int D>
void check_numbers(const Run<D> &run) {
  const State<D> &state = run.state;
  const std::vector<Contact<D>> &contacts = state.mode->contacts;
  require(state.stops.size() == run.scene.stops.size(), "state: ", state.stops.size(),
          " stops given, the scene has ", run.scene.stops.size());
  State<D> forced = state;
  set_forcing(forced, run.scene);
  require((forced.value - state.value).abs().sum() < wide,
          "state: the forcing has another phase in this scene");
  for (const Contact<D> &contact : contacts) {
    const AtStop &stop = state.stops[contact.stop];
    const double gap = contact.held ? 0.0 : watched_now(state, contact);
    // A motion may have died down to nothing; what differs by less than that contradicts nothing.
    const double known = wide * size_of(state, contact) + rounding;
    require(std::abs(gap - stop.gap) <= known, "state: gap = ", stop.gap, " at stop ",
            contact.stop + 1, ", where the modal coordinates have ", gap);
  }
  for (const AtStop &at : state.stops) {
    require_sound(std::isfinite(at.gap + at.speed + at.leading + at.last_speed));
    require_sound(at.gap >= 0.0 && at.leading >= 0.0 && at.last_speed >= 0.0);
    require_sound(at.decided ? at.gap == 0.0 && at.speed == 0.0 : at.zeros == 0);
    require_sound(at.zeros <= 2 * run.scene.masses() + 4);
  }
  require_sound(state.span_expected >= 0.0 && !(state.now < state.window_start));
  const ChatterImpacts &impacts = run.chatter.impacts;
  const std::vector<ChatterTable::Node> &nodes = run.chatter.table.nodes;
  require_sound(impacts.jumps.size() == impacts.times.size() * impacts.contacts.size());
  require_sound(impacts.times.empty() == nodes.empty() && nodes.size() <= max_chatter_nodes);
  require_sound(impacts.since >= 0.0 && std::is_sorted(impacts.times.begin(), impacts.times.end()));
  for (const std::size_t k : impacts.contacts)
    require_sound(k < contacts.size() && !contacts[k].held);
  for (const double jump : impacts.jumps) require_sound(jump > 0.0);
  for (std::size_t k = 0; k < nodes.size(); ++k) {
    require_sound(nodes[k].impact < impacts.times.size() && nodes[k].x > 0.0);
    require_sound(k == 0 || (nodes[k].x < nodes[k - 1].x && nodes[k - 1].impact < nodes[k].impact));
  }
}

// Writes where the run stands, or sets the run to stand there. Throws std::invalid_argument where
// the numbers contradict the scene or each other.
template <int D>
void pass(Row &row, Run<D> &run) {
  State<D> &state = run.state;
  ChatterImpacts &impacts = run.chatter.impacts;
  Held held = row.reads ? Held() : state.mode->held;
  auto lanes = static_cast<std::size_t>(state.value.size());
  row.pass(state.now, held, lanes);
  if (row.reads) {
    check_place(run.scene, state.now, held);
    state.mode = &run.modes.enter(run.scene, held, run.counters);
    const Eigen::Index number = state.mode->lanes();
    require(lanes == static_cast<std::size_t>(number), "state: ", lanes,
            " modal coordinates given, the contact mode ", contact_mode_name(held), " has ",
            number);
    state.value.resize(number);
    state.slope.resize(number);
  }
  for (double &value : state.value) row.pass(value);
  for (double &slope : state.slope) row.pass(slope);
  row.pass(state.stops, state.span_expected, state.clear, state.window_start,
           state.impacts_in_window);
  row.pass(impacts.contacts, impacts.times, impacts.jumps, impacts.flight, impacts.since,
           run.chatter.table.nodes);
  if (!row.reads) return;
  require_sound(row.next == row.numbers.size());
  check_numbers(run);
}

}  // namespace vibro_impact
