#include "vibro_impact/analysis/lyapunov.hpp"

#include <algorithm>
#include <boost/math/statistics/univariate_statistics.hpp>
#include <cmath>
#include <vector>

#include "analysis/orbits/motion_state.hpp"
#include "analysis/orbits/orbit_runs.hpp"
#include "analysis/orbits/orbit_tolerances.hpp"
#include "settled_runs.hpp"

namespace vibro_impact {

namespace {

// Whether the sign of the mean growth is certain, from the growth in each block.
bool is_certain(const std::vector<double> &blocks) {
  if (blocks.size() < least_blocks) return false;
  const auto [mean, variance] = boost::math::statistics::mean_and_sample_variance(blocks);
  return std::abs(mean) > least_ratio * std::sqrt(variance / static_cast<double>(blocks.size()));
}

}  // namespace

Growth mean_growth(const Scene &scene, const MotionState &start, int longest,
                   const RunOptions &options) {
  Simulation simulation(scene, options);
  return mean_growth(simulation, start, longest);
}

Growth mean_growth(Simulation &simulation, const MotionState &start, int longest) {
  const Scene &scene = simulation.scene();
  check(scene, start);
  require(longest >= 1, "longest = ", longest, ": must be positive");
  time_after(scene, start, longest);  // refuses a length that cannot be run
  MotionState state = start;
  Eigen::VectorXd perturbation = Eigen::VectorXd::Zero(2 * scene.masses());
  for (const std::size_t row : free_coordinates(start.held))
    perturbation[static_cast<Eigen::Index>(row)] = 1.0;
  perturbation.normalize();
  double logarithm = 0.0, before_block = 0.0;  // of the length, had it never been brought back to 1
  std::vector<double> blocks;                  // growth per forcing period in each block
  int done = 0;
  while (done < longest && !is_certain(blocks)) {
    const int periods = std::min(rescaled_after, longest - done);
    const StroboscopicImage image = stroboscopic_map_and_derivative(simulation, state, periods);
    perturbation = view(image.derivative) * perturbation;
    const double length = perturbation.stableNorm();  // neither overflows nor underflows
    state = image.state;
    done += periods;
    if (length == 0.0) return {-infinity, true};
    perturbation /= length;
    logarithm += std::log(length);
    if (done % block_length != 0) continue;
    blocks.push_back((logarithm - before_block) / block_length);
    before_block = logarithm;
  }
  return {logarithm / (done * Clock(scene.omega).period), is_certain(blocks)};
}

}  // namespace vibro_impact
