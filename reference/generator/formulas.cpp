#include "formulas.hpp"

#include <fmt/format.h>
#include <stdexcept>

namespace vibro_impact_reference {

namespace {

/// The shortest decimal number to which a double is the nearest one.
Real as_printed(double value) {
  return Real(fmt::format("{}", value));
}

/// The angle of mode `mode` (from 1) in a chain of n equal masses on equal springs, fixed at one
/// end and free at the other: the displacement of mass p is proportional to sin(p * angle).
Real mode_angle(int mode, std::size_t masses) {
  return (2 * mode - 1) * acos(Real(-1)) / (2 * static_cast<int>(masses) + 1);
}

/// Throws std::invalid_argument unless all masses and springs of the scene are one.
std::size_t masses_of_unit_chain(const vibro_impact::Scene &scene) {
  for (std::size_t i = 0; i < scene.mass.size(); ++i)
    if (scene.mass[i] != 1.0 || scene.stiffness[i] != 1.0)
      throw std::invalid_argument("a formula: the masses and springs must be one");
  return scene.mass.size();
}

}  // namespace

Real eigenvalue(const Arguments &given) {
  const std::size_t masses = masses_of_unit_chain(vibro_impact::numbers::run_of(given).scene);
  return 2 - 2 * cos(mode_angle(given.mass("mode"), masses));
}

Real mode_shape(const Arguments &given) {
  const std::size_t masses = masses_of_unit_chain(vibro_impact::numbers::run_of(given).scene);
  const Real angle = mode_angle(given.mass("mode"), masses);
  const Real last = sin(static_cast<int>(masses) * angle);
  const Real component = 2 * sin(given.mass("mass") * angle) / sqrt(Real(2 * masses + 1));
  return last > 0 ? component : -component;
}

Real exit_slope(const Arguments &given) {
  return -1 / as_printed(vibro_impact::numbers::run_of(given).scene.beta);
}

Real exit_intercept(const Arguments &given) {
  const vibro_impact::Scene scene = vibro_impact::numbers::run_of(given).scene;
  const std::size_t stop = vibro_impact::numbers::stop_of(scene, given.mass("mass"));
  return as_printed(scene.stops[stop].position) / as_printed(scene.beta);
}

Real bounce_interval(const Arguments &given) {
  const vibro_impact::Scene scene = vibro_impact::numbers::run_of(given).scene;
  masses_of_unit_chain(scene);
  const Real zeta = as_printed(scene.beta) / 2;
  return acos(Real(-1)) / sqrt(1 - zeta * zeta);
}

}  // namespace vibro_impact_reference
