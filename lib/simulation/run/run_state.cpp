#include "run_state.hpp"

namespace vibro_impact {

Instant instant_of(const RunState &state) {
  require(!state.numbers.empty(), "state of a run: there is none to go on from");
  Row row{.numbers = state.numbers, .reads = true};
  Instant instant;
  row.pass(instant);
  return instant;
}

}  // namespace vibro_impact
