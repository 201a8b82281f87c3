// Parameters at which something happens exactly: multi-sliding bifurcations, border orbits, the
// grazing of Figure 5(b), and the scenes of Table I, to thirty digits.
#pragma once

#include "border.hpp"
#include "scenes.hpp"
#include "table1.hpp"
#include "touching.hpp"

#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace vibro_impact_reference {

/// A row of the table: `error` is an estimate.
struct LocatedNumber {
  std::string symbol, value, error, source, meaning;
};

inline LocatedNumber located_row(const std::string &symbol, const Located &located,
                                 const std::string &source, const std::string &meaning) {
  const Real rounding = Real("1e-30") * abs(located.value);  // of the digits that are written
  return {symbol, located.value.str(30), std::max(located.error, rounding).str(2), source, meaning};
}

/// Where the motion of Figure 2's scene and, for the grazing, of Figure 5(b)'s touches something.
/// The starts are read off the bifurcation diagrams; those of the touching orbits lie on the side
/// where nothing is touched yet.
inline std::vector<LocatedNumber> touching_numbers() {
  const auto at = [](const char *name, const char *frequency) {
    Scene scene = scene_named(name);
    scene.chain.frequency = Real(frequency);
    return scene;
  };
  constexpr int settling = 12;
  const auto multi_sliding = [&](std::size_t stop, const char *frequency) {
    return touching_frequency(at("figure2", frequency), settling, [stop](const Scene &scene) {
      return LeastPressing{scene, stop};
    });
  };
  Scene without_stop = at("figure5b", "0.2995");
  const Real place = without_stop.stops.back().position;
  without_stop.stops.pop_back();
  return {
      located_row("multi_sliding_mass_1", multi_sliding(0, "0.256"), "scene of Figure 2",
                  "Omega at which the hold force on mass 1 touches zero inside its sticking phase"),
      located_row("multi_sliding_mass_2", multi_sliding(1, "0.268092"), "scene of Figure 2",
                  "Omega at which the hold force on mass 2 touches zero inside its sticking phase"),
      located_row("grazing_mass_2_figure5b",
                  touching_frequency(without_stop, settling,
                                     [&](const Scene &) {
                                       return Clearance{1, place};
                                     }),
                  "scene of Figure 5(b)",
                  "Omega at which mass 2 touches its stop in the motion without impacts of it"),
  };
}

/// The border orbits of Figure 2's scene.
inline std::vector<LocatedNumber> border_numbers() {
  struct Border {
    const char *symbol;
    std::size_t stop;
    const char *frequency;
    int periods, settling;
    const char *meaning;
  };
  const std::vector<Border> borders = {
      {"border_mass_1_1", 0, "0.2574557", 1, 12, "above it, one stick of mass 1 in a period less"},
      {"border_mass_2_1", 1, "0.2684680", 1, 12, "above it, one stick of mass 2 in a period less"},
      {"border_mass_1_2", 0, "0.2965443", 1, 12, "above it, the chatter of mass 1 is incomplete"},
      {"border_mass_1_3", 0, "0.3309824", 1, 12, "above it, the chatter of mass 1 is complete"},
      {"border_mass_2_2", 1, "0.3670049", 1, 12, "above it, the chatter of mass 2 is incomplete"},
      {"border_mass_1_4", 0, "0.3678203", 2, 24,
       "above it, every other chatter of mass 1 is incomplete"},
      {"border_mass_2_3", 1, "0.4038279", 1, 12, "above it, the chatter of mass 2 is complete"},
      {"border_mass_1_6", 0, "0.4038337", 1, 12, "above it, the chatter of mass 1 is complete"},
      {"border_mass_1_7", 0, "0.4642152", 1, 12, "above it, mass 1 does not stick"},
      {"border_mass_2_4", 1, "0.4747401", 1, 12, "above it, no mass sticks"},
  };
  std::vector<Real> floors;
  for (const char *floor : {"1e-5", "1e-8", "1e-12", "1e-17", "1e-22"})
    floors.push_back(Real(floor));
  if (std::numeric_limits<Real>::digits10 > 50) floors.push_back(Real("1e-26"));
  std::vector<LocatedNumber> rows;
  for (const Border &border : borders) {
    Scene scene = scene_named("figure2");
    scene.chain.frequency = Real(border.frequency);
    rows.push_back(located_row(
        border.symbol,
        border_frequency(std::move(scene), border.stop, border.periods, border.settling, floors),
        "scene of Figure 2",
        std::string("Omega at which a chatter ends on the border: ") + border.meaning));
  }
  return rows;
}

/// Table I, computed twice: with chatter down to 1e-17 and zeros to 1e-33, and down to 1e-19, where
/// rounding leaves the duration of a flight 1e-31, and to 1e-36. The difference is the estimate of
/// the error.
inline std::vector<LocatedNumber> pair_numbers() {
  const auto coarse = table1_numbers(resolution_down_to(Real("1e-17"), Real("1e-33")));
  const auto fine = table1_numbers(resolution_down_to(Real("1e-19"), Real("1e-36")));
  std::vector<LocatedNumber> rows;
  for (std::size_t i = 0; i < fine.size(); ++i)
    rows.push_back(located_row(fine[i].symbol,
                               {fine[i].value, abs(fine[i].value - coarse[i].value)}, "Table I",
                               fine[i].meaning));
  return rows;
}

/// The table located.csv.
inline std::string located_table() {
  std::string table = "symbol,value,kind,error,source,meaning\n";
  for (const auto &rows : {touching_numbers(), border_numbers(), pair_numbers()})
    for (const LocatedNumber &row : rows)
      table += row.symbol + ',' + row.value + ",computed," + row.error + ',' + quoted(row.source) +
               ',' + quoted(row.meaning) + '\n';
  return table;
}

}  // namespace vibro_impact_reference
