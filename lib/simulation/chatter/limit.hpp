// The limit of a complete chatter: infinitely many impacts that are over in a finite time. The
// state there is the flight from the latest impact as if none followed, plus the responses to the
// impacts to come, which depend on them through their moments sum_k J_k (T - t_k)^n only
// (lib/README.md).
#pragma once

#include <optional>

#include "chatter.hpp"
#include "simulation/flight/clearance.hpp"
#include "simulation/flight/expansion.hpp"

namespace vibro_impact {

// The time left to the limit, and the nodes of the table it is extrapolated from.
struct ChatterLimit {
  double left = 0.0;
  std::size_t oldest = 0;
};

// The limit, when its estimated error is at most `tolerance` and it does not agree by chance: near
// a border orbit, where the press falls to zero as the chatter ends, the extrapolated time left and
// that which the latest impact predicts are far apart until late.
template <int D>
std::optional<ChatterLimit> extrapolate(const Chatter<D> &chatter, double tolerance) {
  const ChatterTable &table = chatter.table;
  if (table.nodes.size() < fewest_chatter_nodes || !(table.error <= tolerance)) return std::nullopt;
  const std::size_t last = table.nodes.size() - 1;
  const double now = chatter.impacts.times.back(), predicted = table.nodes[last].predicted - now;
  const double left = limit_of(table.row[table.best]) - now;
  if (!(std::abs(left - predicted) < near_limit * predicted)) return std::nullopt;
  return ChatterLimit{left, last - table.best};
}

// True when no other stop comes into play up to the limit, whatever the impacts to come: none of
// them is faster than the latest was, and their jumps add up to less than 1.5 times the first-order
// sum.
template <int D>
bool others_stay_clear(Chatter<D> &chatter, const State<D> &state, double left) {
  const ContactMode<D> &mode = *state.mode;
  auto &pushes = chatter.pushes, &speeds = chatter.speeds;
  pushes.setZero(mode.lanes());
  for (std::size_t j = 0; j < chatter.impacts.contacts.size(); ++j) {
    const Contact<D> &hit = chatter.hit(j);
    const double latest = chatter.jump(chatter.impacts.times.size() - 1, j);
    pushes +=
        (jumps_to_come * latest * hit.restitution / (1.0 - hit.restitution)) * hit.jump_slope.abs();
  }
  bound_speeds(state, left, speeds);
  speeds += pushes;
  for (std::size_t k = 0; k < mode.contacts.size(); ++k) {
    if (chatter.hits_contact(k)) continue;
    const Contact<D> &contact = mode.contacts[k];
    const double jumps = contact.held ? (contact.watched.on_slope.abs() * pushes).sum() : 0.0;
    // What is read off the lanes has rounding in it, but no more than the motion itself.
    if (!stays_clear(state, contact, watched_now(state, contact), speeds, left, narrow, jumps))
      return false;
  }
  return true;
}

// Adds to the lanes, and to what was added before, the responses to impacts with these moments, of
// orders from `from` to `to`, in units of powers of the rate of the path.
template <int D>
void add_responses(State<D> &state, State<D> &sum, const Contact<D> &hit, const double *moments,
                   int from, int to) {
  const ContactMode<D> &mode = *state.mode;
  for (Eigen::Index i = 0; i < mode.modal_lanes(); ++i) {
    OscillatorState response{0.0, 0.0};
    for (int n = from; n <= to; ++n) {
      response.value += moments[n] * mode.flow_weights.response(i, n);
      response.slope += moments[n] * mode.flow_weights.rate_of_response(i, n);
    }
    const auto added = change_of(mode, i, hit.jump_value(i), hit.jump_slope(i), response);
    state.value(i) += added.value;
    state.slope(i) += added.slope;
    sum.value(i) += added.value;
    sum.slope(i) += added.slope;
  }
}

// The moments of the impacts to come at one stop, in units of powers of the rate of the path, and
// what the oldest node changes in them.
struct Moments {
  Terms of{}, change{};
};

// What each node predicts of the impacts at the stop of hit j, less the impacts after it that are
// past. Those have the sum of the weights of the nodes before them, which is tiny for the oldest.
template <int D>
Moments extrapolate_moments(const Chatter<D> &chatter, const ChatterLimit &limit, std::size_t j,
                            const Expansion &path) {
  const ChatterTable &table = chatter.table;
  const ChatterImpacts &impacts = chatter.impacts;
  const double r = chatter.hit(j).restitution;
  Terms ratio{};
  double power = r;
  for (int n = 0; n <= path.order; ++n, power *= r)
    ratio[static_cast<std::size_t>(n)] = power / (1.0 - power);
  const auto weights = node_weights(table, limit.oldest),
             fewer = node_weights(table, limit.oldest + 1);
  Moments moments;
  double before = 0.0, change_before = 0.0;
  std::size_t node = limit.oldest;
  for (std::size_t k = table.nodes[node].impact; k < impacts.times.size(); ++k) {
    double weight = 0.0, change = 0.0;
    if (node < table.nodes.size() && table.nodes[node].impact == k) {
      weight = weights[node];
      change = weight - fewer[node++];
    }
    const double x = path.rate * (impacts.times.back() - impacts.times[k] + path.span);
    const double quartic = x * x * x * x;
    Packet moment = chatter.jump(k, j) * powers_of(x);
    for (int n = 0; n <= path.order; n += 4, moment *= quartic) {
      const Packet ratios = packet(ratio.data() + n);
      Eigen::Map<Packet>(moments.of.data() + n) += moment * (weight * ratios - before);
      Eigen::Map<Packet>(moments.change.data() + n) += moment * (change * ratios - change_before);
    }
    before += weight;
    change_before += change;
  }
  return moments;
}

// Sets the state to that at the limit, from `before`, just after the latest impact, with the masses
// hit at rest on their stops. A narrow gap beside them is carried, as on a flight, with the
// responses on their own: their size is not that of the lanes. Returns an estimate of the error of
// the responses relative to the jump of the oldest impact used: what its node changes in the
// moments, as the fastest mode feels it. (Where the mass itself hardly feels that mode, the error
// of the time of the limit does not show it.)
template <int D>
double move_to_limit(Chatter<D> &chatter, const ChatterLimit &limit, const Scene &scene,
                     const Clock &clock, double scene_rate, const Expansion &path,
                     const State<D> &before, State<D> &state, Counters &counters) {
  const ContactMode<D> &mode = *before.mode;
  State<D> &responses = chatter.responses;
  responses.value.setZero(mode.lanes());
  responses.slope.setZero(mode.lanes());
  state = before;
  const std::size_t hits = chatter.impacts.contacts.size(),
                    oldest = chatter.table.nodes[limit.oldest].impact;
  move_lanes(state, scene, clock, path, path.span);
  double error = 0.0;
  for (std::size_t j = 0; j < hits; ++j) {
    const Moments moments = extrapolate_moments(chatter, limit, j, path);
    add_responses(state, responses, chatter.hit(j), moments.of.data(), 2, path.order);
    double sum = 0.0, factorial = 1.0;
    for (int n = 2; n <= path.order; ++n)
      sum += std::abs(moments.change[static_cast<std::size_t>(n)]) / (factorial *= n);
    error = std::max(error, responses_share * sum / chatter.jump(oldest, j));
  }
  // M_1 brings the masses to their stops, M_0 to rest there.
  for (std::size_t j = 0; j < hits; ++j) {
    const double gap = watched_now(state, chatter.hit(j));
    const double moments[2] = {0.0, -gap * path.rate};
    add_responses(state, responses, chatter.hit(j), moments, 1, 1);
  }
  tie_decays(state);
  for (const std::size_t k : chatter.impacts.contacts) place_at_stop(state, mode.contacts[k], 0.0);
  for (std::size_t k = 0; k < mode.contacts.size(); ++k) {
    const Contact<D> &contact = mode.contacts[k];
    if (contact.held || chatter.hits_contact(k)) {
      set_in_flight(state.stops[contact.stop]);
    } else if (is_wide(state, contact)) {
      read_gap(state, contact);
    } else {
      Polynomial gap;
      read_along(before, contact, path, scene_rate, gap, counters);
      const Jet carried = jet_at(gap, 0, 1.0);
      const auto &on_lanes = contact.watched.on_value;
      set_in_flight(state.stops[contact.stop], carried.value + (on_lanes * responses.value).sum(),
                    carried.slope / path.span + (on_lanes * responses.slope).sum());
    }
  }
  return error;
}

}  // namespace vibro_impact
