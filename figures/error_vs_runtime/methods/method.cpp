#include "method.hpp"

#include <limits>

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
    problem.start = {row.number("from"),
                     {row.number("x1"), row.number("x2")},
                     {row.number("v1"), row.number("v2")},
                     {row.cell("held1") == "1", row.cell("held2") == "1"}};
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

Error error_of(const Result &result, const Problem &problem) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  if (!result.failure.empty()) return {nan, result.failure};
  const truth::Differences differences =
      truth::compare(result.events, problem.reference_events, problem.scene,
                     {.reach = 0.1 * Clock(problem.scene.omega).period,
                      .slowest_compared = slowest_impact_compared});
  return {differences.first.empty() ? differences.time : nan, differences.first};
}

Methods all_methods() {
  Methods all;
  const auto add = [&](const std::vector<Method> &family) {
    all.methods.insert(all.methods.end(), family.begin(), family.end());
  };
  add(this_library());
  add(by_hand());
  add(plain_event_driven());
  add(dop853());
  add(odeint());
#ifdef WITH_ARKODE
  add(arkode());
#else
  all.left_out.emplace_back("ARKODE");
#endif
  add(stiff_spring());
  return all;
}

}  // namespace vibro_impact::comparison
