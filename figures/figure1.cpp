// Figure 1: the chain of Figure 2 at rest, and its motion through two forcing periods of Figure 2.
//
// figure1.csv: a row for each mass, with its forcing amplitude, and the side and place of its stop.
//
// figure1_scenes.csv: the parameters of the scene.
//
// figure1_motion.csv: a row for each frame, with both displacements, and what each mass does.
#include "driver.hpp"
#include "measures/runs.hpp"

namespace {

using namespace vibro_impact;

// Frames are this far apart in time while a mass chatters, and three times as far otherwise.
constexpr double step = 0.2;

// gnuplot reads a piece of another cell where the last cell of a row is empty.
constexpr const char *no_action = "-";

// The action of a mass, by its last event before `time`.
const char *action_of(int mass, double time, const std::vector<Event> &events) {
  const Event *last = nullptr;
  for (const Event &event : events)
    if (event.mass == mass && event.time <= time) last = &event;
  if (last == nullptr) return no_action;
  switch (last->kind) {
    case EventKind::impact:
      return time < last->time + step ? "impact" : "chatters";
    case EventKind::stick:
      return "sticks";
    case EventKind::release:
      return time < last->time + 2.0 ? "released" : no_action;
  }
  return no_action;
}

bool near_an_impact(double time, const std::vector<Event> &events) {
  return std::any_of(events.begin(), events.end(), [time](const Event &event) {
    return event.kind == EventKind::impact && std::abs(event.time - time) < 0.6;
  });
}

void draw(const std::filesystem::path &output) {
  const Scene scene = paper::figure2();
  Table chain("amplitude,side,stop");
  for (const Stop &stop : scene.stops)
    chain.row(scene.amplitude[static_cast<std::size_t>(stop.mass - 1)], sign(stop.side),
              stop.position);
  write(chain, output / "figure1.csv");
  write(figures::parameters({scene}), output / "figure1_scenes.csv");

  const double period = Clock(scene.omega).period, to = paper::panel("figure2a").to;
  const double from = to - 2 * period;
  SampleRecorder samples(from, to, step);
  EventRecorder recorder(from - period, infinity);
  require_complete(simulate(scene, samples.to, figures::all_visible_chatter, samples, recorder));
  Table motion("t,x1,x2,action1,action2");
  for (std::size_t i = 0; i < samples.times.size(); ++i) {
    const double time = samples.times[i];
    if (i % 3 == 0 || near_an_impact(time, recorder.events))
      motion.row(time, figures::displacement(samples, i, 1), figures::displacement(samples, i, 2),
                 action_of(1, time, recorder.events), action_of(2, time, recorder.events));
  }
  write(motion, output / "figure1_motion.csv");
}

}  // namespace

int main(int argc, char **argv) {
  return figures::main_of_driver(argc, argv, "Figure 1: the chain, and its motion in Figure 2",
                                 draw);
}
