// Error against run time as it was measured on an idle machine with every method installed: the
// table that the committed pictures are drawn from, and what the documents say of it.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <string>
#include <vector>

#include "reference/truth/table_reader.hpp"

namespace vibro_impact::comparison {

// A run that made all events: its setting, the largest error of an event time, and the processor
// time in microseconds, for a forcing period or for a problem shorter than that.
struct Measured {
  std::string problem, method;
  double setting, error, microseconds;
};

// The runs in a table of the driver error_vs_runtime. Those that failed are left out. Throws
// std::runtime_error naming a table that cannot be read.
inline std::vector<Measured> read_measured(const std::string &path) {
  std::vector<Measured> runs;
  for (const auto &cells : truth::read_rows(path, 11)) {
    if (!cells[10].empty()) continue;
    const auto number = [&](std::size_t k) { return truth::number_in(path, cells[k]); };
    runs.push_back({cells[0], cells[1], number(2), number(3), number(5)});
  }
  return runs;
}

// The fastest run of a method on a problem with an error of at most `error`. Throws
// std::runtime_error if there is none.
inline Measured fastest(const std::vector<Measured> &runs, const std::string &problem,
                        const std::string &method, double error) {
  const Measured *best = nullptr;
  for (const Measured &run : runs)
    if (run.problem == problem && run.method == method && run.error <= error &&
        (!best || run.microseconds < best->microseconds))
      best = &run;
  if (!best)
    throw std::runtime_error(
        fmt::format("{} on {}: no run has an error below {:g}", method, problem, error));
  return *best;
}

// The most accurate run of a method on a problem, and of equally accurate ones the fastest.
inline Measured most_accurate(const std::vector<Measured> &runs, const std::string &problem,
                              const std::string &method) {
  double least = infinity;
  for (const Measured &run : runs)
    if (run.problem == problem && run.method == method) least = std::min(least, run.error);
  return fastest(runs, problem, method, least);
}

constexpr const char *library = "this library";

// How much faster the library is than the most accurate runs of Odeint's steppers, at no larger an
// error. The sentence names both settings.
inline std::string sentence_of_speed(const std::vector<Measured> &runs) {
  std::string text;
  for (const char *stepper : {"runge_kutta_fehlberg78", "runge_kutta_dopri5"}) {
    const Measured other = most_accurate(runs, "figure2", std::string("odeint ") + stepper),
                   ours = fastest(runs, "figure2", library, other.error);
    text += fmt::format(
        "{}{:.0f} times the time of the library for an error of {:.1e} ({} at {:.0e}; the "
        "library at {:.0e}, {:.1e})",
        text.empty() ? "" : ", and ", other.microseconds / ours.microseconds, other.error, stepper,
        other.setting, ours.setting, ours.error);
  }
  return text;
}

// A positive number with three digits or as an integer.
inline std::string three_digits(double value) {
  return value < 100.0 ? fmt::format("{:.3g}", value) : fmt::format("{:.0f}", value);
}

// The table of the page of the methods. Of ten periods of Figure 2 it has the most accurate run of
// every method. Of one flight and one sticking phase it has the fastest runs of the library and of
// runge_kutta_dopri5 with errors below 1e-7.
inline truth::Rows rows_of_methods(const std::vector<Measured> &runs) {
  truth::Rows rows{{"motion", "method", "setting", "largest error of an event time", "us",
                    "relative to the library"}};
  double reference = 0.0;  // the time of the library, which comes first in each motion
  const auto add = [&](const std::string &motion, const Measured &run) {
    if (run.method == library) reference = run.microseconds;
    rows.push_back({motion, run.method, fmt::format("{:.0e}", run.setting),
                    fmt::format("{:.1e}", run.error), three_digits(run.microseconds),
                    three_digits(run.microseconds / reference)});
  };
  std::vector<std::string> methods;
  for (const Measured &run : runs)
    if (run.problem == "figure2" && std::ranges::count(methods, run.method) == 0)
      methods.push_back(run.method);
  for (const std::string &method : methods)
    add("ten periods of Figure 2", most_accurate(runs, "figure2", method));
  for (const std::string method : {library, "odeint runge_kutta_dopri5"})
    add("one flight", fastest(runs, "flight", method, 1e-7));
  for (const std::string method : {library, "odeint runge_kutta_dopri5"})
    add("one sticking phase", fastest(runs, "sticking", method, 1e-7));
  return rows;
}

}  // namespace vibro_impact::comparison
