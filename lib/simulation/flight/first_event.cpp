#include "first_event.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "simulation/chain/tolerances.hpp"

namespace vibro_impact::detail {

namespace {

// Inserts what is known of the start of the flight into the coefficients of a contact.
void insert_start(const Start &start, double unit, Polynomial &p) {
  Terms &c = p.coefficient;
  c[0] = start.value;
  c[1] = start.derivative * unit;
  if (start.zeros == 0) return;
  // A mass that leaves in an order beyond that of the step does so in its last order.
  const int zeros = std::min(start.zeros, p.order);
  std::fill_n(c.begin(), zeros, 0.0);
  if (zeros < 2) return;
  double term = start.derivative;
  for (int n = 1; n <= zeros; ++n) term *= unit / n;
  c[static_cast<std::size_t>(zeros)] = term;
}

// True if a gap stays positive up to u_max by a parabola below it, (4) of lib/README.md.
bool stays_positive(const TaylorTable &table, const Contact &contact, const Start &start,
                    double u_max) {
  const double g2 = -contact.sigma * table.of_order(2)[contact.mass],
               g3 = -contact.sigma * table.of_order(3)[contact.mass],
               higher = travel_margin * table.travel[contact.mass] - std::abs(g2) - std::abs(g3);
  const double slope = start.derivative * table.step.unit,
               second = g2 + u_max * std::min(0.0, g3 - u_max * higher);
  const double lowest = second > 0.0 ? std::clamp(-0.5 * slope / second, 0.0, u_max) : u_max;
  return start.value + std::min(0.0, travel_margin * lowest * (slope + lowest * second)) > 0.0;
}

// True if no contact is below zero, but for rounding, at points before u. This is a check of debug
// builds, which shares nothing with the search for roots.
[[maybe_unused]] bool none_is_passed(const Chain &chain, const Motion &motion,
                                     const TaylorTable &table, const std::vector<Start> &starts,
                                     double u) {
  constexpr int points = 8;
  for (std::size_t k = 0; k < starts.size(); ++k) {
    const Contact &contact = motion.mode->contacts[k];
    Polynomial p;
    read(chain, motion, table, contact, p);
    insert_start(starts[k], table.step.unit, p);
    const double forces = contact.held ? sum_of_forces(chain, contact.mass, motion) : 0.0;
    for (int point = 1; point < points; ++point) {
      const double place = u * point / points;
      double value = 0.0, moduli = 0.0;
      for (int n = p.order; n >= 0; --n) {
        const double c = p.coefficient[static_cast<std::size_t>(n)];
        value = value * place + c;
        moduli = moduli * place + std::abs(c);
      }
      if (value < -touch_rounding * (moduli + forces)) return false;
    }
  }
  return true;
}

}  // namespace

// Without a square of the polynomial, which may leave the range of double precision.
bool only_touches(double value, double slope, double second, double terms) {
  return value <= touch_rounding * terms && second > 0.0 &&
         slope / terms * slope <= 4.0 * touch_rounding * second;
}

Start contact_start(const Chain &chain, const Contact &contact, const AtStop &at,
                    const Motion &motion) {
  if (is_idle(at)) return {.value = infinity};
  if (const auto *known = std::get_if<ExactZeros>(&at); known && known->zeros > 0)
    return {.derivative = known->derivative, .zeros = known->zeros};
  const Value value = evaluate(chain, contact, motion);
  if (rounded(value.value) <= zero_threshold * value.terms)
    return {.derivative = rounded(value.slope), .zeros = 1};
  return {.value = rounded(value.value), .derivative = rounded(value.slope)};
}

FlightEnd StepSearch::find_first_event(const Chain &chain, const Motion &motion, const Step &step,
                                       const std::vector<Start> &starts, std::vector<Near> &near,
                                       Counters &counters) {
  const ContactMode &mode = *motion.mode;
  expand(chain, motion, step, table);
  if (polynomials.size() < mode.contacts.size()) polynomials.resize(mode.contacts.size());
  roots.resize(mode.contacts.size());
  double u = step.u_max;
  bool event = false;
  for (std::size_t k = 0; k < mode.contacts.size(); ++k) {
    const Contact &contact = mode.contacts[k];
    const Start &start = starts[k];
    near[k] = Near::no;
    roots[k] = infinity;
    const double u_search = std::min(step.u_max, u + same_instant * u);
    if (!contact.held && start.zeros == 0 && stays_positive(table, contact, start, u_search))
      continue;
    Polynomial &p = polynomials[k];
    read(chain, motion, table, contact, p);
    insert_start(start, step.unit, p);
    const std::optional<double> root = first_root(p, u_search, counters);
    if (!root) continue;
    if (!std::isfinite(*root)) return {*root, true};
    roots[k] = *root;
    if (!event || *root < u) u = *root;
    event = true;
  }
  assert(none_is_passed(chain, motion, table, starts, u));
  if (!event) return {step.length, false};
  const auto touches = [&](std::size_t k) {
    const Contact &contact = mode.contacts[k];
    if (!contact.held) return false;
    const Jet jet = jet_at(polynomials[k], 0, u);
    return only_touches(jet.value, jet.slope, jet.second,
                        sum_of_forces(chain, contact.mass, motion));
  };
  bool any_touches = false;
  const Contact *closing = nullptr;  // the first whose gap is zero
  for (std::size_t k = 0; k < mode.contacts.size(); ++k) {
    // Stops that come earlier in the list have a root that may lie far beyond the first.
    if (roots[k] > u + same_instant * u) continue;
    near[k] = touches(k) ? Near::touch : Near::zero;
    any_touches = any_touches || near[k] == Near::touch;
    if (!closing && !mode.contacts[k].held) closing = &mode.contacts[k];
  }
  // Others may touch at the same instant, although such roots are found to half the digits only.
  for (std::size_t k = 0; k < mode.contacts.size() && any_touches; ++k)
    if (roots[k] != u && touches(k)) near[k] = Near::touch;
  const double tau = u * step.unit;
  return {closing ? exact_root(table, *closing, motion, tau) : Real(tau), true};
}

}  // namespace vibro_impact::detail
