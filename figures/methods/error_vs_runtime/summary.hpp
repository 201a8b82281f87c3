// The rows of the table in figures/methods/README.md. The driver prints them (`error_vs_runtime
// --markdown`); a test computes their errors again.
#pragma once

#include <fmt/format.h>

#include <limits>
#include <string>
#include <vector>

namespace vibro_impact::comparison {

struct SummaryRow {
  std::string problem, method;
  double setting;
};

// The row whose time the times of the same problem are divided by.
inline SummaryRow unit_of(const std::string &problem) {
  return {problem, "this library", 1e-13};
}

// Ten periods of Figure 2 by every method that reaches their end, and two stretches in which
// nothing chatters.
inline std::vector<SummaryRow> summary_rows() {
  std::vector<SummaryRow> rows;
  const auto add = [&](const char *problem, const char *method, std::vector<double> settings) {
    for (const double setting : settings) rows.push_back({problem, method, setting});
  };
  add("figure2", "this library", {1e-7, 1e-9, 1e-13});
  add("figure2", "this library (every impact)", {std::numeric_limits<double>::epsilon()});
  add("figure2", "plain event-driven", {1e-5});
  add("figure2", "odeint runge_kutta_dopri5", {1e-8, 1e-12, 1e-14});
  add("figure2", "odeint runge_kutta_fehlberg78", {1e-12, 1e-14});
  add("figure2", "stiff spring (dopri5)", {1e9});
  add("figure2", "CVODE Adams", {1e-12});
  add("figure2", "Siconos Moreau-Jean", {2e-3});
  for (const char *problem : {"flight", "sticking"}) {
    add(problem, "this library", {1e-13});
    add(problem, "odeint runge_kutta_dopri5", {1e-8, 1e-10});
  }
  return rows;
}

// The cells of a row before its error.
inline std::string row_start(const SummaryRow &row) {
  const std::string title = row.problem == "figure2"  ? "ten periods of Figure 2"
                            : row.problem == "flight" ? "one flight"
                                                      : "one sticking phase";
  return fmt::format("| {} | {} | {:.0e} | ", title, row.method, row.setting);
}

}  // namespace vibro_impact::comparison
