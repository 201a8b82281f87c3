// The checksum of a text that is kept in a file: of the state of a run, of the rows of a sweep.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace vibro_impact {

// FNV-1a: no defence against malice, but against a slip of an editor or a disk.
struct Checksum {
  std::uint64_t value = 14695981039346656037U;

  void add(std::string_view text) {
    for (const char c : text)
      value = (value ^ static_cast<unsigned char>(c)) * std::uint64_t{1099511628211U};
  }
  // In 16 hexadecimal digits.
  std::string text() const {
    std::string digits;
    for (int shift = 60; shift >= 0; shift -= 4)
      digits.push_back("0123456789abcdef"[(value >> shift) & 15U]);
    return digits;
  }
};

}  // namespace vibro_impact
