// The axis rule where nothing had to be inferred: the figures whose parameters are printed.
#pragma once

#include <string>
#include <vector>

#include "axis_rule.hpp"
#include "figures/figure3.hpp"
#include "figures/panel.hpp"
#include "reconstruction.hpp"

namespace vibro_impact::figures {

// Impact velocities of Figure 3 on a grid of `count` frequencies. From 181 on the extremes are met
// to a tenth of a tick.
inline std::vector<AxisCheck> checks_of_figure3(int count) {
  Range v1, v2;
  for (double omega : frequencies_of_figure3(count)) {
    const OrbitRecord record = record_of(paper::figure3(omega), recorded_in_figure3(40));
    for (double v : distinct(record.impact_velocities[0])) v1.include(v);
    for (double v : distinct(record.impact_velocities[1])) v2.include(v);
  }
  return {upwards("3(a)", "v1", paper::figure3a_box, v1),
          upwards("3(b)", "v2", paper::figure3b_box, v2)};
}

// Figure 4 shows a sticking phase, or two, and nothing else: its abscissa is data as well.
inline std::vector<AxisCheck> checks_of_figure4(const std::string &panel, const Scene &scene) {
  Range force, time;
  for (const HoldForceRecorder::Row &row : hold_force_rows(scene)) {
    force.include(row.force);
    time.include(row.time);
  }
  return {upwards(panel, "F2", paper::figure4_box, force), across(panel, paper::figure4_box, time)};
}

inline AxisCheck check_of_figure5c() {
  const paper::AxisBox &box = paper::figure5c_box;
  SampleRecorder samples = scan_samples(box);
  require_complete(simulate(paper::figure5c(), box.to, all_visible_chatter, samples));
  return upwards("5(c)", "x", box, range_of(samples));
}

}  // namespace vibro_impact::figures
