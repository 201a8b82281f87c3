// The properties every run must have, whatever the scene.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

#include "event_rules.hpp"
#include "events.hpp"
#include "reference/generator/event_driven.hpp"
#include "samples_at_events.hpp"
#include "wide_scenes.hpp"
#include "witness.hpp"

namespace vibro_impact::testing {

// The first property of the run with all its impacts that a witness finds broken, or nothing.
//
// The state after every flight agrees in the energy norm, within a share of the motion and the
// rounding of the phase over long flights. A free chain may be far from where it started, and one
// at rest may be anywhere, with its links hardly stretched: positions are known to epsilon of their
// size. A force is rounded as the largest of those in the chain. Displacements are at least of the
// order of the unit of length. A speed that is lost counts from the rounding of the witness on.
inline std::string seen_by_a_witness(const Trial &trial, double share, Witness &witness) {
  const auto &[scene, until, units, completes] = trial;
  const Outcome outcome =
      simulate(scene, until, {.limit_below_speed = 0.0, .max_steps = 5000}, witness);
  // If a run is given up, all properties hold up to its last event.
  if (outcome.ending == Ending::reached) witness.close(outcome.state);
  constexpr double epsilon = std::numeric_limits<double>::epsilon();
  const double scale = std::max(units.length, witness.farthest()), rate = frequency_bound(scene);
  // The rounding of a gap that is too small to be evaluated again adds up over its impacts, at
  // random.
  const double impacts = std::sqrt(static_cast<double>(outcome.counters.impacts));
  const double displaced =
                   1e-12 * scale + (64.0 + impacts) * rounding_of_steady_response(scene, until),
               pulled = 2e-11 * (scale / units.length) * (rate * units.time) * units.force +
                        4.0 * rounding_of_forcing(scene),
               apart = (share + epsilon * std::max(rate, scene.omega) * until) * witness.size() +
                       8.0 * epsilon * witness.stretch();
  const struct {
    const char *what;
    double found, bound;
  } bounds[] = {
      {"state at the end of a flight off by", witness.apart(), apart},
      {"beyond a stop by", static_cast<double>(witness.deepest), displaced},
      {"gap at an impact or a stick", static_cast<double>(witness.off_the_stop), displaced},
      {"hold force of the wrong sign", static_cast<double>(witness.weakest), pulled},
      {"hold force at a release", static_cast<double>(witness.not_zero), pulled},
      {"speed lost at a stick", static_cast<double>(witness.lost), 1e-17 * witness.fastest()},
  };
  for (const auto &[what, found, bound] : bounds)
    if (!(found <= bound)) return fmt::format("{} {:.3g} > {:.3g}", what, found, bound);
  return "";
}

// Looks every 0.1 radians of the fastest mode, or some 1,500 times in a long run.
inline Witness witness_of(const Scene &scene, double until) {
  return Witness(scene, std::max(0.1, until * frequency_bound(scene) / 1500.0));
}

// Whether a run may end at the limit of steps, unless its scene says that it never does.
//
// This number of steps is possible only if impacts lose almost no energy, if a mass rattles in a
// small clearance or between neighbours that rattle too, or if the run is long against the motion:
// a chatter of some 60 impacts in each half period of the fastest mode.
inline bool may_be_given_up(const Trial &trial, long long most_steps) {
  const Scene &scene = trial.scene;
  double elastic = scene.restitution;
  for (const Stop &stop : scene.stops) elastic = std::max(elastic, law_of(scene, stop).at_rest());
  const double half_periods = frequency_bound(scene) * trial.until / std::numbers::pi;
  return elastic >= 0.97 || scene.stops.size() >= 2 ||
         !(60.0 * half_periods < static_cast<double>(most_steps));
}

// The same run over again, the same to the last bit: events, end, and how it ended.
inline std::string difference(const std::vector<Event> &events, const Outcome &outcome,
                              const std::vector<Event> &others, const Outcome &other) {
  if (others.size() != events.size())
    return fmt::format("{} events instead of {}", others.size(), events.size());
  for (std::size_t i = 0; i < events.size(); ++i)
    if (events[i] != others[i])
      return fmt::format("event {} of {} at {} differs", i, events.size(), events[i].time);
  if (other.ending != outcome.ending || other.reason != outcome.reason) return "another ending";
  if (other.state != outcome.state) return "another state at the end";
  return "";
}

// The verdict on one scene.
struct Verdict {
  std::string broken = {};  // empty when every property holds
  bool gave_up = false;     // the run ended at the limit of steps
};

// A run: its scene, its options, its events and its outcome.
struct Run {
  const Scene &scene;
  double until;
  RunOptions options;
  std::vector<Event> events;
  Outcome outcome;
};

// A run that is sampled on its way is the same.
inline std::string broken_by_samples(const Run &run, SampleRecorder &samples,
                                     SamplesAtEvents &at_events) {
  EventRecorder events;
  const Outcome outcome = simulate(run.scene, run.until, run.options, events, samples, at_events);
  const std::string differs = difference(run.events, run.outcome, events.events, outcome);
  return differs.empty() ? at_events.broken : "sampled: " + differs;
}

// The run taken up where another one stood at `split`: the events of the two, in sequence, are
// those of the whole, and so are the samples.
inline std::string broken_by_a_split(const Run &run, double split, const SampleRecorder &samples,
                                     const SamplesAtEvents &at_events) {
  EventRecorder events;
  SampleRecorder others(samples.from, samples.to, samples.every);
  SamplesAtEvents others_at_events(run.events);
  Simulation simulation(run.scene, run.options);
  if (simulation.advance(split, events, others, others_at_events).ending != Ending::reached)
    return "";
  const Outcome outcome = simulation.advance(run.until, events, others, others_at_events);
  const bool given_up = run.outcome.ending == Ending::given_up;
  // Each call has its own steps, so that two calls may go on for longer.
  if (given_up && events.events.size() > run.events.size()) events.events.resize(run.events.size());
  const std::string differs =
      difference(run.events, run.outcome, events.events, given_up ? run.outcome : outcome);
  if (!differs.empty()) return fmt::format("resumed at {}: {}", split, differs);
  if (given_up) return "";
  if (others.times != samples.times || others.displacements != samples.displacements ||
      others_at_events.velocities != at_events.velocities)
    return fmt::format("resumed at {}: other samples", split);
  return "";
}

// The run in many calls: its events are those of the whole, and none lies before its call.
inline std::string broken_by_many_calls(const Run &run) {
  if (run.outcome.ending == Ending::given_up) return "";
  constexpr int calls = 400;
  EventRecorder events;
  Simulation simulation(run.scene, run.options);
  Outcome outcome;
  double from = 0.0;
  for (int call = 1; call <= calls; ++call) {
    const std::size_t before = events.events.size();
    const double to = call < calls ? run.until * call / calls : run.until;
    outcome = simulation.advance(to, events);
    if (events.events.size() > before && events.events[before].time < from)
      return fmt::format("an event at {} in a call from {}", events.events[before].time, from);
    from = to;
  }
  const std::string differs = difference(run.events, run.outcome, events.events, outcome);
  return differs.empty() ? "" : fmt::format("in {} calls: {}", calls, differs);
}

inline std::string broken_by_a_mirror(const Run &run) {
  EventRecorder mirror;
  const Outcome outcome = simulate(mirrored(run.scene), run.until, run.options, mirror);
  for (Event &event : mirror.events) event = mirrored(event);
  Outcome back = outcome;
  for (auto *values : {&back.state.displacement, &back.state.velocity})
    for (double &value : *values) value = -value;
  for (signed char &held : back.state.held) held = static_cast<signed char>(-held);
  const std::string differs = difference(run.events, run.outcome, mirror.events, back);
  return differs.empty() ? "" : "mirror image: " + differs;
}

// The sticks and releases are those of the generator with 50 digits, to 1e-12 of the run: the times
// of the scenes that are asked this are determined by their inputs to some 1e-14.
inline std::string broken_by_digits(const Run &run) {
  namespace digits = vibro_impact_reference;
  std::vector<Event> ours = run.events;
  std::erase_if(ours, [](const Event &event) { return event.kind == EventKind::impact; });
  std::vector<digits::Event> exact =
      digits::simulate(digits::in_digits(run.scene, run.until), {.roots = {.newton = true}}).events;
  std::erase_if(exact, [](const auto &event) { return event.kind == EventKind::impact; });
  if (ours.size() != exact.size())
    return fmt::format("{} sticks and releases instead of {}", ours.size(), exact.size());
  for (std::size_t i = 0; i < ours.size(); ++i) {
    const double off = static_cast<double>(exact[i].time - ours[i].time);
    if (ours[i].mass != static_cast<int>(exact[i].mass) + 1 || ours[i].kind != exact[i].kind ||
        !(std::abs(off) <= 1e-12 * run.until))
      return fmt::format("{} at {} off by {:.3g}", name(ours[i].kind), ours[i].time, off);
  }
  return "";
}

// The kinetic and elastic energy, but for what roundings of 2^-53 of it, one a step, of either
// sign, add up to, eight times over. The motion of one mass repeats itself, and with it its
// roundings. The change of its speed alone has some six, each up to 2^-53 of it and twice as large
// in the energy: 3.7 a step were measured over 6,000 scenes, and lib/README.md says four. The
// motion of two masses may nearly repeat itself: 0.03 a step was measured, 0.07 are 1e-11 in 1.3e6
// steps.
inline std::string broken_by_energy(const Run &run) {
  const double before = energy_of(run.scene, start_of(run.scene)),
               gained = energy_of(run.scene, run.outcome.state) / before - 1.0,
               steps = static_cast<double>(run.outcome.counters.expansions);
  const double repeated = run.scene.masses() == 1 ? 4.0 : 0.07;  // a step
  const double allowed = 0x1p-53 * std::max(8.0 * std::sqrt(steps), repeated * steps);
  return std::abs(gained) <= allowed
             ? ""
             : fmt::format("gains {:.3g} of its energy in {} steps", gained, steps);
}

// A force that touches zero may by rounding release the mass for a moment, at most once a period:
// that is a release, an impact and a stick.
inline std::string broken_by_touches(const Run &run) {
  const double touches = run.until / Clock(run.scene.omega).period * run.scene.masses();
  return static_cast<double>(run.events.size()) <= run.scene.masses() + 3.0 * touches
             ? ""
             : fmt::format("{} events at {:.0f} touches", run.events.size(), touches);
}

// No mass is released at a touch.
inline std::string broken_by_a_touch(const Run &run) {
  const auto releases = select(run.events, EventKind::release).size();
  return releases == 0 ? "" : fmt::format("{} releases", releases);
}

// Each mass is free in the dip at the start, and is released in each of the nineteen that follow.
inline std::string broken_by_dips(const Run &run) {
  const auto releases = std::count_if(run.events.begin(), run.events.end(), [](const Event &event) {
    return event.kind == EventKind::release;
  });
  return releases == 19 * run.scene.masses() ? "" : fmt::format("{} releases", releases);
}

// Runs the scene, sampled and not, in two parts, mirrored, and before a witness. Where the parts
// meet follows from `seed`: any time, or that of an event. `share`: of the motion, that a flight
// may be off. `own` is a property of this kind of scenes alone.
inline Verdict try_scene(const Trial &trial, long long most_steps, double share, unsigned seed,
                         std::string (*own)(const Run &) = nullptr) {
  const Scene &scene = trial.scene;
  const double until = trial.until;
  RunOptions options;
  options.max_steps = most_steps;
  Verdict verdict;
  EventRules rules(scene);
  const Outcome outcome = simulate(scene, until, options, rules);
  const Run run{scene, until, options, rules.events, outcome};
  verdict.gave_up = outcome.ending == Ending::given_up;
  verdict.broken = rules.broken;
  const auto require_that = [&verdict](const auto &property) {
    if (verdict.broken.empty()) verdict.broken = property();
  };
  require_that([&] {
    return verdict.gave_up && (trial.completes || !may_be_given_up(trial, most_steps)) ? "gave up"
                                                                                       : "";
  });
  require_that([&] {
    return outcome.reason.find("an event was missed") != std::string::npos ? "missed an event" : "";
  });
  require_that([&] {
    for (const double x : outcome.state.displacement)
      if (!std::isfinite(x)) return "not finite";
    return "";
  });
  Draw draw{std::mt19937(seed + 1)};
  double split = draw.uniform(0.0, outcome.time);
  if (!run.events.empty() && draw.one_in(2))
    split = run.events[draw.generator() % run.events.size()].time;
  SampleRecorder samples{0.0, until, until / 701.3};
  SamplesAtEvents at_events(run.events);
  require_that([&] { return broken_by_samples(run, samples, at_events); });
  require_that([&] { return broken_by_a_split(run, split, samples, at_events); });
  require_that([&] { return broken_by_a_mirror(run); });
  require_that([&] { return own == nullptr ? "" : own(run); });
  Witness witness = witness_of(scene, until);
  require_that([&] { return seen_by_a_witness(trial, share, witness); });
  return verdict;
}

}  // namespace vibro_impact::testing
