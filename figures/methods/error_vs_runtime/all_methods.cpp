#include "method.hpp"

namespace vibro_impact::comparison {

Methods all_methods() {
  Methods all;
  const auto add = [&all](std::vector<Method> family, const char *without) {
    if (family.empty()) all.left_out.emplace_back(without);
    for (Method &method : family) all.methods.push_back(std::move(method));
  };
  add(this_library(), "");
  add(plain_event_driven(), "");
  add(odeint_with_dense_output(), "");
  add(odeint_without_dense_output(), "");
  add(odeint_rosenbrock(), "");
  add(cvode(), "CVODE (SUNDIALS)");
  add(siconos_time_stepping(), "Siconos Moreau-Jean");
  add(siconos_event_driven(), "Siconos LsodarOSI");
  add(stiff_spring(), "");
  return all;
}

}  // namespace vibro_impact::comparison
