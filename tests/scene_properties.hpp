// The properties every run must have, whatever the scene.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "energy_balance.hpp"
#include "random_scenes.hpp"
#include "vibro_impact/expansion.hpp"
#include "vibro_impact/vibro_impact.hpp"

namespace vibro_impact::testing {

// Deepest penetration and most negative pressing force over dense samples.
struct Watch {
  const Scene *scene;
  double until, every;
  std::size_t asked = 0;
  double penetration = 0.0, pull = 0.0, size = 0.0;
  bool finite = true;

  double next_time() const {
    return sample_time(0.0, until, every, asked);
  }
  void sample(const Moment &moment) {
    ++asked;
    for (int i = 1; i <= scene->masses(); ++i)
      size = std::max(size, std::abs(moment.displacement(i)));
    for (const Stop &stop : scene->stops) {
      const double x = moment.displacement(stop.mass), force = moment.hold_force(stop.mass);
      finite = finite && std::isfinite(x);
      penetration = std::max(penetration, sign(stop.side) * (x - stop.position));
      if (!std::isnan(force) && x == stop.position) pull = std::max(pull, -sign(stop.side) * force);
    }
  }
};

// What one event allows the next one to be: time never falls; only a free mass has impacts and
// sticks, so that every stick is followed by its release before the next impact of that mass; only
// a held mass is released, from the side it is held at; the contact mode told with the event is the
// one that follows from all events before; the impact law.
struct EventRules {
  const Scene &scene;
  Held held = Held(scene.mass.size(), 0);
  double last = 0.0;
  std::vector<Event> events = {};
  std::string broken = {};

  void event(const Event &event, const Moment &) {
    events.push_back(event);
    if (!broken.empty()) return;
    const double sigma = sign(event.side);
    signed char &how = held[static_cast<std::size_t>(event.mass - 1)];
    const char *fault = nullptr;
    if (!(event.time >= last)) fault = "time falls";
    if (event.kind == EventKind::impact) {
      if (how != 0) fault = "impact of a held mass";
      if (!(sigma * event.velocity_before >= 0.0)) fault = "impact while leaving";
      if (event.velocity_after != -scene.restitution * event.velocity_before) fault = "impact law";
    } else if (event.kind == EventKind::stick) {
      if (how != 0) fault = "stick of a held mass";
      how = static_cast<signed char>(event.side);
    } else {
      if (how != static_cast<signed char>(event.side)) fault = "release of a mass not held there";
      how = 0;
    }
    if (event.held != held) fault = "contact mode";
    last = event.time;
    if (fault != nullptr)
      broken = fmt::format("{}: {} of mass {} at {}", fault, name(event.kind), event.mass, last);
  }
};

// The work of a run is bounded by its events and by the time it takes the fastest mode:
// - an expansion ends at an event or spans max_reach radians of the fastest lane, which is no
//   faster than the chain's fastest mode with all masses free (its eigenvalues interlace those of
//   every contact mode) or the forcing;
// - an impact may cost a span cut at the guessed flight, and one to follow its chatter, in which
//   two flights may be looked ahead, each at most twice;
// - a mass comes to rest by an impact, or starts at rest; and once a span without one, where a
//   scene has died down to rounding on a stop that no static force presses it to. Two per stop of
//   slack are for starts at rest where rounding holds and frees a mass once more.
// Every stop is looked at once an expansion or flight of a chatter. A root search takes below 25
// steps on average in any scene seen; 64 would be a search that creeps. A crossing sought on the
// lanes takes 4 at most. Empty, or what is exceeded.
inline std::string excessive_work(const Scene &scene, double until, const Counters &work) {
  const double w = frequency_bound(scene), stops = static_cast<double>(scene.stops.size());
  const double rate = std::max(scene.omega, root_modulus(scene.beta * w * w, w * w));
  const auto impacts = static_cast<double>(work.impacts);
  const auto changes = static_cast<double>(work.sticks + work.releases);
  const double spans = rate * until / max_reach;
  const double expansions = 4.0 * impacts + changes + spans + 2.0 * stops + 2.0;
  const auto over = [](const char *what, double count, double bound) {
    return count > bound ? fmt::format("{} {}, at most {:.6g} expected", count, what, bound) : "";
  };
  const auto expanded = static_cast<double>(work.expansions);
  const auto searched = static_cast<double>(work.roots_searched);
  const auto sought = static_cast<double>(work.crossings_sought);
  const auto dismissed = static_cast<double>(work.roots_dismissed);
  std::string text = over("expansions", expanded, expansions);
  const auto followed = static_cast<double>(work.flights_followed);
  if (text.empty()) text = over("flights followed", followed, 4.0 * impacts);
  if (text.empty())
    text = over("roots looked for", searched + dismissed, stops * (expanded + followed));
  if (text.empty())
    text = over("root iterations", static_cast<double>(work.root_iterations),
                64.0 * searched + 4.0 * sought);
  if (text.empty())
    text = over("sticks", static_cast<double>(work.sticks), impacts + 2.0 * stops + spans);
  if (text.empty())
    text = over("releases", static_cast<double>(work.releases), static_cast<double>(work.sticks));
  return text;
}

// The imbalance of energy relative to the energy that took part, and how much is rounding.
//
// 1e-11: seen are 7e-13 in 2,000 ordinary scenes, from a few thousand events of rounding each, and
// all 20,000 keep it. The frequencies of a chain with soft and stiff links are known to epsilon
// times the *largest* stiffness only, so the forces of its soft links, and the energy, to that
// share; twice that is allowed, and one of 20,000 extreme scenes needs more than half of it.
struct Balance {
  double imbalance = 0.0, tolerance = 0.0;
  double noticed = 0.0;  // imbalance that r + 1e-6 in the losses would make
  bool known = false;    // the account itself is exact to 1e-10
};

inline Balance energy_balance(const Scene &scene, double until, double assumed_restitution) {
  RunOptions options;
  options.resolve_chatter = 0.0;  // all impacts, down to where the rest lies below rounding
  options.max_impacts_per_period = 1000;
  EnergyAudit audit{scene, assumed_restitution};
  try {
    audit.close(simulate(scene, until, options, audit).state);
  } catch (const std::runtime_error &) {
    // The balance holds up to the last event before the run was given up.
  }
  const auto [softest, stiffest] =
      std::minmax_element(scene.stiffness.begin(), scene.stiffness.end());
  const double ratio = *stiffest / *softest;
  return {static_cast<double>(std::abs(audit.imbalance()) / audit.scale()),
          1e-11 + 2.0 * std::numeric_limits<double>::epsilon() * ratio,
          static_cast<double>(2e-6L * scene.restitution * audit.in_impacts / audit.scale()),
          audit.scale() > 0 && audit.account.rounding < 1e-10L * audit.scale()};
}

// Displacements are known to epsilon times the steady response, whose static bound this is: all
// forces on a chain of all the links' compliances. Next to a resonance the response may be 32 times
// as large before the library no longer splits it off.
inline double rounding_of_steady_response(const Scene &scene) {
  double force = 0.0, compliance = 0.0;
  for (const double a : scene.amplitude) force += std::abs(a);
  for (const double k : scene.stiffness) compliance += 1.0 / k;
  return std::numeric_limits<double>::epsilon() * force * compliance;
}

// What trying one scene showed.
struct Verdict {
  std::string broken = {};  // empty when every property holds
  bool gave_up = false;     // the run ended at the limit of impacts
  bool balanced = false;    // its energy was accounted for
};

// Runs the scene, sampled and not, mirrored, in other units, and with its energy accounted for.
inline Verdict try_scene(const Scene &scene, double until, long long most_impacts) {
  RunOptions options;
  options.max_impacts_per_period = most_impacts;
  Verdict verdict;
  EventRules sampled{scene}, rules{scene};
  Watch watch{&scene, until, until / 701.3};
  Outcome outcome;
  try {
    outcome = simulate(scene, until, options, sampled, watch);
  } catch (const std::runtime_error &) {
    verdict.gave_up = true;
    // So many impacts are possible only where almost no energy is lost in them, where a mass
    // rattles in a small clearance or between neighbours that rattle too, or where a forcing period
    // is long against the motion: a chatter of some 60 impacts in each half period of the fastest
    // mode.
    const double chatters = 2.0 * frequency_bound(scene) / scene.omega;
    if (scene.restitution < 0.97 && scene.stops.size() < 2 &&
        60.0 * chatters < static_cast<double>(most_impacts))
      verdict.broken = "gave up";
  }
  const double scale = std::max(1.0, watch.size);
  if (!sampled.broken.empty()) verdict.broken = sampled.broken;
  if (!watch.finite) verdict.broken = "not finite";
  if (watch.penetration > 1e-12 * scale + 64.0 * rounding_of_steady_response(scene))
    verdict.broken = fmt::format("penetration {:.3g}", watch.penetration);
  if (watch.pull > 1e-11 * scale * frequency_bound(scene))
    verdict.broken = fmt::format("hold force pulls {:.3g}", watch.pull);
  if (verdict.broken.empty()) {
    const Balance balance = energy_balance(scene, until, scene.restitution);
    verdict.balanced = balance.known;
    if (balance.known && !(balance.imbalance <= balance.tolerance))
      verdict.broken =
          fmt::format("energy balance {:.3g} > {:.3g}", balance.imbalance, balance.tolerance);
  }
  if (!verdict.broken.empty() || verdict.gave_up) return verdict;
  if (!outcome.state.displacement.allFinite()) verdict.broken = "not finite";

  // Samples make a run resolve a chatter up to the sample, so the three runs compared take none.
  EventRecorder mirror, scaled;
  try {
    outcome = simulate(scene, until, options, rules);
    simulate(mirrored(scene), until, options, mirror);
    simulate(rescaled(scene, 0x1p-7, 0x1p6), until, options, scaled);
  } catch (const std::runtime_error &error) {
    verdict.broken = std::string("only without samples: ") + error.what();
    return verdict;
  }
  verdict.broken =
      rules.broken.empty() ? excessive_work(scene, until, outcome.counters) : rules.broken;
  // A squared speed underflows below 1e-154, and other units then round otherwise: events are
  // compared up to the first that slow.
  const auto before_tiny = [](const std::vector<Event> &events, double unit) {
    const auto tiny = [unit](double v) { return v != 0.0 && std::abs(v) < 1e-140 * unit; };
    const auto first = std::find_if(events.begin(), events.end(), [&](const Event &event) {
      return tiny(event.velocity_before) || tiny(event.velocity_after);
    });
    return static_cast<std::size_t>(first - events.begin());
  };
  const std::size_t compared = before_tiny(rules.events, 1.0);
  if (mirror.events.size() != rules.events.size()) verdict.broken = "mirror image: other events";
  if (before_tiny(scaled.events, 0x1p-7) != compared)
    verdict.broken = "rescaled units: other events";
  for (std::size_t i = 0; verdict.broken.empty() && i < compared; ++i) {
    const Event &e = rules.events[i], &m = mirror.events[i], &s = scaled.events[i];
    if (m.time != e.time || m.mass != e.mass || m.kind != e.kind ||
        m.velocity_before != -e.velocity_before)
      verdict.broken =
          fmt::format("mirror image differs at event {} of {}", i, rules.events.size());
    if (s.time != e.time || s.mass != e.mass || s.kind != e.kind ||
        s.velocity_before != 0x1p-7 * e.velocity_before)
      verdict.broken =
          fmt::format("rescaled units differ at event {} of {}", i, rules.events.size());
  }
  return verdict;
}

}  // namespace vibro_impact::testing
