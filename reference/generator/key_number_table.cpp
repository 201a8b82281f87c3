#include "key_number_table.hpp"

#include "formulas.hpp"

#include <fmt/format.h>
#include <fstream>
#include <map>
#include <stdexcept>

namespace vibro_impact_reference {

namespace {

/// The frequencies are known to the width of a bracket, all else to 30 digits.
int known_digits(const std::string &quantity) {
  return quantity.ends_with("_frequency") ? 18 : 30;
}

const std::string checked_numbers_table = REFERENCE_DIR "/checked_numbers.csv";

}  // namespace

std::string digits_of(DigitsEngine &engine, const numbers::CheckedNumber &number) {
  using Formula = Real (*)(const Arguments &);
  static const std::map<std::string, Formula> formulas{{"eigenvalue", eigenvalue},
                                                       {"mode_shape", mode_shape},
                                                       {"exit_slope", exit_slope},
                                                       {"exit_intercept", exit_intercept},
                                                       {"interval", bounce_interval}};
  try {
    if (number.kind == "derived")
      return formulas.at(number.quantity)(number.arguments).str(known_digits(number.quantity));
    return numbers::answer(engine, quantities_in_digits(), number.quantity, number.arguments)
        .str(known_digits(number.quantity));
  } catch (const std::exception &error) {
    throw std::runtime_error(
        fmt::format("{}, {} {}: {}", number.id, number.quantity, number.given, error.what()));
  }
}

std::string filled_table() {
  const auto known = numbers::read_numbers(checked_numbers_table);
  std::ifstream file = vibro_impact::truth::opened(checked_numbers_table);
  std::string table, line;
  std::getline(file, line);
  table = line + '\n';
  DigitsEngine engine;
  for (const numbers::CheckedNumber &number : known) {
    std::getline(file, line);
    const auto comma = line.find(','), rest = line.find(',', comma + 1);
    const std::string digits = number.of_the_paper() ? digits_of(engine, number) : number.digits;
    table += number.id + ',' + digits + line.substr(rest) + '\n';
  }
  return table;
}

std::string digits_of(const std::string &id) {
  DigitsEngine engine;
  for (const numbers::CheckedNumber &number : numbers::read_numbers(checked_numbers_table))
    if (number.id == id && number.of_the_paper()) return digits_of(engine, number) + '\n';
  throw std::runtime_error("key number '" + id + "': the table has no such row");
}

}  // namespace vibro_impact_reference
