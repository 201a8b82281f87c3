// The problems of the work-precision figure, and the error of a run against the 50-digit reference.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "method.hpp"
#include "vibro_impact/record.hpp"

namespace vibro_impact::comparison {

// Reads work_precision_states.csv and work_precision_events.csv from `reference`. Throws
// std::runtime_error naming the file that cannot be read or the scene that is not known.
std::vector<Problem> problems(const std::filesystem::path &reference);

// Impacts of the reference at least this fast are compared, up to the first slower one since the
// mass was last released (or the start): those a method has to resolve, whatever it does with the
// end of a chatter. Flights between them last longer than 0.05.
constexpr double slowest_impact_compared = 1e-2;

// Largest error in the time of a stick, a release or such an impact, and in the displacements and
// velocities at the end. NaN where `failure` says what is missing, what should not be there or why
// the method gave up.
struct Errors {
  double time, state;
  std::string failure = {};
};
Errors errors_of(const Result &result, const Problem &problem);

}  // namespace vibro_impact::comparison
