#include "vibro_impact/analysis/lyapunov.hpp"

#include <algorithm>
#include <boost/math/statistics/univariate_statistics.hpp>
#include <cmath>
#include <vector>

#include "analysis/orbits/motion_state.hpp"
#include "analysis/orbits/orbit_tolerances.hpp"
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

Growth mean_growth(const Scene &scene, const MotionState &start, const GrowthOptions &options,
                   const RunOptions &run) {
  check(scene);
  check(scene, start);
  require(options.longest >= 1, "longest = ", options.longest, ": must be positive");
  require(options.error >= 0.0, "error = ", options.error, ": must be non-negative");
  time_after(scene, start, options.longest);  // refuses a length that cannot be run
  MotionState state = start;
  // The perturbation is carried in units of its coordinates, in which its length is taken.
  const Eigen::VectorXd units = coordinate_units(scene, Held(scene.mass.size(), 0));
  Eigen::VectorXd perturbation = Eigen::VectorXd::Zero(units.size());
  perturbation(free_coordinates(start.held)).setOnes();
  perturbation.normalize();
  double logarithm = 0.0, before_block = 0.0;  // of the length, had it never been brought back to 1
  std::vector<double> blocks;                  // growth per time in each block
  int done = 0;
  Growth growth;
  while (done < options.longest && !(growth.error <= options.error)) {
    const int periods = std::min(rescaled_after, options.longest - done);
    const StroboscopicImage image = stroboscopic_map_and_derivative(scene, state, periods, run);
    perturbation = (view(image.derivative) * perturbation.cwiseProduct(units)).cwiseQuotient(units);
    const double length = perturbation.stableNorm();  // neither overflows nor underflows
    state = image.state;
    done += periods;
    if (length == 0.0) return {-infinity, 0.0};
    perturbation /= length;
    logarithm += std::log(length);
    const double period = Clock(scene.omega).period, time = done * period;
    if (done % block_length == 0) {
      blocks.push_back((logarithm - before_block) / (block_length * period));
      before_block = logarithm;
    }
    growth = {logarithm / time, std::max(standard_error(blocks), least_change / time)};
  }
  return growth;
}

}  // namespace vibro_impact
