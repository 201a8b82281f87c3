#include "frequencies.hpp"

#include <algorithm>
#include <stdexcept>

namespace vibro_impact_reference {

namespace {

/// The motion that goes on from `state`, at phase zero of the forcing, for some forcing periods.
/// Brings the state to their end, where the phase is zero again and the time is counted anew.
Run carried_on(Scene scene, State &state, int periods, const Resolution &resolution) {
  Run run;
  scene.end_time = periods * 2 * acos(Real(-1)) / scene[&Field::omega];
  advance(scene, state, run, resolution);
  state.time = 0;
  return run;
}

/// The state at another frequency on the line through two settled motions, up to the square of the
/// distance.
State extrapolated(const Settled &one, const Settled &other, const Real &frequency) {
  const Real part = (frequency - one.frequency) / (other.frequency - one.frequency);
  State state = one.state;
  for (std::size_t i = 0; i < state.x.size(); ++i) {
    state.x[i] += part * (other.state.x[i] - one.state.x[i]);
    state.v[i] += part * (other.state.v[i] - one.state.v[i]);
  }
  return state;
}

/// Throws std::logic_error if the counts at the ends of the bracket agree.
void require_change(const Bracket &bracket, std::size_t near, std::size_t far) {
  if (near == far)
    throw std::logic_error("the counts at " + bracket.near.str(10) + " and " + bracket.far.str(10) +
                           " agree");
}

}  // namespace

Real changing_frequency(Scene scene, Bracket bracket, const Count &count) {
  const Resolution resolution = resolution_down_to(chatter_floor);
  const auto count_at = [&](const Real &frequency, State &state) {
    scene[&Field::omega] = frequency;
    carried_on(scene, state, settling_from_near, resolution);
    return count(carried_on(scene, state, counted, resolution));
  };
  const auto settled_at = [&](const Real &frequency) {
    scene[&Field::omega] = frequency;
    Run run;
    State state = initial_state(scene, resolution, run);
    carried_on(scene, state, settling_from_rest, resolution);
    return Settled{frequency, state};
  };
  Settled before = settled_at(2 * bracket.near - bracket.far), last = settled_at(bracket.near),
          beyond = settled_at(bracket.far);
  const std::size_t count_near = count_at(bracket.near, last.state);
  require_change(bracket, count_near, count_at(bracket.far, beyond.state));
  while (abs(bracket.far - bracket.near) > bracket_width) {
    const Real middle = (bracket.near + bracket.far) / 2;
    Settled trial{middle, extrapolated(before, last, middle)};
    if (count_at(middle, trial.state) == count_near) {
      bracket.near = middle;
      before = last;
      last = trial;
    } else {
      bracket.far = middle;
    }
  }
  return bracket.far;
}

Real jumping_frequency(Scene scene, Bracket bracket, int settling, const Count &count) {
  const Resolution resolution = resolution_down_to(chatter_floor);
  const auto count_at = [&](const Real &frequency) {
    scene[&Field::omega] = frequency;
    Run run;
    State state = initial_state(scene, resolution, run);
    carried_on(scene, state, settling, resolution);
    return count(carried_on(scene, state, counted, resolution));
  };
  const std::size_t count_near = count_at(bracket.near);
  require_change(bracket, count_near, count_at(bracket.far));
  while (abs(bracket.far - bracket.near) > bracket_width) {
    const Real middle = (bracket.near + bracket.far) / 2;
    (count_at(middle) == count_near ? bracket.near : bracket.far) = middle;
  }
  return bracket.far;
}

Count sticks_of(std::size_t mass) {
  return [mass](const Run &run) {
    return static_cast<std::size_t>(
        std::count_if(run.events.begin(), run.events.end(), [mass](const Event &event) {
          return event.kind == EventKind::stick && event.mass == mass;
        }));
  };
}

}  // namespace vibro_impact_reference
