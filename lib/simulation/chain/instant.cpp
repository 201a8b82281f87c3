#include "vibro_impact/instant.hpp"

#include "require.hpp"

namespace vibro_impact {

void refuse_omega(double omega) {
  throw std::invalid_argument(line("omega = ", omega, ": must be non-negative and finite"));
}

void refuse_time(double time) {
  throw std::invalid_argument(
      line("time ", time, ": more forcing periods than double precision can count"));
}

}  // namespace vibro_impact
