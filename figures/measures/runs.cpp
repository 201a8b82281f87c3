#include "runs.hpp"

#include <cmath>

#include "vibro_impact/analysis/locate.hpp"

namespace vibro_impact::figures {

double displacement(const SampleRecorder &samples, std::size_t sample, int mass) {
  return samples.displacements[2 * sample + static_cast<std::size_t>(mass - 1)];
}

Range range_of(const SampleRecorder &samples, int mass) {
  Range range;
  for (std::size_t i = 0; i < samples.times.size(); ++i)
    range.include(displacement(samples, i, mass));
  return range;
}

std::vector<Event> events_of(const Scene &scene, double from, double until,
                             const RunOptions &options) {
  EventRecorder recorder(from, infinity);
  require_complete(simulate(scene, until, options, recorder));
  return recorder.events;
}

double dual_sticks(const Scene &scene, double from, double until) {
  const std::vector<Event> events = events_of(scene, from, until);
  return static_cast<double>(std::ranges::count_if(events, [](const Event &event) {
    return event.kind == EventKind::stick && contact_mode_name(event.held) == "1+2";
  }));
}

int settled_sticking_phases(const Scene &scene, int mass) {
  return sticking_phases(scene, mass, paper::figure4_settling_periods, 4);
}

int followed_sticking_phases(Scene scene, int mass, const MotionState &settled) {
  scene.displacement = settled.displacement;
  scene.velocity = settled.velocity;
  return settled_sticking_phases(scene, mass);
}

Table displacement_table(const SampleRecorder &samples) {
  Table table("t,x1,x2");
  for (std::size_t i = 0; i < samples.times.size(); ++i)
    table.row(samples.times[i], displacement(samples, i, 1), displacement(samples, i, 2));
  return table;
}

Table displacements(const Scene &scene, const paper::AxisBox &box, double every) {
  SampleRecorder samples(box.from, box.to, every);
  require_complete(simulate(scene, samples.to, all_visible_chatter, samples));
  return displacement_table(samples);
}

Table impacts(const Scene &scene, const paper::AxisBox &box) {
  Table table("t,mass,speed");
  for (const Event &event : events_of(scene, box.from, box.to, all_visible_chatter))
    if (event.kind == EventKind::impact)
      table.row(event.time, event.mass, std::abs(event.velocity_before));
  return table;
}

Table parameters(const std::vector<Scene> &scenes) {
  Table table("omega,r,s1,s2");
  for (const Scene &scene : scenes)
    table.row(scene.omega, scene.restitution, scene.stops[0].position, scene.stops[1].position);
  return table;
}

void StickingPhaseRecorder::sample(const Moment &moment) {
  ++asked;
  const double force = moment.hold_force(mass);
  add(std::isnan(force) ? "free" : "orbit", force, moment);
}

void StickingPhaseRecorder::event(const Event &event, const Moment &moment) {
  if (event.mass != mass || event.time < from || event.time > to) return;
  switch (event.kind) {
    case EventKind::impact:
      return;
    case EventKind::stick:
      ++phase;
      return add(name(event.kind), moment.hold_force(mass), moment);
    case EventKind::release:
      return add(name(event.kind), event.by_a_jump ? moment.hold_force(mass) : 0.0, moment);
  }
}

void StickingPhaseRecorder::add(std::string_view kind, double force, const Moment &moment) {
  rows.push_back({phase, kind, moment.instant.phase, force});
  if (other == 0) return;
  rows.back().x = moment.displacement(other);
  rows.back().v = moment.velocity(other);
}

}  // namespace vibro_impact::figures
