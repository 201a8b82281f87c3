// The contact modes that a run has met.
#pragma once

#include <memory>
#include <vector>

#include "contact_mode.hpp"

namespace vibro_impact::detail {

// The contact modes of one run. A mode is built when the run enters it. The run keeps the latest
// `most_contact_modes` and drops the mode entered least recently. Copies of a run share the modes,
// which never change.
class ContactModes {
 public:
  // `built` is set to whether the mode had to be built. The mode lives at least until
  // `most_contact_modes` others have been entered.
  const ContactMode &enter(const Scene &scene, const Held &held, bool &built);

 private:
  std::vector<std::shared_ptr<const ContactMode>> recent_;  // the latest entered last
};

}  // namespace vibro_impact::detail
