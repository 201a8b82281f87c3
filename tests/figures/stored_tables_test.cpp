// The comparison of a fresh run with the stored one: what it lets pass and what it does not.
#include "figures/stored_tables.hpp"

#include <gtest/gtest.h>

#include <fstream>

namespace {

using namespace vibro_impact::figures;

// A folder of its own for each test, gone afterwards.
struct StoredTables : ::testing::Test {
  std::filesystem::path folder =
      std::filesystem::path(::testing::TempDir()) /
      (std::string("stored_") + ::testing::UnitTest::GetInstance()->current_test_info()->name());

  StoredTables() {
    std::filesystem::remove_all(folder);
    std::filesystem::create_directories(folder);
  }
  ~StoredTables() override {
    std::filesystem::remove_all(folder);
  }
  std::filesystem::path written(const std::string &name, const std::string &text) const {
    std::ofstream(folder / name) << text;
    return folder / name;
  }
  Extract of(const std::string &text) const {
    return extract(written("table.csv", text), 41, 1e300);
  }
};

TEST_F(StoredTables, AreSummedAsSha256sumDoes) {
  written("a.csv", "abc");  // FIPS 180-2, appendix B.1
  written("left_out.pdf", "abc");
  const Sums sums = sums_of(folder, "here");
  ASSERT_EQ(sums.of.size(), 1u);
  EXPECT_EQ(sums.of.at("a.csv"),
            "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  const Sums again = read_sums(written("SHA256SUMS", text_of(sums)));
  EXPECT_EQ(again.of, sums.of);
  EXPECT_EQ(again.platform, "here");
}

TEST_F(StoredTables, AreKeptInAFewRowsFirstAndLastAmongThem) {
  std::string text = "t,x\n";
  for (int i = 0; i <= 1000; ++i) text += std::to_string(i) + "," + std::to_string(i * i) + "\n";
  const auto table = written("long.csv", text);
  const Extract whole = extract(table, 5, 1e300);
  EXPECT_EQ(whole.numbers, (std::vector<std::size_t>{0, 250, 500, 750, 1000}));
  EXPECT_EQ(whole.rows_in_all, 1001u);
  EXPECT_EQ(whole.rows.back(), (std::vector<std::string>{"1000", "1000000"}));
  const Extract beginning = extract(table, 5, 100.0);
  EXPECT_EQ(beginning.rows_in_all, 101u);
  EXPECT_EQ(beginning.numbers.back(), 100u);
  const Extract again = read_extract(written("long.extract", text_of(whole)));
  EXPECT_EQ(again.header, whole.header);
  EXPECT_EQ(again.numbers, whole.numbers);
  EXPECT_EQ(again.rows, whole.rows);
  EXPECT_EQ(again.rows_in_all, whole.rows_in_all);
}

TEST_F(StoredTables, DifferByTheirNumbersAndByAllElse) {
  const Extract stored = of("t,x,kind\n0,4,impact\n1,-2,stick\n");
  EXPECT_EQ(difference(stored, stored).largest, 0.0);
  const Difference off = difference(of("t,x,kind\n0,4,impact\n1,-2.001,stick\n"), stored);
  EXPECT_NEAR(off.largest, 0.001 / 4.0, 1e-15);  // of the largest of the column
  EXPECT_EQ(off.where, "row 1, column 2");
  EXPECT_EQ(off.reason, "");
  EXPECT_NE(difference(of("t,x,kind\n0,4,impact\n"), stored).reason, "");
  EXPECT_NE(difference(of("t,v,kind\n0,4,impact\n1,-2,stick\n"), stored).reason, "");
  EXPECT_NE(difference(of("t,x,kind\n0,4,impact\n1,-2,release\n"), stored).reason, "");
  EXPECT_NE(difference(of("t,x,kind\n0,4,impact\n1,nan,stick\n"), stored).reason, "");
}

TEST_F(StoredTables, DifferByTheirErrorsAsNumbersOfOrderOne) {
  const Extract stored = of("omega,error\n0.25,1e-16\n");
  EXPECT_NEAR(difference(of("omega,error\n0.25,3e-16\n"), stored).largest, 2e-16, 1e-30);
  EXPECT_NEAR(difference(of("omega,error\n0.25,1e-3\n"), stored).largest, 1e-3, 1e-12);
}

TEST_F(StoredTables, FollowTheRuleOfTheLongestNameThatFits) {
  const Rules rules =
      read_rules(written("rules.csv",
                         "table,tolerance,until,reason\n,1e-9,,all\n"
                         "figure3,1e-6,0.5,\"chaos, then\"\nfigure3b,not compared,,b\n"));
  EXPECT_EQ(rule_for(rules, "figure2.csv").tolerance, 1e-9);
  EXPECT_EQ(rule_for(rules, "figure3a.csv").until, 0.5);
  EXPECT_EQ(rule_for(rules, "figure3a.csv").reason, "chaos, then");
  EXPECT_FALSE(rule_for(rules, "figure3b.csv").compared);
}

}  // namespace
