// The checksum of a file of text.
#pragma once

#include <fmt/format.h>

#include <cstdint>
#include <string>
#include <string_view>

namespace vibro_impact::runner {

// FNV-1a: no defence against malice, but against a slip of an editor or a disk.
struct Checksum {
  std::uint64_t value = 14695981039346656037U;

  void add(std::string_view text) {
    for (const char c : text)
      value = (value ^ static_cast<unsigned char>(c)) * std::uint64_t{1099511628211U};
  }
  std::string text() const {
    return fmt::format("{:016x}", value);
  }
};

}  // namespace vibro_impact::runner
