// The first event along one expansion: impacts, and hold forces that come to zero, of one mass or
// of several at the same instant.
#pragma once

#include <algorithm>
#include <vector>

#include "clearance.hpp"
#include "expansion.hpp"

namespace vibro_impact {

// One flight, its storage reused: no allocation between events.
template <int D>
struct Flight {
  // What is known of a contact along the flight.
  struct Watch {
    bool clear = false;        // certain to stay positive: not looked at
    Polynomial polynomial;     // else
    std::optional<Root> root;  // its first one on the path, where the flight ends
  };
  Expansion path;
  std::vector<Watch> watched;         // by contact of the mode
  Eigen::Array<double, D, 1> speeds;  // bounds of those of the lanes
  double u = 1.0;                     // of the first event, or the end of the path
  bool eventful = false;
  bool all_clear = false;  // no contact was near
};

// Finds the first event in (0, 1] of the flight's path, along which `state` moves.
template <int D>
void find_first_event(const State<D> &state, double scene_rate, Flight<D> &flight,
                      Counters &counters) {
  const ContactMode<D> &mode = *state.mode;
  const Expansion &path = flight.path;
  bound_speeds(state, path.span, flight.speeds);
  const double together = same_instant / (path.rate * path.span);
  if (flight.watched.size() < mode.contacts.size()) flight.watched.resize(mode.contacts.size());
  flight.all_clear = true;
  flight.eventful = false;
  flight.u = 1.0;
  for (std::size_t k = 0; k < mode.contacts.size(); ++k) {
    const Contact<D> &contact = mode.contacts[k];
    const AtStop &stop = state.stops[contact.stop];
    auto &watch = flight.watched[k];
    watch.root.reset();
    const double now = contact.held ? watched_now(state, contact) : stop.gap;
    watch.clear =
        !stop.decided && stays_clear(state, contact, now, flight.speeds, path.span, 2.0 * wide);
    if (watch.clear) {
      ++counters.stops_clear;
      continue;
    }
    flight.all_clear = false;
    read_along(state, contact, path, scene_rate, watch.polynomial, counters);
    watch.root = first_root(watch.polynomial, std::min(1.0, flight.u + together), counters);
    if (!watch.root) continue;
    flight.eventful = true;
    flight.u = std::min(flight.u, watch.root->at);
  }
  for (std::size_t k = 0; k < mode.contacts.size(); ++k) {  // at the same instant, or later
    std::optional<Root> &root = flight.watched[k].root;
    if (root && root->at > flight.u + together) root.reset();
  }
}

// Moves the state to u of the path: lanes, time, and what is carried of the stops.
template <int D>
void move_along(State<D> &state, Flight<D> &flight, double u, const Scene &scene,
                const Clock &clock) {
  const ContactMode<D> &mode = *state.mode;
  const Expansion &path = flight.path;
  if (u > 0.0) {
    move_lanes(state, scene, clock, path, u * path.span);
    drop_dead_lanes(state);
  }
  for (std::size_t k = 0; k < mode.contacts.size(); ++k) {
    const Contact<D> &contact = mode.contacts[k];
    const auto &watch = flight.watched[k];
    AtStop &stop = state.stops[contact.stop];
    if (contact.held) {
      if (u > 0.0) set_in_flight(stop);  // what is known of its force is known at one instant
      continue;
    }
    if (u == flight.u && watch.root) {
      set_in_flight(stop, 0.0, watch.root->slope / path.span);
      continue;
    }
    if (u == 0.0) continue;
    // A wide gap is read off the lanes, so that the carried one cannot drift away from them; and so
    // is a narrower one that has: a mass that seldom hits beside one that does so 20,000 times.
    const double size = watch.clear ? 0.0 : size_of(state, contact),
                 read = watch.clear ? 0.0 : watched_now(state, contact);
    bool off_the_lanes = watch.clear || read > wide * size;
    Jet carried{};
    if (!off_the_lanes) {
      carried = jet_at(watch.polynomial, 0, u);
      if (stop.decided && carried.value == 0.0 && carried.slope == 0.0)
        continue;  // at rest still, as far as can be told
      off_the_lanes = read > wide * wide * size && std::abs(carried.value - read) > drifted * size;
    }
    if (off_the_lanes) {
      read_gap(state, contact);
      continue;
    }
    set_in_flight(stop, std::max(0.0, carried.value), carried.slope / path.span);
    stop.below_rounding = stop.gap < rounding * size;
  }
}

}  // namespace vibro_impact
