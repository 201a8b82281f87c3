// Takes the place of the Siconos methods where Siconos is not installed.
#include "method.hpp"

namespace vibro_impact::comparison {

std::vector<Method> siconos_time_stepping() {
  return {};
}

std::vector<Method> siconos_event_driven() {
  return {};
}

}  // namespace vibro_impact::comparison
