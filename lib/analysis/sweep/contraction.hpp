// How the distances of sections p forcing periods apart fall, by which a motion settles.
#pragma once

#include <algorithm>
#include <bit>
#include <utility>
#include <vector>

#include "analysis/orbits/orbit_tolerances.hpp"
#include "vibro_impact/scene.hpp"

namespace vibro_impact {

// The largest numbers of a sequence in its latest blocks. The numbers from 2^k to 2^(k+1) are one
// block: a long sequence forgets its beginning.
struct LargestByBlock {
  double latest = 0.0, before = 0.0, earlier = 0.0;

  void add(double value, int number) {
    if (std::has_single_bit(static_cast<unsigned>(number))) {
      earlier = std::exchange(before, latest);
      latest = 0.0;
    }
    latest = std::max(latest, value);
  }
};

// The distances d_n of sections p periods apart, and their ratios d_n / d_(n-p), for one p. All
// lengths compare with `scale`, the amplitude of the motion.
struct Contraction {
  std::vector<double> distances;  // the latest p, by section modulo p; infinite: not known yet
  std::vector<double> ratios;     // likewise
  int settled = 0;                // latest sections in a row with the estimate below the tolerance
  LargestByBlock largest_distance = {};

  explicit Contraction(std::size_t p) : distances(p, infinity), ratios(p, infinity) {
  }

  // Adds the distance of section `number`. Distances below rounding count as zero.
  void add(double distance, int number, double scale) {
    const std::size_t k = static_cast<std::size_t>(number) % distances.size();
    const double floor = repeats * scale, before = std::exchange(distances[k], distance);
    double &ratio = ratios[k];
    if (before > floor && before < infinity)
      ratio = distance / before;
    else if (distance > floor || before == infinity)
      ratio = infinity;
    else if (ratio == infinity)  // both distances are below the floor
      ratio = 0.0;
    // A single small ratio may be chance: the estimate is no less than a distance above the floor.
    const double least = distance > floor ? 1.0 : 0.0;
    const bool below = ratio < 1.0 && distance * std::max(ratio / (1.0 - ratio), least) <=
                                          settle_tolerance * scale;
    settled = below ? settled + 1 : 0;
    largest_distance.add(distance, number);
  }

  // The largest distance of the latest sections, or its estimate from those to come if this is
  // larger, of a motion that has settled. Sections that are equal to the last bit repeat for ever.
  double still_to_come(double scale) const {
    double largest = 0.0;
    for (std::size_t k = 0; k < ratios.size(); ++k)
      largest = std::max(largest, distances[k] * std::max(ratios[k] / (1.0 - ratios[k]), 1.0));
    return largest == 0.0 ? 0.0 : std::max(largest, newton_tolerance * scale);
  }
};

}  // namespace vibro_impact
