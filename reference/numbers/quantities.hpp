// The quantities of the paper's key numbers that are read off runs. Each is defined once and asked
// of two engines: the library, in double precision, and the generator, in 50 digits. For key
// numbers with a formula (kind `formula`), the generator has the formula.
//
// The engines share these questions, the scenes and the kinds of events. They share no algorithm
// and no number type. An engine has these members, where a run starts from the initial state of its
// scene and masses are counted from 1:
//
//   Number                                        the type of its numbers
//   events(run)                                   all events, in the order of time
//   period(scene)                                 the forcing period
//   range(run, mass, window)                      lowest and highest displacement in a window
//   turning_point(run, mass, window)              where the displacement is greatest in between
//   least_pressing(run, stop)                     the least force that presses into the stop, in
//                                                 a sticking phase at the end
//   changing_frequency(scene, mass, near, far, motion)
//                                                 Omega at which the number of sticking phases of
//                                                 the mass changes
//   grazing_frequency(scene, mass, near, far)     Omega at which the mass begins to hit its stop
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

#include "checked_number.hpp"
#include "panels.hpp"
#include "reference/scenes/paper_scenes.hpp"
#include "reference/truth/case.hpp"
#include "vibro_impact/event.hpp"

namespace vibro_impact::numbers {

template <class Number>
struct TimedEvent {
  Number time;
  EventKind kind;
  int mass;
  std::string contact_mode;  // after the event: the masses that stick, as 1+2
};

template <class Number>
struct Interval {
  Number from, to;
};

template <class Number>
struct TurningPoint {
  Number time, displacement;
};

// How the motion changes at a frequency. On the side of `near`, from 2 near - far up to the change,
// every chatter in question is complete, so that the motion is smooth in the frequency.
//   settled    the motion from rest changes where the settled motion ends
//   from_rest  the motion from rest jumps to another one, and both are stable on both sides
//   followed   the motion that settles at `near` ends; from rest another one is reached before
enum class Change : std::size_t { settled, from_rest, followed };
constexpr const char *change_words[] = {"settled", "from_rest", "followed"};

// Throws std::runtime_error for any other word.
inline Change change_in(const Arguments &arguments) {
  if (!arguments.contains("motion")) return Change::settled;
  return Change{truth::word_in("motion", arguments.text("motion"), change_words)};
}

// The run of a scene of the paper (`scene`), with another Omega (`omega`), coefficient of
// restitution (`r`) or end (`until`) where these are given.
inline paper::NamedScene run_of(const Arguments &arguments) {
  paper::NamedScene run = paper::scene_named(arguments.text("scene"));
  run.scene.omega = arguments.at("omega", run.scene.omega);
  run.scene.restitution = arguments.at("r", run.scene.restitution);
  run.until = arguments.at("until", run.until);
  return run;
}

// The stop of a mass. Throws std::runtime_error if it has none.
inline std::size_t stop_of(const Scene &scene, int mass) {
  for (std::size_t i = 0; i < scene.stops.size(); ++i)
    if (scene.stops[i].mass == mass) return i;
  throw std::runtime_error(fmt::format("mass {}: has no stop", mass));
}

// --- Events --------------------------------------------------------------------------------------

template <class Number>
using TimedEvents = std::vector<TimedEvent<Number>>;

// The first event of a kind and a mass in an interval. Throws std::runtime_error if there is none.
template <class Number>
Number first_time(const TimedEvents<Number> &events, EventKind kind, int mass,
                  const Interval<Number> &interval) {
  for (const auto &event : events)
    if (event.kind == kind && event.mass == mass && event.time >= interval.from &&
        event.time <= interval.to)
      return event.time;
  throw std::runtime_error("the run has no such event");
}

constexpr const char *run_names = "scene omega r until";
constexpr const char *event_names =
    "scene omega r until kind mass contact_mode panel from to periods while_sticking release_of "
    "before";

// [from, to] of the arguments, by default the window of a panel of the paper, or the whole run.
inline Interval<double> window_of(const paper::NamedScene &run, const Arguments &given) {
  Interval<double> window{0.0, run.until};
  if (given.contains("panel")) {
    const paper::AxisBox box = paper::panel(given.text("panel"));
    window = {box.from, box.to};
  }
  return {given.at("from", window.from), given.at("to", window.to)};
}

// The interval that a question about events is about: the window, narrowed to the last `periods`
// forcing periods, to the first sticking phase of the mass `while_sticking`, or to the time
// `before` the first release of the mass `release_of`.
template <class Engine>
Interval<typename Engine::Number> interval_of(Engine &engine, const paper::NamedScene &run,
                                              const TimedEvents<typename Engine::Number> &events,
                                              const Arguments &given) {
  using Number = typename Engine::Number;
  const Interval<double> window = window_of(run, given);
  Interval<Number> interval{Number(window.from), Number(window.to)};
  if (given.contains("periods"))
    interval.from = interval.to - Number(given.at("periods")) * engine.period(run.scene);
  if (const int mass = given.mass("while_sticking")) {
    interval.from = first_time(events, EventKind::stick, mass, interval);
    interval.to = first_time(events, EventKind::release, mass, interval);
  }
  if (const int mass = given.mass("release_of")) {
    interval.to = first_time(events, EventKind::release, mass, interval);
    interval.from = interval.to - Number(given.at("before"));
  }
  return interval;
}

// The events of a run that a question is about: of a kind, of one mass if one is given, with one
// contact mode after them if one is given, in an interval.
template <class Engine>
TimedEvents<typename Engine::Number> asked_events(Engine &engine, const Arguments &given) {
  const paper::NamedScene run = run_of(given);
  auto events = engine.events(run);
  const Interval<typename Engine::Number> asked = interval_of(engine, run, events, given);
  const EventKind kind = truth::kind_in("kind", given.text("kind"));
  const int mass = given.mass("mass");
  const std::string mode = given.contains("contact_mode") ? given.text("contact_mode") : "";
  std::erase_if(events, [&](const auto &event) {
    return event.kind != kind || (mass != 0 && event.mass != mass) || event.time < asked.from ||
           event.time > asked.to || (!mode.empty() && event.contact_mode != mode);
  });
  return events;
}

// The range, or the turning point, of a mass in the window of the arguments.
template <class Engine>
auto asked_range(Engine &engine, const Arguments &given) {
  const paper::NamedScene run = run_of(given);
  return engine.range(run, given.mass("mass"), window_of(run, given));
}
template <class Engine>
auto asked_turn(Engine &engine, const Arguments &given) {
  const paper::NamedScene run = run_of(given);
  return engine.turning_point(run, given.mass("mass"), window_of(run, given));
}

// --- The quantities ------------------------------------------------------------------------------

// A quantity: the names of its arguments, which blanks separate, and the answer of an engine.
template <class Engine>
struct Quantity {
  std::string names;
  std::function<typename Engine::Number(Engine &, const Arguments &)> answer;
};

template <class Engine>
using Quantities = std::map<std::string, Quantity<Engine>>;

// The quantities that both engines answer.
template <class Engine>
Quantities<Engine> common_quantities() {
  using Number = typename Engine::Number;
  using Given = const Arguments &;
  const std::string mass_names = std::string(run_names) + " mass",
                    window_names = mass_names + " panel from to",
                    near_far_names = mass_names + " near far";
  return {
      // How many events there are. A complete chatter has infinitely many impacts, of which each
      // engine reports another number: an interval may not hold one where impacts are counted.
      {"count",
       {event_names,
        [](Engine &engine, Given given) {
          return Number(static_cast<double>(asked_events(engine, given).size()));
        }}},
      // The time of the first event.
      {"time",
       {event_names,
        [](Engine &engine, Given given) {
          const auto events = asked_events(engine, given);
          if (events.empty()) throw std::runtime_error("the run has no such event");
          return events.front().time;
        }}},
      // The mean time from one event to the next.
      {"interval",
       {event_names,
        [](Engine &engine, Given given) {
          const auto events = asked_events(engine, given);
          if (events.size() < 2) throw std::runtime_error("the run has fewer than two such events");
          return (events.back().time - events.front().time) /
                 static_cast<double>(events.size() - 1);
        }}},
      {"lowest",
       {window_names,
        [](Engine &engine, Given given) { return asked_range(engine, given).lowest; }}},
      {"highest",
       {window_names,
        [](Engine &engine, Given given) { return asked_range(engine, given).highest; }}},
      {"turning_time",
       {window_names, [](Engine &engine, Given given) { return asked_turn(engine, given).time; }}},
      // The distance from the turning point to the stop of the mass.
      {"turning_gap",
       {window_names,
        [](Engine &engine, Given given) {
          const Scene scene = run_of(given).scene;
          const double stop = scene.stops[stop_of(scene, given.mass("mass"))].position;
          return Number(stop) - asked_turn(engine, given).displacement;
        }}},
      // The hold force on a mass where that force is nearest to zero inside a sticking phase.
      {"hold_force_peak",
       {mass_names,
        [](Engine &engine, Given given) {
          const paper::NamedScene run = run_of(given);
          const std::size_t stop = stop_of(run.scene, given.mass("mass"));
          return sign(run.scene.stops[stop].side) * engine.least_pressing(run, stop);
        }}},
      {"changing_frequency",
       {near_far_names + " motion",
        [](Engine &engine, Given given) {
          return engine.changing_frequency(run_of(given).scene, given.mass("mass"),
                                           given.at("near"), given.at("far"), change_in(given));
        }}},
      {"grazing_frequency", {near_far_names, [](Engine &engine, Given given) {
                               return engine.grazing_frequency(run_of(given).scene,
                                                               given.mass("mass"), given.at("near"),
                                                               given.at("far"));
                             }}}};
}

// The answer of an engine to a row of the table. Throws std::runtime_error naming a row of which it
// cannot be computed.
template <class Engine>
typename Engine::Number answer(Engine &engine, const Quantities<Engine> &quantities,
                               const CheckedNumber &number) try {
  const auto found = quantities.find(number.quantity);
  if (found == quantities.end())
    throw std::runtime_error("quantity '" + number.quantity + "': is unknown");
  require_only(number.arguments, found->second.names);
  return found->second.answer(engine, number.arguments);
} catch (const std::exception &error) {
  throw std::runtime_error(
      fmt::format("{}, {} {}: {}", number.id, number.quantity, number.given, error.what()));
}

}  // namespace vibro_impact::numbers
