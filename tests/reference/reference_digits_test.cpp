// The thirty digits of reference/located.csv: what the same generator finds with a hundred.
#include <gtest/gtest.h>

#include <boost/multiprecision/cpp_bin_float.hpp>

#include <map>
#include <string>

#include "reference/table_reader.hpp"

namespace {

using Digits = boost::multiprecision::cpp_bin_float_50;

struct Row {
  Digits value, error;
};

std::map<std::string, Row> located(const std::string &name) {
  const std::string path = std::string(REFERENCE_DIR "/") + name;
  std::ifstream file = vibro_impact::figures::opened(path);
  std::map<std::string, Row> rows;
  for (const auto &cells : vibro_impact::figures::read_rows(file, path, 6))
    rows[cells[0]] = {Digits(cells[1]), Digits(cells[3])};
  return rows;
}

// The estimate of the error holds what rounding to thirty digits takes away. Every number agrees
// within it, and it is a unit in the thirtieth digit or less.
TEST(LocatedNumbers, AgreeInThirtyDigitsWithAHundred) {
  const auto fifty = located("located.csv"), hundred = located("located_100.csv");
  ASSERT_EQ(fifty.size(), hundred.size());
  EXPECT_GE(fifty.size(), 28u);
  for (const auto &[symbol, row] : fifty) {
    const Digits difference = abs(row.value - hundred.at(symbol).value);
    EXPECT_LE(difference, row.error) << symbol;
    EXPECT_LE(row.error, Digits("1.05e-30") * abs(row.value)) << symbol;
  }
}

}  // namespace
