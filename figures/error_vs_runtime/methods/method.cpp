#include "method.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "reference/scenes/extreme_scenes.hpp"
#include "reference/scenes/paper_scenes.hpp"
#include "reference/truth/event_comparison.hpp"
#include "reference/truth/event_reader.hpp"
#include "reference/truth/table_reader.hpp"

namespace vibro_impact::comparison {

std::vector<Problem> problems(const std::filesystem::path &reference) {
  std::vector<Problem> all;
  const std::string states = reference / "work_precision_states.csv";
  const auto events = truth::read_event_tables(reference / "work_precision_events.csv", "problem");
  for (const auto &row : truth::read_rows(states)) {
    const std::string name = row.cell("problem"), scene = row.cell("scene");
    Problem &problem = all.emplace_back();
    problem.name = name;
    problem.scene = paper::scene_named(scene).scene;
    problem.from = row.number("from");
    problem.start = {instant_at(problem.from, Clock(problem.scene.omega)),
                     {row.number("x1"), row.number("x2")},
                     {row.number("v1"), row.number("v2")},
                     Held(2, 0)};
    for (const std::size_t i : {0u, 1u})
      if (row.cell("held" + std::to_string(i + 1)) == "1")
        problem.start.held[i] = static_cast<signed char>(problem.scene.stops[i].side);
    problem.until = row.number("until");
    if (const auto its_events = events.find(name); its_events != events.end()) {
      problem.reference_events = its_events->second;
    } else {  // a motion from rest is the beginning of the motion in the table of its scene
      problem.reference_events = truth::read_event_table(reference / (scene + "_events.csv"));
      std::erase_if(problem.reference_events,
                    [&](const Event &event) { return event.time > problem.until; });
    }
  }
  return all;
}

Problem chain_problem(const std::filesystem::path &reference, int masses) {
  Problem problem{.name = fmt::format("chain{}", masses),
                  .scene = extremes::chain_of_stops(masses)};
  problem.start = start_of(problem.scene);
  problem.until = 2.0 * Clock(problem.scene.omega).period;
  problem.reference_events = truth::read_event_table(reference / (problem.name + "_events.csv"));
  return problem;
}

double runs_counted(const Problem &problem) {
  return std::max(1.0, (problem.until - problem.from) / Clock(problem.scene.omega).period);
}

void Result::record(double time, std::size_t i, EventKind kind, double velocity) {
  events.push_back(event_at(time, static_cast<int>(i) + 1, kind, velocity));
}

void Result::count_impact(double time, std::size_t i, double speed) {
  constexpr long long at_most = 20'000;
  if (++impacts > at_most)
    failure = fmt::format("more than {} impacts up to t = {:.6f} (mass {}, speed {:.2g})", at_most,
                          time, i + 1, speed);
}

Error error_of(const Result &result, const Problem &problem) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  if (!result.failure.empty()) return {nan, result.failure};
  const truth::Differences differences =
      truth::compare(result.events, problem.reference_events, problem.scene,
                     {.reach = 0.1 * Clock(problem.scene.omega).period,
                      .slowest_compared = slowest_impact_compared});
  return {differences.first.empty() ? differences.time : nan, differences.first};
}

std::vector<Method> all_methods() {
  std::vector<Method> all;
  const auto add = [&](const std::vector<Method> &family) {
    all.insert(all.end(), family.begin(), family.end());
  };
  add(this_library());
  add(by_hand());
  add(plain_event_driven());
  add(dop853());
  add(odeint());
  add(stiff_spring());
  return all;
}

}  // namespace vibro_impact::comparison
