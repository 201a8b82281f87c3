#include "chatter_table.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace vibro_impact::detail {

namespace {

using Eigen::Index;

// The state at the limit, to leading order. Over the time left x / (1 - r) the flight moves on by
// the first order of its Taylor series, and the jumps J of the gap speeds to come add up to
// J r / (1 - r).
void predict(const Motion &motion, const Chatter &chatter, double time_left,
             PredictedState &state) {
  const std::vector<Contact> &contacts = motion.mode->contacts;
  for (PerCoordinate *array : {&state.y, &state.dy, &state.y_low, &state.dy_low})
    array->resize(motion.y.size());
  for (Index j = 0; j < motion.y.size(); j += 2) {
    Pair value = time_left * pair(motion.dy.data() + j),
         slope = time_left * acceleration(motion, j);
    for (std::size_t hit = 0; hit < chatter.contacts.size(); ++hit) {
      const Contact &contact = contacts[chatter.contacts[hit]];
      const double to_come = chatter.jumps[hit] * contact.restitution / (1.0 - contact.restitution);
      slope += to_come * pair(contact.impulse.slope.data() + j);
      if (contact.impulse.value.size() > 0)
        value += to_come * pair(contact.impulse.value.data() + j);
    }
    store(twofold(motion.y, motion.y_low, j) + value, state.y, state.y_low, j);
    store(twofold(motion.dy, motion.dy_low, j) + slope, state.dy, state.dy_low, j);
  }
}

// Computes the row of Neville's scheme that ends with the latest node.
void extrapolate(Chatter &chatter) {
  const std::size_t last = chatter.size - 1;
  const ChatterNode &latest = chatter.node(last);
  chatter.error = infinity;
  chatter.best = 0;
  ExtrapolatedLimit entry{latest.predicted / latest.x, 1.0 / latest.x};
  double error_before = 0.0, time_before = entry.time();
  for (std::size_t column = 1; column <= last; ++column) {
    const ExtrapolatedLimit without_latest = std::exchange(chatter.row[column - 1], entry);
    const double share = latest.x / (chatter.node(last - column).x - latest.x);
    entry.predicted += (entry.predicted - without_latest.predicted) * share;
    entry.reciprocal += (entry.reciprocal - without_latest.reciprocal) * share;
    const double time = entry.time(), error = std::abs(time - time_before);
    // Two limits may agree by chance: the estimate is not much below that with one node less.
    const double estimate = std::max(error, min_error_decay * error_before);
    if (estimate <= chatter.error) {
      chatter.error = estimate;
      chatter.best = column;
    }
    error_before = error;
    time_before = time;
  }
  chatter.row[last] = entry;
}

}  // namespace

bool Chatter::hits(std::size_t contact) const {
  return std::find(contacts.begin(), contacts.end(), contact) != contacts.end();
}

void end_chatter(Chatter &chatter) {
  chatter.contacts.clear();
  chatter.impacts = chatter.size = chatter.oldest = 0;
  chatter.flight_time = chatter.since = chatter.time = 0.0;
}

void begin_chatter(Chatter &chatter, const std::vector<std::size_t> &contacts, double restitution) {
  end_chatter(chatter);
  chatter.contacts = contacts;
  chatter.restitution = restitution;
  const double stride = std::log(node_ratio) / std::log(restitution);
  chatter.stride = static_cast<std::size_t>(std::ceil(std::max(1.0, stride)));
}

bool add_impact(Chatter &chatter, double flight_time, const std::vector<double> &jumps,
                const Motion &motion) {
  if (chatter.under_way()) chatter.time += chatter.since;
  chatter.flight_time = flight_time;
  chatter.since = 0.0;
  chatter.jumps = jumps;
  if (chatter.impacts++ % chatter.stride != 0) return false;
  if (chatter.size < max_chatter_nodes)
    ++chatter.size;
  else  // the oldest node goes
    chatter.oldest = (chatter.oldest + 1) % max_chatter_nodes;
  ChatterNode &node = chatter.ring[(chatter.oldest + chatter.size - 1) % max_chatter_nodes];
  const double left = flight_time / (1.0 - chatter.restitution);
  node.x = flight_time;
  node.predicted = chatter.time + left;
  node.jump = *std::max_element(jumps.begin(), jumps.end());
  predict(motion, chatter, left, node.state);
  extrapolate(chatter);
  return true;
}

NodeWeights weights_of(const Chatter &chatter, std::size_t oldest) {
  NodeWeights weights;
  for (std::size_t i = chatter.size; i-- > oldest;) {
    weights.without_oldest = weights.all;
    const double x = chatter.node(i).x;
    weights.all[i] = 1.0 / x;
    for (std::size_t j = i + 1; j < chatter.size; ++j) {
      const double later = chatter.node(j).x, inverse = 1.0 / (later - x);
      weights.all[i] *= later * inverse;
      weights.all[j] *= -x * inverse;
    }
  }
  for (PerNode *scaled : {&weights.all, &weights.without_oldest}) {
    const double sum = std::accumulate(scaled->begin(), scaled->end(), 0.0);
    for (double &weight : *scaled) weight /= sum;
  }
  return weights;
}

std::optional<ChatterLimit> extrapolate_limit(const Chatter &chatter, double tolerance) {
  if (chatter.size < fewest_chatter_nodes || !(chatter.error <= tolerance)) return std::nullopt;
  const std::size_t last = chatter.size - 1;
  const double predicted = chatter.node(last).predicted - chatter.time,
               time_left = chatter.row[chatter.best].time() - chatter.time;
  if (!(std::abs(time_left - predicted) < prediction_share * predicted)) return std::nullopt;
  return ChatterLimit{time_left, chatter.error, last - chatter.best};
}

}  // namespace vibro_impact::detail
