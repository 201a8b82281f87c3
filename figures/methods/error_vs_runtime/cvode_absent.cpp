// Takes the place of cvode.cpp where SUNDIALS is not installed.
#include "method.hpp"

namespace vibro_impact::comparison {

std::vector<Method> cvode() {
  return {};
}

}  // namespace vibro_impact::comparison
