#include "digits_engine.hpp"

#include "event_table.hpp"
#include "frequencies.hpp"
#include "turning_points.hpp"

#include <stdexcept>

namespace vibro_impact_reference {

namespace {

/// How far, and how exactly, a chatter is followed for a key number.
Resolution key_number_resolution() {
  return {Real("1e-20"), {Real("1e-36"), true}};
}

std::size_t index(int mass) {
  return static_cast<std::size_t>(mass - 1);
}

}  // namespace

const Run &DigitsEngine::run(const NamedScene &asked) {
  for (const auto &[scene, until, known] : runs_)
    if (scene == asked.scene && until == asked.until) return known;
  const Scene scene = in_digits(asked.scene, asked.until);
  runs_.push_back({asked.scene, asked.until, simulate(scene, key_number_resolution())});
  return runs_.back().run;
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

Real DigitsEngine::lowest(const NamedScene &asked, int mass, double from, double to) {
  return extremes(run(asked), Real(from), Real(to)).lowest[index(mass)];
}

Real DigitsEngine::highest(const NamedScene &asked, int mass, double from, double to) {
  return extremes(run(asked), Real(from), Real(to)).highest[index(mass)];
}

numbers::TurningPoint<Real> DigitsEngine::turning_point(const NamedScene &asked, int mass,
                                                        double from, double to) {
  const Extremes found = extremes(run(asked), Real(from), Real(to));
  return {found.highest_at[index(mass)], found.highest[index(mass)]};
}

Real DigitsEngine::least_pressing(const NamedScene &asked, std::size_t stop) {
  return vibro_impact_reference::least_pressing(in_digits(asked.scene, asked.until), run(asked),
                                                stop, Real(asked.until) - 2 * period(asked.scene));
}

Real DigitsEngine::changing_frequency(const vibro_impact::Scene &scene, int mass, double near,
                                      double far, numbers::Motion motion) {
  const Scene digits = in_digits(scene, 0.0);
  const Bracket bracket{Real(near), Real(far)};
  const Count sticks = sticks_of(index(mass));
  switch (motion) {
    case numbers::Motion::from_rest:
      return jumping_frequency(digits, bracket, settling_of_a_jump, sticks);
    case numbers::Motion::settled:
    case numbers::Motion::followed:
      return vibro_impact_reference::changing_frequency(digits, bracket, sticks);
  }
  throw std::logic_error("motion: its kind is unknown");
}

Real DigitsEngine::grazing_frequency(vibro_impact::Scene scene, int mass, double near, double far) {
  const auto stop = scene.stops.begin() +
                    static_cast<std::ptrdiff_t>(vibro_impact::numbers::stop_of(scene, mass));
  const Real place = Real(stop->position);
  scene.stops.erase(stop);
  const Count reaches = [&](const Run &run) -> std::size_t {
    return extremes(run, Real(0), Real("1e9")).highest[index(mass)] >= place ? 1 : 0;
  };
  return vibro_impact_reference::changing_frequency(in_digits(scene, 0.0), {Real(near), Real(far)},
                                                    reaches);
}

const numbers::Quantities<DigitsEngine> &quantities_in_digits() {
  static const auto quantities = numbers::common_quantities<DigitsEngine>();
  return quantities;
}

}  // namespace vibro_impact_reference
