#include "digits_engine.hpp"

#include "event_table.hpp"
#include "frequencies.hpp"

#include <algorithm>

namespace vibro_impact_reference {

namespace {

std::size_t index(int mass) {
  return static_cast<std::size_t>(mass - 1);
}

}  // namespace

const Run &DigitsEngine::run(const NamedScene &asked) {
  for (const auto &[known, run] : runs_)
    if (known.scene == asked.scene && known.until == asked.until) return run;
  const Scene scene = in_digits(asked.scene, asked.until);
  runs_.emplace_back(asked, simulate(scene, resolution_down_to(Real("1e-20"))));
  return runs_.back().second;
}

std::vector<numbers::Occurrence<Real>> DigitsEngine::events(const NamedScene &asked) {
  std::vector<numbers::Occurrence<Real>> events;
  for (const Event &event : run(asked).events)
    events.push_back({event.time + event.left_out, event.kind, static_cast<int>(event.mass) + 1,
                      contact_mode(event.stuck)});
  return events;
}

Real DigitsEngine::period(const vibro_impact::Scene &scene) {
  return 2 * acos(Real(-1)) / Real(scene.omega);
}

Extremes DigitsEngine::range(const NamedScene &asked, int mass,
                             const numbers::Interval<double> &window) {
  return extremes(run(asked), index(mass), Real(window.from), Real(window.to));
}

numbers::TurningPoint<Real> DigitsEngine::turning_point(const NamedScene &asked, int mass,
                                                        const numbers::Interval<double> &window) {
  const Extremes found = range(asked, mass, window);
  return {found.highest_at, found.highest};
}

Real DigitsEngine::least_pressing(const NamedScene &asked, std::size_t stop) {
  return vibro_impact_reference::least_pressing(in_digits(asked.scene, asked.until), run(asked),
                                                stop, Real(asked.until) - 2 * period(asked.scene));
}

Real DigitsEngine::changing_frequency(const vibro_impact::Scene &scene, int mass, double near,
                                      double far, numbers::Motion motion) {
  const auto frequency_of = motion == numbers::Motion::from_rest
                                ? jumping_frequency
                                : vibro_impact_reference::changing_frequency;
  const Count sticks = [mass](const Run &run) {
    return std::count_if(run.events.begin(), run.events.end(), [mass](const Event &event) {
      return event.kind == EventKind::stick && event.mass == index(mass);
    });
  };
  return frequency_of(in_digits(scene, 0.0), Real(near), Real(far), sticks);
}

Real DigitsEngine::grazing_frequency(vibro_impact::Scene scene, int mass, double near, double far) {
  const auto stop = scene.stops.begin() +
                    static_cast<std::ptrdiff_t>(vibro_impact::numbers::stop_of(scene, mass));
  const Real place = Real(stop->position);
  scene.stops.erase(stop);
  const Count reaches = [&](const Run &run) {
    return extremes(run, index(mass), Real(0), Real("1e9")).highest >= place;
  };
  return vibro_impact_reference::changing_frequency(in_digits(scene, 0.0), Real(near), Real(far),
                                                    reaches);
}

const numbers::Quantities<DigitsEngine> &quantities_in_digits() {
  static const auto quantities = numbers::common_quantities<DigitsEngine>();
  return quantities;
}

}  // namespace vibro_impact_reference
