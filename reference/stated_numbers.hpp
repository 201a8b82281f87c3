// What is printed in the paper or had to be reconstructed, and the table that key numbers go to.
#pragma once

#include <fmt/format.h>

#include "reference/scenes/paper_scenes.hpp"

#include <string>
#include <vector>

namespace vibro_impact_reference {

struct KeyNumber {
  std::string symbol, value, kind, source, meaning;
  std::string error = {};  // estimate; where a table has that column
};

/// Rows as a table: symbol,value,kind,source,meaning.
inline std::string table_of(const std::vector<KeyNumber> &rows) {
  const auto quoted = [](const std::string &field) {
    return field.find(',') == std::string::npos ? field : '"' + field + '"';
  };
  std::string table = "symbol,value,kind,source,meaning\n";
  for (const KeyNumber &row : rows)
    table += row.symbol + ',' + row.value + ',' + row.kind + ',' + quoted(row.source) + ',' +
             quoted(row.meaning) + '\n';
  return table;
}

/// The four rows of an axis box.
inline std::vector<KeyNumber> box_rows(const std::string &panel,
                                       const vibro_impact::paper::AxisBox &box,
                                       const std::string &ordinate, const std::string &source,
                                       const std::string &window = "") {
  const auto row = [&](const std::string &symbol, double value, const std::string &meaning) {
    return KeyNumber{panel + "_" + symbol, fmt::format("{}", value), "printed", source, meaning};
  };
  return {row("t_min", box.from, "start of the shown window" + window),
          row("t_max", box.to, "end of the shown window"),
          row(ordinate + "_min", box.lowest, "lower edge of the axis box"),
          row(ordinate + "_max", box.highest, "upper edge of the axis box")};
}

/// What is printed in the paper or had to be reconstructed. The numbers of scenes and axes are
/// those of reference/scenes/paper_scenes.hpp.
inline std::vector<KeyNumber> stated_numbers() {
  using namespace vibro_impact::paper;
  std::vector<KeyNumber> rows;
  const auto stated = [&](const char *kind) {
    return
        [&rows, kind](const char *symbol, double value, const char *source, const char *meaning) {
          rows.push_back({symbol, fmt::format("{}", value), kind, source, meaning});
        };
  };
  const auto printed = stated("printed"), reconstructed = stated("reconstructed");
  const auto box = [&rows](const std::vector<KeyNumber> &four) {
    rows.insert(rows.end(), four.begin(), four.end());
  };
  const vibro_impact::Scene two = figure2();
  printed("lambda1_printed", 0.382, "section 3", "smaller eigenvalue of E for two masses");
  printed("lambda2_printed", 2.618, "section 3", "larger eigenvalue of E for two masses");
  printed("xi1_mass1_printed", 0.526, "section 3", "first eigenvector, entry of mass 1");
  printed("xi1_mass2_printed", 0.851, "section 3", "first eigenvector, entry of mass 2");
  printed("xi2_mass1_printed", -0.851, "section 3", "second eigenvector, entry of mass 1");
  printed("xi2_mass2_printed", 0.526, "section 3", "second eigenvector, entry of mass 2");
  printed("exit_slope_printed", -10, "section 3.2",
          "slope of the exit boundary of mass 2's sticking region, dx1'/dx1");
  printed("exit_intercept_printed", 1, "section 3.2",
          "x1' of that exit boundary at x1 = 0, with s2 = 0.1");
  printed("exit_point_x", 0.1, "section 3.2",
          "the exit boundary passes through (0.1, 0): x1 there");
  printed("m", two.mass[0], "section 3", "both masses");
  printed("k", two.stiffness[0], "section 3", "both stiffnesses");
  printed("c", two.beta * two.stiffness[0], "section 3", "both viscous dampings");
  printed("r", two.restitution, "section 3",
          "coefficient of restitution, all scenes but Figure 5(b)");
  printed("A1", two.amplitude[0], "section 3", "forcing amplitude on mass 1");
  printed("A2", two.amplitude[1], "section 3", "forcing amplitude on mass 2");
  printed("figure2_s1", two.stops[0].position, "caption of Figure 2",
          "stop of mass 1 (lower), Figures 2-4");
  printed("figure2_s2", two.stops[1].position, "caption of Figure 2",
          "stop of mass 2 (upper), Figures 2-4");
  reconstructed("figure2_Omega", two.omega, "axis boxes and text (figures/README.md)",
                "forcing frequency of Figure 2");
  box(box_rows("figure2a", figure2a_box, "x", "axes of Figure 2(a)"));
  box(box_rows("figure2b", figure2b_box, "x", "axes of Figure 2(b)"));
  printed("figure3_Omega_min", figure3a_box.from, "section 3.2 and axes of Figure 3",
          "lowest forcing frequency");
  printed("figure3_Omega_max", figure3a_box.to, "section 3.2 and axes of Figure 3",
          "highest forcing frequency");
  printed("figure3a_v1_min", figure3a_box.lowest, "axes of Figure 3(a)",
          "lower edge; impact speeds of mass 1 are negative");
  printed("figure3b_v2_max", figure3b_box.highest, "axes of Figure 3(b)",
          "upper edge; impact speeds of mass 2 are positive");
  printed("sticking_Omega_max", 0.5, "section 3.2",
          "sticking motions exist below this forcing frequency");
  printed("incomplete_1_from", 0.3, "section 3.2",
          "mass 1's chatter is incomplete about from this Omega");
  printed("incomplete_1_to", 0.35, "section 3.2", "to about this Omega");
  printed("incomplete_2_from", 0.37, "section 3.2", "and again about from this Omega");
  printed("incomplete_2_to", 0.4, "section 3.2", "to about this Omega");
  printed("multi_sliding_Omega_below", figure4a().omega, "caption of Figure 4",
          "just before the multi-sliding bifurcation, 4(a)");
  printed("multi_sliding_Omega_above", figure4b().omega, "caption of Figure 4",
          "just after the multi-sliding bifurcation, 4(b)");
  box(box_rows("figure4", figure4_box, "F", "axes of Figure 4",
               " (time within the forcing period)"));
  printed("figure5a_s1", figure5a().stops[0].position, "section 3.3", "stop of mass 1 (upper)");
  printed("figure5a_s2", figure5a().stops[1].position, "section 3.3", "stop of mass 2 (upper)");
  reconstructed("figure5a_Omega", figure5a().omega, "axis box and text (figures/README.md)",
                "forcing frequency of Figure 5(a)");
  printed("figure5b_s2", figure5b().stops[1].position, "section 3.3",
          "stop of mass 2 (upper); that of mass 1 stays at 0.3");
  printed("figure5b_r", figure5b().restitution, "section 3.3",
          "coefficient of restitution of Figure 5(b)");
  printed("figure5b_graze_time", 920, "section 3.3",
          "mass 2 touches its stop about then while mass 1 is stuck (GS)");
  reconstructed("figure5b_Omega", figure5b().omega, "axis box and text (figures/README.md)",
                "forcing frequency of Figure 5(b)");
  printed("figure5c_Omega", figure5c().omega, "section 3.3", "forcing frequency of Figure 5(c)");
  reconstructed("figure5c_s1", figure5c().stops[0].position, "axis box of Figure 5(c)",
                "stop of mass 1 (upper)");
  reconstructed("figure5c_s2", figure5c().stops[1].position, "axis box of Figure 5(c)",
                "stop of mass 2 (upper)");
  box(box_rows("figure5a", figure5a_box, "x", "axes of Figure 5(a)"));
  box(box_rows("figure5b", figure5b_box, "x", "axes of Figure 5(b)"));
  box(box_rows("figure5c", figure5c_box, "x", "axes of Figure 5(c)"));
  return rows;
}

}  // namespace vibro_impact_reference
