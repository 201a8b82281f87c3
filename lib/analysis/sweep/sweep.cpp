#include "vibro_impact/analysis/sweep.hpp"

#ifdef _OPENMP
#include <omp.h>
#endif

#include <algorithm>
#include <exception>
#include <map>
#include <mutex>
#include <optional>

#include "simulation/for_analysis.hpp"

namespace vibro_impact {

namespace {

using Take = std::function<void()>;

// Hands out the points and takes what has been computed, in their order.
class InOrder {
 public:
  InOrder(std::size_t points, const SweepOptions &options)
      : end_(points), next_(options.first), taken_(options.first), progress_(options.progress) {
  }

  std::optional<std::size_t> next_point() {
    const std::lock_guard lock(mutex_);
    if (next_ >= end_) return std::nullopt;
    return next_++;
  }

  // An error is taken in its turn, too; no point after it is handed out any more.
  void hand_in(std::size_t point, Take take, bool is_error) {
    const std::lock_guard lock(mutex_);
    if (is_error) end_ = std::min(end_, point + 1);
    waiting_.emplace(point, std::move(take));
    while (!failure_ && !waiting_.empty() && waiting_.begin()->first == taken_) take_next();
  }

  void rethrow() const {
    if (failure_) std::rethrow_exception(failure_);
  }

 private:
  std::mutex mutex_;
  std::size_t end_, next_, taken_;
  std::map<std::size_t, Take> waiting_ = {};  // for points before them
  std::exception_ptr failure_ = nullptr;
  const std::function<void(std::size_t)> &progress_;

  void take_next() {
    try {
      waiting_.extract(waiting_.begin()).mapped()();
      ++taken_;
      if (progress_) progress_(taken_);
    } catch (...) {
      failure_ = std::current_exception();
      end_ = 0;
    }
  }
};

void work(InOrder &in_order, const std::function<Take(std::size_t)> &compute) {
  while (const auto point = in_order.next_point()) {
    Take take;
    bool is_error = false;
    try {
      take = compute(*point);
    } catch (...) {
      is_error = true;
      take = [failure = std::current_exception()] { std::rethrow_exception(failure); };
    }
    in_order.hand_in(*point, std::move(take), is_error);
  }
}

}  // namespace

int available_threads() {
#ifdef _OPENMP
  return omp_get_max_threads();
#else
  return 1;
#endif
}

void sweep_in_order(std::size_t points, const std::function<Take(std::size_t)> &compute,
                    const SweepOptions &options) {
  require(options.threads >= 0, "threads = ", options.threads, ": must be non-negative");
  require(compute != nullptr, "sweep: a function is missing");
  [[maybe_unused]] const int threads = options.threads > 0 ? options.threads : available_threads();
  InOrder in_order(points, options);
#pragma omp parallel num_threads(threads)
  work(in_order, compute);
  in_order.rethrow();
}

}  // namespace vibro_impact
