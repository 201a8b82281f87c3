#include "method.hpp"

namespace vibro_impact::comparison {

Methods all_methods() {
  Methods all;
  const auto add = [&](const std::vector<Method> &family) {
    all.methods.insert(all.methods.end(), family.begin(), family.end());
  };
  add(this_library());
  add(plain_event_driven());
  add(odeint());
#ifdef WITH_CVODE
  add(cvode());
#else
  all.left_out.emplace_back("CVODE (SUNDIALS)");
#endif
#ifdef WITH_SICONOS
  add(siconos());
#else
  all.left_out.emplace_back("Siconos");
#endif
  add(stiff_spring());
  return all;
}

}  // namespace vibro_impact::comparison
