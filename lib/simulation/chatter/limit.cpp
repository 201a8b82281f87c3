#include "limit.hpp"

#include <algorithm>
#include <cmath>

#include "simulation/stops/impact.hpp"

namespace vibro_impact::detail {

namespace {

using Eigen::Index;

// Adds the responses to impacts with these moments, of orders from `from` to `to`: a moment M_n
// adds M_n S^(n) / n!, with the response S to a unit impulse in the table.
void add_responses(const Terms &moments, int from, int to, LimitState &state) {
  const TaylorTable &response = state.response;
  for (int n = from; n <= to; ++n) {
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

bool others_stay_out_of_reach(const Chatter &chatter, const Motion &motion, double omega,
                              double time_left, PerCoordinate &pushes, PerCoordinate &speed) {
  const ContactMode &mode = *motion.mode;
  pushes.setZero(motion.y.size());
  for (std::size_t j = 0; j < chatter.contacts.size(); ++j) {
    const Contact &hit = mode.contacts[chatter.contacts[j]];
    const double to_come = hit.restitution / (1.0 - hit.restitution) * chatter.latest_jump(j);
    pushes += jump_sum_factor * to_come * hit.impulse.abs();
  }
  bound_travel(motion, time_left, speed);
  speed += pushes;
  for (std::size_t k = 0; k < mode.contacts.size(); ++k) {
    const Contact &contact = mode.contacts[k];
    if (chatter.hits(k)) continue;
    // A gap evaluated from the coordinates is off by their rounding, which is below the margin.
    const double jumps = contact.damping * (contact.modulus * pushes).sum();
    if (!stays_out_of_reach(motion, contact, evaluate(contact, motion), speed, omega, time_left,
                            limit_margin, jumps))
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
  expand(motion, step, clock.omega, forced, state.flight);
  move_coordinates(state.flight, 1.0, state.motion);
  pass_time(state.motion, clock, step.length);
  complete_move(state.motion, clock);
  state.added.setZero(motion.y.size());
  state.added_slope.setZero(motion.y.size());
  for (std::size_t j = 0; j < chatter.contacts.size(); ++j) {
    const Contact &hit = mode.contacts[chatter.contacts[j]];
    const ChatterMoments moments =
        extrapolate_moments(chatter, limit, j, hit.restitution, step.order);
    expand_impulse(mode, hit, step, state.response);
    add_responses(moments.moment, 2, step.order, state);
    double sum = 0.0, radians = 1.0;  // (rate length)^n / n!
    for (int n = 0; n <= step.order; ++n, radians *= step.rate * step.length / n)
      if (n >= 2) sum += std::abs(moments.change[static_cast<std::size_t>(n)]) * radians;
    const std::size_t oldest = chatter.table.nodes[limit.oldest].impact - chatter.dropped;
    const double jump = chatter.jumps[oldest * chatter.contacts.size() + j];
    // Some n = 1 / (1 - r) jumps come, each off by what n^(1/2) impacts round: no error shows
    // below.
    const double loss = 1.0 - hit.restitution,
                 rounded = impact_rounding / 8.0 / (loss * std::sqrt(loss));
    state.error = std::max(state.error, response_error_share * sum / jump - rounded);
  }
  // The gap at the limit is zero, which gives M_1.
  for (std::size_t j = 0; j < chatter.contacts.size(); ++j) {
    const Contact &hit = mode.contacts[chatter.contacts[j]];
    const double gap = evaluate(hit, state.motion) + (hit.row * state.added).sum();
    if (chatter.contacts.size() > 1) expand_impulse(mode, hit, step, state.response);
    Terms moment{};
    moment[1] = -gap / step.length;
    add_responses(moment, 1, 1, state);
  }
  state.motion.y += state.added;
  state.motion.dy += state.added_slope;
  complete_change(state.motion);
  // The gap speed at the limit is zero, which gives M_0.
  for (const std::size_t k : chatter.contacts) place(mode.contacts[k], {0.0, 0.0}, state.motion);
  for (std::size_t k = 0; k < mode.contacts.size(); ++k) {
    const Contact &contact = mode.contacts[k];
    StopState &stop = state.stops[contact.stop];
    if (contact.held || chatter.hits(k)) {
      stop.contact = AtRest{};
    } else if (is_resolved(contact, state.motion)) {
      stop.contact = InFlight{evaluate(contact, state.motion), gap_speed(contact, state.motion)};
    } else if (const auto *flight = std::get_if<InFlight>(&stops[contact.stop].contact)) {
      // A small gap is carried, as on a flight, with the responses on their own.
      Polynomial gap;
      read_along(state.flight, contact, gap);
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
