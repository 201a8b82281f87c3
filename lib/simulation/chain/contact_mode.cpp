#include "contact_mode.hpp"

#include <algorithm>
#include <cmath>

#include "scene.hpp"
#include "tolerances.hpp"

namespace vibro_impact::detail {

namespace {

// An upper bound of the largest eigenvalue z of M^-1 K of the free masses, exact for one and for
// two. M^-1/2 K M^-1/2 is tridiagonal, with the diagonal d. Let r_i be the sum of the moduli beside
// it in row i. Of an eigenvector y let y_i be the largest entry, and y_j that of the neighbours of
// mass i. If z exceeds d_i and d_j, then
//   (z - d_i) |y_i| <= r_i |y_j|,   (z - d_j) |y_j| <= r_j |y_i|,   (z - d_i) (z - d_j) <= r_i r_j
double largest_eigenvalue(const Chain &chain, const Held &held) {
  const std::size_t n = chain.masses;
  List<double> diagonal(n, 0.0), off(n + 1, 0.0);  // off[i] ties mass i to mass i - 1
  for (std::size_t i = 0; i < n; ++i) {
    if (held[i] != 0) continue;
    diagonal[i] = chain.stiffness_at(i) / chain.mass[i];
    if (i > 0 && held[i - 1] == 0)
      off[i] = chain.link[i] / std::sqrt(chain.mass[i]) / std::sqrt(chain.mass[i - 1]);
  }
  double bound = diagonal[0], root = std::sqrt(off[1]);  // of r_(i - 1)
  for (std::size_t i = 1; i < n; ++i) {
    const double mean = 0.5 * (diagonal[i] + diagonal[i - 1]),
                 next = std::sqrt(off[i] + off[i + 1]);
    bound = std::max(bound, mean + std::hypot(diagonal[i] - mean, root * next));
    root = next;
  }
  return bound;
}

}  // namespace

ContactMode build_contact_mode(const Chain &chain, const Held &held) {
  ContactMode mode;
  mode.held = held;
  mode.mass.assign(chain.padded, infinity);
  mode.inverse_mass.assign(chain.padded, 0.0);
  for (std::size_t i = 0; i < chain.masses; ++i) {
    if (held[i] != 0) continue;
    mode.mass[i] = chain.mass[i];
    mode.inverse_mass[i] = 1.0 / chain.mass[i];
  }
  const double lambda = largest_eigenvalue(chain, held);
  mode.fastest = std::max(root_modulus(chain.beta * lambda, lambda), chain.omega);
  for (Contact contact : chain.stops) {
    contact.held = held[contact.mass] != 0;
    if (!contact.held || held[contact.mass] == static_cast<signed char>(contact.sigma))
      mode.contacts.push_back(contact);
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
