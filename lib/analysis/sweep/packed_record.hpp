// A record as bytes, for its way from one process to another.
#pragma once

#include <string>
#include <string_view>

#include "vibro_impact/analysis/orbit_record.hpp"

namespace vibro_impact {

void pack(const OrbitRecord &record, std::string &bytes);

// Takes a record off the front. Throws std::runtime_error when the bytes are not those of a record.
OrbitRecord unpack(std::string_view &bytes);

}  // namespace vibro_impact
