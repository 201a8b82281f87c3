// A scene of one's own and its events: three masses, of which the first rattles between two stops
// and the last runs into a plastic one.
#include <cstdio>

#include "vibro_impact/vibro_impact.hpp"

int main() {
  using namespace vibro_impact;
  Scene scene;
  scene.mass = {1.0, 2.0, 1.0};
  scene.stiffness = {1.0, 1.0, 0.5};
  scene.beta = 0.1;
  scene.amplitude = {0.5, 0.0, 0.0};
  scene.omega = 0.4;
  scene.restitution = 0.7;
  scene.stops = {{1, Side::lower, -0.3}, {1, Side::upper, 0.4}, {3, Side::upper, 0.2, 0.0}};

  EventRecorder recorder(90.0);
  const Outcome outcome = simulate(scene, 100.0, recorder);
  for (const Event &event : recorder.events)
    std::printf("t = %.12f  mass %d  %-7s  v = %+.6f  stuck: %s\n", event.time, event.mass,
                name(event.kind), event.velocity_before, contact_mode_name(event.held).c_str());
  std::printf("x(%g) = %.12f %.12f %.12f after %lld impacts\n", outcome.time,
              outcome.state.displacement[0], outcome.state.displacement[1],
              outcome.state.displacement[2], outcome.counters.impacts);
  return recorder.events.empty() || outcome.ending != Ending::reached;
}
