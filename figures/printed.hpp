// What the paper's print can tell of a number, and the verdict on it that follows.
#pragma once

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <string>

namespace vibro_impact::figures {

// The paper's words, the value they state, and the values that it cannot be told from. No words:
// the paper does not have the number.
struct Printed {
  std::string words = {};
  double value = 0.0, from = 0.0, to = 0.0;

  bool silent() const {
    return words.empty();
  }
};

// A decimal number, known to half a unit of its last digit.
inline Printed digits(const std::string &number) {
  const auto point = number.find('.');
  const auto decimals = point == std::string::npos ? 0 : number.size() - point - 1;
  const double value = std::stod(number), half = 0.5 * std::pow(10.0, -static_cast<int>(decimals));
  return {number, value, value - half, value + half};
}

// Two values between which the text or the ticks of an axis put it.
inline Printed between(const std::string &low, const std::string &high) {
  const double from = std::stod(low), to = std::stod(high);
  return {low + " to " + high, 0.5 * (from + to), from, to};
}

// A frequency that the text reads off Figure 3, whose ticks stand 0.05 apart: a twentieth of that,
// half a millimetre on the page, can still be told.
inline Printed read_off_figure3(const std::string &number) {
  const double value = std::stod(number), half = 0.05 / 20.0;
  return {"about " + number, value, value - half, value + half};
}

// A statement that leaves no room: a count, a mass that touches its stop.
inline Printed exactly(const std::string &words, double value) {
  return {words, value, value, value};
}

// A statement that something happens, against the count of it.
inline Printed at_least_once(const std::string &words) {
  return {words, 1.0, 1.0, std::numeric_limits<double>::infinity()};
}

enum class Verdict { agrees, differs, not_in_the_paper };

inline Verdict verdict_on(const Printed &printed, double computed) {
  if (printed.silent()) return Verdict::not_in_the_paper;
  return computed >= printed.from && computed <= printed.to ? Verdict::agrees : Verdict::differs;
}

// In words; a number that differs, by how much from what is printed.
inline std::string in_words(const Printed &printed, double computed) {
  switch (verdict_on(printed, computed)) {
    case Verdict::agrees:
      return "agrees with the paper";
    case Verdict::differs:
      return fmt::format("differs from the paper by {:+.2g}", computed - printed.value);
    default:
      return "not in the paper";
  }
}

}  // namespace vibro_impact::figures
