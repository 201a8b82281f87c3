#include "first_event.hpp"

#include <algorithm>
#include <cmath>

#include "simulation/chain/pair.hpp"
#include "simulation/chain/placement.hpp"
#include "simulation/chain/tolerances.hpp"

namespace vibro_impact::detail {

namespace {

using Complex = std::complex<double>;
using Eigen::Index;
// Sets bounds of |y(t + tau) - y(t)| and |y'(t + tau) - y'(t)| over the step, 0 <= tau <= h. A
// share of |y| and |y'| is added as a margin: a contact out of reach then stays well above its
// rounding, and its gap can be evaluated from the coordinates after the step.
//
// E^2 = y'^2 + lambda y^2 and E'^2 = y''^2 + lambda y'^2 grow by the forcing alone. With y, y' and
// y'' at the start of the step this gives (7) of lib/README.md:
//   |y'(t + tau)| <= |y'| + sqrt(lambda) |y| + |force| h,
//   |y'(t + tau)| <= |y'| + (|y''| + Omega |force| h) / sqrt(lambda).
// The second bound is small for a coordinate that hardly moves, as under a slow forcing.
void bound_travel(const Motion &motion, double omega, Flight &flight) {
  constexpr double margin = 2.0 * resolved_ratio;
  const ModalCoordinates &all = motion.mode->coordinates;
  const double length = flight.step.length, time = (1.0 + resolved_ratio) * length;
  flight.travel.resize(motion.y.size());
  flight.rate_travel.resize(motion.y.size());
  for (Index j = 0; j < motion.y.size(); j += 2) {
    const Pair y = abs(pair(motion.y.data() + j)), dy = abs(pair(motion.dy.data() + j)),
               force = pair(all.force.data() + j);
    const Pair frequency = pair(all.frequency.data() + j);
    const Pair acceleration = abs(pair(flight.table.of_order(2) + j)) * (2.0 / (length * length)) +
                              omega * length * force;
    const Pair speed = dy + smaller(frequency * y + length * force,
                                    acceleration * pair(all.inverse_frequency.data() + j));
    store(time * speed + margin * y, flight.travel.data() + j);
    store(time * (acceleration + frequency * dy) + margin * dy, flight.rate_travel.data() + j);
  }
}

// A bound of the change of (3) over the step, with the margin. The cosine of the forcing changes by
// at most Omega h, to which 1 percent is added.
double travel_of(const Contact &contact, double omega, const Flight &flight) {
  constexpr double margin = 2.0 * resolved_ratio;
  double travel = dot(contact.modulus, flight.travel) + margin * std::abs(contact.offset);
  if (contact.held)
    travel += contact.damping * dot(contact.modulus, flight.rate_travel) +
              contact.forcing_modulus * (1.01 * omega * flight.step.length + margin);
  return travel;
}

// The rounding of the coefficient of order n of (3).
double rounding_of_order(const TaylorTable &table, const Contact &contact, int n) {
  double size = dot_moduli(contact.modulus.data(), table.of_order(n), table.coordinates);
  if (contact.held)
    size += contact.damping / table.length * (n + 1) *
                dot_moduli(contact.modulus.data(), table.of_order(n + 1), table.coordinates) +
            contact.forcing_modulus;
  return row_rounding * size;
}

// Inserts the zeros of a decided force. The first coefficient after them has the decided sign and
// is at least its rounding. Further coefficients below their rounding are zero, up to the first one
// above it: they must not bring the mass back at once.
void insert_decided_force(const DecidedForce &force, const Contact &contact,
                          const TaylorTable &table, Polynomial &p) {
  // The force on a released mass is the second derivative of its gap.
  const int known = force.none ? p.order + 1 : force.zeros + (contact.held ? 0 : 2);
  // The gap of a mass that leaves in an order beyond that of the step is not identically zero.
  const int zeros = force.none ? known : std::min(known, p.order);
  std::fill_n(p.coefficient.begin(), zeros, 0.0);
  for (int n = zeros; n <= p.order; ++n) {
    double &coefficient = p.coefficient[static_cast<std::size_t>(n)];
    const double rounding = rounding_of_order(table, contact, n);
    const bool above = std::abs(coefficient) > rounding;
    if (n == zeros)
      coefficient = std::max({std::abs(coefficient), rounding, least_coefficient});
    else if (!above)
      coefficient = 0.0;
    if (above) return;
  }
}

// Replaces the leading coefficients of the polynomial of a contact by those known more accurately:
// a small gap and its speed, or the zeros of a decided force.
void insert_exact_coefficients(const Motion &motion, const Contact &contact, const StopState &stop,
                               const TaylorTable &table, Polynomial &p) {
  if (const auto &force = stop.contact.decided) {
    insert_decided_force(*force, contact, table, p);
  } else if (!contact.held && !(p.coefficient[0] > resolved_ratio * terms_of(contact, motion))) {
    const Gap gap = gap_of(contact, stop, motion);
    p.coefficient[0] = std::max(0.0, gap.value);
    p.coefficient[1] = gap.speed * table.length;
  }
}

// True when a hold force is nothing but rounding over the whole step. The mass stays held. `travel`
// is at least 2 resolved_ratio times the terms, so that a larger p(0) alone exceeds the bound of
// the sum.
bool is_rounding(const Motion &motion, const Contact &contact, double travel, const Polynomial &p) {
  if (std::abs(p.coefficient[0]) > row_rounding * travel / resolved_ratio) return false;
  double sum = 0.0;
  for (int n = 0; n <= p.order; ++n) sum += std::abs(p.coefficient[static_cast<std::size_t>(n)]);
  return sum <= row_rounding * (terms_of(contact, motion) + travel);
}

// Drops the roots after the first event. A root u is as far from it as rounding allows when u -
// flight.u is at most `tolerance`, and at most the sum of the roundings of the two roots: the
// rounding of (3) over its slope.
void drop_later_roots(const Motion &motion, double tolerance, Flight &flight) {
  const std::vector<Contact> &contacts = motion.mode->contacts;
  const auto rounding_of = [&](std::size_t k) {
    return same_instant * terms_of(contacts[k], motion) /
           std::abs(flight.approaches[k].root->slope);
  };
  double rounding_of_first = infinity;
  for (std::size_t k = 0; k < contacts.size(); ++k)
    if (flight.approaches[k].root && flight.approaches[k].root->u == flight.u)
      rounding_of_first = std::min(rounding_of_first, rounding_of(k));
  for (std::size_t k = 0; k < contacts.size(); ++k) {
    std::optional<Root> &root = flight.approaches[k].root;
    if (!root || root->u == flight.u) continue;
    if (root->u - flight.u > std::min(tolerance, rounding_of(k) + rounding_of_first)) root.reset();
  }
}

// Places the small gap of a mass that was released at the start of the step. The polynomial has its
// exact zeros, while the coordinates have the rounding of the mode change and of fast decays.
void place_released(const Flight &flight, const std::vector<StopState> &stops, Motion &motion) {
  const std::vector<Contact> &contacts = motion.mode->contacts;
  for (std::size_t k = 0; k < contacts.size(); ++k) {
    if (!stops[contacts[k].stop].contact.released || flight.approaches[k].root) continue;
    if (is_resolved(contacts[k], motion)) continue;
    const Jet jet = jet_at(flight.approaches[k].polynomial, 0, flight.u);
    place(contacts[k], {jet.value, jet.slope / flight.step.length}, motion);
  }
}

}  // namespace

void find_first_event(const Motion &motion, const std::vector<StopState> &stops, const Clock &clock,
                      bool forced, Flight &flight, Counters &counters) {
  const ContactMode &mode = *motion.mode;
  const Step &step = flight.step;
  expand(motion, step, clock.omega, forced, flight.table);
  bound_travel(motion, clock.omega, flight);
  // Two roots u1 < u2 are one instant if u2 - u1 is at most each of these: 2^-46 radians of the
  // rate in motion, 2^-16 u1, and the sum of the roundings of both roots (drop_later_roots).
  const double rounding = same_instant / (step.rate * step.length);
  const auto simultaneous = [rounding](double u) {
    return std::min(rounding, same_instant_of_flight * u);
  };
  if (flight.approaches.size() < mode.contacts.size())
    flight.approaches.resize(mode.contacts.size());
  flight.any_near = flight.event = flight.any_released = false;
  flight.u = 1.0;
  for (std::size_t k = 0; k < mode.contacts.size(); ++k) {
    const Contact &contact = mode.contacts[k];
    const StopState &stop = stops[contact.stop];
    Approach &approach = flight.approaches[k];
    approach.root.reset();
    if (stop.contact.postponed) {  // decided at the end of the step
      flight.any_near = flight.event = true;
      continue;
    }
    const bool decided = stop.contact.decided.has_value();
    flight.any_released = flight.any_released || (decided && !contact.held);
    const double travel = travel_of(contact, clock.omega, flight);
    if (!decided && evaluate(contact, motion) > travel) {
      ++counters.out_of_reach;
      continue;
    }
    flight.any_near = true;
    Polynomial &p = approach.polynomial;
    read_along(flight.table, contact, p);
    counters.products += (step.order + 1) * mode.padded();
    if (contact.held && !decided && is_rounding(motion, contact, travel, p)) continue;
    insert_exact_coefficients(motion, contact, stop, flight.table, p);
    approach.root = first_root(p, std::min(1.0, flight.u + simultaneous(flight.u)), counters);
    if (!approach.root) continue;
    flight.event = true;
    flight.u = std::min(approach.root->u, flight.u);  // NaN if the root is
    if (std::isnan(flight.u)) return;
  }
  drop_later_roots(motion, simultaneous(flight.u), flight);
}

void move_along(const Flight &flight, double u, const Clock &clock, Motion &motion,
                std::vector<StopState> &stops) {
  if (u > 0.0) {
    move_coordinates(flight.table, u, clock, motion);
    if (u == flight.u && flight.any_released) place_released(flight, stops, motion);
    forget_instant(stops);
  }
  if (u < flight.u) return;
  const std::vector<Contact> &contacts = motion.mode->contacts;
  for (std::size_t k = 0; k < contacts.size(); ++k)
    if (const auto &root = flight.approaches[k].root; root && !contacts[k].held)
      stops[contacts[k].stop].contact = {.speed = root->slope / flight.step.length};
}

void forget_instant(std::vector<StopState> &stops) {
  for (StopState &stop : stops) {
    AtStop &contact = stop.contact;
    contact.speed.reset();
    if (contact.released)
      contact = {};
    else if (!rests_without_force(stop))
      contact.decided.reset();
  }
}

}  // namespace vibro_impact::detail
