// Independent pieces of work on as many threads as OpenMP gives.
#pragma once

#include <cstddef>
#include <exception>

namespace vibro_impact::figures {

// work(0) to work(count - 1), in any order. None may leave a parallel loop with an exception: it is
// thrown when all are done.
template <class Work>
void in_parallel(std::size_t count, const Work &work) {
  std::exception_ptr failure;
#pragma omp parallel for schedule(dynamic)
  for (std::size_t i = 0; i < count; ++i) {
    try {
      work(i);
    } catch (...) {
#pragma omp critical
      failure = std::current_exception();
    }
  }
  if (failure) std::rethrow_exception(failure);
}

}  // namespace vibro_impact::figures
