// Where a run stands, with what makes a resumed run the same as one that never ended: the numbers,
// and what they may be beside a scene.
#pragma once

#include "simulation/chain/require.hpp"
#include "simulation/chatter/chatter.hpp"
#include "vibro_impact/simulate.hpp"

namespace vibro_impact {

struct RunState::Numbers {
  Instant instant;
  Held held;
  std::vector<double> value, slope;  // lanes of the contact mode
  std::vector<AtStop> stops;         // one per stop of the scene
  double next_flight = std::numeric_limits<double>::infinity();
  bool clear = true;
  Instant window_start;
  long long impacts_in_window = 0;
  ChatterImpacts chatter;
  std::vector<ChatterTable::Node> nodes;
};

// Throws std::invalid_argument unless the instant lies in a period of the forcing and the masses
// are held at stops that exist.
void check_place(const Scene &scene, const Instant &instant, const Held &held);

// Throws std::invalid_argument where what is known of one stop, by itself, is not that of a run.
void check_stop_state(const AtStop &stop, bool held);

// Throws std::invalid_argument where the impacts of a chatter so far are not those of a run.
void check_chatter(const ChatterImpacts &chatter, const std::vector<ChatterTable::Node> &nodes);

// Throws std::invalid_argument where the state contradicts itself, or the scene in this mode.
template <int D>
void require_consistent(const RunState::Numbers &from, const Scene &scene,
                        const ContactMode<D> &mode) {
  using Lanes = Eigen::Array<double, D, 1>;
  const auto lanes = static_cast<std::size_t>(mode.lanes());
  require(from.value.size() == lanes && from.slope.size() == lanes, "state: ", from.value.size(),
          " and ", from.slope.size(), " modal coordinates given, the contact mode ",
          contact_mode_name(from.held), " has ", lanes);
  require(from.stops.size() == scene.stops.size(), "state: ", from.stops.size(),
          " stops given, the scene has ", scene.stops.size());
  State<D> state;
  state.now = from.instant;
  state.mode = &mode;
  state.value = Eigen::Map<const Lanes>(from.value.data(), mode.lanes());
  state.slope = Eigen::Map<const Lanes>(from.slope.data(), mode.lanes());
  require(std::isfinite(state.value.sum() + state.slope.sum()),
          "state: modal coordinates that are not finite");
  const Lanes value = state.value;
  set_forcing(state, scene);
  require((value - state.value).abs().sum() < wide,
          "state: the forcing has another phase in this scene");
  state.value = value;
  for (const Contact<D> &contact : mode.contacts) {
    const AtStop &stop = from.stops[contact.stop];
    check_stop_state(stop, contact.held);
    const double misplaced = contact.held ? 0.0 : watched_now(state, contact) - stop.gap;
    require(std::abs(misplaced) <= wide * size_of(state, contact), "state: gap = ", stop.gap,
            " at stop ", contact.stop + 1, ", where the modal coordinates have ",
            stop.gap + misplaced);
  }
  require(from.next_flight >= 0.0 && from.impacts_in_window >= 0, "state: next flight ",
          from.next_flight, ", ", from.impacts_in_window, " impacts: not those of a run");
  require(!(from.instant < from.window_start), "state: impacts are counted from a later time");
  check_chatter(from.chatter, from.nodes);
  for (const std::size_t k : from.chatter.contacts)
    require(k < mode.contacts.size() && !mode.contacts[k].held,
            "state: a chatter at stops that no free mass comes to");
}

}  // namespace vibro_impact
