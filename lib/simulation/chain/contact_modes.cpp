#include "contact_modes.hpp"

#include <algorithm>

#include "tolerances.hpp"

namespace vibro_impact::detail {

const ContactMode &ContactModes::enter(const Scene &scene, const Held &held, bool &built) {
  const auto latest = std::find_if(recent_.rbegin(), recent_.rend(),
                                   [&held](const auto &mode) { return mode->held == held; });
  built = latest == recent_.rend();
  if (!built) {
    std::rotate(latest.base() - 1, latest.base(), recent_.end());
    return *recent_.back();
  }
  if (recent_.size() == most_contact_modes) recent_.erase(recent_.begin());
  recent_.push_back(std::make_shared<const ContactMode>(build_contact_mode(scene, held)));
  return *recent_.back();
}

}  // namespace vibro_impact::detail
