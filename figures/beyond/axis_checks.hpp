// The axis rule where nothing had to be inferred: the figures whose parameters are printed.
#pragma once

#include <string>
#include <vector>

#include "axis_rule.hpp"
#include "figures/figure3.hpp"
#include "figures/hold_force.hpp"
#include "reconstruction.hpp"

namespace vibro_impact::figures {

// One axis of a panel: as printed, and the data it should fill.
struct AxisCheck {
  std::string panel, quantity;
  Range axis;
  double tick;
  Range data;

  bool passes() const {
    return fills(data, axis, tick);
  }
};

// Impact velocities of Figure 3 on a grid of `count` frequencies. From 181 on the extremes are met
// to a tenth of a tick.
inline std::vector<AxisCheck> checks_of_figure3(int count) {
  Range v1, v2;
  for (double omega : frequencies_of_figure3(count)) {
    const auto velocities = impact_velocities(omega, 40);
    for (double v : velocities[0]) v1.include(v);
    for (double v : velocities[1]) v2.include(v);
  }
  const paper::AxisBox &a = paper::figure3a_box, &b = paper::figure3b_box;
  return {{"3(a)", "v1", ordinate(a), a.tick, v1}, {"3(b)", "v2", ordinate(b), b.tick, v2}};
}

// Figure 4 shows a sticking phase, or two, and nothing else: its abscissa is data as well.
inline std::vector<AxisCheck> checks_of_figure4(const std::string &panel, const Scene &scene) {
  const paper::AxisBox &box = paper::figure4_box;
  Range force, time;
  for (const HoldForceRecorder::Row &row : hold_force_rows(scene)) {
    force.include(row.force);
    time.include(row.time);
  }
  return {{panel, "F2", ordinate(box), box.tick, force},
          {panel, "t", abscissa(box), box.tick_across, time}};
}

inline AxisCheck check_of_figure5c() {
  const paper::AxisBox &box = paper::figure5c_box;
  SampleRecorder samples = scan_samples(box);
  require_complete(simulate(paper::figure5c(), box.to, scan_options(), samples));
  return {"5(c)", "x", ordinate(box), box.tick, range_of(samples)};
}

// The figures whose frequencies had to be inferred, at any frequency.
inline std::vector<AxisCheck> checks_of_figure2(double omega) {
  const Figure2Trial trial = try_figure2(omega);
  const paper::AxisBox &a = paper::figure2a_box, &b = paper::figure2b_box;
  return {{"2(a)", "x", ordinate(a), a.tick, trial.shown},
          {"2(b)", "x2", ordinate(b), b.tick, trial.close_up},
          {"2(b)", "t", abscissa(b), b.tick_across, {trial.begins, trial.complete}}};
}

inline AxisCheck check_of_figure5a(double omega) {
  const paper::AxisBox &box = paper::figure5a_box;
  return {"5(a)", "x", ordinate(box), box.tick, try_figure5a(omega).shown};
}

inline AxisCheck check_of_figure5b(double omega) {
  const paper::AxisBox &box = paper::figure5b_box;
  return {"5(b)", "x", ordinate(box), box.tick, try_figure5b(omega).shown};
}

}  // namespace vibro_impact::figures
