#include "processes.hpp"

namespace vibro_impact {

Processes::Processes(int &, char **&) {
}

Processes::~Processes() = default;

Ranks Processes::ranks() const {
  return {rank_, size_, {}, {}};
}

long long Processes::said_by_rank_0(long long value) const {
  return value;
}

}  // namespace vibro_impact
