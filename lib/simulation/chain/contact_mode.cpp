#include "contact_mode.hpp"

#include <algorithm>
#include <cmath>

#include "rates.hpp"
#include "tolerances.hpp"

namespace vibro_impact::detail {

namespace {

// An upper bound, to a percent, of the largest eigenvalue of M^-1 K of the free masses. By
// Sylvester's law, all eigenvalues lie below z if all pivots of z - M^-1/2 K M^-1/2 are positive.
// The matrix is tridiagonal, so that a test of z costs O(N).
double largest_eigenvalue(const Chain &chain, const Held &held) {
  const std::size_t n = chain.masses;
  List<double> diagonal(n), off(n);  // off[i] ties mass i to mass i - 1
  double high = 0.0, low = 0.0;
  for (std::size_t i = 0; i < n; ++i) {
    if (held[i] != 0) continue;
    diagonal[i] = chain.stiffness_at(i) / chain.mass[i];
    if (i > 0 && held[i - 1] == 0)
      off[i] = chain.link[i] / std::sqrt(chain.mass[i]) / std::sqrt(chain.mass[i - 1]);
  }
  for (std::size_t i = 0; i < n; ++i) {
    // Gershgorin, and the largest entry of the diagonal.
    high = std::max(high, diagonal[i] + off[i] + (i + 1 < n ? off[i + 1] : 0.0));
    low = std::max(low, diagonal[i]);
  }
  while (high > rate_margin * low) {
    const double middle = 0.5 * (high + low);
    bool above_all = true;
    double pivot = 1.0;
    for (std::size_t i = 0; i < n && above_all; ++i) {
      pivot = middle - diagonal[i] - (i > 0 ? off[i] * (off[i] / pivot) : 0.0);
      above_all = pivot > 0.0;
    }
    (above_all ? high : low) = middle;
  }
  return high;
}

// Adds the pair of a mass to a list of pairs that ends with this one or an earlier one.
void add(std::size_t mass, List<std::size_t> &pairs) {
  const std::size_t first = mass / 2 * 2;
  if (pairs.empty() || pairs.back() != first) pairs.push_back(first);
}

}  // namespace

ContactMode build_contact_mode(const Chain &chain, const Held &held) {
  ContactMode mode;
  mode.held = held;
  mode.mass.assign(chain.padded, infinity);
  mode.inverse_mass.assign(chain.padded, 0.0);
  for (std::size_t i = 0; i < chain.masses; ++i) {
    mode.grounded = mode.grounded || chain.ground[i] != 0.0;
    if (chain.lowest[i] > -infinity || chain.highest[i] < infinity) add(i, mode.stopped_pairs);
    if (held[i] != 0) continue;
    mode.mass[i] = chain.mass[i];
    mode.inverse_mass[i] = 1.0 / chain.mass[i];
    if (chain.a[i] != 0.0 || chain.b[i] != 0.0) add(i, mode.forced_pairs);
  }
  const double lambda = largest_eigenvalue(chain, held);
  mode.fastest = std::max(root_modulus(chain.beta * lambda, lambda), chain.omega);
  for (std::size_t k = 0; k < chain.stops.size(); ++k) {
    const ChainStop &stop = chain.stops[k];
    const bool is_held = held[stop.mass] != 0;
    if (is_held && held[stop.mass] != static_cast<signed char>(stop.sigma)) continue;
    mode.contacts.push_back({k, stop.mass, stop.sigma, stop.position, is_held});
  }
  return mode;
}

const ContactMode &ContactModes::enter(const Chain &chain, const Held &held, Counters &counters) {
  const auto latest = std::find_if(recent_.rbegin(), recent_.rend(),
                                   [&held](const auto &mode) { return mode->held == held; });
  if (latest != recent_.rend()) {
    std::rotate(latest.base() - 1, latest.base(), recent_.end());
    return *recent_.back();
  }
  ++counters.modes_built;
  if (recent_.size() == most_contact_modes) recent_.erase(recent_.begin());
  recent_.push_back(std::make_shared<const ContactMode>(build_contact_mode(chain, held)));
  return *recent_.back();
}

}  // namespace vibro_impact::detail
