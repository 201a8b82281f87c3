// The engine in double precision: it answers the questions of reference/numbers/quantities.hpp with
// the library.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "figures/measures/runs.hpp"
#include "reference/numbers/quantities.hpp"

namespace vibro_impact::figures {

struct LibraryEngine {
  using Number = double;

  std::vector<numbers::TimedEvent<double>> events(const paper::NamedScene &run);
  double period(const Scene &scene);
  // The range of samples 1e-4 apart.
  Range range(const paper::NamedScene &run, int mass, const numbers::Interval<double> &window);
  numbers::TurningPoint<double> turning_point(const paper::NamedScene &run, int mass,
                                              const numbers::Interval<double> &window);
  // On the periodic orbit to which the motion settles.
  double least_pressing(const paper::NamedScene &run, std::size_t stop);
  double changing_frequency(const Scene &scene, int mass, double near, double far,
                            numbers::Change motion);
  // The stop is put back into the settled motion without it, because the motion from rest may hit
  // the stop below this frequency.
  double grazing_frequency(const Scene &scene, int mass, double near, double far);
};

// All that the library computes: the quantities of both engines, those that have a formula in 50
// digits, and those of other authors.
const numbers::Quantities<LibraryEngine> &library_quantities();

// Adds a quantity that is answered without the engine.
void add(numbers::Quantities<LibraryEngine> &all, const std::string &quantity,
         const std::string &names, std::function<double(const numbers::Arguments &)> answer);

// The library's value of a row. Throws std::runtime_error naming a row of which it cannot be
// computed.
double computed(const numbers::CheckedNumber &number);

}  // namespace vibro_impact::figures
