// Hysteresis of an oscillator with one mass. The forcing frequency rises through the frequency
// 1.1459 at which the free motion grazes the stop, and falls again. Each motion starts where the
// motion at the frequency before has settled. On the way up the motion with impacts lives on.
#include <cstdio>
#include <vector>

#include "vibro_impact/analysis/analysis.hpp"
#include "vibro_impact/vibro_impact.hpp"

int main() {
  using namespace vibro_impact;
  Scene scene{.mass = {1.0},
              .stiffness = {1.0},
              .beta = 0.1,
              .amplitude = {0.1},
              .omega = 1.1,
              .restitution = 0.7,
              .stops = {{1, Side::upper, 0.3}}};
  std::vector<double> frequencies;
  for (int k = 0; k <= 14; ++k) frequencies.push_back(1.1 + 0.025 * k);
  for (int k = 13; k >= 0; --k) frequencies.push_back(1.1 + 0.025 * k);

  MotionState state = start_of(scene);
  std::vector<bool> hits;
  for (const double omega : frequencies) {
    scene.omega = omega;
    const OrbitRecord record = record_of(scene, start_near(scene, state));
    state = record.state;
    hits.push_back(record.counts.impacts[0] > 0);
    std::printf("%.3f %s\n", omega, hits.back() ? "impacts" : "no impacts");
  }
  return !(hits[4] && !hits[24]);  // at 1.2, on the way up and on the way down
}
