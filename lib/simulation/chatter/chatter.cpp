#include "chatter.hpp"

#include <algorithm>
#include <cmath>

namespace vibro_impact::detail {

ImpactSum taken_by_impact(const Chain &chain, std::size_t stop, double closing, double leaving) {
  const double m = chain.mass[chain.stops[stop].mass];
  return {m * (closing + leaving), 0.5 * m * (closing - leaving) * (closing + leaving)};
}

const ChatterNode &Chatter::node(std::size_t before_latest) const {
  return ring_[(newest_ + most_chatter_nodes - before_latest) % most_chatter_nodes];
}

void Chatter::end() {
  size_ = impacts_ = 0;
  flight_time_ = duration_ = 0.0;
}

// The predictions of successive nodes differ from the limit by the powers 2, 3, ... of the ratio of
// their flight times. Each column of the scheme removes one of them.
void Chatter::set_weights(double ratio) {
  std::array<Weights, most_chatter_nodes> column{};  // entry k ends with node k, the oldest first
  weights_ = {};
  weights_ratio_ = ratio;
  for (std::size_t k = 0; k < most_chatter_nodes; ++k) column[k][k] = 1.0;
  double power = ratio;
  for (std::size_t count = 2; count <= most_chatter_nodes; ++count) {
    power *= ratio;
    const double share = power / (1.0 - power);
    for (std::size_t k = most_chatter_nodes; k-- >= count;)
      for (std::size_t i = 0; i < most_chatter_nodes; ++i)
        column[k][i] += (column[k][i] - column[k - 1][i]) * share;
    for (std::size_t i = 0; i < count; ++i)
      weights_[count][i] = column.back()[most_chatter_nodes - 1 - i];
  }
}

void Chatter::add(const Chain &chain, const Motion &motion, const Contact &contact, double closing,
                  double flight_time) {
  const std::size_t stop = contact.stop, mass = contact.mass;
  const double r = contact.law.at_rest();
  if (!(stop == contact_.stop && flight_time < flight_time_)) {
    end();
    contact_ = contact;
    sum_ = {};
    first_ = motion.now;
    stride_ =
        static_cast<std::size_t>(std::ceil(std::max(1.0, std::log(node_ratio) / std::log(r))));
    ratio_ = std::pow(r, static_cast<double>(stride_));
  }
  flight_time_ = flight_time;
  const double leaving = std::abs(motion.v[mass].hi), m = chain.mass[mass];
  const ImpactSum taken = taken_by_impact(chain, stop, closing, leaving);
  sum_ += Pair{taken.impulse, taken.energy};
  const double left = flight_time / (1.0 - r);
  if (impacts_++ % stride_ != 0) return;
  // The nodes before have not come to the constant ratio: their predictions are no series in it.
  if (size_ > 0 && std::abs(left / left_ - ratio_) > ratio_change * ratio_) size_ = 0;
  if (size_ == 0) duration_ = left;
  newest_ = (newest_ + 1) % most_chatter_nodes;
  size_ = std::min(size_ + 1, most_chatter_nodes);
  if (size_ == fewest_chatter_nodes && weights_ratio_ != ratio_) set_weights(ratio_);
  left_ = left;
  // Each jump of the velocity is r times the one before, as is each impulse. Each energy is r^2
  // times the one before.
  const double jump = (1.0 + r) / (1.0 - r) * leaving;
  ChatterNode &node = ring_[newest_];
  node.jump = -contact.sigma * jump;
  node.time = elapsed(first_, motion.now, chain.clock) + left;
  node.x.resize(motion.x.size());
  node.v.resize(motion.x.size());
  for (std::size_t i = 0; i < motion.x.size(); i += 2) {
    const RealPair v = load(&motion.v[i]);
    Pair gain = left * pair(&motion.acceleration[i]);
    if (mass / 2 * 2 == i) gain[mass % 2] += node.jump;
    store(load(&motion.x[i]) + v * Pair{left, left}, &node.x[i]);
    store(v + gain, &node.v[i]);
  }
  node.sum = sum_ + Pair{m * jump, 0.5 * m * leaving * leaving};
}

// Differences from the latest node lose no digits. `oldest` is what the oldest node adds.
std::optional<double> Chatter::time_left(double tolerance, double rate) const {
  if (size_ < fewest_chatter_nodes) return std::nullopt;
  const Weights &all = weights_[size_], &fewer = weights_[size_ - 1];
  const Real &latest = node(0).time;
  double change = 0.0, oldest = 0.0;
  for (std::size_t k = 1; k < size_; ++k) {
    const Real &time = node(k).time;
    const double distance = (time.hi - latest.hi) + (time.lo - latest.lo);
    change += all[k] * distance;
    oldest += (all[k] - fewer[k]) * distance;
  }
  if (!(std::abs(oldest) <= tolerance * std::min(duration_, 1.0 / rate))) return std::nullopt;
  return left_ + change;
}

bool Chatter::extrapolate(double tolerance, Motion &motion) const {
  const Weights &all = weights_[size_], &fewer = weights_[size_ - 1];
  const ChatterNode &latest = node(0);
  for (std::size_t i = 0; i < latest.x.size(); i += 2) {
    const RealPair x = load(&latest.x[i]), v = load(&latest.v[i]);
    Pair x_change{}, v_change{}, v_oldest{};
    for (std::size_t k = 1; k < size_; ++k) {
      const RealPair ex = load(&node(k).x[i]), ev = load(&node(k).v[i]);
      const Pair v_distance = (ev.hi - v.hi) + (ev.lo - v.lo);
      x_change += all[k] * ((ex.hi - x.hi) + (ex.lo - x.lo));
      v_change += all[k] * v_distance;
      v_oldest += (all[k] - fewer[k]) * v_distance;
    }
    const double error = std::max(std::abs(v_oldest[0]), std::abs(v_oldest[1]));
    if (!(error <= tolerance * std::abs(node(size_ - 1).jump))) return false;
    store(x + x_change, &motion.x[i]);
    store(v + v_change, &motion.v[i]);
  }
  return true;
}

ImpactSum Chatter::sum_left() const {
  const RealPair &latest = node(0).sum;
  Pair left = (latest - sum_).hi;
  for (std::size_t k = 1; k < size_; ++k) left += weights_[size_][k] * (node(k).sum - latest).hi;
  return {left[0], left[1]};
}

}  // namespace vibro_impact::detail
