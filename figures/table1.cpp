// Table I: one motion for each pair of events on the two masses.
#include "table1_scenes.hpp"

#include <fmt/format.h>

#include <cmath>

#include "figures/driver.hpp"
#include "figures/panel.hpp"

namespace {

using namespace vibro_impact;

// Speed of the contact of `mass` at `time`; zero where it has none, that is, where it sticks.
double contact_speed(const std::vector<PressedEvent> &events, int mass, double time) {
  for (const auto &[event, press] : events)
    if (event.kind == EventKind::impact && event.mass == mass && event.time == time)
      return std::abs(event.velocity_before);
  return 0.0;
}

void draw(const std::filesystem::path &output) {
  Table scenes("pair,side1,s1,side2,s2,r,Omega,x1,x2,v1,v2");
  Table pairs("pair,shown,t,until,x1,x2,speed1,speed2");
  for (const figures::PairScene &panel : figures::table1_scenes()) {
    const char *name = abbreviation(panel.kind);
    const Scene &scene = panel.scene;
    const MotionState start = start_of(scene);
    scenes.row(name, sign(scene.stops[0].side), scene.stops[0].position, sign(scene.stops[1].side),
               scene.stops[1].position, scene.restitution, scene.omega, start.displacement[0],
               start.displacement[1], start.velocity[0], start.velocity[1]);

    SampleRecorder samples{
        .from = panel.from, .to = panel.to, .every = (panel.to - panel.from) / 4000};
    PressedEventRecorder events{scene, panel.from};
    require_complete(simulate(scene, panel.to, figures::all_visible_chatter, samples, events));
    write(figures::displacement_table(samples), output / fmt::format("table1_{}.csv", name));
    for (const PairedEvents &pair : event_pairs(events.events)) {
      const MotionState at = figures::state_at(scene, pair.from);
      pairs.row(abbreviation(pair.kind), name, pair.from, pair.to, at.displacement[0],
                at.displacement[1], contact_speed(events.events, pair.mass, pair.from),
                contact_speed(events.events, pair.other, pair.to));
    }
  }
  write(scenes, output / "table1_scenes.csv");
  write(pairs, output / "table1_pairs.csv");
}

}  // namespace

int main(int argc, char **argv) {
  return vibro_impact::figures::drive(argc, argv, "Table I: a motion for each pair of events",
                                      draw);
}
