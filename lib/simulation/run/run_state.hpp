// What a run starts from: a motion, or where another run stood. The latter is a row of numbers with
// everything that makes a resumed run the same as one that never ended.
#pragma once

#include <concepts>

#include "run.hpp"

namespace vibro_impact {

// Runs a scene, checked, from a motion or from where another run stood (the other is null), on D
// lanes: N + 2 for N masses under forcing, or any number.
template <int D>
Outcome run_lanes(const Scene &scene, const MotionState *motion, const RunState *state,
                  double until, const RunOptions &options, std::span<const RecorderRef> recorders);

// The instant at which the run stood.
Instant instant_of(const RunState &state);

// The numbers of a run: written, or read back in the same order. A double holds every count.
struct Row {
  std::vector<double> numbers = {};
  bool reads = false;
  std::size_t next = 0;  // index of the next number to be read

  void pass(auto &...values) {
    (one(values), ...);
  }
  template <class Number>
  requires std::integral<Number> || std::floating_point<Number>
  void one(Number &value) {
    if (!reads) return numbers.push_back(static_cast<double>(value));
    require(next < numbers.size(), "state of a run: it has ", numbers.size(),
            " numbers, too few for one of this scene");
    value = static_cast<Number>(numbers[next++]);
  }
  void one(Instant &instant) {
    pass(instant.cycle, instant.phase);
  }
  void one(AtStop &at) {
    pass(at.gap, at.speed, at.below_rounding, at.decided, at.zeros, at.leading, at.last_speed,
         at.falling, at.force_was_zero);
  }
  void one(ChatterTable::Node &node) {
    pass(node.x, node.predicted, node.impact);
  }
  template <class Value>
  void one(std::vector<Value> &values) {
    std::size_t size = values.size();
    pass(size);
    values.resize(size);
    for (Value &value : values) pass(value);
  }
};

// Throws std::invalid_argument for the state of a run of another scene, as far as a state shows it:
// by its stops, the phase of its forcing and its gaps.
template <int D>
void check_scene_of(const Run<D> &run) {
  const State<D> &state = run.state;
  require(state.stops.size() == run.scene.stops.size(), "state: ", state.stops.size(),
          " stops given, the scene has ", run.scene.stops.size());
  State<D> forced = state;
  set_forcing(forced, run.scene);
  require((forced.value - state.value).abs().sum() < wide,
          "state: the forcing has another phase in this scene");
  for (const Contact<D> &contact : state.mode->contacts) {
    const AtStop &stop = state.stops[contact.stop];
    const double gap = contact.held ? 0.0 : watched_now(state, contact);
    // A motion may have died down to nothing; what differs by less than that contradicts nothing.
    const double known = wide * size_of(state, contact) + rounding;
    require(std::abs(gap - stop.gap) <= known, "state: gap = ", stop.gap, " at stop ",
            contact.stop + 1, ", where the modal coordinates have ", gap);
  }
}

// Writes where the run stands, or sets the run to stand there. Throws std::invalid_argument for the
// state of a run of another scene.
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
  if (row.reads) check_scene_of(run);
}

}  // namespace vibro_impact
