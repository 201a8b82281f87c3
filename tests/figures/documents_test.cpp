// The comparison of the documents with what `check` computes: an edited number is found, a computed
// part is written anew, and nothing else changes.
#include "figures/check/documents.hpp"

#include <gtest/gtest.h>

namespace {

using namespace vibro_impact::figures;

using vibro_impact::numbers::Claim, vibro_impact::numbers::Printed;

Finding checked(const std::string &id, const Printed &printed, double computed) {
  vibro_impact::numbers::CheckedNumber number;
  number.id = id;
  number.source = "wagg";
  number.meaning = "of " + id;
  number.format = ".0e";
  number.printed = printed;
  return {number, computed};
}

// Two key numbers, of which the second differs from the paper.
Results results() {
  return {{checked("start", {"715 to 716", Claim::stated, 715.0, 716.0}, 715.561564510661),
           checked("gap", {"it grazes", Claim::stated, 0.0, 0.0}, 7.53817007e-05)},
          {}};
}

using Words = std::vector<std::string>;

TEST(Documents, ANumberOfFiveDigitsThatIsNoKeyNumberIsFound) {
  const auto unknown = [](const std::string &text) { return unknown_numbers(results(), text); };
  EXPECT_EQ(unknown("from 715.5616 to 715.5617, 715.56156 and -715.561564511"), Words{"715.5617"});
  EXPECT_EQ(unknown("a gap of 7.5382e-05, not 7.5381e-05"), Words{"7.5381e-05"});
  EXPECT_EQ(unknown("0.29655-0.33098"), (Words{"0.29655", "0.33098"}));
  EXPECT_EQ(unknown("four digits: 0.2561, 12.33, 0.0025; doi 10.1007/s11071-006-0757-7"), Words{});
  EXPECT_EQ(unknown("```\n0.123456\n```\n0.123457\n"), Words{"0.123457"});
}

TEST(Documents, ComputedPartsAreWrittenAnewAndNothingElse) {
  const auto written = [](const std::string &text) { return with_computed_parts(results(), text); };
  EXPECT_EQ(written("no part"), "no part");
  EXPECT_EQ(written("a <!--check gap .1e-->7.4e-05<!--end--> b"),
            "a <!--check gap .1e-->7.5e-05<!--end--> b");
  EXPECT_EQ(written("<!--check class start-->differs<!--end-->, <!--check class gap-->x<!--end-->"),
            "<!--check class start-->agrees<!--end-->, <!--check class gap-->differs<!--end-->");
  EXPECT_EQ(written("<!--check counts-->0<!--end-->"),
            "<!--check counts-->2 key numbers: 1 agree with the paper, 0 are close to it, 1 differ "
            "from it, 0 depend on an inferred value, 0 are not in the paper<!--end-->");
  EXPECT_NE(written("<!--check few gap--><!--end-->").find("| it grazes | 8e-05 | differs |"),
            std::string::npos);
  EXPECT_THROW(written("<!--check class nothing-->1<!--end-->"), std::runtime_error);
  EXPECT_THROW(written("<!--check gap .1e-->7.5e-05"), std::runtime_error);
  EXPECT_THROW(written("<!--check nothing-->1<!--end-->"), std::runtime_error);
}

}  // namespace
