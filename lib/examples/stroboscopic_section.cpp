// A recorder of one's own that is asked for samples: the state of mass 1 at one phase of the
// forcing, period by period. At a frequency of chaos in Figure 3 the points fill a curve. A motion
// of period n would give n points.
#include <algorithm>
#include <cstdio>
#include <vector>

#include "paper_scene.hpp"
#include "vibro_impact/vibro_impact.hpp"

using namespace vibro_impact;

// The section at `phase` (a part of the period, in [0, 1)) from period `first` on.
struct StroboscopicSection : Recorder {
  struct Point {
    double displacement, velocity;
  };
  double period, phase;
  int first;
  std::vector<Point> points = {};

  StroboscopicSection(double forcing_period, double phase_of_section, int first_period)
      : period(forcing_period), phase(phase_of_section), first(first_period) {
  }

  // The next time at which this recorder asks for a sample.
  double next_time() const override {
    return (first + static_cast<double>(points.size()) + phase) * period;
  }
  void sample(const Moment &moment) override {
    points.push_back({moment.displacement(1), moment.velocity(1)});
  }
};

int main() {
  const Scene scene = paper_scene(0.69);
  StroboscopicSection section(Clock(scene.omega).period, 0.25, 200);
  require_complete(simulate(scene, 1200 * section.period, section));
  std::printf("x1,v1\n");
  for (const auto &point : section.points)
    std::printf("%.12f,%.12f\n", point.displacement, point.velocity);
  const auto [least, greatest] = std::minmax_element(
      section.points.begin(), section.points.end(),
      [](const auto &a, const auto &b) { return a.displacement < b.displacement; });
  return section.points.size() != 1000 || greatest->displacement - least->displacement < 0.01;
}
