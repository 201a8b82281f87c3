#include "measured.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "reference/numbers/checked_number.hpp"

namespace vibro_impact::comparison {

namespace {

using Names = std::vector<std::string>;

const std::string library = "this library";
const Names steppers{"DOP853", "odeint runge_kutta_dopri5", "odeint runge_kutta_fehlberg78"};
constexpr double errors[] = {1e-5, 1e-6, 1e-8, 1e-9, 1e-10, 3e-11, 7e-13};

const std::pair<std::string, std::string> motions[] = {{"figure2", "ten periods of Figure 2"},
                                                       {"figure4", "ten periods of Figure 4(a)"},
                                                       {"flight", "one flight"},
                                                       {"sticking", "one sticking phase"},
                                                       {"chatter", "one chatter"},
                                                       {"chain10", "ten masses"},
                                                       {"chain200", "200 masses"}};

std::string two_digits(double value) {
  return value < 10.0 ? fmt::format("{:#.2g}", value) : fmt::format("{:.0f}", value);
}

// The time of the fastest of these methods relative to that of the library, at no larger an error.
std::string ratio(const std::vector<Measured> &runs, const std::string &problem,
                  const Names &methods, double error) {
  const auto ours = fastest(runs, problem, {library}, error),
             other = fastest(runs, problem, methods, error);
  return ours && other ? two_digits(other->microseconds / ours->microseconds) : "-";
}

std::string name_of(double error) {
  return numbers::formatted(error, ".0e");
}

}  // namespace

std::vector<Measured> read_measured(const std::string &path) {
  std::vector<Measured> runs;
  for (const truth::Row &row : truth::read_rows(path))
    if (row.cell("failure").empty())
      runs.push_back({row.cell("problem"), row.cell("method"), row.number("setting"),
                      row.number("error_time"), row.number("fastest_us")});
  return runs;
}

std::optional<Measured> fastest(const std::vector<Measured> &runs, const std::string &problem,
                                const Names &methods, double error) {
  std::optional<Measured> best;
  for (const Measured &run : runs)
    if (run.problem == problem && run.error <= error &&
        std::ranges::count(methods, run.method) > 0 &&
        (!best || run.microseconds < best->microseconds))
      best = run;
  return best;
}

std::vector<truth::Cells> rows_of_steppers(const std::vector<Measured> &runs) {
  std::vector<truth::Cells> rows{{"motion"}};
  for (const double error : errors) rows.front().push_back(name_of(error));
  for (const auto &[problem, motion] : motions) {
    truth::Cells &row = rows.emplace_back(truth::Cells{motion});
    for (const double error : errors) row.push_back(ratio(runs, problem, steppers, error));
  }
  return rows;
}

std::vector<truth::Cells> rows_of_methods(const std::vector<Measured> &runs) {
  const std::pair<std::string, std::string> columns[] = {
      {"by hand", "by hand"},      {"this library (every impact)", "every impact"},
      {steppers[0], "DOP853"},     {steppers[1], "dopri5"},
      {steppers[2], "fehlberg78"}, {"plain event-driven", "plain"}};
  std::vector<truth::Cells> rows{{"error", "library, us"}};
  for (const auto &[method, column] : columns) rows.front().push_back(column);
  for (const double error : errors) {
    const auto ours = fastest(runs, "figure2", {library}, error);
    rows.push_back({name_of(error), ours ? fmt::format("{:.1f}", ours->microseconds) : "-"});
    for (const auto &[method, column] : columns)
      rows.back().push_back(ratio(runs, "figure2", {method}, error));
  }
  return rows;
}

}  // namespace vibro_impact::comparison
