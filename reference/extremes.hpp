// The extreme and the degenerate cases: the scenes of reference/scenes/extreme_cases.hpp and
// reference/scenes/degenerate_cases.hpp (numbers only), simulated by the generator.
#pragma once

#include "event_driven.hpp"
#include "reference/scenes/degenerate_cases.hpp"
#include "reference/scenes/extreme_cases.hpp"

#include <string>
#include <vector>

namespace vibro_impact_reference {

/// The scene in 50 digits; every double is taken over exactly.
inline Scene in_digits(const vibro_impact::extremes::Case &extreme) {
  const vibro_impact::Scene &given = extreme.scene;
  const auto digits = [](const std::vector<double> &values, std::size_t size) {
    Vector result(size);
    for (std::size_t i = 0; i < values.size(); ++i) result[i] = Real(values[i]);
    return result;
  };
  const std::size_t n = given.mass.size();
  Scene scene{.name = extreme.name,
              .chain = {.masses = digits(given.mass, n),
                        .stiffnesses = digits(given.stiffness, n),
                        .damping_ratio = Real(given.beta),
                        .amplitudes = digits(given.amplitude, n),
                        .frequency = Real(given.omega)},
              .stops = {},
              .restitution = Real(given.restitution),
              .initial_positions = digits(given.displacement, n),
              .initial_velocities = digits(given.velocity, n),
              .end_time = Real(extreme.until)};
  for (const vibro_impact::Stop &stop : given.stops) {
    scene.stops.push_back({static_cast<std::size_t>(stop.mass - 1),
                           stop.side == vibro_impact::Side::upper ? Side::upper : Side::lower,
                           Real(stop.position)});
  }
  return scene;
}

/// The thresholds of a case: its slowest impact, and bounces without a pressing force 1e-4 below
/// it.
inline Resolution resolution_of(const vibro_impact::extremes::Case &extreme) {
  Resolution resolution;
  resolution.speed_floor = Real(extreme.slowest_impact);
  resolution.hopeless_speed = resolution.speed_floor * Real("1e-4");
  return resolution;
}

/// The cases whose truth is the generator's.
inline std::vector<vibro_impact::extremes::Case> cases_in_digits() {
  std::vector<vibro_impact::extremes::Case> selected;
  for (const auto &extreme : vibro_impact::extremes::all_cases()) {
    if (extreme.truth == vibro_impact::extremes::Truth::digits) selected.push_back(extreme);
  }
  return selected;
}

}  // namespace vibro_impact_reference
