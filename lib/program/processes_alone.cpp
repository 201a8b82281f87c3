#include "processes.hpp"

namespace vibro_impact {

Processes::Processes() = default;

Processes::~Processes() = default;

void Processes::share_out(int threads, const ComputeRow &compute,
                          const std::function<void(int, const ComputeRow &)> &use) const {
  use(threads, compute);
}

}  // namespace vibro_impact
