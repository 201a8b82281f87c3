// What the user is told of a wrong command line or a wrong file.
#pragma once

#include <stdexcept>

namespace vibro_impact::runner {

// One line naming the value and the rule it breaks.
struct BadInput : std::invalid_argument {
  using std::invalid_argument::invalid_argument;
};

}  // namespace vibro_impact::runner
