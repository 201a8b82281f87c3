#include "chain.hpp"

#include <algorithm>
#include <cmath>

#include "scene.hpp"

namespace vibro_impact::detail {

Chain::Chain(const Scene &scene)
    : masses(scene.mass.size()),
      padded((masses + 1) / 2 * 2),
      beta(scene.beta),
      omega(scene.forced() ? scene.omega : 0.0),
      clock(scene.omega),
      rate_bound(detail::rate_bound(scene)),
      rate_unit(std::exp2(std::ilogb(rate_bound) + 1)) {
  const auto padded_list = [this](const std::vector<double> &values) {
    List<double> list(values.begin(), values.end());
    list.resize(padded, 0.0);
    return list;
  };
  mass = padded_list(scene.mass);
  link = padded_list(scene.stiffness);
  ground = padded_list(scene.ground);
  a = padded_list(scene.amplitude);
  b = padded_list(scene.sine);
  p = padded_list(scene.constant);
  lowest.assign(padded, -infinity);
  highest.assign(padded, infinity);
  for (const Stop &stop : scene.stops) {
    const auto i = static_cast<std::size_t>(stop.mass - 1);
    stops.push_back({stops.size(), i, sign(stop.side), stop.position, law_of(scene, stop)});
    (stop.side == Side::upper ? highest : lowest)[i] = stop.position;
  }
  for (std::size_t i = 0; i < masses; ++i) {
    force_bound =
        std::max(force_bound, (std::abs(a[i]) + std::abs(b[i]) + std::abs(p[i])) / mass[i]);
    grounded = grounded || ground[i] != 0.0;
    if (lowest[i] > -infinity || highest[i] < infinity) add_pair(i, stopped_pairs);
    if (a[i] != 0.0 || b[i] != 0.0) add_pair(i, forced_pairs);
  }
}

}  // namespace vibro_impact::detail
