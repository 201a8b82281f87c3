// An event as it truly happens: of the 50-digit generator or of a closed formula.
#pragma once

#include <string>

namespace vibro_impact::figures {

// At cycle T + time with T the forcing period: a time that is known better than a double could hold
// after 1e6 periods.
struct TrueEvent {
  long long cycle = 0;
  double time = 0.0;
  int mass = 1;
  std::string event;  // impact, stick, release
  double velocity_before = 0.0;
  std::string contact_mode;  // after it: `-`, `1`, `1+2`
};

}  // namespace vibro_impact::figures
