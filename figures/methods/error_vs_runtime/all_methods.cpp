#include "method.hpp"

namespace vibro_impact::comparison {

Methods all_methods() {
  const std::vector<Method> of_cvode = cvode(), of_siconos = siconos();
  Methods all;
  for (const auto &family :
       {this_library(), plain_event_driven(), odeint(), of_cvode, of_siconos, stiff_spring()})
    all.methods.insert(all.methods.end(), family.begin(), family.end());
  if (of_cvode.empty()) all.left_out.emplace_back("CVODE (SUNDIALS)");
  if (of_siconos.empty()) all.left_out.emplace_back("Siconos");
  return all;
}

}  // namespace vibro_impact::comparison
