// Takes the place of siconos.cpp where Siconos is not installed.
#include "method.hpp"

namespace vibro_impact::comparison {

std::vector<Method> siconos() {
  return {};
}

}  // namespace vibro_impact::comparison
