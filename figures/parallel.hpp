// Independent pieces of work on as many threads as a sweep takes.
#pragma once

#include "vibro_impact/analysis/sweep.hpp"

namespace vibro_impact::figures {

// work(0) to work(count - 1), in any order. Throws what the first of them throws.
template <class Work>
void in_parallel(std::size_t count, const Work &work) {
  sweep_in_order(count, [&](std::size_t i) -> std::function<void()> {
    work(i);
    return [] {};
  });
}

}  // namespace vibro_impact::figures
