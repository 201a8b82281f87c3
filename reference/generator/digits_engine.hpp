// The engine of 50 digits: it answers the questions of reference/numbers/quantities.hpp.
#pragma once

#include "event_driven.hpp"
#include "reference/numbers/quantities.hpp"

#include <cstddef>
#include <functional>
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

/// The extremes of the motion of a mass over [from, to]: at zeros of the velocity (sampled, then
/// bisected) or where one piece of motion meets the next. Throws std::runtime_error if the run has
/// no motion there.
Extremes extremes(const Run &run, std::size_t mass, const Real &from, const Real &to);

/// How hard a mass is pressed into its stop where that is least inside its sticking phases that
/// begin after `from`: the local minimum nearest to zero. Throws std::runtime_error if there is
/// none.
Real least_pressing(const Scene &scene, const Run &run, std::size_t stop, const Real &from);

/// A whole number read off a run, such as the number of its sticking phases.
using Count = std::function<std::ptrdiff_t(const Run &)>;

/// The frequency between `near` and `far` at which the count changes. The settled motion is
/// followed from `near`: every trial begins at the state extrapolated from the last two frequencies
/// known to have the same count as `near`, so that the unsettled part of a trial is small beside
/// the bracket. Throws std::logic_error if the counts at the ends agree.
Real changing_frequency(const Scene &scene, const Real &near, const Real &far, const Count &count);

/// The frequency between `near` and `far` at which the count of the motion from rest jumps. Every
/// trial starts at rest. Throws as `changing_frequency` does.
Real jumping_frequency(const Scene &scene, const Real &near, const Real &far, const Count &count);

/// The engine simulates every run once and keeps it.
class DigitsEngine {
 public:
  using Number = Real;

  std::vector<numbers::TimedEvent<Real>> events(const NamedScene &asked);
  Real period(const vibro_impact::Scene &scene);
  Extremes range(const NamedScene &asked, int mass, const numbers::Interval<double> &window);
  numbers::TurningPoint<Real> turning_point(const NamedScene &asked, int mass,
                                            const numbers::Interval<double> &window);
  /// In the last two forcing periods.
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

/// All quantities that this engine answers by a run, compiled once.
const numbers::Quantities<DigitsEngine> &quantities_in_digits();

}  // namespace vibro_impact_reference
