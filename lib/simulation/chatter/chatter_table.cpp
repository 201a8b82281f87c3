#include "chatter_table.hpp"

#include <algorithm>
#include <cmath>

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
      slope += to_come * pair(contact.impulse.data() + j);
      if (contact.impulse_value.size() > 0)
        value += to_come * pair(contact.impulse_value.data() + j);
    }
    store(twofold(motion.y, motion.y_low, j) + value, state.y, state.y_low, j);
    store(twofold(motion.dy, motion.dy_low, j) + slope, state.dy, state.dy_low, j);
  }
}

}  // namespace

// Lagrange's weights at x = 0, divided by x_i and by the sum of these quotients.
PerNode node_weights(const ChatterTable &table, std::size_t first) {
  PerNode weights{};
  double sum = 0.0;
  for (std::size_t i = first; i < table.size; ++i) {
    weights[i] = 1.0 / table.x[i];
    for (std::size_t j = first; j < table.size; ++j)
      if (j != i) weights[i] *= table.x[j] / (table.x[j] - table.x[i]);
    sum += weights[i];
  }
  for (double &weight : weights) weight /= sum;
  return weights;
}

// The factor x / (x - x_i) of the node is taken out of the others.
PerNode without_node(const ChatterTable &table, std::size_t first, PerNode weights) {
  double sum = 0.0;
  weights[first] = 0.0;
  for (std::size_t i = first + 1; i < table.size; ++i) {
    weights[i] *= 1.0 - table.x[i] / table.x[first];
    sum += weights[i];
  }
  for (double &weight : weights) weight /= sum;
  return weights;
}

PredictedState &extend(ChatterTable &table, double x, double predicted, double jump) {
  table.error = std::numeric_limits<double>::infinity();
  table.best = 0;
  if (table.size == max_chatter_nodes) {
    for (PerNode *numbers : {&table.x, &table.predicted, &table.jump})
      std::copy(numbers->begin() + 1, numbers->end(), numbers->begin());
    table.oldest_state = (table.oldest_state + 1) % max_chatter_nodes;
    --table.size;
  }
  const std::size_t last = table.size++;
  table.x[last] = x;
  table.predicted[last] = predicted;
  table.jump[last] = jump;
  ChatterTable::Entry entry{predicted / x, 1.0 / x};
  double error_before = 0.0, limit_before = entry.limit();
  for (std::size_t column = 1; column <= last; ++column) {
    const ChatterTable::Entry without_newest = table.row[column - 1];
    table.row[column - 1] = entry;
    const double share = x / (table.x[last - column] - x);
    entry.predicted += (entry.predicted - without_newest.predicted) * share;
    entry.reciprocal += (entry.reciprocal - without_newest.reciprocal) * share;
    const double limit = entry.limit(), error = std::abs(limit - limit_before);
    // Two limits may agree by chance: the estimate is not much below that with one node less.
    const double estimate = std::max(error, min_error_decay * error_before);
    if (estimate <= table.error) {
      table.error = estimate;
      table.best = column;
    }
    error_before = error;
    limit_before = limit;
  }
  table.row[last] = entry;
  return table.states[(table.oldest_state + last) % max_chatter_nodes];
}

bool Chatter::hits(std::size_t contact) const {
  return std::find(contacts.begin(), contacts.end(), contact) != contacts.end();
}

void end_chatter(Chatter &chatter) {
  chatter.contacts.clear();
  chatter.impacts = chatter.table.size = chatter.table.oldest_state = 0;
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
  const double left = flight_time / (1.0 - chatter.restitution);
  predict(motion, chatter, left,
          extend(chatter.table, flight_time, chatter.time + left,
                 *std::max_element(jumps.begin(), jumps.end())));
  return true;
}

std::optional<ChatterLimit> extrapolate_limit(const Chatter &chatter, double tolerance) {
  const ChatterTable &table = chatter.table;
  if (table.size < fewest_chatter_nodes || !(table.error <= tolerance)) return std::nullopt;
  const std::size_t last = table.size - 1;
  const double predicted = table.predicted[last] - chatter.time,
               time_left = table.row[table.best].limit() - chatter.time;
  if (!(std::abs(time_left - predicted) < prediction_share * predicted)) return std::nullopt;
  return ChatterLimit{time_left, table.error, last - table.best};
}

}  // namespace vibro_impact::detail
