#include "chatter.hpp"

#include <algorithm>
#include <cmath>

namespace vibro_impact::detail {

const ChatterNode &Chatter::node(std::size_t before_latest) const {
  return ring_[(newest_ + most_chatter_nodes - before_latest) % most_chatter_nodes];
}

bool Chatter::hits(std::size_t stop) const {
  return std::find(stops_.begin(), stops_.end(), stop) != stops_.end();
}

void Chatter::end() {
  stops_.clear();
  size_ = impacts_ = 0;
  x_ = duration_ = 0.0;
}

// What successive nodes predict differs from the limit by the powers 2, 3, ... of the ratio of
// their x. Each column of the scheme removes one of them.
void Chatter::set_weights(double ratio) {
  std::array<Weights, most_chatter_nodes> column{};  // entry k ends with node k, the oldest first
  weights_ = {};
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

bool Chatter::add(const std::vector<std::size_t> &stops, double x, double r, const Motion &motion,
                  const std::vector<double> &jumps) {
  if (!(stops == stops_ && x < x_)) {
    end();
    stops_ = stops;
    if (r != restitution_) {
      restitution_ = r;
      stride_ =
          static_cast<std::size_t>(std::ceil(std::max(1.0, std::log(node_ratio) / std::log(r))));
      set_weights(std::pow(r, static_cast<double>(stride_)));
    }
  }
  x_ = x;
  const double left = x / (1.0 - r);
  duration_ = std::max(duration_, left);
  if (impacts_++ % stride_ != 0) return false;
  newest_ = (newest_ + 1) % most_chatter_nodes;
  size_ = std::min(size_ + 1, most_chatter_nodes);
  ChatterNode &latest = ring_[newest_];
  latest.left = left;
  latest.instant = motion.now;
  latest.x = motion.x;
  latest.v = motion.v;
  latest.acceleration = motion.acceleration;
  latest.jumps = jumps;
  latest.largest_jump = 0.0;
  for (const double jump : jumps)
    latest.largest_jump = std::max(latest.largest_jump, std::abs(jump));
  return true;
}

bool Chatter::find_limit(double tolerance, const Clock &clock, ChatterLimit &limit) const {
  if (size_ < fewest_chatter_nodes) return false;
  const Weights &all = weights_[size_], &fewer = weights_[size_ - 1];
  const ChatterNode &latest = node(0);
  // Differences from the latest node lose no digits. `oldest` is what the oldest node adds.
  double change = 0.0, oldest = 0.0;
  for (std::size_t k = 1; k < size_; ++k) {
    const ChatterNode &earlier = node(k);
    const double distance = rounded(elapsed(latest.instant, earlier.instant, clock) +
                                    (Real(earlier.left) - latest.left));
    change += all[k] * distance;
    oldest += (all[k] - fewer[k]) * distance;
  }
  if (!(std::abs(oldest) <= tolerance * duration_)) return false;
  if (!(std::abs(change) < prediction_share * latest.left)) return false;
  limit.x.resize(latest.x.size());
  limit.v.resize(latest.x.size());
  for (std::size_t i = 0; i < latest.x.size(); i += 2) {
    const RealPair x = load(&latest.x[i]), v = load(&latest.v[i]);
    const Pair travel = v.hi * latest.left,
               gain = pair(&latest.acceleration[i]) * latest.left + pair(&latest.jumps[i]);
    Pair x_change{}, v_change{}, v_oldest{};
    for (std::size_t k = 1; k < size_; ++k) {
      const ChatterNode &earlier = node(k);
      const RealPair ex = load(&earlier.x[i]), ev = load(&earlier.v[i]);
      const Pair early_gain =
          pair(&earlier.acceleration[i]) * earlier.left + pair(&earlier.jumps[i]);
      const Pair x_distance = (ex.hi - x.hi) + (ex.lo - x.lo) + (ev.hi * earlier.left - travel),
                 v_distance = (ev.hi - v.hi) + (ev.lo - v.lo) + (early_gain - gain);
      x_change += all[k] * x_distance;
      v_change += all[k] * v_distance;
      v_oldest += (all[k] - fewer[k]) * v_distance;
    }
    const double error = std::max(std::abs(v_oldest[0]), std::abs(v_oldest[1]));
    if (!(error <= tolerance * node(size_ - 1).largest_jump)) return false;
    store(x + (v * Pair{latest.left, latest.left} + x_change), &limit.x[i]);
    store(v + (gain + v_change), &limit.v[i]);
  }
  limit.time_left = latest.left + change;
  return true;
}

}  // namespace vibro_impact::detail
