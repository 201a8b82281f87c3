// What is printed in the paper or had to be reconstructed, and the table that key numbers go to.
#pragma once

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

/// What is printed in the paper or had to be reconstructed.
inline std::vector<KeyNumber> stated_numbers() {
  std::vector<KeyNumber> rows;
  const auto printed = [&](const char *symbol, const char *value, const char *source,
                           const char *meaning) {
    rows.push_back({symbol, value, "printed", source, meaning});
  };
  const auto reconstructed = [&](const char *symbol, const char *value, const char *source,
                                 const char *meaning) {
    rows.push_back({symbol, value, "reconstructed", source, meaning});
  };
  printed("lambda1_printed", "0.382", "section 3", "smaller eigenvalue of E for two masses");
  printed("lambda2_printed", "2.618", "section 3", "larger eigenvalue of E for two masses");
  printed("xi1_mass1_printed", "0.526", "section 3", "first eigenvector, entry of mass 1");
  printed("xi1_mass2_printed", "0.851", "section 3", "first eigenvector, entry of mass 2");
  printed("xi2_mass1_printed", "-0.851", "section 3", "second eigenvector, entry of mass 1");
  printed("xi2_mass2_printed", "0.526", "section 3", "second eigenvector, entry of mass 2");
  printed("exit_slope_printed", "-10", "section 3.2",
          "slope of the exit boundary of mass 2's sticking region, dx1'/dx1");
  printed("exit_intercept_printed", "1", "section 3.2",
          "x1' of that exit boundary at x1 = 0, with s2 = 0.1");
  printed("exit_point_x", "0.1", "section 3.2",
          "the exit boundary passes through (0.1, 0): x1 there");
  printed("m", "1", "section 3", "both masses");
  printed("k", "1", "section 3", "both stiffnesses");
  printed("c", "0.1", "section 3", "both viscous dampings");
  printed("r", "0.7", "section 3", "coefficient of restitution, all scenes but Figure 5(b)");
  printed("A1", "0.5", "section 3", "forcing amplitude on mass 1");
  printed("A2", "0", "section 3", "forcing amplitude on mass 2");
  printed("figure2_s1", "-0.3", "caption of Figure 2", "stop of mass 1 (lower), Figures 2-4");
  printed("figure2_s2", "0.1", "caption of Figure 2", "stop of mass 2 (upper), Figures 2-4");
  reconstructed("figure2_Omega", "0.2797", "axis boxes and text (figures/README.md)",
                "forcing frequency of Figure 2");
  printed("figure2a_t_min", "700", "axes of Figure 2(a)", "start of the shown window");
  printed("figure2a_t_max", "750", "axes of Figure 2(a)", "end of the shown window");
  printed("figure2a_x_min", "-0.5", "axes of Figure 2(a)", "lower edge of the axis box");
  printed("figure2a_x_max", "0.4", "axes of Figure 2(a)", "upper edge of the axis box");
  printed("figure2b_t_min", "715", "axes of Figure 2(b)", "start of the shown window");
  printed("figure2b_t_max", "722", "axes of Figure 2(b)", "end of the shown window");
  printed("figure2b_x_min", "-0.06", "axes of Figure 2(b)", "lower edge of the axis box");
  printed("figure2b_x_max", "0.12", "axes of Figure 2(b)", "upper edge of the axis box");
  printed("figure3_Omega_min", "0.25", "section 3.2 and axes of Figure 3",
          "lowest forcing frequency");
  printed("figure3_Omega_max", "0.7", "section 3.2 and axes of Figure 3",
          "highest forcing frequency");
  printed("figure3a_v1_min", "-0.4", "axes of Figure 3(a)",
          "lower edge; impact speeds of mass 1 are negative");
  printed("figure3b_v2_max", "0.4", "axes of Figure 3(b)",
          "upper edge; impact speeds of mass 2 are positive");
  printed("sticking_Omega_max", "0.5", "section 3.2",
          "sticking motions exist below this forcing frequency");
  printed("incomplete_1_from", "0.3", "section 3.2",
          "mass 1's chatter is incomplete about from this Omega");
  printed("incomplete_1_to", "0.35", "section 3.2", "to about this Omega");
  printed("incomplete_2_from", "0.37", "section 3.2", "and again about from this Omega");
  printed("incomplete_2_to", "0.4", "section 3.2", "to about this Omega");
  printed("multi_sliding_Omega_below", "0.256", "caption of Figure 4",
          "just before the multi-sliding bifurcation, 4(a)");
  printed("multi_sliding_Omega_above", "0.2561", "caption of Figure 4",
          "just after the multi-sliding bifurcation, 4(b)");
  printed("figure4_t_min", "12", "axes of Figure 4",
          "start of the shown window (time within the forcing period)");
  printed("figure4_t_max", "17.5", "axes of Figure 4", "end of the shown window");
  printed("figure4_F_min", "-0.2", "axes of Figure 4", "lower edge of the axis box");
  printed("figure4_F_max", "0.02", "axes of Figure 4", "upper edge of the axis box");
  printed("figure5a_s1", "0.3", "section 3.3", "stop of mass 1 (upper)");
  printed("figure5a_s2", "0.3", "section 3.3", "stop of mass 2 (upper)");
  reconstructed("figure5a_Omega", "0.1769", "axis box and text (figures/README.md)",
                "forcing frequency of Figure 5(a)");
  printed("figure5b_s2", "0.45", "section 3.3",
          "stop of mass 2 (upper); that of mass 1 stays at 0.3");
  printed("figure5b_r", "0.001", "section 3.3", "coefficient of restitution of Figure 5(b)");
  printed("figure5b_graze_time", "920", "section 3.3",
          "mass 2 touches its stop about then while mass 1 is stuck (GS)");
  reconstructed("figure5b_Omega", "0.2995", "axis box and text (figures/README.md)",
                "forcing frequency of Figure 5(b)");
  printed("figure5c_Omega", "0.02", "section 3.3", "forcing frequency of Figure 5(c)");
  reconstructed("figure5c_s1", "0.3", "axis box of Figure 5(c)", "stop of mass 1 (upper)");
  reconstructed("figure5c_s2", "0.3", "axis box of Figure 5(c)", "stop of mass 2 (upper)");
  printed("figure5a_t_min", "950", "axes of Figure 5(a)", "start of the shown window");
  printed("figure5a_t_max", "964", "axes of Figure 5(a)", "end of the shown window");
  printed("figure5a_x_min", "-0.05", "axes of Figure 5(a)", "lower edge of the axis box");
  printed("figure5a_x_max", "0.35", "axes of Figure 5(a)", "upper edge of the axis box");
  printed("figure5b_t_min", "916", "axes of Figure 5(b)", "start of the shown window");
  printed("figure5b_t_max", "930", "axes of Figure 5(b)", "end of the shown window");
  printed("figure5b_x_min", "-0.4", "axes of Figure 5(b)", "lower edge of the axis box");
  printed("figure5b_x_max", "0.5", "axes of Figure 5(b)", "upper edge of the axis box");
  printed("figure5c_t_min", "900", "axes of Figure 5(c)", "start of the shown window");
  printed("figure5c_t_max", "1000", "axes of Figure 5(c)", "end of the shown window");
  printed("figure5c_x_min", "0.2", "axes of Figure 5(c)", "lower edge of the axis box");
  printed("figure5c_x_max", "0.31", "axes of Figure 5(c)", "upper edge of the axis box");
  return rows;
}

}  // namespace vibro_impact_reference
