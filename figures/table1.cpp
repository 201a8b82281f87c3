// Table I: one motion for each pair of events on the two masses.
#include <fmt/format.h>

#include "driver.hpp"
#include "measures/runs.hpp"
#include "reference/scenes/table1_scenes.hpp"
#include "vibro_impact/analysis/event_pairs.hpp"

namespace {

using namespace vibro_impact;

// The letter of the event of a mass in a pair: G (grazing), S (sticking) or I (impact). The name of
// a mixed pair has that of `mass` first.
std::string event_in(const PairedEvents &pair, int mass) {
  const std::string name = abbreviation(pair.kind);
  return {name[0] == 'D' || mass == pair.other ? name[1] : name[0]};
}

// table1_<pair>.csv has a motion, table1_pairs.csv its stops and when it shows its pair: from `t`
// until `until`, with the masses at x1 and x2 at `t`, and the event of each. table1_scenes.csv has
// their parameters.
void draw(const std::filesystem::path &output) {
  Table pairs("pair,t,until,x1,x2,event1,event2,at_rest");
  std::vector<Scene> scenes;
  for (const auto &[name, scene, from, to] : paper::table1_scenes()) {
    scenes.push_back(scene);
    SampleRecorder samples(from, to, (to - from) / 4000);
    PressedEventRecorder events(scene, from);
    require_complete(simulate(scene, to, figures::all_visible_chatter, samples, events));
    write(figures::displacement_table(samples), output / fmt::format("table1_{}.csv", name));
    for (const PairedEvents &pair : event_pairs(events.events)) {
      if (abbreviation(pair.kind) != name) continue;
      const MotionState state = require_complete(simulate(scene, pair.from)).state;
      pairs.row(name, pair.from, pair.to, state.displacement[0], state.displacement[1],
                event_in(pair, 1), event_in(pair, 2), int{scene.displacement.empty()});
    }
  }
  write(pairs, output / "table1_pairs.csv");
  write(figures::parameters(scenes), output / "table1_scenes.csv");
}

}  // namespace

int main(int argc, char **argv) {
  return vibro_impact::figures::main_of_driver(argc, argv,
                                               "Table I: a motion for each pair of events", draw);
}
