#include "vibro_impact/analysis/lyapunov.hpp"

#include <algorithm>
#include <boost/math/statistics/univariate_statistics.hpp>
#include <cmath>
#include <vector>

#include "analysis/orbits/orbit_tolerances.hpp"
#include "analysis/orbits/tangents.hpp"
#include "vibro_impact/analysis/periodic_orbit.hpp"

namespace vibro_impact {

namespace {

// The standard error of the mean of all blocks.
double standard_error(const std::vector<double> &blocks) {
  if (blocks.size() < least_blocks) return infinity;
  const double variance = boost::math::statistics::sample_variance(blocks);
  return std::sqrt(variance / static_cast<double>(blocks.size()));
}

}  // namespace

Smooth<Growth> mean_growth(const Scene &scene, const MotionState &start,
                           const GrowthOptions &options, const RunOptions &run) {
  check(scene);
  check(scene, start);
  require(options.longest >= 1, "longest = ", options.longest, ": must be positive");
  require(options.error >= 0.0, "error = ", options.error, ": must be non-negative");
  time_after(scene, start, options.longest);  // refuses a length that cannot be run
  // The length of the perturbation is that of motion.hpp.
  const Eigen::VectorXd units = length_units(scene);
  Eigen::VectorXd perturbation = Eigen::VectorXd::Zero(units.size());
  perturbation(free_coordinates(start.held)).setOnes();
  perturbation.normalize();
  Tangents tangents(scene, start, perturbation.cwiseProduct(units));
  Simulation simulation(scene, start, run);
  MotionState state = start;
  double logarithm = 0.0, before_block = 0.0;  // of the length, had it never been brought back to 1
  std::vector<double> blocks;                  // growth per time in each block
  const double period = Clock(scene.omega).period;
  Growth growth;
  for (int done = 0; done < options.longest && !(growth.error <= options.error);) {
    const int periods = std::min(rescaled_after, options.longest - done);
    const Motion motion = next_motion(simulation, state, periods, run);
    tangents.pass(motion.knots);
    state = motion.end();
    done += periods;
    const Smooth<Eigen::MatrixXd> now = tangents.get();
    if (!now.exists()) return Smooth<Growth>::none(now.why_not());
    // It neither overflows nor underflows.
    const double length = now->col(0).cwiseQuotient(units).stableNorm();
    if (length == 0.0) return Growth{-infinity, 0.0};
    if (!std::isfinite(length)) break;  // the motion itself has underflowed
    tangents.scale(1.0 / length);
    logarithm += std::log(length);
    const double time = done * period;
    if (done % block_length == 0) {
      blocks.push_back((logarithm - before_block) / (block_length * period));
      before_block = logarithm;
    }
    growth = {logarithm / time, std::max(standard_error(blocks), least_change / time)};
  }
  return growth;
}

}  // namespace vibro_impact
