// The border orbits unfolded: what the self-similar chatter says of the distances at which impacts
// are added (figures/README.md, The border orbit unfolded), and what is measured.
#pragma once

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <vector>

#include "border_cascade.hpp"

namespace vibro_impact::figures {

// What the border chatter (border_orbit.hpp) says of its unfolding; of the restitution alone.
struct CascadePrediction {
  double factor;      // of the distances at which consecutive impacts are added
  double correction;  // per impact, of what the end of the chatter does to the next one
};

// Per impact the difference from the border chatter grows by `escape`, and the speeds fall by
// `speed_ratio`: a distance d is used up after n impacts, d escape^n of order 1, and leaves
// a speed of order speed_ratio^n, which the next chatter sees beside d.
inline CascadePrediction predicted_cascade(double restitution) {
  const BorderChatter chatter = border_chatter(restitution);
  return {1.0 / chatter.escape, chatter.speed_ratio * chatter.escape};
}

// The factor of the distances of consecutive impacts in the limit.
struct MeasuredFactor {
  double value, uncertainty;
};

// The mean factor over `stride` impacts, less what dies out per impact by the correction of the
// prediction, by the factor itself (terms in the distance) and by its square (Richardson). The
// median of those that end at distances where the rounding of omega leaves five digits and these
// terms suffice; uncertainty: half of their range. Nothing where the cascade is too short.
inline std::optional<MeasuredFactor> measured_factor(const std::vector<AddedImpact> &added,
                                                     const CascadePrediction &predicted) {
  constexpr int stride = 5;
  constexpr double nearest = 2e-10, farthest = 2e-9;
  std::map<int, double> distance;
  for (const AddedImpact &one : added) distance[one.impact] = one.distance;
  std::vector<double> estimates;
  for (const auto &[impact, at] : distance) {
    if (at < nearest || at > farthest) continue;
    std::vector<double> logs;  // of the distances; the last impact first
    for (int k = impact; logs.size() < 5 && distance.contains(k); k -= stride)
      logs.push_back(std::log(distance.at(k)));
    if (logs.size() < 5) continue;
    for (std::size_t k = 0; k + 1 < 5; ++k) logs[k] = (logs[k] - logs[k + 1]) / stride;
    std::size_t left = 4;
    for (const double dying :
         {predicted.correction, predicted.factor, std::pow(predicted.factor, 2)}) {
      const double over = std::pow(dying, stride);
      --left;
      for (std::size_t k = 0; k < left; ++k)
        logs[k] = (logs[k] - over * logs[k + 1]) / (1.0 - over);
    }
    estimates.push_back(std::exp(logs[0]));
  }
  if (estimates.size() < 3) return std::nullopt;
  std::sort(estimates.begin(), estimates.end());
  return MeasuredFactor{estimates[estimates.size() / 2],
                        0.5 * (estimates.back() - estimates.front())};
}

// How far beyond the grazing, in units of its distance, the orbit with the added impact goes on
// beside the one without, up to its fold: followed outwards from `inside`, which has the impact, to
// a thousandth of that. Nothing where it ends at the grazing.
inline std::optional<double> fold_beyond(const Unfolding &of, const AddedImpact &added,
                                         UnfoldedOrbit inside) {
  const auto beyond = [&] { return inside.distance / added.distance - 1.0; };
  double step = 0.25 * std::abs(beyond());
  while (step > std::max(1e-8, 1e-3 * beyond())) {
    const auto next = orbit_at(of, inside.distance + step * added.distance, inside);
    if (next && next->impacts == added.impact)
      inside = *next;
    else
      step /= 2.0;
  }
  // At a fold a multiplier is 1; where there is none it goes to minus infinity at the grazing.
  const bool fold = beyond() > 1e-6 && inside.orbit.multipliers.front().real() > 0.5;
  return fold ? std::optional(beyond()) : std::nullopt;
}

}  // namespace vibro_impact::figures
