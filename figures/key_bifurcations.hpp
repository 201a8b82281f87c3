// The located numbers that the paper reads off its diagrams or does not have: bifurcation points
// and the scenes of Table I.
#pragma once

#include <string>
#include <vector>

#include "figures/beyond/bifurcations.hpp"
#include "figures/beyond/grazing.hpp"
#include "figures/beyond/table1_scenes.hpp"
#include "key_numbers.hpp"

namespace vibro_impact::figures {

inline std::vector<KeyNumber> key_bifurcations() {
  const std::string ten_digits = "ten digits of a frequency; both ways of locating agree to 1e-13";
  std::vector<KeyNumber> rows;
  // The one change of the sticking count of `mass` in [below, above], located by the smooth
  // function.
  const auto change = [&](const std::string &symbol, const std::string &meaning,
                          const Printed &printed, int mass, double below, double above) {
    rows.push_back({symbol, meaning, printed, "{:.13f}", 1e-10, ten_digits, [=] {
                      const auto changes = changes_between(mass, below, above);
                      return locate(changes.at(0), mass).back().omega.value;
                    }});
  };
  change("multi_sliding_mass_1", "Omega of the multi-sliding of mass 1", between("0.256", "0.2561"),
         1, 0.256, 0.2561);
  change("border_mass_1_1", "Omega at which the second stick of mass 1 ends", {}, 1, 0.2574,
         0.2575);
  change("multi_sliding_mass_2", "Omega of the multi-sliding of mass 2", {}, 2, 0.268, 0.2682);
  change("border_mass_2_1", "Omega at which the second stick of mass 2 ends", {}, 2, 0.2684,
         0.2685);
  change("border_mass_1_2", "Figure 3: chatter of mass 1 incomplete from Omega",
         read_off_figure3("0.3"), 1, 0.2965, 0.2966);
  change("border_mass_1_3", "Figure 3: chatter of mass 1 incomplete to Omega",
         read_off_figure3("0.35"), 1, 0.3309, 0.331);
  change("border_mass_2_2", "Figure 3: chatter of mass 2 incomplete from", {}, 2, 0.367, 0.36701);
  change("border_mass_1_4", "Figure 3: every other chatter of mass 1 incomplete from",
         read_off_figure3("0.37"), 1, 0.36782, 0.367822);
  change("border_mass_2_3", "Figure 3: chatter of mass 2 incomplete to", {}, 2, 0.40382, 0.40383);
  change("border_mass_1_6", "Figure 3: chatter of mass 1 incomplete to Omega",
         read_off_figure3("0.4"), 1, 0.40383, 0.40384);
  change("border_mass_1_7", "Figure 3: no sticking of mass 1 above (up to 0.632)", {}, 1, 0.4642,
         0.4643);
  change("border_mass_2_4", "Figure 3: no sticking of either mass above (up to 0.632)",
         read_off_figure3("0.5"), 2, 0.4747, 0.4748);
  rows.push_back({"grazing_mass_2_figure5b",
                  "Omega at which mass 2 grazes its stop in Figure 5(b)",
                  {},
                  "{:.13f}",
                  1e-10,
                  ten_digits,
                  [] { return grazing().omega.value; }});
  const std::string solved =
      "rounding; stops of grazing masses stand 2e-15 before the turning point";
  const auto table1 = [&](const std::string &symbol, const std::string &meaning, auto compute) {
    rows.push_back({symbol, "Table I, " + meaning, {}, "{:.13f}", 1e-13, solved, compute});
  };
  table1("DG_Omega", "dual grazing: Omega", [] { return dual_grazing().scene.omega; });
  table1("DG_s1", "dual grazing: s1", [] { return dual_grazing().scene.stops[0].position; });
  table1("DG_s2", "dual grazing: s2", [] { return dual_grazing().scene.stops[1].position; });
  table1("DI_s2", "double impact: s2", [] { return double_impact().scene.stops[1].position; });
  table1("GS_s2", "grazing-sticking: s2",
         [] { return grazing_sticking().scene.stops[1].position; });
  table1("GI_s1", "grazing-impact: s1", [] { return grazing_impact().scene.stops[0].position; });
  table1("GI_s2", "grazing-impact: s2", [] { return grazing_impact().scene.stops[1].position; });
  rows.push_back(
      {"DS_from", "Table I, dual sticking: begins", {}, "{:.11f}", 1e-10, "an event time", [] {
         return dual_sticking().time;
       }});
  return rows;
}

}  // namespace vibro_impact::figures
