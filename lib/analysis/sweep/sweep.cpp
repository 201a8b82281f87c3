#include "vibro_impact/analysis/sweep.hpp"

#ifdef _OPENMP
#include <omp.h>
#endif

#include <algorithm>
#include <atomic>
#include <cmath>
#include <exception>
#include <utility>

#include "analysis/orbits/motion_state.hpp"

namespace vibro_impact {

namespace {

constexpr int most_threads = 1024;
constexpr std::size_t most_points = std::size_t{1} << 53;  // exact as a double, too

}  // namespace

int available_threads() {
#ifdef _OPENMP
  return std::min(omp_get_max_threads(), most_threads);
#else
  return 1;
#endif
}

void compute_points(std::size_t points, int threads,
                    const std::function<void(std::size_t point)> &compute) {
  require(threads >= 0 && threads <= most_threads, "threads = ", threads, ": must lie from 0 to ",
          most_threads);
  [[maybe_unused]] const int used = threads > 0 ? threads : available_threads();
  std::exception_ptr failure;
  std::atomic<std::size_t> failed_point = points;  // the first point that failed
#pragma omp parallel for schedule(dynamic) num_threads(used)
  for (std::size_t point = 0; point < points; ++point) {
    if (point > failed_point) continue;
    try {
      compute(point);
    } catch (...) {
#pragma omp critical(sweep_failure)
      if (point < failed_point) {
        failed_point = point;
        failure = std::current_exception();
      }
    }
  }
  if (failure) std::rethrow_exception(failure);
}

double Axis::value(std::size_t k) const {
  require(k < count, "value ", k, " of ", parameter, ": there are ", count);
  if (count < 2) return from;
  const double part = static_cast<double>(k) / static_cast<double>(count - 1);
  if (!logarithmic) return std::lerp(from, to, part);
  if (k == 0 || k + 1 == count) return k == 0 ? from : to;
  return std::copysign(std::exp(std::lerp(std::log(std::abs(from)), std::log(std::abs(to)), part)),
                       from);
}

std::size_t Grid::points() const {
  std::size_t product = 1;
  for (const Axis &axis : axes) {
    require(axis.count >= 1, axis.parameter, ": ", axis.count, " values; there must be at least 1");
    require(product <= most_points / axis.count, axis.parameter, ": ", axis.count,
            " values: more points than can be counted");
    product *= axis.count;
  }
  return product;
}

std::vector<double> Grid::values(std::size_t point) const {
  require(point < points(), "point ", point, ": the grid has ", points());
  std::vector<double> found(axes.size());
  for (std::size_t k = axes.size(); k-- > 0; point /= axes[k].count)
    found[k] = axes[k].value(point % axes[k].count);
  return found;
}

Scene Grid::scene_at(std::size_t point) const {
  Scene at = scene;
  const std::vector<double> of_axes = values(point);
  for (std::size_t k = 0; k < axes.size(); ++k)
    at = with(std::move(at), axes[k].parameter, of_axes[k]);
  return at;
}

namespace {

// Starts every mass at 0, or at the stop that 0 lies beyond.
void move_inside(Scene &scene) {
  scene.displacement.assign(scene.mass.size(), 0.0);
  for (const Stop &stop : scene.stops)
    if (stop.mass >= 1 && stop.mass <= scene.masses() && is_beyond(stop, 0.0))
      scene.displacement[static_cast<std::size_t>(stop.mass - 1)] = stop.position;
}

}  // namespace

void check(const Grid &grid) {
  grid.points();
  for (std::size_t k = 0; k < grid.axes.size(); ++k) {
    const Axis &axis = grid.axes[k];
    const std::string &what = axis.parameter;
    get(grid.scene, axis.parameter);
    require(std::isfinite(axis.from) && std::isfinite(axis.to), what, " from ", axis.from, " to ",
            axis.to, ": must be finite");
    require(
        !axis.logarithmic || (axis.from < 0.0 ? axis.to < 0.0 : axis.from > 0.0 && axis.to > 0.0),
        what, " from ", axis.from, " to ", axis.to, ": logarithmic steps need ends of one sign");
    for (std::size_t j = 0; j < k; ++j)
      require(!(grid.axes[j].parameter == axis.parameter), what, ": given twice");
  }
  // The conditions on a scene are bounds that are linear in its scalars. If they hold in the
  // corners of the grid, they hold everywhere.
  // A start beyond a stop is refused at its own point alone.
  const bool starts_vary = std::ranges::any_of(grid.axes, [](const Axis &axis) {
    return axis.parameter.starts_with("displacement") || axis.parameter.starts_with("stop");
  });
  require(grid.axes.size() < 20, grid.axes.size(), " axes: at most 19");
  for (std::size_t corner = 0; corner < std::size_t{1} << grid.axes.size(); ++corner) {
    Scene scene = grid.scene;
    for (std::size_t k = 0; k < grid.axes.size(); ++k) {
      const Axis &axis = grid.axes[k];
      const std::size_t end = (corner >> k) % 2 == 0 ? 0 : axis.count - 1;
      scene = with(std::move(scene), axis.parameter, axis.value(end));
    }
    if (starts_vary) move_inside(scene);
    check(scene);
    require(scene.omega > 0.0, "omega = ", scene.omega, ": a sweep needs a forcing period");
  }
}

}  // namespace vibro_impact
