#include "method.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <limits>
#include <numbers>

#include "figures/event_tables.hpp"
#include "reference/paper_scenes.hpp"
#include "reference/table_reader.hpp"
#include "vibro_impact/record.hpp"

namespace vibro_impact::comparison {

namespace {

static_assert(impact == EventKind::impact && stick == EventKind::stick &&
              release == EventKind::release);

EventKind kind_named(const std::string &name) {
  return name == "stick" ? stick : name == "release" ? release : impact;
}

// The events of one mass, split at its sticks and releases.
struct Course {
  std::vector<std::vector<double>> impacts = {{}};  // times, one list per stretch between two marks
  std::vector<Happened> marks = {};                 // sticks and releases
};

// `slowest` > 0: of every stretch only the impacts up to the first slower one.
Course course_of(const std::vector<Happened> &events, int mass, double slowest) {
  Course course;
  bool open = true;
  for (const Happened &event : events) {
    if (event.mass != mass) continue;
    if (event.kind != impact) {
      course.marks.push_back(event);
      course.impacts.emplace_back();
      open = true;
      continue;
    }
    open = open && std::abs(event.velocity_before) >= slowest;
    if (open || slowest == 0.0) course.impacts.back().push_back(event.time);
  }
  return course;
}

}  // namespace

double Problem::periods() const {
  return (until - start.time) * scene.omega / (2.0 * std::numbers::pi);
}

std::vector<Problem> problems(const std::filesystem::path &reference) {
  std::vector<Problem> all;
  const std::string states = reference / "work_precision_states.csv";
  const auto events = figures::read_event_tables(reference / "work_precision_events.csv");
  for (const auto &row : figures::read_rows(states, 14)) {
    const auto number = [&](std::size_t i) { return figures::number_in(states, row[i]); };
    const std::array<bool, 2> held{row[8] == "1", row[9] == "1"};
    all.push_back({row[0],
                   paper::scene_named(row[1]).scene,
                   {number(2), {number(4), number(5)}, {number(6), number(7)}, held},
                   number(3),
                   {},
                   {number(3), {number(10), number(11)}, {number(12), number(13)}, {}}});
    const auto happened = events.find(row[0]);
    if (happened == events.end()) continue;
    for (const figures::TrueEvent &event : happened->second)
      all.back().reference_events.push_back(
          {event.time, event.mass, kind_named(event.event), event.velocity_before});
  }
  return all;
}

Errors errors_of(const Result &result, const Problem &problem) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  if (!result.failure.empty()) return {nan, nan, result.failure};
  double worst = 0.0;
  for (const int mass : {1, 2}) {
    const Course expected = course_of(problem.reference_events, mass, slowest_impact_compared);
    const Course found = course_of(result.events, mass, 0.0);
    for (std::size_t i = 0; i < std::max(expected.marks.size(), found.marks.size()); ++i) {
      if (i == expected.marks.size())
        return {nan, nan,
                fmt::format("mass {}: spurious {} at t = {:.6f}", mass, name(found.marks[i].kind),
                            found.marks[i].time)};
      // A mark that comes more than a tenth of a forcing period away is not the one expected.
      const Happened &mark = expected.marks[i];
      const double reach = 0.1 * 2.0 * std::numbers::pi / problem.scene.omega;
      if (i == found.marks.size() || found.marks[i].kind != mark.kind ||
          !(std::abs(found.marks[i].time - mark.time) < reach))
        return {nan, nan,
                fmt::format("mass {}: {} at t = {:.6f} missed", mass, name(mark.kind), mark.time)};
      worst = std::max(worst, std::abs(found.marks[i].time - mark.time));
    }
    for (std::size_t i = 0; i < expected.impacts.size(); ++i)
      for (std::size_t j = 0; j < expected.impacts[i].size(); ++j) {
        if (j == found.impacts[i].size())
          return {
              nan, nan,
              fmt::format("mass {}: impact at t = {:.6f} missed", mass, expected.impacts[i][j])};
        worst = std::max(worst, std::abs(found.impacts[i][j] - expected.impacts[i][j]));
      }
  }
  double state = 0.0;
  for (std::size_t i = 0; i < 2; ++i) {
    state = std::max(state,
                     std::abs(result.end.displacement[i] - problem.reference_end.displacement[i]));
    state = std::max(state, std::abs(result.end.velocity[i] - problem.reference_end.velocity[i]));
  }
  if (!std::isfinite(state)) return {nan, nan, "the state at the end is not finite"};
  return {worst, state, {}};
}

Methods all_methods() {
  Methods all;
  const auto add = [&](const std::vector<Method> &family) {
    all.methods.insert(all.methods.end(), family.begin(), family.end());
  };
  add(this_library());
  add(plain_event_driven());
  add(odeint());
#ifdef WITH_CVODE
  add(cvode());
#else
  all.left_out.emplace_back("CVODE (SUNDIALS)");
#endif
#ifdef WITH_SICONOS
  add(siconos());
#else
  all.left_out.emplace_back("Siconos");
#endif
  add(stiff_spring());
  return all;
}

}  // namespace vibro_impact::comparison
