// A contact mode: which masses are held at which stop. What follows from it here costs O(N) and
// holds for every motion of the mode.
#pragma once

#include <memory>
#include <vector>

#include "chain.hpp"
#include "vibro_impact/counters.hpp"

namespace vibro_impact::detail {

struct ContactMode {
  Held held;
  // m of a free mass, infinity of a held one, which has no acceleration. And its reciprocal.
  List<double> mass, inverse_mass;
  List<Contact> contacts;
  double fastest = 0.0;  // a bound of the rates of the free masses and of the forcing
};

ContactMode build_contact_mode(const Chain &chain, const Held &held);

// The contact modes of one run, built when the run enters them. The latest `most_contact_modes` are
// kept. Copies of a run share them.
class ContactModes {
 public:
  // Counts a mode that had to be built. The mode lives at least until `most_contact_modes` others
  // have been entered.
  const ContactMode &enter(const Chain &chain, const Held &held, Counters &counters);

 private:
  std::vector<std::shared_ptr<const ContactMode>> recent_;  // the latest entered last
};

}  // namespace vibro_impact::detail
