#include "vibro_impact/analysis/sweep.hpp"

#ifdef _OPENMP
#include <omp.h>
#endif

#include <algorithm>
#include <exception>
#include <map>
#include <mutex>

#include "simulation/for_analysis.hpp"

namespace vibro_impact {

namespace {

using Take = std::function<void()>;

constexpr int most_threads = 1024;

}  // namespace

int available_threads() {
#ifdef _OPENMP
  return std::min(omp_get_max_threads(), most_threads);
#else
  return 1;
#endif
}

void sweep_in_order(std::size_t points, const std::function<Take(std::size_t)> &compute,
                    const SweepOptions &options) {
  require(options.threads >= 0 && options.threads <= most_threads, "threads = ", options.threads,
          ": must lie from 0 to ", most_threads);
  require(options.first <= points, "first = ", options.first, ": there are ", points, " points");
  require(compute != nullptr, "sweep: a function is missing");
  [[maybe_unused]] const int threads = options.threads > 0 ? options.threads : available_threads();
  std::mutex mutex;
  std::size_t end = points, next = options.first, taken = options.first;
  std::map<std::size_t, Take> waiting;  // for points before them
  std::exception_ptr failure;
  const auto take_next = [&] {
    try {
      waiting.extract(waiting.begin()).mapped()();
      ++taken;
      if (options.progress) options.progress(taken);
    } catch (...) {
      failure = std::current_exception();
      end = 0;
    }
  };
#pragma omp parallel num_threads(threads)
  for (std::unique_lock lock(mutex); next < end;) {
    const std::size_t point = next++;
    lock.unlock();
    Take take;
    bool is_error = false;
    try {
      take = compute(point);
      require(take != nullptr, "sweep: nothing that takes point ", point);
    } catch (...) {
      is_error = true;
      take = [error = std::current_exception()] { std::rethrow_exception(error); };
    }
    lock.lock();
    // An error is taken in its turn, too; no point after it is handed out any more.
    if (is_error) end = std::min(end, point + 1);
    waiting.emplace(point, std::move(take));
    while (!failure && !waiting.empty() && waiting.begin()->first == taken) take_next();
  }
  if (failure) std::rethrow_exception(failure);
}

}  // namespace vibro_impact
