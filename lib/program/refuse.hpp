// The refusal of a wrong command line or of a file that cannot be used.
#pragma once

#include <fmt/format.h>

#include <stdexcept>
#include <utility>

namespace vibro_impact::runner {

// Throws std::invalid_argument with one line that names the value and the rule it breaks.
template <class... Values>
[[noreturn]] void refuse(fmt::format_string<Values...> line, Values &&...values) {
  throw std::invalid_argument(fmt::format(line, std::forward<Values>(values)...));
}

}  // namespace vibro_impact::runner
