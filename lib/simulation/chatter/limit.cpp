#include "limit.hpp"

#include <algorithm>
#include <cmath>

#include "simulation/chain/pair.hpp"
#include "simulation/stops/impact.hpp"

namespace vibro_impact::detail {

namespace {

using Eigen::Index;

// Adds the responses M_n S^(n) / n! to the moments M_n of orders n = first, ..., last. S is the
// response to a unit impulse: the response table has its Taylor coefficients.
void add_responses(const Terms &moments, int first, int last, LimitState &state) {
  const TaylorTable &response = state.response_table;
  for (int n = first; n <= last; ++n) {
    const double moment = moments[static_cast<std::size_t>(n)];
    const double *value = response.of_order(n), *next = response.of_order(n + 1);
    const double slope = moment * (n + 1) / response.length;
    for (Index j = 0; j < response.coordinates; ++j) {
      state.added(j) += moment * value[j];
      state.added_slope(j) += slope * next[j];
    }
  }
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
    const double to_come =
        hit.restitution / (1.0 - hit.restitution) * chatter.jump(chatter.times.size() - 1, j);
    jumps += jump_sum_factor * to_come * hit.impulse.abs();
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
    if (!(evaluate(contact, motion) > jump + (1.0 + gap_reread_ratio) * time_left * rate +
                                          limit_margin * terms_of(contact, motion)))
      return false;
  }
  return true;
}

void set_limit_state(const Chatter &chatter, const ChatterLimit &limit, const Step &step,
                     const Clock &clock, bool forced, const Motion &motion,
                     const std::vector<StopState> &stops, LimitState &state) {
  const ContactMode &mode = *motion.mode;
  state.motion = motion;
  state.stops = stops;
  state.error = 0.0;
  expand(motion, step, clock.omega, forced, state.flight_table);
  move_coordinates(state.flight_table, 1.0, state.motion);
  pass_time(state.motion, clock, step.length);
  complete_move(state.motion, clock);
  state.added.setZero(motion.y.size());
  state.added_slope.setZero(motion.y.size());
  for (std::size_t j = 0; j < chatter.contacts.size(); ++j) {
    const Contact &hit = mode.contacts[chatter.contacts[j]];
    const ChatterMoments moments =
        extrapolate_moments(chatter, limit, j, hit.restitution, step.order);
    expand_impulse(mode, hit, step, state.response_table);
    add_responses(moments.moment, 2, step.order, state);
    double sum = 0.0, weight = 1.0;  // weight = (rate length)^n / n!
    for (int n = 0; n <= step.order; ++n, weight *= step.rate * step.length / n)
      if (n >= 2) sum += std::abs(moments.difference[static_cast<std::size_t>(n)]) * weight;
    const std::size_t oldest = chatter.table.nodes[limit.oldest].impact - chatter.dropped;
    // About n = 1 / (1 - r) jumps follow, each off by the rounding of n^(1/2) impacts. An error
    // below this rounding cannot be seen.
    const double loss = 1.0 - hit.restitution;
    const double rounding = impact_rounding / 8.0 / (loss * std::sqrt(loss));
    state.error =
        std::max(state.error, response_error_share * sum / chatter.jump(oldest, j) - rounding);
  }
  // M_1 follows from the gap at the limit, which is zero.
  for (std::size_t j = 0; j < chatter.contacts.size(); ++j) {
    const Contact &hit = mode.contacts[chatter.contacts[j]];
    const double gap = evaluate(hit, state.motion) + (hit.row * state.added).sum();
    if (chatter.contacts.size() > 1) expand_impulse(mode, hit, step, state.response_table);
    Terms moment{};
    moment[1] = -gap / step.length;
    add_responses(moment, 1, 1, state);
  }
  state.motion.y += state.added;
  state.motion.dy += state.added_slope;
  complete_change(state.motion);
  // M_0 follows from the gap speed at the limit, which is zero.
  for (const std::size_t k : chatter.contacts) place(mode.contacts[k], {0.0, 0.0}, state.motion);
  for (std::size_t k = 0; k < mode.contacts.size(); ++k) {
    const Contact &contact = mode.contacts[k];
    StopState &stop = state.stops[contact.stop];
    if (contact.held || chatter.hits(k)) {
      stop.contact = AtRest{};
    } else if (is_resolved(contact, state.motion)) {
      stop.contact = InFlight{evaluate(contact, state.motion), gap_speed(contact, state.motion)};
    } else if (const auto *flight = std::get_if<InFlight>(&stops[contact.stop].contact)) {
      // A small gap is carried along the flight, and the responses are added to it.
      Polynomial gap;
      read_along(state.flight_table, contact, gap);
      gap.coefficient[0] = flight->gap;
      gap.coefficient[1] = flight->speed * step.length;
      const Jet carried = jet_at(gap, 0, 1.0);
      stop.contact =
          InFlight{carried.value + (contact.row * state.added).sum(),
                   carried.slope / step.length + (contact.row * state.added_slope).sum()};
    }
  }
}

}  // namespace vibro_impact::detail
