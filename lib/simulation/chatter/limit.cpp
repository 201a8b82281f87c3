#include "limit.hpp"

#include <algorithm>
#include <cmath>

#include "simulation/chain/pair.hpp"
#include "simulation/flight/first_event.hpp"
#include "simulation/stops/impact.hpp"

namespace vibro_impact::detail {

namespace {

using Eigen::Index;

// Adds sum_i w_i (z_i - z) to a state, where z is that of the latest node, and sets what its oldest
// node adds to the sum. All differences are small, and so is the rounding of the sum.
void extrapolate_states(const Chatter &chatter, const ChatterLimit &limit, LimitState &state) {
  const NodeWeights weights = weights_of(chatter, limit.oldest);
  const std::size_t last = chatter.size - 1;
  const PredictedState &latest = chatter.node(last).state;
  const auto extrapolate = [&](PerCoordinate PredictedState::*value,
                               PerCoordinate PredictedState::*low, PerCoordinate &y,
                               PerCoordinate &y_low, PerCoordinate &difference) {
    for (Index j = 0; j < y.size(); j += 2) {
      const Twofold<Pair> z = twofold(latest.*value, latest.*low, j);
      Pair change{}, from_oldest{};
      for (std::size_t i = limit.oldest; i < last; ++i) {
        const PredictedState &node = chatter.node(i).state;
        const Twofold<Pair> other = twofold(node.*value, node.*low, j);
        const Pair distance = (other.value - z.value) + (other.low - z.low);
        change += weights.all[i] * distance;
        from_oldest += (weights.all[i] - weights.without_oldest[i]) * distance;
      }
      store(z + change, y, y_low, j);
      store(from_oldest, difference.data() + j);
    }
  };
  Motion &motion = state.motion;
  state.difference.resize(motion.y.size());
  state.slope_difference.resize(motion.y.size());
  extrapolate(&PredictedState::y, &PredictedState::y_low, motion.y, motion.y_low, state.difference);
  extrapolate(&PredictedState::dy, &PredictedState::dy_low, motion.dy, motion.dy_low,
              state.slope_difference);
}

// The error of the speeds, from what the oldest node changes. The gaps of the masses hit and their
// speeds are exact.
double error_of_state(const ContactMode &mode, const Chatter &chatter, double oldest_jump,
                      LimitState &state) {
  for (const std::size_t k : chatter.contacts) {
    const Contact &hit = mode.contacts[k];
    state.difference -= dot(hit.row, state.difference) * hit.placement;
    state.slope_difference -= dot(hit.row, state.slope_difference) * hit.impulse.slope;
  }
  double sum = 0.0;
  for (Index j = 0; j < state.difference.size(); ++j) {
    const bool decay = mode.coordinates.decay[static_cast<std::size_t>(j)];
    sum += mode.extent(j) * (mode.coordinates.rate(j) * std::abs(state.difference(j)) +
                             (decay ? 0.0 : std::abs(state.slope_difference(j))));
  }
  // About n = 1 / (1 - r) jumps follow, each off by the rounding of n^(1/2) impacts. This is noise
  // of the estimate and not an error of the state, and is taken off.
  const double loss = 1.0 - chatter.restitution;
  return state_error_share * sum / oldest_jump - impact_rounding / 8.0 / (loss * std::sqrt(loss));
}

}  // namespace

bool others_stay_out_of_reach(const Chatter &chatter, const Motion &motion,
                              const std::vector<StopState> &stops, double omega, double time_left,
                              LimitState &state) {
  const ContactMode &mode = *motion.mode;
  const ModalCoordinates &all = mode.coordinates;
  PerCoordinate &jumps = state.jumps, &speed = state.speed;
  jumps.setZero(motion.y.size());
  for (std::size_t j = 0; j < chatter.contacts.size(); ++j) {
    const Contact &hit = mode.contacts[chatter.contacts[j]];
    const double to_come = hit.restitution / (1.0 - hit.restitution) * chatter.jumps[j];
    jumps += jump_sum_factor * to_come * hit.impulse.slope.abs();
  }
  // |y'| + sqrt(lambda) |y| + |force| time_left bounds |y'| up to the limit without impacts,
  // because y'^2 + lambda y^2 grows by the forcing alone.
  speed = motion.dy.abs() + all.frequency * motion.y.abs() + time_left * all.force;
  speed += jumps;
  for (std::size_t k = 0; k < mode.contacts.size(); ++k) {
    const Contact &contact = mode.contacts[k];
    if (chatter.hits(k) || (!contact.held && rests_without_force(stops[contact.stop]))) continue;
    double rate = dot(contact.modulus, speed), jump = 0.0;
    if (contact.held) {
      rate += contact.damping * (contact.modulus * (3.0 * all.rate * speed + all.force)).sum() +
              contact.forcing_modulus * omega;
      jump = contact.damping * (contact.modulus * jumps).sum();
    }
    // The rounding of the gap, evaluated from the coordinates, is below the margin.
    if (!(evaluate(contact, motion) > jump + (1.0 + resolved_ratio) * time_left * rate +
                                          limit_margin * terms_of(contact, motion)))
      return false;
  }
  return true;
}

void set_limit_state(const Chatter &chatter, const ChatterLimit &limit, const Clock &clock,
                     const Motion &motion, const std::vector<StopState> &stops, LimitState &state) {
  const ContactMode &mode = *motion.mode;
  state.motion = motion;
  state.stops = stops;
  extrapolate_states(chatter, limit, state);
  state.error = error_of_state(mode, chatter, chatter.node(limit.oldest).jump, state);
  pass_time(state.motion, clock, limit.time_left);
  complete_change(state.motion);
  state.placed.clear();
  for (const std::size_t k : chatter.contacts) state.placed.add(mode.contacts[k], {});
  state.placed.apply(state.motion);
  forget_instant(state.stops);
  for (const std::size_t k : chatter.contacts)
    state.stops[mode.contacts[k].stop].contact = {.at_rest = true};
}

}  // namespace vibro_impact::detail
