#include "processes.hpp"

#include <algorithm>
#include <mutex>

#include "vibro_impact/analysis/sweep.hpp"

namespace vibro_impact {

std::size_t tasks_at_once(std::size_t left, std::size_t processes) {
  return std::max<std::size_t>(left / (8 * processes), 1);
}

void share_out_on_threads(std::size_t tasks, const Processes::Work &work,
                          const Processes::Take &keep) {
  std::mutex mutex;
  const auto send = [&](const std::string &text) {
    const std::lock_guard lock(mutex);
    keep(text);
  };
  compute_points(tasks, 0, [&](std::size_t task) { work(task, send); });
}

}  // namespace vibro_impact
