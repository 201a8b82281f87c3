#include "vibro_impact/analysis/sweep.hpp"

#ifdef _OPENMP
#include <omp.h>
#endif

#include <atomic>

#include "simulation/for_analysis.hpp"

namespace vibro_impact {

namespace {

constexpr int most_threads = 1024;
constexpr std::size_t points_per_thread = 32;  // of a block

int threads_of(int asked) {
  return asked > 0 ? asked : available_threads();
}

}  // namespace

int available_threads() {
#ifdef _OPENMP
  return std::min(omp_get_max_threads(), most_threads);
#else
  return 1;
#endif
}

std::size_t block_size(std::size_t points, const SweepOptions &options) {
  require(options.threads >= 0 && options.threads <= most_threads, "threads = ", options.threads,
          ": must lie from 0 to ", most_threads);
  require(options.first <= points, "first = ", options.first, ": there are ", points, " points");
  return points_per_thread * static_cast<std::size_t>(threads_of(options.threads));
}

std::exception_ptr compute_block(std::size_t begin, std::size_t end, [[maybe_unused]] int threads,
                                 const std::function<void(std::size_t point)> &compute) {
  std::exception_ptr failure;
  std::atomic<std::size_t> failed_point = end;  // the first point that failed
#pragma omp parallel for schedule(dynamic) num_threads(threads_of(threads))
  for (std::size_t point = begin; point < end; ++point) {
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
  return failure;
}

}  // namespace vibro_impact
