#include "method.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "reference/scenes/paper_scenes.hpp"
#include "reference/truth/event_reader.hpp"
#include "reference/truth/table_reader.hpp"

namespace vibro_impact::comparison {

namespace {

EventKind kind_named(const std::string &text) {
  for (const EventKind kind : {EventKind::stick, EventKind::release})
    if (text == name(kind)) return kind;
  return EventKind::impact;
}

// The events of one mass, split at its sticks and releases.
struct Course {
  std::vector<std::vector<double>> impacts = {{}};  // times, one list per stretch between two marks
  std::vector<MassEvent> marks = {};                // sticks and releases
};

// `slowest` > 0: of every stretch only the impacts before the first slower one.
Course course_of(const std::vector<MassEvent> &events, int mass, double slowest) {
  Course course;
  bool compared = true;
  for (const MassEvent &event : events) {
    if (event.mass != mass) continue;
    if (event.kind != EventKind::impact) {
      course.marks.push_back(event);
      course.impacts.emplace_back();
      compared = true;
      continue;
    }
    compared = compared && std::abs(event.velocity_before) >= slowest;
    if (compared || slowest == 0.0) course.impacts.back().push_back(event.time);
  }
  return course;
}

// Compares the sticks and releases, then the impacts between them. A mark more than `reach` away is
// not the expected one. Raises `worst` to the largest error of a time; returns what is missing or
// spurious, or nothing.
std::string compare(const Course &found, const Course &expected, double reach, double &worst) {
  for (std::size_t i = 0; i < std::max(expected.marks.size(), found.marks.size()); ++i) {
    if (i == expected.marks.size())
      return fmt::format("spurious {} at t = {:.6f}", name(found.marks[i].kind),
                         found.marks[i].time);
    const MassEvent &mark = expected.marks[i];
    if (i == found.marks.size() || found.marks[i].kind != mark.kind ||
        !(std::abs(found.marks[i].time - mark.time) < reach))
      return fmt::format("{} at t = {:.6f} missed", name(mark.kind), mark.time);
    worst = std::max(worst, std::abs(found.marks[i].time - mark.time));
  }
  for (std::size_t i = 0; i < expected.impacts.size(); ++i)
    for (std::size_t j = 0; j < expected.impacts[i].size(); ++j) {
      if (j == found.impacts[i].size())
        return fmt::format("impact at t = {:.6f} missed", expected.impacts[i][j]);
      worst = std::max(worst, std::abs(found.impacts[i][j] - expected.impacts[i][j]));
    }
  return {};
}

Errors failed(const std::string &failure) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  return {nan, nan, failure};
}

}  // namespace

double Problem::periods() const {
  return (until - start.time) * scene.omega / (2.0 * std::numbers::pi);
}

std::vector<Problem> problems(const std::filesystem::path &reference) {
  std::vector<Problem> all;
  const std::string states = reference / "work_precision_states.csv";
  const auto events = truth::read_event_tables(reference / "work_precision_events.csv");
  for (const auto &row : truth::read_rows(states, 14)) {
    const auto number = [&](std::size_t i) { return truth::number_in(states, row[i]); };
    Problem &problem = all.emplace_back();
    problem.name = row[0];
    problem.scene = paper::scene_named(row[1]).scene;
    problem.start = {
        number(2), {number(4), number(5)}, {number(6), number(7)}, {row[8] == "1", row[9] == "1"}};
    problem.until = number(3);
    problem.reference_end = {
        number(3), {number(10), number(11)}, {number(12), number(13)}, {false, false}};
    const auto events_of_it = events.find(row[0]);
    if (events_of_it == events.end()) continue;
    for (const truth::TrueEvent &event : events_of_it->second)
      problem.reference_events.push_back(
          {event.time, event.mass, kind_named(event.event), event.velocity_before});
  }
  return all;
}

Errors errors_of(const Result &result, const Problem &problem) {
  if (!result.failure.empty()) return failed(result.failure);
  const double tenth_of_a_period = 0.1 * 2.0 * std::numbers::pi / problem.scene.omega;
  Errors errors{0.0, 0.0};
  for (const int mass : {1, 2}) {
    const Course expected = course_of(problem.reference_events, mass, slowest_impact_compared);
    const std::string difference =
        compare(course_of(result.events, mass, 0.0), expected, tenth_of_a_period, errors.time);
    if (!difference.empty()) return failed(fmt::format("mass {}: {}", mass, difference));
  }
  const TwoMassState &end = result.end, &expected = problem.reference_end;
  for (std::size_t i = 0; i < 2; ++i)
    for (const double error :
         {end.displacement[i] - expected.displacement[i], end.velocity[i] - expected.velocity[i]}) {
      if (!std::isfinite(error)) return failed("the state at the end is not finite");
      errors.state = std::max(errors.state, std::abs(error));
    }
  return errors;
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
  all.left_out.emplace_back("CVODE");
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
