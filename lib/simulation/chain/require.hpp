// Messages of one line, and the refusal of bad input with a message that names the value and the
// rule.
#pragma once

#include <array>
#include <charconv>
#include <concepts>
#include <stdexcept>
#include <string>
#include <string_view>

namespace vibro_impact::detail {

inline void append(std::string &text, std::string_view piece) {
  text += piece;
}

// Appends the shortest digits that determine the number.
template <class Number>
requires std::integral<Number> || std::floating_point<Number>
void append(std::string &text, Number number) {
  std::array<char, 32> digits{};
  text.append(digits.data(), std::to_chars(digits.begin(), digits.end(), number).ptr);
}

// Joins texts and numbers to one text.
template <class... Pieces>
std::string line(const Pieces &...pieces) {
  std::string text;
  (append(text, pieces), ...);
  return text;
}

// Throws std::invalid_argument unless `holds`. The message is made only then, because scenes are
// checked before every run.
template <class... Pieces>
void require(bool holds, const Pieces &...pieces) {
  if (!holds) throw std::invalid_argument(line(pieces...));
}

inline void require_mass(int mass, int masses) {
  require(mass >= 1 && mass <= masses, "mass ", mass, ": the chain has masses 1 to ", masses);
}

}  // namespace vibro_impact::detail
