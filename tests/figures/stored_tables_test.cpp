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
  // What is said of the first table beside the second, stored.
  std::string between(const std::string &fresh, const std::string &stored) const {
    const auto kept = written("table.extract", extract(written("stored.csv", stored), 1e300));
    return difference(extract(written("fresh.csv", fresh), 1e300), kept, 1e-6);
  }
};

TEST_F(StoredTables, AreKeptInAFewRowsFirstAndLastAmongThem) {
  std::string text = "t,x\n";
  for (int i = 0; i <= 1000; ++i) text += std::to_string(i) + "," + std::to_string(i * i) + "\n";
  const auto table = written("long.csv", text);
  EXPECT_EQ(extract(table, 1e300, 5),
            "row of 1001,t,x\n0,0,0\n250,250,62500\n500,500,250000\n750,750,562500\n"
            "1000,1000,1000000\n");
  EXPECT_EQ(extract(table, 100.0, 3), "row of 101,t,x\n0,0,0\n50,50,2500\n100,100,10000\n");
}

TEST_F(StoredTables, DifferByTheirNumbersAndByAllElse) {
  const std::string stored = "t,x,kind\n0,4,impact\n1,-2,stick\n";
  EXPECT_EQ(between(stored, stored), "");
  EXPECT_EQ(between("t,x,kind\n0,4,impact\n1,-2.000001,stick\n", stored), "") << "5e-7 of it";
  EXPECT_EQ(between("t,x,kind\n9e-8,4,impact\n1,-2,stick\n", stored), "") << "near zero";
  EXPECT_NE(between("t,x,kind\n0,4,impact\n1,-2.00001,stick\n", stored), "");
  EXPECT_NE(between("t,x,kind\n2e-7,4,impact\n1,-2,stick\n", stored), "");
  EXPECT_NE(between("t,x,kind\n0,4,impact\n", stored), "");
  EXPECT_NE(between("t,v,kind\n0,4,impact\n1,-2,stick\n", stored), "");
  EXPECT_NE(between("t,x,kind\n0,4,impact\n1,-2,release\n", stored), "");
  EXPECT_NE(between("t,x,kind\n0,4,impact\n1,nan,stick\n", stored), "");
  EXPECT_NE(difference("t\n", folder / "not_there.extract", 1.0), "");
}

TEST_F(StoredTables, FollowTheRuleOfTheLongestNameThatFits) {
  const Rules rules =
      read_rules(written("rules.csv",
                         "table,tolerance,until,reason\n,1e-9,,all\n"
                         "figure3,1e-6,0.5,\"chaos, then\"\nfigure3b,not compared,,b\n"));
  EXPECT_EQ(rule_for(rules, "figure2.csv").tolerance, 1e-9);
  EXPECT_EQ(rule_for(rules, "figure3a.csv").until, 0.5);
  EXPECT_FALSE(rule_for(rules, "figure3b.csv").tolerance);
}

}  // namespace
