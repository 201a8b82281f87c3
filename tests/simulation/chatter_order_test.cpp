// The order of the extrapolated limit of a chatter: what an impact predicts is off by the square of
// the flight x that follows, without a linear term, and what two predict by its cube. (A table that
// expects a linear term leaves a square there.)
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "reference/scenes/extreme_cases.hpp"
#include "simulation/chatter/limit.hpp"
#include "vibro_impact/simulate.hpp"

namespace {

using namespace vibro_impact;

// The slope of log |error| against log x, through all points.
double slope_of(const std::vector<double> &x, const std::vector<double> &error) {
  double sx = 0.0, sy = 0.0, sxx = 0.0, sxy = 0.0;
  for (std::size_t k = 0; k < x.size(); ++k) {
    const double a = std::log(x[k]), b = std::log(std::abs(error[k]));
    sx += a, sy += b, sxx += a * a, sxy += a * b;
  }
  const auto n = static_cast<double>(x.size());
  return (n * sxy - sx * sy) / (n * sxx - sx * sx);
}

// One mass on a spring, pressed onto its upper stop by a spring force and a forcing that changes,
// every impact resolved: the limit is the time of its stick.
TEST(ChatterOrder, OfTheLimitHasNoLinearTerm) {
  for (const double r : {0.4, 0.5, 0.7}) {
    const Scene scene = extremes::one_mass(0.0, 0.3, 0.28, r, -0.5, -0.7);
    EventRecorder recorder;
    simulate(scene, 20.0, {.resolve_chatter = 0.0}, recorder);
    std::vector<Event> impacts;
    double limit = 0.0;
    for (const Event &event : recorder.events) {
      if (event.kind == EventKind::stick) {
        limit = event.time;
        break;
      }
      impacts.push_back(event);
    }
    ASSERT_GT(limit, 0.0) << r;
    ASSERT_GT(impacts.size(), 15u) << r;
    // By nodes used, less one.
    std::vector<double> flights[2], errors[2];
    ChatterTable table;
    for (std::size_t k = 0; k < impacts.size(); ++k) {
      const double t = impacts[k].time - impacts[0].time,
                   press = 0.3 * std::cos(0.28 * impacts[k].time) + 0.5,
                   x = 2.0 * std::abs(impacts[k].velocity_after) / press;
      if (x > 0.5) continue;
      extend(table, {x, t + x / (1.0 - r), k});
      for (std::size_t n = 0; n < std::min<std::size_t>(2, table.nodes.size()); ++n) {
        const double error = limit_of(table.row[n]) - (limit - impacts[0].time);
        if (std::abs(error) < 1e-12) continue;  // near rounding
        flights[n].push_back(x);
        errors[n].push_back(error);
      }
    }
    for (std::size_t n = 0; n < 2; ++n) {
      ASSERT_GE(flights[n].size(), 3u) << r << " " << n;
      const double slope = slope_of(flights[n], errors[n]);
      fmt::print("r = {}, {} nodes: error ~ x^{:.2f}\n", r, n + 1, slope);
      EXPECT_NEAR(slope, static_cast<double>(n) + 2.0, 0.15) << r;
    }
  }
}

// A mass held beside a chatter feels the jumps of its neighbour through the damper between them. A
// limit is only taken where all jumps to come, r / (1 - r) of the latest, cannot let it go.
TEST(ChatterOrder, JumpsToComeMayNotLetGoANeighbour) {
  constexpr double r = 0.7, jump = 1e-3, jumps_left = jump * r / (1.0 - r);
  Scene scene = paper::figure2();
  scene.beta = 0.1;
  scene.restitution = r;
  scene.stops = {{1, Side::upper, 0.0}, {2, Side::upper, 0.0}};
  // Both at rest at the origin, and a phase of the forcing that presses the second by its share.
  for (const auto &[share, stays] : {std::pair{1.2, false}, {0.5, false}, {3.0, true}}) {
    scene.amplitude = {0.0, share * scene.beta * scene.stiffness[1] * jumps_left};
    const auto pressed = build_contact_mode<Eigen::Dynamic>(scene, Held{0, 1});
    State<Eigen::Dynamic> state;
    state.stops.resize(2);
    set_lanes(state, scene, pressed, start_of(scene));
    Chatter<Eigen::Dynamic> chatter;
    const std::vector<std::size_t> first{0};
    begin(chatter, pressed, first);
    chatter.impacts.times = {0.0};
    chatter.impacts.jumps = {jump};
    EXPECT_EQ(others_stay_clear(chatter, state, 1e-9), stays) << share;
  }
}

}  // namespace
