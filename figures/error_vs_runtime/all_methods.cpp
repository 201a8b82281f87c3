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
  add(cvode(), "CVODE left out: SUNDIALS (libsundials-dev) was not found when this was built");
  const char *const siconos =
      "left out: Siconos (libsiconos-kernel-dev) was not found when this was built";
  add(siconos_time_stepping(), (std::string("Siconos Moreau-Jean ") + siconos).c_str());
  add(siconos_event_driven(), (std::string("Siconos LsodarOSI ") + siconos).c_str());
  add(stiff_spring(), "");
  return all;
}

}  // namespace vibro_impact::comparison
