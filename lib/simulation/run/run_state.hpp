// What a run starts from: a motion, or where another run stood, with what makes a resumed run the
// same as one that never ended: the numbers, and what they may be beside a scene.
#pragma once

#include "simulation/chain/require.hpp"
#include "simulation/chatter/chatter.hpp"
#include "vibro_impact/simulate.hpp"

namespace vibro_impact {

struct RunState::Numbers : BesideLanes {
  Held held;
  std::vector<double> value, slope;  // lanes of the contact mode
  ChatterImpacts chatter;
  std::vector<ChatterTable::Node> nodes;
};

// What a run starts from: the motion at the start, or where another run stood.
struct Start {
  const MotionState *motion = nullptr;
  const RunState *state = nullptr;
};

constexpr int any_lanes = Eigen::Dynamic;

// True for two masses under forcing, the paper's case, which get lanes of fixed size; the code is
// the same. They have no room for a strongly damped mode split in two.
bool has_four_lanes(const Scene &scene);

// Runs a scene, checked, on D lanes: N + 2 for N masses under forcing, or any number.
template <int D>
Outcome run_lanes(const Scene &scene, const Start &start, double until, const RunOptions &options,
                  std::span<const RecorderRef> recorders);

// Throws std::invalid_argument unless the instant lies in a period of the forcing and the masses
// are held at stops that exist.
void check_place(const Scene &scene, const Instant &instant, const Held &held);

// The state in this mode. Throws std::invalid_argument where it contradicts the scene.
template <int D>
State<D> state_in(const RunState::Numbers &from, const Scene &scene, const ContactMode<D> &mode) {
  using Lanes = typename State<D>::Lanes;
  const auto lanes = static_cast<std::size_t>(mode.lanes());
  require(from.value.size() == lanes && from.slope.size() == lanes, "state: ", from.value.size(),
          " and ", from.slope.size(), " modal coordinates given, the contact mode ",
          contact_mode_name(from.held), " has ", lanes);
  require(from.stops.size() == scene.stops.size(), "state: ", from.stops.size(),
          " stops given, the scene has ", scene.stops.size());
  const State<D> state{from, &mode, Eigen::Map<const Lanes>(from.value.data(), mode.lanes()),
                       Eigen::Map<const Lanes>(from.slope.data(), mode.lanes())};
  State<D> forced = state;
  set_forcing(forced, scene);
  require((forced.value - state.value).abs().sum() < wide,
          "state: the forcing has another phase in this scene");
  for (const Contact<D> &contact : mode.contacts) {
    const AtStop &stop = from.stops[contact.stop];
    const double gap = contact.held ? 0.0 : watched_now(state, contact);
    // A motion may have died down to nothing; what differs by less than that contradicts nothing.
    const double known = wide * size_of(state, contact) + rounding;
    require(std::abs(gap - stop.gap) <= known, "state: gap = ", stop.gap, " at stop ",
            contact.stop + 1, ", where the modal coordinates have ", gap);
  }
  for (const std::size_t k : from.chatter.contacts)
    require(k < mode.contacts.size() && !mode.contacts[k].held,
            "state: a chatter at stops that no free mass comes to");
  return state;
}

}  // namespace vibro_impact
