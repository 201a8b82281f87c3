// The engine of 50 digits: it answers the questions of reference/numbers/quantities.hpp.
#pragma once

#include "event_driven.hpp"
#include "reference/numbers/quantities.hpp"

#include <cstddef>
#include <list>
#include <utility>
#include <vector>

namespace vibro_impact_reference {

namespace numbers = vibro_impact::numbers;
using vibro_impact::paper::NamedScene;

/// Smallest and largest position of a mass, and when the largest is met first.
struct Extremes {
  Real lowest, highest, highest_at;
};

/// The engine simulates every run once and keeps it.
class DigitsEngine {
 public:
  using Number = Real;

  /// Forcing periods in which a motion from rest settles. The slowest is that at border_mass_2_3.
  int settling_from_rest = 300;

  std::vector<numbers::TimedEvent<Real>> events(const NamedScene &asked);
  Real period(const vibro_impact::Scene &scene);
  Extremes range(const NamedScene &asked, int mass, const numbers::Interval<double> &window);
  numbers::TurningPoint<Real> turning_point(const NamedScene &asked, int mass,
                                            const numbers::Interval<double> &window);
  /// The local minimum nearest to zero, inside the sticking phases that begin in the last two
  /// forcing periods. Throws std::runtime_error if there is none.
  Real least_pressing(const NamedScene &asked, std::size_t stop);
  /// The settled motion and the one followed from `near` are found in the same way.
  Real changing_frequency(const vibro_impact::Scene &scene, int mass, double near, double far,
                          numbers::Change motion);
  /// The frequency at which the greatest displacement of the mass, its stop taken away, reaches it.
  Real grazing_frequency(vibro_impact::Scene scene, int mass, double near, double far);

 private:
  const Run &run(const NamedScene &asked);

  // Its entries stay where they are when another one is added.
  std::list<std::pair<NamedScene, Run>> runs_;
};

}  // namespace vibro_impact_reference
