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

// The time left to the limit, extrapolated from the last `nodes` nodes with these weights.
struct ChatterLimit {
  double left = 0.0;
  double error = 0.0;  // estimated
  std::size_t nodes = 0;
  std::array<double, max_chatter_nodes> weight{};  // by node of the table
};

// The limit, when its estimated error is at most `tolerance` and it does not agree by chance: near
// a border orbit, where the press falls to zero as the chatter ends, the extrapolated time left and
// that which the latest impact predicts are far apart until late.
template <int D>
std::optional<ChatterLimit> extrapolate(const Chatter<D> &chatter, double tolerance) {
  const ChatterTable &table = chatter.table;
  if (table.nodes.size() < 2 || !(table.error <= tolerance)) return std::nullopt;
  const std::size_t last = table.nodes.size() - 1, first = last - table.best;
  const double now = chatter.impacts.times.back(), predicted = table.nodes[last].predicted - now;
  ChatterLimit limit{table.limit[table.best] - now, table.error, table.best + 1, {}};
  if (!(std::abs(limit.left - predicted) < near_limit * predicted)) return std::nullopt;
  for (std::size_t i = first; i <= last; ++i) {
    double weight = 1.0;
    for (std::size_t j = first; j <= last; ++j)
      if (j != i) weight *= table.nodes[j].x / (table.nodes[j].x - table.nodes[i].x);
    limit.weight[i] = weight;
  }
  return limit;
}

// True when no other stop comes into play up to the limit, whatever the impacts to come: none of
// them is faster than the latest was, and their jumps add up to less than 1.5 times the first-order
// sum.
template <int D>
bool others_stay_clear(const Chatter<D> &chatter, const State<D> &state, double left) {
  const ContactMode<D> &mode = *state.mode;
  typename State<D>::Lanes pushes = State<D>::Lanes::Zero(mode.lanes());
  for (std::size_t j = 0; j < chatter.hits.size(); ++j) {
    const auto &hit = chatter.hits[j];
    const double latest =
        chatter.impacts.jumps[chatter.impacts.jumps.size() - chatter.hits.size() + j];
    pushes +=
        (jumps_to_come * latest * hit.restitution / (1.0 - hit.restitution)) * hit.jump_slope.abs();
  }
  const typename State<D>::Lanes speeds = speed_bounds(state, left) + pushes;
  for (std::size_t k = 0; k < mode.contacts.size(); ++k) {
    if (chatter.hits_contact(k)) continue;
    const Contact<D> &contact = mode.contacts[k];
    const Reading<D> &watched = contact.watched;
    const double jumps = contact.held ? (watched.on_slope.abs() * pushes).sum() : 0.0;
    // A narrow gap read off the lanes has rounding in it, but no more than the motion itself.
    if (!stays_clear(state, contact, watched_now(state, contact), speeds, left, narrow, jumps))
      return false;
  }
  return true;
}

// Adds to the lanes the responses to impacts with these moments, of orders from `from` to `to`, in
// units of powers of the span of the path.
template <int D>
void add_responses(State<D> &state, const typename Chatter<D>::Hit &hit, const Expansion &path,
                   const Weights<D> &flow, const double *moments, int from, int to) {
  const ContactMode<D> &mode = *state.mode;
  for (Eigen::Index i = 0; i < mode.modal_lanes(); ++i) {
    OscillatorState<double> response{0.0, 0.0};
    for (int n = from; n <= to; ++n) {
      const double moment = moments[n] * path.power[static_cast<std::size_t>(n)];
      response.value += moment * flow.response(i, n);
      response.slope += moment * flow.rate_of_response(i, n);
    }
    const auto added = lane_after(mode, i, hit.jump_value(i), hit.jump_slope(i), response);
    state.value(i) += added.value;
    state.slope(i) += added.slope;
  }
}

// Sets `moments` to those of the impacts to come at the stop of hit j, in units of powers of the
// span of the path: what each node predicts, less the impacts after it that are past. Those have
// the sum of the weights of the nodes before them, which is tiny for the oldest.
template <int D>
void extrapolate_moments(const Chatter<D> &chatter, const ChatterLimit &limit, std::size_t j,
                         const Expansion &path, detail::Powers &moments) {
  const double r = chatter.hits[j].restitution, left = path.span;
  const auto top = static_cast<std::size_t>(path.order);
  detail::Powers ratio{};
  double power = r;
  for (std::size_t n = 0; n <= top; ++n, power *= r) ratio[n] = power / (1.0 - power);
  moments.fill(0.0);
  double before = 0.0;
  std::size_t node = chatter.table.nodes.size() - limit.nodes;
  for (std::size_t k = chatter.table.nodes[node].impact; k < chatter.impacts.times.size(); ++k) {
    const double weight = chatter.table.nodes[node].impact == k ? limit.weight[node++] : 0.0;
    const double x = (chatter.impacts.times.back() - chatter.impacts.times[k] + left) / left;
    double moment = chatter.impacts.jumps[k * chatter.hits.size() + j];
    for (std::size_t n = 0; n <= top; ++n, moment *= x)
      moments[n] += moment * (weight * ratio[n] - before);
    before += weight;
  }
}

// Moves the state, just after the latest impact, to the limit, with the masses hit at rest on their
// stops. Returns an estimate of the error of the responses relative to the jump of the oldest
// impact used: what its node changes in the moments, as the fastest mode feels it. (Where the mass
// itself hardly feels that mode, the error of the time of the limit does not show it.)
template <int D>
double move_to_limit(const Chatter<D> &chatter, const ChatterLimit &limit, const Scene &scene,
                     const Clock &clock, Weights<D> &weights, const Expansion &path,
                     State<D> &state) {
  const ContactMode<D> &mode = *state.mode;
  const std::size_t hits = chatter.hits.size();
  if (weights.rate != path.rate) build_flow_weights(mode, path.rate, weights);
  move_lanes(state, scene, clock, weights, path, path.span);
  const auto &nodes = chatter.table.nodes;
  const std::size_t oldest = nodes.size() - limit.nodes;
  ChatterLimit change = limit;  // by the weights of one node less
  for (std::size_t i = oldest; i < nodes.size(); ++i)
    change.weight[i] *= nodes[i].x / nodes[oldest].x;
  detail::Powers moments, changes;
  double error = 0.0;
  for (std::size_t j = 0; j < hits; ++j) {
    extrapolate_moments(chatter, limit, j, path, moments);
    add_responses(state, chatter.hits[j], path, weights, moments.data(), 2, path.order);
    extrapolate_moments(chatter, change, j, path, changes);
    double sum = 0.0, power = path.power[1];
    for (std::size_t n = 2; n < changes.size(); ++n)
      sum += std::abs(changes[n]) * (power *= path.power[1] / static_cast<double>(n));
    error = std::max(error, luck * sum / chatter.impacts.jumps[nodes[oldest].impact * hits + j]);
  }
  // The second moments bring the masses to their stops, the first ones to rest there.
  for (std::size_t j = 0; j < hits; ++j) {
    moments[1] = -watched_now(state, mode.contacts[chatter.impacts.contacts[j]]) / path.span;
    add_responses(state, chatter.hits[j], path, weights, moments.data(), 1, 1);
  }
  tie_decays(state);
  for (const std::size_t k : chatter.impacts.contacts) place_at_stop(state, mode.contacts[k], 0.0);
  for (std::size_t k = 0; k < mode.contacts.size(); ++k) {
    const Contact<D> &contact = mode.contacts[k];
    if (contact.held || chatter.hits_contact(k))
      set_gap(state.stops[contact.stop], 0.0, 0.0);
    else
      read_gap(state, contact);  // it is clear
  }
  return error;
}

}  // namespace vibro_impact
