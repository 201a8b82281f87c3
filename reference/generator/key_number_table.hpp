// The key numbers in the table of checked numbers: the generator fills in their references and
// leaves all else as it is.
#pragma once

#include "digits_engine.hpp"
#include "reference/numbers/checked_number.hpp"

#include <string>

namespace vibro_impact_reference {

/// The digits of a key number, by a formula (kind `derived`) or by a run (kind `computed`). Throws
/// std::runtime_error naming the row.
std::string digits_of(DigitsEngine &engine, const numbers::CheckedNumber &number);

/// The digits of the key number with this id. Throws std::runtime_error if there is none.
std::string digits_of(const std::string &id);

/// The whole table.
std::string filled_table();

}  // namespace vibro_impact_reference
