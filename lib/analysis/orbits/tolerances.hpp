// Every tolerance of the analysis but for those that its callers choose. Why each is what it is:
// the table in lib/README.md.
#pragma once

#include <cstddef>

namespace vibro_impact {

constexpr double tangents_to_motion = 0.01;     // of the tolerance of a chatter limit
constexpr double short_flight = 0.5;            // of the fastest rate: changes go by the series
constexpr std::size_t most_tangent_nodes = 16;  // of the extrapolation of tangents
constexpr double tangent_node_ratio = 0.81;     // of the speed from node to node, at most

constexpr double simultaneous = 1e-6;  // time between events of a pair
constexpr double slow_contact = 1e-6;  // speed of a contact that may be grazing
constexpr double pulled_off = 1e-9;    // force on it

constexpr double repeats = 1e-12;        // distance of two sections, in the state
constexpr double same_section = 10.0;    // distance, in tolerances of what is still to come
constexpr double not_decided = 1e4;      // likewise
constexpr double sections_apart = 1e-6;  // distance of two sections of one orbit

constexpr long long rescaled_after = 8;  // forcing periods
constexpr long long block_length = 40;   // forcing periods
constexpr std::size_t least_blocks = 4;  // of a mean growth
constexpr double least_ratio = 4.0;      // of the mean to its standard error
constexpr int most_averaged = 1000;      // forcing periods

constexpr double by_derivative = 1e-10;  // of a parameter, the last step to a curve from one side
constexpr double first_margin = 1e-9;    // of a parameter, beside a guess
constexpr double last_margin = 2e-3;     // likewise
constexpr double near_border = 0.2;      // of the way to the ratio of speeds of another chatter
constexpr double not_far_off = 0.5;      // likewise
constexpr double longest_step = 0.1;     // of Newton's method for a border orbit, in the plane
constexpr double last_step = 3e-15;      // likewise
constexpr double rounding_step = 1e-11;  // from which on steps need to become shorter

constexpr double curvature_step = 1e-3;  // of a flight between two nodes
constexpr double one_sided = 1e-10;      // last step of zero_from_one_side, in the value

}  // namespace vibro_impact
