// The engine of 50 digits: it answers the questions of reference/numbers/quantities.hpp.
#pragma once

#include "event_driven.hpp"
#include "event_table.hpp"
#include "frequencies.hpp"
#include "in_digits.hpp"
#include "reference/numbers/quantities.hpp"
#include "turning_points.hpp"

#include <cstddef>
#include <map>
#include <string>
#include <vector>

namespace vibro_impact_reference {

namespace numbers = vibro_impact::numbers;
using vibro_impact::paper::NamedScene;

/// How far, and how exactly, a chatter is followed for a key number.
inline Resolution key_number_resolution() {
  return {Real("1e-20"), {Real("1e-36"), true}};
}

/// By Event::Kind.
constexpr vibro_impact::EventKind event_kinds[] = {vibro_impact::EventKind::impact,
                                                   vibro_impact::EventKind::stick,
                                                   vibro_impact::EventKind::release};

/// It simulates every run once and keeps it.
class DigitsEngine {
 public:
  using Number = Real;

  std::vector<numbers::Occurrence<Real>> events(const NamedScene &asked) {
    std::vector<numbers::Occurrence<Real>> events;
    const Scene scene = in_digits(asked.scene, asked.until);
    for (const Event &event : run(asked).events) {
      const bool ends_a_chatter = event.kind == Event::Kind::stick && event.pressing > 0;
      events.push_back({ends_a_chatter ? completion(scene, event) : event.time,
                        event_kinds[static_cast<int>(event.kind)], static_cast<int>(event.mass) + 1,
                        contact_mode(event.stuck)});
    }
    return events;
  }

  Real period(const vibro_impact::Scene &scene) {
    return 2 * acos(Real(-1)) / Real(scene.omega);
  }

  Real lowest(const NamedScene &asked, int mass, double from, double to) {
    return extremes(run(asked), Real(from), Real(to)).lowest[index(mass)];
  }

  Real highest(const NamedScene &asked, int mass, double from, double to) {
    return extremes(run(asked), Real(from), Real(to)).highest[index(mass)];
  }

  numbers::TurningPoint<Real> turning_point(const NamedScene &asked, int mass, double from,
                                            double to) {
    const Extremes found = extremes(run(asked), Real(from), Real(to));
    return {found.highest_at[index(mass)], found.highest[index(mass)]};
  }

  /// In the last two forcing periods.
  Real least_pressing(const NamedScene &asked, std::size_t stop) {
    return vibro_impact_reference::least_pressing(in_digits(asked.scene, asked.until), run(asked),
                                                  stop,
                                                  Real(asked.until) - 2 * period(asked.scene));
  }

  /// The settled motion and the one followed from `near` are found in the same way.
  Real changing_frequency(const vibro_impact::Scene &scene, int mass, double near, double far,
                          numbers::Motion motion) {
    const Scene digits = in_digits(scene, 0.0);
    const Bracket bracket{Real(near), Real(far)};
    const Count sticks = sticks_of(index(mass));
    return motion == numbers::Motion::from_rest
               ? jumping_frequency(digits, bracket, settling_of_a_jump, sticks)
               : vibro_impact_reference::changing_frequency(digits, bracket, sticks);
  }

  /// Where the greatest displacement of the mass, its stop taken away, reaches that stop.
  Real grazing_frequency(vibro_impact::Scene scene, int mass, double near, double far) {
    const auto stop = scene.stops.begin() +
                      static_cast<std::ptrdiff_t>(vibro_impact::numbers::stop_of(scene, mass));
    const Real place = Real(stop->position);
    scene.stops.erase(stop);
    const Count reaches = [&](const Run &run) -> std::size_t {
      return extremes(run, Real(0), Real("1e9")).highest[index(mass)] >= place ? 1 : 0;
    };
    return vibro_impact_reference::changing_frequency(in_digits(scene, 0.0),
                                                      {Real(near), Real(far)}, reaches);
  }

 private:
  static std::size_t index(int mass) {
    return static_cast<std::size_t>(mass - 1);
  }

  const Run &run(const NamedScene &asked) {
    const auto known = runs_.find(asked.name);
    if (known != runs_.end()) return known->second;
    return runs_[asked.name] =
               simulate(in_digits(asked.scene, asked.until), key_number_resolution());
  }

  std::map<std::string, Run> runs_;
};

}  // namespace vibro_impact_reference
