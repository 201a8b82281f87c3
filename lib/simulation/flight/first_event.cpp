#include "first_event.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "simulation/chain/pair.hpp"
#include "simulation/chain/tolerances.hpp"

namespace vibro_impact::detail {

namespace {

using Complex = std::complex<double>;
using Eigen::Index;
constexpr double infinity = std::numeric_limits<double>::infinity();

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
  constexpr double margin = 2.0 * gap_reread_ratio;
  const ModalCoordinates &all = motion.mode->coordinates;
  const double length = flight.step.length, time = (1.0 + gap_reread_ratio) * length;
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

// True when (3) of a contact, now `value`, stays positive over the step by the margin. The cosine
// of the forcing changes by at most Omega h, to which 1 percent is added.
bool is_out_of_reach(const Contact &contact, double value, double omega, const Flight &flight) {
  constexpr double margin = 2.0 * gap_reread_ratio;
  double travel = dot(contact.modulus, flight.travel) + margin * std::abs(contact.offset);
  if (contact.held)
    travel += contact.damping * dot(contact.modulus, flight.rate_travel) +
              contact.forcing_modulus * (1.01 * omega * flight.step.length + margin);
  return value > travel;
}

// Replaces the leading coefficients of the polynomial of a contact by those known more accurately:
// the carried gap and gap speed, or the zeros of a decided force. The first coefficient after the
// zeros has the decided sign.
void insert_exact_coefficients(const Contact &contact, const StopState &stop, double length,
                               Polynomial &p) {
  if (const DecidedForce *force = decided_force(stop)) {
    // The force on a released mass is the second derivative of its gap.
    const int known = force->none ? p.order + 1 : force->zeros + (contact.held ? 0 : 2);
    // The gap of a mass that leaves in an order beyond that of the step is not identically zero.
    const int zeros = force->none ? known : std::min(known, p.order);
    std::fill_n(p.coefficient.begin(), zeros, 0.0);
    double &first = p.coefficient[static_cast<std::size_t>(zeros)];
    first = std::abs(first);
  } else if (const auto *flight = std::get_if<InFlight>(&stop.contact)) {
    p.coefficient[0] = flight->gap;
    p.coefficient[1] = flight->speed * length;
  }
}

// Sets the gap after a step. It is evaluated from the coordinates when it is well above their
// rounding, or when the carried gap has drifted from them. Otherwise the carried gap is kept.
template <class Carry>
void set_gap(const Motion &motion, const Contact &contact, const Carry &carry, StopState &stop) {
  const double terms = terms_of(contact, motion), evaluated = evaluate(contact, motion);
  InFlight carried;
  bool evaluate_anew = evaluated > gap_reread_ratio * terms;
  if (!evaluate_anew) {
    carried = carry();
    evaluate_anew = evaluated > gap_reread_ratio * gap_reread_ratio * terms &&
                    std::abs(carried.gap - evaluated) > carried_gap_drift * terms;
  }
  if (evaluate_anew) {
    stop.contact = InFlight{evaluated, gap_speed(contact, motion)};
    return;
  }
  carried.gap = std::max(0.0, carried.gap);
  carried.below_rounding = carried.gap < row_rounding * terms;
  stop.contact = carried;
}

// The least time in which a mass that closes its gap at `speed`, under an acceleration towards the
// stop of at most `push`, or away from it of `push` if `pushed_away`, closes `room`. Infinite if it
// turns back before.
double closing_time(double speed, double push, bool pushed_away, double room) {
  if (!(speed > 0.0) && (pushed_away || push == 0.0)) return infinity;
  if (!pushed_away) return 2.0 * room / (speed + std::sqrt(speed * speed + 2.0 * push * room));
  const bool turns_back = push > 0.0 && !(speed * speed > 2.0 * push * room);
  return turns_back ? infinity : room / speed;
}

// A time in which the rigid-body mode cannot close `room` of a gap. Its speed and the modulus of
// its forces bound it. Where the forces only turn, its mean speed and the amplitude 2 |f| / Omega^2
// may give a longer time.
double drift_time(const Motion &motion, const Contact &contact, double room, double omega) {
  const ModalCoordinates &all = motion.mode->coordinates;
  const Index j = motion.mode->drift;
  const double row = contact.row(j), slope = motion.dy(j);
  const bool turns = omega > 0.0 && all.force_of(j) != 0.0;
  const double turning = turns ? std::abs(all.force_of(j)) : 0.0;
  const double constant = all.constant(j) + (turns ? 0.0 : all.force_re(j));
  const double push = std::abs(row) * (std::abs(constant) + turning);
  const double time =
      closing_time(std::max(0.0, -row * slope), push, !turns && row * constant >= 0.0, room);
  if (!turns || constant != 0.0) return time;
  const double left = room - 2.0 * push / (omega * omega);
  if (!(left > 0.0)) return time;
  const double mean_slope = slope - std::imag(all.force_of(j) * motion.turn) / omega;
  return row * mean_slope < 0.0 ? std::max(time, left / (-row * mean_slope)) : infinity;
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

}  // namespace

double quiet_time(const Motion &motion, const std::vector<StopState> &stops, double omega) {
  const ContactMode &mode = *motion.mode;
  const ModalCoordinates &all = mode.coordinates;
  // The amplitude of a coordinate about its steady response.
  const auto amplitude_of = [&](Index j) {
    const Complex steady = all.steady_of(j) * motion.turn;
    const double y = motion.y(j) - all.rest(j) - steady.real();
    if (!(all.frequency(j) > 0.0)) return std::abs(y);
    return std::hypot(y, (motion.dy(j) + omega * steady.imag()) / all.frequency(j));
  };
  double quiet = infinity;
  for (const Contact &contact : mode.contacts) {
    const StopState &stop = stops[contact.stop];
    if (!contact.held && rests_without_force(stop)) continue;
    double swing = 0.0, rest = contact.rest + (contact.held ? contact.offset : gap_of(stop));
    for (Index j = 0; j < static_cast<Index>(all.size); ++j) {
      if (j == mode.drift) continue;
      if (!contact.held) rest -= contact.row(j) * motion.y(j);
      swing += contact.modulus(j) * (1.0 + contact.damping * all.rate(j)) * amplitude_of(j);
    }
    if (omega == 0.0)
      rest += contact.steady.real();
    else
      swing += std::abs(contact.steady);
    const double room = rest - swing - 2.0 * gap_reread_ratio * (std::abs(rest) + swing);
    if (!(room > 0.0)) return 0.0;
    if (mode.drift < 0 || contact.held) continue;
    quiet = std::min(quiet, drift_time(motion, contact, room, omega));
  }
  return quiet;
}

void find_first_event(const Motion &motion, const std::vector<StopState> &stops, const Clock &clock,
                      bool forced, Flight &flight, Counters &counters) {
  const ContactMode &mode = *motion.mode;
  const Step &step = flight.step;
  expand(motion, step, clock.omega, forced, flight.table);
  bound_travel(motion, clock.omega, flight);
  // Two events are simultaneous when they are closer than the rounding of the time of the motion,
  // which is that of the flight after a much shorter flight, and than the rounding of both roots.
  const double rounding = same_instant / (step.rate * step.length);
  const auto simultaneous = [rounding](double u) {
    return std::min(rounding, same_instant * short_flight_ratio * u);
  };
  if (flight.approaches.size() < mode.contacts.size())
    flight.approaches.resize(mode.contacts.size());
  flight.any_near = flight.event = false;
  flight.u = 1.0;
  for (std::size_t k = 0; k < mode.contacts.size(); ++k) {
    const Contact &contact = mode.contacts[k];
    const StopState &stop = stops[contact.stop];
    Approach &approach = flight.approaches[k];
    approach.root.reset();
    approach.out_of_reach = is_postponed(stop);  // the end of the step is the event
    if (approach.out_of_reach) {
      flight.any_near = flight.event = true;
      continue;
    }
    const DecidedForce *decided = decided_force(stop);
    const double value = contact.held ? evaluate(contact, motion) : gap_of(stop);
    approach.out_of_reach =
        decided == nullptr && is_out_of_reach(contact, value, clock.omega, flight);
    if (approach.out_of_reach) {
      ++counters.out_of_reach;
      continue;
    }
    flight.any_near = true;
    Polynomial &p = approach.polynomial;
    read_along(flight.table, contact, p);
    counters.products += (step.order + 1) * mode.padded();
    // With more than one zero derivative the motion that moves this mass has yet to pass along the
    // chain, and the coefficients computed so far are rounding.
    if (flight_of(stop).below_rounding || (decided != nullptr && decided->zeros > 1))
      drop_rounding(motion, clock.omega, flight.table, contact, flight.moduli, p);
    insert_exact_coefficients(contact, stop, step.length, p);
    approach.root = first_root(p, std::min(1.0, flight.u + simultaneous(flight.u)), counters);
    if (!approach.root) continue;
    flight.event = true;
    flight.u = std::min(flight.u, approach.root->u);
  }
  drop_later_roots(motion, simultaneous(flight.u), flight);
}

void move_along(const Flight &flight, double u, const Clock &clock, Motion &motion,
                std::vector<StopState> &stops) {
  const ContactMode &mode = *motion.mode;
  const double length = flight.step.length;
  if (u > 0.0) {
    move_coordinates(flight.table, u, motion);
    pass_time(motion, clock, u * length);
    complete_move(motion, clock);
    let_dead_coordinates_follow(motion, clock.omega);
  }
  for (std::size_t k = 0; k < mode.contacts.size(); ++k) {
    const Contact &contact = mode.contacts[k];
    const Approach &approach = flight.approaches[k];
    StopState &stop = stops[contact.stop];
    if (is_postponed(stop)) continue;
    if (contact.held) {
      if (u > 0.0) stop.contact = AtRest{};  // a decided force is valid at its instant only
    } else if (u == flight.u && approach.root) {
      stop.contact = InFlight{0.0, approach.root->slope / length};
    } else if (u > 0.0 && approach.out_of_reach) {
      stop.contact = InFlight{std::max(0.0, evaluate(contact, motion)), gap_speed(contact, motion)};
    } else if (u > 0.0 && !rests_without_force(stop)) {
      const auto along_step = [&] {
        const Jet jet = jet_at(approach.polynomial, 0, u);
        return InFlight{jet.value, jet.slope / length};
      };
      set_gap(motion, contact, along_step, stop);
    }
  }
}

void fly_along(const Instant &target, const Clock &clock, Motion &motion,
               std::vector<StopState> &stops, PerCoordinate &change) {
  fly(motion, clock, target, change);
  for (const Contact &contact : motion.mode->contacts) {
    StopState &stop = stops[contact.stop];
    if (contact.held)
      stop.contact = AtRest{};
    else if (!rests_without_force(stop))
      set_gap(
          motion, contact,
          [&] {
            return InFlight{gap_of(stop) + dot(contact.row, change), gap_speed(contact, motion)};
          },
          stop);
  }
}

}  // namespace vibro_impact::detail
