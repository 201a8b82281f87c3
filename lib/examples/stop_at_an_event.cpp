// A recorder of one's own that ends the run, and the run taken up again: how long does each of the
// first five sticking phases of mass 1 last?
#include <cstdio>

#include "paper_scene.hpp"
#include "vibro_impact/vibro_impact.hpp"

using namespace vibro_impact;

// Ends the run when mass 1 is let go.
struct StickingPhase : Recorder {
  double begun = 0.0, ended = 0.0;

  void event(const Event &event, const Moment &) override {
    if (event.mass != 1) return;
    if (event.kind == EventKind::stick) begun = event.time;
    if (event.kind == EventKind::release) ended = event.time;
  }
  bool done() const override {
    return ended > 0.0;
  }
};

int main() {
  const Scene scene = paper_scene(0.256);  // Figure 4(a)
  StickingPhase first;
  Simulation simulation(scene);
  Outcome outcome = simulation.advance(1000.0, first);
  for (int k = 1; k <= 5 && outcome.ending == Ending::stopped; ++k) {
    std::printf("phase %d: from %.9f to %.9f\n", k, first.begun, first.ended);
    first = {};
    outcome = simulation.advance(1000.0, first);  // as if it had never ended
  }
  return outcome.ending != Ending::stopped || !(first.ended > first.begun);
}
