// Parameters at which something happens exactly: multi-sliding bifurcations, border orbits, the
// grazing of Figure 5(b), and the scenes of Table I, to thirty digits. What each means stands in
// the table, located.csv.
#pragma once

#include "border.hpp"
#include "extremes_of_motion.hpp"
#include "filled_table.hpp"
#include "scenes.hpp"
#include "table1.hpp"

#include <algorithm>
#include <limits>
#include <utility>
#include <vector>

namespace vibro_impact_reference {

/// The last coordinate of points, as a polynomial in the value that goes with each, at value zero.
inline Real at_zero(const std::vector<std::pair<Real, Real>> &points) {
  Real x = 0;
  for (const auto &point : points) {
    Real weight = 1;
    for (const auto &other : points)
      if (other.first != point.first) weight *= other.first / (other.first - point.first);
    x += weight * point.second;
  }
  return x;
}

/// The frequency near that of the scene at which the condition of the orbit is zero: frequencies at
/// which it has ever smaller positive values, by polynomial continuation to zero. An orbit beyond
/// it is another one, with a phase of sticking or an impact that this one does not have; on this
/// side everything is smooth. The error: what the last point changes.
inline Located touching_frequency(Scene scene, int settling, const Condition &condition) {
  const Resolution resolution = resolution_down_to(Real("1e-22"));
  SoughtOrbit orbit = orbit_from_rest(std::move(scene), 1, settling, resolution);
  SquareMatrix inverse;
  std::vector<std::pair<Real, Real>> points;
  Located located{0, 1};
  for (const char *target : {"1e-6", "1e-10", "1e-14", "1e-18", "1e-22"}) {
    const Real value(target);
    const Real step = solve_orbit(orbit, inverse, resolution, condition, value, Real("1e-33"));
    points.push_back({value, orbit.unknowns.back()});
    const Real zero = at_zero(points);
    located = {zero, abs(zero - located.value) + step};
  }
  return located;
}

inline Found written(const Located &located) {
  const Real rounding = Real("1e-30") * abs(located.value);  // of the digits that are written
  return {located.value.str(30), std::max(located.error, rounding).str(2)};
}

inline Scene scene_at(const char *name, const char *frequency) {
  Scene scene = scene_named(name);
  scene.chain.frequency = Real(frequency);
  return scene;
}

/// Where the motion of Figure 2's scene and, for the grazing, of Figure 5(b)'s touches something.
/// The starts are read off the bifurcation diagrams; those of the touching orbits lie on the side
/// where nothing is touched yet.
inline void add_touching(Numbers &numbers) {
  constexpr int settling = 12;
  const auto multi_sliding = [&](std::size_t stop, const char *frequency) {
    return written(touching_frequency(scene_at("figure2", frequency), settling,
                                      [stop](const Scene &scene, const Run &run) {
                                        return least_pressing(scene, run, stop, Real(0));
                                      }));
  };
  numbers["multi_sliding_mass_1"] = multi_sliding(0, "0.256");
  numbers["multi_sliding_mass_2"] = multi_sliding(1, "0.268092");
  Scene without_stop = scene_at("figure5b", "0.2995");
  const Real place = without_stop.stops.back().position;
  without_stop.stops.pop_back();
  numbers["grazing_mass_2_figure5b"] = written(
      touching_frequency(without_stop, settling, [&](const Scene &scene, const Run &run) -> Real {
        return place - extremes(run, Real(0), scene.end_time).highest[1];
      }));
}

/// The border orbits of Figure 2's scene.
inline void add_borders(Numbers &numbers) {
  struct Border {
    const char *symbol;
    std::size_t stop;
    const char *frequency;
    int periods, settling;
  };
  const std::vector<Border> borders = {
      {"border_mass_1_1", 0, "0.2574557", 1, 12}, {"border_mass_2_1", 1, "0.2684680", 1, 12},
      {"border_mass_1_2", 0, "0.2965443", 1, 12}, {"border_mass_1_3", 0, "0.3309824", 1, 12},
      {"border_mass_2_2", 1, "0.3670049", 1, 12}, {"border_mass_1_4", 0, "0.3678203", 2, 24},
      {"border_mass_2_3", 1, "0.4038279", 1, 12}, {"border_mass_1_6", 0, "0.4038337", 1, 12},
      {"border_mass_1_7", 0, "0.4642152", 1, 12}, {"border_mass_2_4", 1, "0.4747401", 1, 12},
  };
  std::vector<Real> floors;
  for (const char *floor : {"1e-5", "1e-8", "1e-12", "1e-17", "1e-22"})
    floors.push_back(Real(floor));
  if (std::numeric_limits<Real>::digits10 > 50) floors.push_back(Real("1e-26"));
  for (const auto &[symbol, stop, frequency, periods, settling] : borders)
    numbers[symbol] =
        written(border_frequency(scene_at("figure2", frequency), stop, periods, settling, floors));
}

/// Table I, computed twice: with chatter down to 1e-17 and zeros to 1e-33, and down to 1e-19, where
/// rounding leaves the duration of a flight 1e-31, and to 1e-36. The difference is the estimate of
/// the error.
inline void add_pairs(Numbers &numbers) {
  const auto coarse = table1_numbers({Real("1e-17"), {Real("1e-33"), true}});
  const auto fine = table1_numbers({Real("1e-19"), {Real("1e-36"), true}});
  for (const auto &[symbol, value] : fine)
    numbers[symbol] = written({value, abs(value - coarse.at(symbol))});
}

inline Numbers located_numbers() {
  Numbers numbers;
  add_touching(numbers);
  add_borders(numbers);
  add_pairs(numbers);
  return numbers;
}

}  // namespace vibro_impact_reference
