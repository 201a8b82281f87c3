// A sweep over the forcing frequency: how often per period does each mass of the paper's Figure 3
// stick, once the motion from rest has settled? The points are shared out among all processors.
#include <cstdio>

#include "paper_scene.hpp"
#include "vibro_impact/analysis/analysis.hpp"
#include "vibro_impact/vibro_impact.hpp"

int main() {
  using namespace vibro_impact;
  const Grid grid{paper_scene(0.25), {{parameter_named("omega"), 0.25, 0.7, 19}}};
  bool some_stick = false, some_do_not = false;
  std::printf("omega,period,sticks1,sticks2\n");
  std::size_t point = 0;
  for (const OrbitRecord &record : sweep(grid)) {
    const double periods = record.counts.periods;
    const std::vector<int> &sticks = record.counts.sticks;
    std::printf("%g,%d,%g,%g\n", grid.values(point++)[0], record.period, sticks[0] / periods,
                sticks[1] / periods);
    some_stick = some_stick || (sticks[0] > 0 && sticks[1] > 0);
    some_do_not = some_do_not || (sticks[0] == 0 && sticks[1] == 0);
  }
  return !(some_stick && some_do_not);  // Section 3.2: sticking below about 0.5, none above
}
