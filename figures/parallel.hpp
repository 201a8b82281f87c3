// Independent pieces of work on as many threads as a sweep takes.
#pragma once

#include "vibro_impact/analysis/sweep.hpp"

namespace vibro_impact::figures {

// work(0) to work(count - 1), in any order. Throws what the first of them throws.
template <class Work>
void in_parallel(std::size_t count, const Work &work) {
  const std::exception_ptr failure = compute_block(0, count, 0, work);
  if (failure) std::rethrow_exception(failure);
}

}  // namespace vibro_impact::figures
